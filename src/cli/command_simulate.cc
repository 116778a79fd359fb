// mixity simulate: a simulated experiment, as a data set.
#include <cmath>
#include <iostream>
#include <sstream>

#include "base/files.h"
#include "base/number_text.h"
#include "base/toml_file.h"
#include "cli/commands.h"
#include "cli/flags.h"
#include "cli/plan_flags.h"
#include "dataset/table/csv.h"
#include "studies/simulate.h"

DEFINE_string(index, "0", "index of the experiment in the random stream of the seed");

namespace mixity::cli {

int run_simulate(const Arguments& arguments) {
  require_flags_only("simulate", arguments);
  const Plan plan = plan_from_flags(true, {.bytes = 300, .most = 10000000});
  const Dataset data = simulate(plan, count_from("seed", 0), count_from("index", 0));
  std::ostringstream table;
  table << "curve," << (data.holds_approach() ? "delta [um]" : "P [mN]")
        << ",T [mN],A [mm^2],sigma_T [mN],sigma_A [mm^2]"
        << (data.axes.empty() ? "" : ",a_par [mm],a_perp [mm],sigma_a_par [mm],sigma_a_perp [mm]") << '\n';
  const double force = data.display.force_scale, area = data.display.area_scale;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Point& point = data.points[i];
    table << csv_field(data.curves[point.curve]) << ',' << shortest(as_decimal(point.P * data.held_scale())) << ','
          << shortest(point.T * force) << ',' << shortest(point.A * area) << ','
          << shortest(as_decimal(data.errors[i].T * force)) << ',' << shortest(as_decimal(data.errors[i].A * area));
    if (!data.axes.empty()) {
      const double mean = std::sqrt(point.A * area / pi<double>()), ratio = std::exp(0.5 * data.axes[i].q),
                   share = data.axes[i].sigma_q / std::sqrt(2.0);
      for (const double axis : {mean * ratio, mean / ratio}) table << ',' << shortest(axis);
      for (const double axis : {mean * ratio, mean / ratio}) table << ',' << shortest(axis * share);
    }
    table << '\n';
  }
  if (FLAGS_out.empty()) {
    std::cout << table.str();
    return kFine;
  }
  if (!FLAGS_out.ends_with(".csv")) throw must("out", "end in .csv");
  std::string constants;
  for (const auto& [name, text] : constants_as_stated(plan.constants))
    constants += name + " = " + toml_text(text) + "\n";
  constants += "provenance = \"reconstructed\"\nsource = " + toml_text(command_line()) + "\n";
  std::vector<OutputFile> files{{FLAGS_out, table.str()}, {metadata_path(FLAGS_out), constants}};
  write_outputs(std::move(files));
  std::cout << "Written to " << FLAGS_out << " and " << metadata_path(FLAGS_out) << '\n';
  return kFine;
}

}  // namespace mixity::cli
