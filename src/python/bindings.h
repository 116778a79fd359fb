// Shared by the parts of the module: arrays, and progress and Ctrl-C during long work.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "analysis/request.h"
#include "base/stop.h"
#include "fitting/prediction.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace mixity {

using Numbers = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Output = nb::ndarray<double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Codes = nb::ndarray<std::uint8_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

/// Names and texts, as for constants and options.
using Stated = std::vector<std::pair<std::string, std::string>>;

/// Files by path, with their bytes.
using Contents = std::vector<std::pair<std::string, nb::bytes>>;
std::vector<InputFile> inputs_of(const Contents& contents);

/// Hands an array over to Python.
inline nb::ndarray<nb::numpy, double> numpy_of(std::vector<double> values) {
  auto* const owned = new std::vector<double>(std::move(values));
  const nb::capsule owner(owned, [](void* p) noexcept { delete static_cast<std::vector<double>*>(p); });
  return nb::ndarray<nb::numpy, double>(owned->data(), {owned->size()}, owner);
}

/// Made from the arguments of folds(); throws InputError.
Control control_of(const std::string& kind, double stiffness);

/// A fold as a dict; `with_errors`: with standard errors of T, u and A.
nb::dict shown(const FoldPrediction& fold, bool with_errors);

struct Interrupted {};

/// Calls Python's callback, and checks for Ctrl-C while it exists, on the thread that Python waits on. Once one of
/// these throws, all threads stop.
class Watch {
 public:
  explicit Watch(nb::object callback) : callback_(std::move(callback)) {}
  void operator()(double share) { look(share); }

 private:
  void look(std::optional<double> share) {
    constexpr std::chrono::milliseconds kPause(20);  // between looks, which wait for the interpreter's lock
    if (stop_) throw Interrupted();
    if (std::this_thread::get_id() != main_) return;
    const auto now = std::chrono::steady_clock::now();
    if (!share && now - looked_ < kPause) return;
    looked_ = now;
    const nb::gil_scoped_acquire gil;
    try {
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      if (share && !callback_.is_none()) callback_(*share);
    } catch (...) {
      stop_ = true;
      throw;
    }
  }

  nb::object callback_;
  const std::thread::id main_ = std::this_thread::get_id();
  std::atomic<bool> stop_ = false;
  std::chrono::steady_clock::time_point looked_{};
  const StopCheck check_ = [this] { look({}); };
  const Stoppable stoppable_{&check_};
};

/// While it exists, the interpreter's lock is released, and Ctrl-C stops the work.
class Released {
  const Watch watch_{nb::none()};
  const nb::gil_scoped_release released_;
};

auto without_gil(const auto& work) {
  const Released released;
  return work();
}

/// Reads one file, or several as one data set.
Dataset load_files(const std::vector<std::string>& paths, const Stated& constants, Inputs& inputs);

/// A request made from the options of a fit; throws InputError.
FitRequest request_of(const Dataset& data, const Stated& options);

void bind_mechanics(nb::module_& m);
void bind_data(nb::module_& m);
void bind_fits(nb::module_& m);
void bind_studies(nb::module_& m);
void bind_reports(nb::module_& m);

}  // namespace mixity
