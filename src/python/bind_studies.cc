// Plans and simulated experiments.
#include "base/input_error.h"
#include "python/bindings.h"
#include "studies/design.h"
#include "studies/simulate.h"

namespace mixity {
namespace {

nb::dict shown(const Expectation& expected) {
  nb::dict rivals, one;
  for (const Expectation::Rival& rival : expected.rivals) rivals[rival.model.c_str()] = rival.chi2;
  one["standard_error"] = expected.standard_error;
  one["chi2"] = rivals;
  return one;
}

Plan plan_of(const std::string& model, const std::vector<double>& parameters, const Stated& constants,
             const std::vector<double>& loads, std::size_t points, double reach, const std::string& sigma_T,
             const std::string& sigma_A) {
  Plan plan{model, parameters, {}, loads, points, reach, {}, {}};
  plan.constants = stated_by(constants);
  const auto error_of = [](const char* name, const std::string& text) {
    const auto error = parse_quantity(text);
    if (!error) throw InputError(name, "is '" + text + "'; it must be \"1%\" or a quantity");
    return *error;
  };
  plan.sigma_T = error_of("sigma_T", sigma_T);
  plan.sigma_A = error_of("sigma_A", sigma_A);
  Plan whole = plan;
  if (whole.loads.empty()) whole.loads = {0};  // a dummy load if all are to be found
  if (const std::string problem = problem_of(whole); !problem.empty()) throw InputError("plan", problem);
  return plan;
}

}  // namespace

void bind_studies(nb::module_& m) {
  nb::class_<Plan>(m, "Plan")
      .def(nb::new_(&plan_of))
      .def_ro("loads", &Plan::loads)
      .def(
          "simulate",
          [](const Plan& plan, std::uint64_t seed, std::optional<std::uint64_t> index) {
            return without_gil([&] { return simulate(plan, seed, index); });
          },
          "seed"_a, "index"_a.none())
      .def("expect",
           [](const Plan& plan, const std::vector<std::string>& rivals) {
             return shown(without_gil([&] { return expect(plan, rivals); }));
           })
      .def("next_loads",
           [](const Plan& plan, double least, double most, std::size_t candidates,
              const std::vector<std::string>& rivals) {
             const auto found = without_gil([&] { return next_loads(plan, least, most, candidates, rivals); });
             nb::list list;
             for (const LoadCandidate& one : found) list.append(nb::make_tuple(one.load, shown(one.expected)));
             return list;
           })
      .def("best",
           [](const Plan& plan, double least, double most, std::size_t runs, bool for_models,
              const std::vector<std::string>& rivals) {
             const Released released;
             return best_plan(plan, least, most, runs, for_models ? Goal::model : Goal::error, rivals);
           })
      .def(
          "experiments",
          [](const Plan& plan, std::uint64_t seed, std::size_t count, const std::vector<std::string>& rivals,
             const nb::object& progress) {
            Watch watch(progress);
            const auto tried = [&] {
              const nb::gil_scoped_release released;
              return try_plan(plan, seed, count, rivals, [&](double share) { watch(share); });
            };
            const Outcome outcome = tried();
            nb::dict one;
            one["experiments"] = outcome.experiments;
            one["with_value"] = outcome.with_value;
            one["ok"] = outcome.ok;
            one["mean"] = outcome.mean;
            one["spread"] = outcome.spread;
            one["standard_error"] = outcome.mean_standard_error;
            one["covered"] = outcome.covered;
            one["decided"] = outcome.decided;
            return one;
          },
          "seed"_a, "count"_a, "rivals"_a, "progress"_a.none());
}

}  // namespace mixity
