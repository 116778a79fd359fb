// curve_fits MODEL POINTS FILE [own_loads] [constants] [priors]: a fit under the objective curve, to be timed beside
// ODRPACK on the very same points (tools/peers/odrpack.py). Writes P, T, A and the errors of T and A to FILE as native
// doubles, point after point, and prints a line of JSON: the fit, and what one sweep of distances takes, which no fit
// can do without. Then answers each line of input by a line of two numbers: seconds of a fit, of all processors and on
// the wall. `constants`: with toughness and modulus free; `priors`: with five constants uncertain. The line says which:
// `bare` (value, status, standard errors, intervals), `whole` (with its checks, too).
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <stdexcept>

#include "curve/noisy_runs.h"
#include "fitting/fit.h"

namespace mixity {
namespace {

struct Seconds {
  double processors, wall;
};

/// A mean over as many calls as fill 20 ms: reading the clocks then takes none of it.
template <class Action>
Seconds timed(const Action& action) {
  const auto now = [](clockid_t clock) {
    std::timespec at{};
    clock_gettime(clock, &at);
    return static_cast<double>(at.tv_sec) + 1e-9 * static_cast<double>(at.tv_nsec);
  };
  const double processors = now(CLOCK_PROCESS_CPUTIME_ID), wall = now(CLOCK_MONOTONIC);
  int calls = 0;
  do {
    action();
    ++calls;
  } while (now(CLOCK_MONOTONIC) - wall < 0.02);
  return {(now(CLOCK_PROCESS_CPUTIME_ID) - processors) / calls, (now(CLOCK_MONOTONIC) - wall) / calls};
}

/// Of distances from the fitted curves, with derivatives, on one processor.
double seconds_of_sweep(const Dataset& data, const ContactModel& model, const ParameterValues& p) {
  constexpr std::size_t kBlock = 2048;
  const std::size_t n = data.points.size();
  std::vector<double> values[5], out(4 * kBlock), slopes(p.size() * kBlock);
  for (std::size_t i = 0; i < n; ++i) {
    const double row[] = {data.points[i].P, data.points[i].T, data.points[i].A, data.errors[i].T, data.errors[i].A};
    for (int k = 0; k < 5; ++k) values[k].push_back(row[k]);
  }
  const auto sweep = [&] {
    for (std::size_t from = 0; from < n; from += kBlock) {
      const std::size_t count = std::min(kBlock, n - from);
      const auto of = [&](int k) { return std::span<const double>(values[k]).subspan(from, count); };
      const auto to = [&](std::size_t k) { return std::span<double>(out).subspan(k * kBlock, count); };
      CurveDistances distances{to(0), to(1), to(2), to(3), std::span(slopes).first(p.size() * count)};
      if (!model.curve_distances(p, {of(0), of(1), of(2), of(3), of(4)}, Search::local, true, distances))
        throw std::runtime_error("a distance is not finite");
    }
  };
  sweep();
  std::vector<double> seconds;
  for (int i = 0; i < 5; ++i) seconds.push_back(timed(sweep).processors);
  std::nth_element(seconds.begin(), seconds.begin() + 2, seconds.end());
  return seconds[2];
}

void write_points(const Dataset& data, const char* path) {
  std::FILE* file = std::fopen(path, "wb");
  if (!file) throw std::runtime_error(std::string("cannot write ") + path);
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const double row[] = {data.points[i].P, data.points[i].T, data.points[i].A, data.errors[i].T, data.errors[i].A};
    std::fwrite(row, sizeof(double), 5, file);
  }
  std::fclose(file);
}

/// As tools/peers/priors.py has them.
void state_errors(Dataset& data) {
  data.contact = Contact{0.01, 2e6, 0.03};
  Metadata& metadata = data.metadata;
  metadata.radius = data.contact->radius;
  metadata.modulus = data.contact->modulus;
  metadata.toughness = data.contact->toughness;
  metadata.area_scale = 1;
  metadata.load_offset = metadata.shear_offset = 0;
  metadata.standard_errors = {{"modulus", 0.05 * *metadata.modulus},
                              {"toughness", 0.10 * *metadata.toughness},
                              {"area_scale", 0.01},
                              {"load_offset", 0.5 * data.contact->force_unit()},
                              {"shear_offset", 0.5 * data.contact->force_unit()}};
}

void serve(const ContactModel& model, std::size_t points, const char* path, bool own_loads, bool constants,
           bool priors) {
  // not where the others start, which is at the typical values
  const std::string key(model.info().key);
  const std::span<const ParameterInfo> infos = model.parameters();
  ParameterValues truth = ParameterValues::zeros(infos.size());
  for (std::size_t k = 0; k < truth.size(); ++k) truth[k] = 2 * infos[k].typical;
  Dataset data = noisy_runs(key, truth, {.points = points, .own_loads = own_loads});
  if (priors) state_errors(data);
  write_points(data, path);
  FitOptions options{.objective = Objective::curve};
  if (constants) options.free = {kToughness, kModulus};
  FitOptions bare = options;
  bare.checks = false;
  const FitResult fit = fit_model(data, key, options);
  std::printf(R"({"status": "%s", "chi2": %.17g, "names": [)", std::string(to_string(fit.status)).c_str(),
              fit.sum_of_squares);
  const char* comma = "";
  for (const FittedParameter& parameter : fit.parameters) {
    std::printf("%s\"%s\"", comma, parameter.name.c_str());
    comma = ", ";
  }
  const auto print_all = [&](const char* name, auto value_of) {
    std::printf(R"(], "%s": [)", name);
    const char* separator = "";
    for (const FittedParameter& parameter : fit.parameters) {
      std::printf("%s%.17g", separator, value_of(parameter));
      separator = ", ";
    }
  };
  print_all("starts", [&](const FittedParameter& parameter) {
    const auto info =
        std::find_if(infos.begin(), infos.end(), [&](const ParameterInfo& one) { return one.name == parameter.name; });
    return info == infos.end() ? 1.0 : info->typical;
  });
  print_all("values", [](const FittedParameter& parameter) { return parameter.value.value_or(0); });
  print_all("errors", [](const FittedParameter& parameter) { return parameter.stderr_.value_or(0); });
  print_all("lows",
            [](const FittedParameter& one) { return one.interval && one.interval->low ? *one.interval->low : 0; });
  print_all("highs",
            [](const FittedParameter& one) { return one.interval && one.interval->high ? *one.interval->high : 0; });
  const Evidence evidence = fit.evidence ? fit.evidence->evidence : Evidence{};
  std::printf(R"(], "posterior": [%.17g, %.17g, %.17g, %.17g)", evidence.mean, evidence.standard_deviation,
              evidence.low, evidence.high);
  ParameterValues fitted = truth;
  for (std::size_t k = 0; k < fitted.size(); ++k) fitted[k] = fit.parameters[k].value.value_or(truth[k]);
  std::printf("], \"sweep\": %.6g}\n", seconds_of_sweep(data, model, fitted));
  std::fflush(stdout);
  for (std::string line; std::getline(std::cin, line);) {
    const Seconds taken = timed([&] { fit_model(data, key, line == "bare" ? bare : options); });
    std::printf("%.9g %.9g\n", taken.processors, taken.wall);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace mixity

int main(int count, char** arguments) try {
  using namespace mixity;
  bool known = count >= 4, own_loads = false, constants = false, priors = false;
  for (int i = 4; i < count; ++i) {
    const std::string word = arguments[i];
    (word == "own_loads" ? own_loads : word == "priors" ? priors : constants) = true;
    known &= word == "own_loads" || word == "constants" || word == "priors";
  }
  const auto points = known ? static_cast<std::size_t>(std::atof(arguments[2])) : 0;
  const auto model = known ? ContactModel::find(arguments[1]) : std::nullopt;
  known = model && points >= 8;
  if (known) serve(*model, points, arguments[3], own_loads, constants, priors);
  if (!known) std::fprintf(stderr, "curve_fits MODEL POINTS FILE [own_loads] [constants] [priors], 8 points or more\n");
  return known ? 0 : 2;
} catch (const std::exception& error) {
  std::fprintf(stderr, "curve_fits: %s\n", error.what());
  return 1;
}
