// Fits one model to arrays and asks what follows: P and T in mN, A in mm^2.
#include <mixity/mixity.h>

#include <iostream>

int main() {
  const std::vector<double> P(6, 4.68), T{0, 10, 20, 30, 40, 50}, A{0.395, 0.393, 0.386, 0.375, 0.357, 0.331};
  const mixity::Dataset data =
      mixity::make_dataset("glass on rubber", {{"P [mN]", P}, {"T [mN]", T}, {"A [mm^2]", A}},
                           {{"radius", "9.42 mm"}, {"modulus", "2.133 MPa +/- 3%"}, {"toughness", "27 mJ/m^2"}});
  const mixity::FitResult fit = mixity::fit_model(data, "c");
  const mixity::FittedParameter& lambda = fit.parameters.at(0);
  std::cout << "lambda " << lambda.value.value() << " +/- " << lambda.stderr_.value() << ", "
            << mixity::to_string(fit.status) << '\n';
  const mixity::ContactModel model = mixity::ContactModel::find("c").value();
  const auto folds =
      model.folds(mixity::ParameterValues{*lambda.value}, data.points[0].P, {mixity::Control::Kind::load});
  std::cout << "jumps at " << folds.at(0).T * data.contact->force_unit() * 1e3 << " mN\n";
}
