#include "fitting/starts.h"

#include <algorithm>

namespace mixity {

std::vector<std::vector<double>> toughness_guesses(const Dataset& data, std::string_view model,
                                                   const FitOptions& options, const std::vector<std::size_t>& used,
                                                   std::size_t parameters) {
  constexpr std::size_t kEnough = 1000;  // points, evenly chosen
  const std::size_t every = used.size() / kEnough + 1;
  std::vector<std::vector<std::size_t>> runs(data.curves.size());
  for (std::size_t i = 0; i < used.size(); i += every)
    if (data.toughness(used[i])) runs[data.points[used[i]].curve].push_back(used[i]);
  for (auto& run : runs)
    std::sort(run.begin(), run.end(),
              [&](std::size_t one, std::size_t other) { return data.points[one].T < data.points[other].T; });
  FitOptions toughness = value_only(options);
  toughness.objective = Objective::toughness;
  toughness.scale = Scale::log;
  toughness.weighted = false;
  toughness.loss_scale.reset();
  std::vector<std::vector<double>> guesses;
  const auto guess = [&](const std::vector<std::size_t>& points, Loss loss) {
    toughness.loss = loss;
    const FitResult fit = fit_model(data, model, toughness, &points);
    if (!fit.solution.empty()) guesses.push_back(fit.solution);
  };
  std::size_t last_count = 0;
  for (const double part : {1.0, 0.95, 0.9, 0.8, 0.65}) {
    std::vector<std::size_t> points;
    for (const auto& run : runs)
      points.insert(points.end(), run.begin(),
                    run.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(run.size())));
    if (points.size() == last_count) continue;
    last_count = points.size();
    guess(points, Loss::none);
    // of one parameter a robust loss, whose scan is the dearest of all, has nothing to add
    if (part == 1 && parameters > 1) guess(points, Loss::cauchy);
  }
  return guesses;
}

}  // namespace mixity
