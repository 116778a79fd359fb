#include "cli/commands.h"

#include <iostream>

#include "analysis/settings.h"
#include "base/nearest_name.h"
#include "base/phrases.h"
#include "dataset/metadata.h"

namespace mixity::cli {
namespace {

using Flags = std::vector<std::string_view>;

Flags with_law_flags(Flags flags) {
  flags.insert(flags.end(), {"law", "laws"});
  return flags;
}

Flags with_metadata_flags(Flags flags) {
  for (const MetadataField& one : metadata_fields()) flags.push_back(one.name);
  return flags;
}

Flags with_plan_flags(Flags flags) {
  flags.insert(flags.end(), {"model", "lambda", "lambda_II", "lambda_III", "parameters", "loads", "points", "reach",
                             "sigma_T", "sigma_A", "seed"});
  return with_metadata_flags(with_law_flags(std::move(flags)));
}

}  // namespace

std::vector<std::string_view> with_fit_flags(std::vector<std::string_view> flags) {
  for (const Setting& option : settings()) flags.push_back(option.name);
  flags.push_back("pool");
  return with_metadata_flags(with_law_flags(std::move(flags)));
}

std::span<const Command> commands() {
  static const std::vector<Command> table{
      {"fit",
       run_fit,
       "fit DATA.csv|FIT.toml ... [--pool] [--shard=i/n] [flags]",
       "Fits the models to each data set and reports parameters and goodness of fit.",
       with_fit_flags({"format", "out", "save", "force", "shard"}),
       {"text", "json", "csv"}},
      {"report", run_report, "report DATA.csv|FIT.toml ... --out=DIR [--formats=pdf,png,gnuplot] [flags]",
       "Fits as `fit` does, and writes a web page with all figures and tables, and each figure as a file.",
       with_fit_flags({"out", "force"})},
      {"predict", run_predict,
       "predict DATA.csv|FIT.toml [--loads=P1,P2] --shear=T1,T2,... | --model=KEY --lambda=L "
       "--load=P|--approach=D --shear=T1,T2,... [flags]",
       "Predicts the contact area at given loads, with standard errors if the model is fitted to data.",
       with_fit_flags(
           {"model", "lambda", "lambda_II", "lambda_III", "parameters", "loads", "shear", "approach", "units"})},
      {"curve", run_curve,
       "curve DATA.csv|FIT.toml [--loads=P1,P2] [--points=N] | --model=KEY --lambda=L --load=P|--shear=T "
       "[--points=N|--chord=E] [flags]",
       "Prints the whole equilibrium curve at a normal load, or a(P) at a tangential load, as CSV; for a fit, A(T) "
       "with standard errors.",
       with_fit_flags({"model", "lambda", "parameters", "loads", "shear", "points", "chord", "units"})},
      {"instability",
       run_instability,
       "instability DATA.csv|FIT.toml [--model=KEY] [--loads=P1,P2] | --model=KEY --lambda=L "
       "--load=P|--approach=D [flags]",
       "Lists every fold: where the contact jumps, to which state, and the area lost; for a fit, with standard errors.",
       with_fit_flags({"model", "lambda", "lambda_II", "lambda_III", "parameters", "loads", "approach", "stiffness",
                       "format", "units"}),
       {"text", "json"}},
      {"map", run_map,
       "map --model=KEY [--load_range=P1,P2] [--lambda_range=L1,L2] [--axis=NAME] [--tau0=S|--boundaries]",
       "Prints the regime of a sheared contact over normal load and lambda, or another parameter, as CSV.",
       with_law_flags({"model", "load_range", "lambda_range", "axis", "parameters", "grid", "tau0", "boundaries",
                       "units", "radius", "modulus", "youngs_modulus", "poisson_ratio", "toughness", "mode_III"})},
      {"sahli",
       run_sahli,
       "sahli DATA.csv [--upto=0.5] [--model=c] [--format=csv] [flags]",
       "Fits A = A0 - alpha T^2 to each loading run, and a power law to alpha against A0.",
       with_metadata_flags(with_law_flags({"upto", "model", "lambda", "parameters", "format"})),
       {"text", "csv"}},
      {"figures",
       run_figures,
       "figures --paper --out=DIR [--formats=pdf,png,gnuplot] [DATA.csv ...]",
       "Draws the figures of Papangelo & Ciavarella (2019) from the equations, with the points of given data sets.",
       {"paper", "out", "force", "formats"}},
      {"check", run_check, "check DATA.csv ... [--save=DEFINITION.toml] [flags]",
       "Shows how a data set was read, and warns of anything unusual in it. Works before its constants are known.",
       with_metadata_flags({"pool", "save", "force"})},
      {"points", run_points, "points DATA.csv [--out=POINTS.csv] [flags]",
       "Prints each point with its phase angle and toughness ratio, as CSV.", with_metadata_flags({"out", "force"})},
      {"runs", run_runs,
       "runs LOG.csv [AREAS.csv] ... [--out=DIR] [--lag=L] [--zero_drift] [--cuts=CUTS.toml] [--formats=pdf] "
       "[--save=DEFINITION.toml] [flags]",
       "Cuts logs of forces and areas over time into loading runs: points to fit, peaks, and figures of the cuts. Each "
       "file is a log, or files are in pairs: forces and areas.",
       with_metadata_flags({"out", "save", "force", "lag", "zero_drift", "cuts", "formats"})},
      {"design",
       run_design,
       "design --model=KEY --lambda=L [--loads=P1,P2] [--load_range=P1,P2] [--runs=N] [--wanted=2%] [--experiments=N] "
       "[flags]",
       "Predicts the error of lambda and the odds between models for a planned experiment, and finds the most "
       "informative loads.",
       with_plan_flags({"models", "load_range", "runs", "goal", "wanted", "experiments", "format"}),
       {"text", "csv"}},
      {"simulate", run_simulate,
       "simulate --model=KEY --lambda=L --loads=P1,P2 [--seed=N] [--index=N] [--out=DATA.csv] [flags]",
       "Simulates a planned experiment from the model with seeded noise.", with_plan_flags({"index", "out", "force"})},
      {"merge",
       run_merge,
       "merge PART1.json PART2.json ... [--out=FITS.json]",
       "Merges the results of `fit --shard=i/n --format=json` from several machines.",
       {"out", "force"}},
      {"import",
       run_import,
       "import EXPORT.csv --x=\"T [mN]\" --y=\"A [mm^2]\" --loads=\"P1,P2,... mN\" [--out=DATA.csv]",
       "Converts the export of a program that digitises plots (WebPlotDigitizer, Engauge) to a data CSV.",
       {"x", "y", "loads", "layout", "decimal", "sheet", "out", "force"}},
      {"help", run_help, "help [COMMAND]", "Explains the program or a command.", {}},
  };
  return table;
}

const Command& find_command(const std::string& name) {
  for (const Command& command : commands())
    if (command.name == name) return command;
  if (name.starts_with("-"))
    throw UsageError("flag '" + name + "' stands before the command: the command comes first (see mixity help)");
  throw UsageError("unknown command '" + name + "'" + did_you_mean(name, texts_of(commands(), &Command::name)) +
                   " (see mixity help)");
}

void require_flags_only(const std::string& command, const Arguments& arguments) {
  if (!arguments.empty()) throw UsageError(command + " takes flags only, not '" + arguments[0] + "'");
}

void warn(const std::string& message) { std::cerr << "mixity: " << message << '\n'; }

}  // namespace mixity::cli
