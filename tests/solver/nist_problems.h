// The NIST StRD sets as problems of the solver.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "solver/jet_problem.h"
#include "solver/nist_data.h"
#include "solver/nist_models.h"

namespace mixity::nist {

template <class Model>
std::unique_ptr<Problem> make_problem(const Set& set, const std::vector<double>& start) {
  const nist::Observations<Model, double> data(set);
  std::vector<FreeParameter> parameters;
  for (std::size_t k = 0; k < start.size(); ++k) parameters.push_back(unbounded("b" + std::to_string(k + 1), start[k]));
  const auto residual = [data](const auto* b, std::size_t i) { return Model::value(b, data.x[i].data()) - data.y[i]; };
  return std::make_unique<JetProblem<Model::kParameters, decltype(residual)>>(data.y.size(), parameters, norm(data.y),
                                                                              false, residual);
}

/// Names a model where a function takes no template argument.
template <class Model>
struct Of {};

/// entry(Of<Model>, name) of each set, from the lower level of difficulty to the higher, as NIST lists them.
template <class Entry>
auto for_each_set(const Entry& entry) {
  return std::array{
      entry(Of<Saturation>{}, "Misra1a"),
      entry(Of<Chwirut>{}, "Chwirut2"),
      entry(Of<Chwirut>{}, "Chwirut1"),
      entry(Of<Lanczos>{}, "Lanczos3"),
      entry(Of<Gauss>{}, "Gauss1"),
      entry(Of<Gauss>{}, "Gauss2"),
      entry(Of<DanWood>{}, "DanWood"),
      entry(Of<Misra1b>{}, "Misra1b"),
      entry(Of<Kirby2>{}, "Kirby2"),
      entry(Of<CubicOverCubic>{}, "Hahn1"),
      entry(Of<Nelson>{}, "Nelson"),
      entry(Of<Mgh17>{}, "MGH17"),
      entry(Of<Lanczos>{}, "Lanczos1"),
      entry(Of<Lanczos>{}, "Lanczos2"),
      entry(Of<Gauss>{}, "Gauss3"),
      entry(Of<Misra1c>{}, "Misra1c"),
      entry(Of<Misra1d>{}, "Misra1d"),
      entry(Of<Roszman1>{}, "Roszman1"),
      entry(Of<Enso>{}, "ENSO"),
      entry(Of<Mgh09>{}, "MGH09"),
      entry(Of<CubicOverCubic>{}, "Thurber"),
      entry(Of<Saturation>{}, "BoxBOD"),
      entry(Of<Rat42>{}, "Rat42"),
      entry(Of<Mgh10>{}, "MGH10"),
      entry(Of<Eckerle4>{}, "Eckerle4"),
      entry(Of<Rat43>{}, "Rat43"),
      entry(Of<Bennett5>{}, "Bennett5"),
  };
}

}  // namespace mixity::nist
