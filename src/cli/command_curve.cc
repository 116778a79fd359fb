// mixity curve: the whole equilibrium curve at a normal load, or a(P) at a tangential load, as CSV; for a fit, A(T)
// with its band up to the jump of the contact.
#include <cmath>
#include <iostream>

#include "cli/commands.h"
#include "cli/contact_flags.h"
#include "cli/fitted_contact.h"

DEFINE_string(chord, "",
              "instead of --points: the fewest points whose chords stay within this fraction of the ranges of T and A");

namespace mixity::cli {
namespace {

std::size_t point_count() { return count_from("points", 2, 10000000); }

void print_at_load(const ContactModel& model, const ParameterValues& p, const OutputUnits& units) {
  const Load load = load_from(flag_of_loads("load"), units);
  require_contact(model, p, load.dimensionless);
  if (above_pull_off(load.dimensionless) < 0)
    throw refused("load", "no contact exists below the pull-off load -3 pi/2 R G_Ic");
  CurveSampling sampling;
  if (is_set("chord"))
    sampling = {.rule = CurveSampling::Rule::fewest, .chord = number_from("chord", 1e-9)};
  else
    sampling.points = point_count();
  const std::vector<CurvePoint> points = model.curve(p, load.dimensionless, sampling).points;
  for (const CurvePoint& q : points)
    if (!(q.T < kInfiniteT))
      throw UsageError("the curve reaches tangential loads above 1e150, which cannot be computed");

  std::cout << units.headings("phi,P,T,y,a,A,u,psi,f,stable") << '\n';
  for (const CurvePoint& q : points) {
    print_numbers({q.phi, load.shown, q.T * units.shear_scale(), q.y * units.force_scale, q.a * units.length_scale,
                   q.A * units.area_scale, q.u * units.slip_scale(), q.psi, q.f});
    std::cout << (q.dT >= 0 ? ",1\n" : ",0\n");
  }
}

void print_at_shear(const ContactModel& model, const ParameterValues& p, const OutputUnits& units) {
  Load shear = load_from("shear", units);
  shear.dimensionless *= units.shear_weight;
  if (!(shear.dimensionless >= 0 && shear.dimensionless <= kLargestLoad))
    throw UsageError("flag '--shear': T must lie between 0 and 1e150");
  require_contact(model, p);
  const std::size_t n = point_count();
  // From the unstable end to twice the edge load at which the load is a hundred times that of Hertz
  const double largest = 40 * pi<double>() + shear.dimensionless;
  std::cout << units.headings("P,T,y,a,A,stable") << '\n';
  std::vector<double> edge_loads;
  for (std::size_t i = 1; i <= n; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(n);
    edge_loads.push_back(largest * part * part);
  }
  for (const ConstantShearPoint& q : model.at_constant_shear(p, shear.dimensionless, edge_loads)) {
    print_numbers({q.P * units.force_scale, shear.shown, q.y * units.force_scale, q.a * units.length_scale,
                   area_from_radius(q.a) * units.area_scale});
    std::cout << (q.dP_dy > 0 ? ",1\n" : ",0\n");
  }
}

}  // namespace

int run_curve(const Arguments& arguments) {
  if (!arguments.empty()) {
    if (is_set("shear") || is_set("chord"))
      throw UsageError("flags '--shear' and '--chord' describe a single contact without data");
    const std::size_t points = point_count();
    const FittedContact fitted("curve", arguments);
    fitted.print_areas([&](const Load& P) { return fitted.shears_to_the_jump(P, points); });
    return fitted.exit_code();
  }
  const ContactModel model = shaped_model_from(FLAGS_model);
  if (model.is_elliptic())
    throw UsageError(
        "the curve of an elliptic contact is not a circle's: mixity predict --shape=ellipse has both axes");
  const bool at_load = is_set("load") || is_set("loads");
  if (at_load == is_set("shear")) throw UsageError("curve needs either --load (A against T) or --shear (a against P)");
  if (is_set("chord") && is_set("shear")) throw UsageError("flag '--chord' needs --load");
  if (is_set("chord") && is_set("points")) throw UsageError("flags '--points' and '--chord': give one of them");
  const ParameterValues p = parameters_from_flags(model);
  const OutputUnits units = output_units();
  at_load ? print_at_load(model, p, units) : print_at_shear(model, p, units);
  return kFine;
}

}  // namespace mixity::cli
