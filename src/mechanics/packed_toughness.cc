#include "mechanics/vector_math.h"
// after the declarations of the vector forms

#include "mechanics/packed_toughness.h"

namespace mixity {
namespace {

template <class Law>
MIXITY_LOOP void loop(Law law, double parameter, const double* __restrict first, const double* __restrict second,
                      std::size_t n, double* __restrict value, double* __restrict slope, double* __restrict curvature) {
  for (std::size_t i = 0; i < n; ++i) {
    const PackedForm<double> form = law.packed_form(parameter, PackedPoint<double>{first[i], second[i]});
    value[i] = Law::kLogSign * std::log(form.argument);
    slope[i] = form.slope;
    curvature[i] = form.curvature;
  }
}

}  // namespace

template <class Law>
void packed_log_toughness(Law law, double parameter, const double* first, const double* second, std::size_t n,
                          double* value, double* slope, double* curvature) {
  in_vectors([&] { loop(law, parameter, first, second, n, value, slope, curvature); });
}

namespace {
[[gnu::used]] const auto packed_instances = each_law([]<class Law>() {
  if constexpr (HasPackedForm<Law>)
    return &packed_log_toughness<Law>;
  else
    return nullptr;
});
}  // namespace

}  // namespace mixity
