// Work against precision of one predicted area A at given P and T: ours, root searches on the printed equation, and
// tables of the curve. The truth is a bisection of the printed equation in 50 digits.
//
// Evaluations: calls of the equation per answer, a call with derivatives being one; for a table its points, whose
// making is not in the time; what "mixity anew" needs to find a fold counts as far as it takes the residual's tau. The
// "tolerance" of a table is its number of points.
#include <array>
#include <cstdio>
#include <memory>
#include <random>
#include <string>

#include "benchmarks/precision/precision.h"
#include "benchmarks/precision/table.h"
#include "benchmarks/precision/textbook.h"
#include "mechanics/batch.h"
#include "mechanics/printed_equation.h"

namespace mixity::precision {
namespace {

constexpr std::size_t kArray = 256;  // equal loads at once: other methods, too, meet the same load again and again
const std::string kArrayMethod = "mixity arrays";

volatile double sink;  // keeps answers from being optimised away

template <class Model>
double area_at(const LoadedContact<Model>& contact, double P, double T) {
  const Equilibrium found = contact.at(T);
  return found.status == EquilibriumStatus::ok ? area_from_radius(radius_from_edge_load(found.y, P))
                                               : std::numeric_limits<double>::infinity();
}

/// Contact at one load and its stable branch.
template <class Model>
struct Case {
  std::string name;
  Parameters<Model> p;
  double P, T, y_bottom, y_jkr;
  truth::Digits50 area{};

  Case(const std::string& fraction, double lambda, double load, double shear) : p{lambda}, P(load), T(shear) {
    const LoadedContact contact(Model{}, p, P);
    y_bottom = contact.first_branch().y_bottom;
    y_jkr = contact.jkr_edge_load();
    char text[80];
    std::snprintf(text, sizeof text, "%s, lambda = %g, P = %g, T = ", std::string(Model::info.key).c_str(), lambda, P);
    name = text + fraction;
    area = truth::printed_area(Model::info.key, lambda, 0, P, T, y_bottom, truth::jkr_edge_load(P));
  }

  double error(double A) const {
    return std::isfinite(A) ? std::abs(static_cast<double>((A - area) / area))
                            : std::numeric_limits<double>::infinity();
  }
  Row row(const std::string& method, double tolerance, double A, double evaluations, bool ok) const {
    return {.task = "predict",
            .case_name = name,
            .method = method,
            .tolerance = tolerance,
            .error = error(A),
            .evaluations = evaluations,
            .claim = ok ? "ok" : "failed"};
  }
};

template <class Model>
void add_ours(const Case<Model>& c, std::vector<Row>& rows) {
  const Parameters<Model> p = c.p;
  const double P = c.P, T = c.T;
  // Steps of the search; a closed form: one. What a new contact looks for its folds by shows in the time alone.
  const int steps = std::max(LoadedContact(Model{}, p, P).at(T).iterations, 1);

  const auto contact = std::make_shared<LoadedContact<Model>>(Model{}, p, P);
  const double A = area_at(*contact, P, T);
  rows.push_back(c.row("mixity", 0, A, steps, std::isfinite(A)));
  rows.back().run = [contact, P, T] { sink = area_at(*contact, P, T); };
  rows.push_back(c.row("mixity anew", 0, A, steps, std::isfinite(A)));
  rows.back().run = [p, P, T] { sink = area_at(LoadedContact(Model{}, p, P), P, T); };

  const auto loads = std::make_shared<std::vector<double>>(kArray, T);
  const auto out = std::make_shared<std::vector<double>>(kArray);
  const bool all = predict_areas(LoadedContact(Model{}, p, P), *loads, *out) == kArray;
  rows.push_back(c.row(kArrayMethod, 0, out->front(), 0, all));
  rows.back().run = [p, P, loads, out] {
    predict_areas(LoadedContact(Model{}, p, P), *loads, *out);
    sink = out->back();
  };
}

template <class Model>
void add_textbook(const Case<Model>& c, std::vector<Row>& rows) {
  using Method = Answer (*)(const PrintedEquation<Model>&, const Bracket&, double);
  const std::vector<std::pair<const char*, Method>> methods{
      {"Newton", &newton<Model>},    {"bracketed Newton", &bracketed_newton<Model>},
#ifdef MIXITY_HAS_GSL
      {"Brent", &brent<Model>},
#endif
      {"TOMS 748", &toms748<Model>}, {"bisection", &bisection<Model>},
  };
  const PrintedEquation<Model> G{c.p[0], c.P, c.T};
  // a little above JKR, so that roundings leave the root inside
  const Bracket bracket{radius_from_edge_load(c.y_bottom, c.P), radius_from_edge_load(c.y_jkr, c.P) * (1 + 1e-9)};
  for (const auto& [name, method] : methods)
    for (int digits = 2; digits <= 15; ++digits) {
      const double tolerance = std::pow(10.0, -digits);
      const Answer answer = method(G, bracket, tolerance);
      rows.push_back(c.row(name, tolerance, answer.A, answer.evaluations, answer.ok));
      rows.back().run = [G, bracket, tolerance, solve = method] { sink = solve(G, bracket, tolerance).A; };
    }
}

template <class Model>
void add_tables(const Case<Model>& c, std::vector<Row>& rows) {
  const EquilibriumCurve curve(Model{}, c.p, c.P);
  // to the end of the branch; towards an asymptote to twice the load
  const LoadedContact contact(Model{}, c.p, c.P);
  const double y_last = std::isfinite(contact.first_branch().T_bottom) ? c.y_bottom : contact.at(2 * c.T).y;
  // Timed at loads at random: a processor learns the way of a binary search to one place, which users do not repeat.
  const auto loads = std::make_shared<std::vector<double>>(4096);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, std::min(contact.first_branch().T_bottom, 2 * c.T));
  for (double& T : *loads) T = uniform(random);
  for (const double n : {10.0, 30.0, 100.0, 300.0, 1e3, 3e3, 1e4, 3e4, 1e5}) {
    const auto table = std::make_shared<Table>(curve, y_last, static_cast<std::size_t>(n));
    rows.push_back(c.row("linear table", n, table->linear(c.T), n, true));
    rows.back().run = [table, loads, i = 0U]() mutable { sink = table->linear((*loads)[++i % loads->size()]); };
    rows.push_back(c.row("cubic table", n, table->cubic(c.T), n, true));
    rows.back().run = [table, loads, i = 0U]() mutable { sink = table->cubic((*loads)[++i % loads->size()]); };
  }
}

template <class Model>
void add_case(const Case<Model>& c, std::vector<Row>& all) {
  std::vector<Row> rows;
  add_ours(c, rows);
  add_textbook(c, rows);
  add_tables(c, rows);
  measure(rows, 41);
  for (Row& row : rows) {
    if (row.method == kArrayMethod) {
      row.median_ns /= kArray;
      row.spread_ns /= kArray;
    }
    row.run = nullptr;  // frees its table
    all.push_back(row);
  }
}

/// Far from the end of the stable branch, and close to it: a fold, Hertz, or (model a) an asymptote.
template <class Model>
void add_cases(double lambda, double P, std::vector<Row>& all) {
  const LoadedContact contact(Model{}, Parameters<Model>{lambda}, P);
  const StableBranch& branch = contact.first_branch();
  if (std::isfinite(branch.T_bottom)) {
    const std::string end = branch.ends_in_fold ? " T_fold" : " T_Hertz";
    for (const auto& [text, fraction] : {std::pair("0.3", 0.3), {"0.999", 0.999}, {"(1 - 1e-6)", 1 - 1e-6}})
      add_case(Case<Model>(text + end, lambda, P, fraction * branch.T_bottom), all);
    return;
  }
  const double scale = circle_radius(P) / std::sqrt(Model::small_shear({lambda}));
  for (const auto& [text, factor] : {std::pair("0.3", 0.3), {"10", 10.0}, {"1000", 1000.0}})
    add_case(Case<Model>(text + std::string(" S0/sqrt(lambda)"), lambda, P, factor * scale), all);
}

}  // namespace
}  // namespace mixity::precision

int main() {
  using namespace mixity;
  using namespace mixity::precision;
  std::vector<Row> rows;
  for (const double P : {-3.0, 0.0, 3.0, 1000.0}) {
    add_cases<Johnson>(0.15, P, rows);
    add_cases<WatersGuduru>(0.15, P, rows);
    add_cases<PapangeloCiavarella>(0.15, P, rows);
  }
  add_cases<Johnson>(0.99, 3.0, rows);  // folds
  print(rows);
}
