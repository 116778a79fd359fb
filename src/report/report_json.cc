#include "report/fit_fields.h"
#include "report/fit_json.h"
#include "report/fit_table.h"
#include "report/report.h"

namespace mixity {
namespace {

/// A figure or a data set with its report.
struct ListedFigure {
  const Figure* figure;
  const ReportContent* report;
};
struct ListedEntry {
  const ReportEntry* entry;
  const ReportContent* report;
};

/// Measured peaks, and those that the fits predict.
struct BothPeaks {
  const PeakForces* measured;
  const std::vector<PredictedPeaks>* predicted;
};

}  // namespace

void describe(Fields<SahliRun>& field) {
  field("curve", "name of the run", &SahliRun::curve);
  field("P", "load", &SahliRun::P);
  field("points", "number of points", &SahliRun::points);
  field("A0", "area without shear", &SahliRun::A0);
  field("A0_stderr", "standard error of A0; null with fewer than three points", &SahliRun::A0_stderr);
  field("alpha", "coefficient of T^2", &SahliRun::alpha);
  field("alpha_stderr", "standard error of alpha; null with fewer than three points", &SahliRun::alpha_stderr);
  field("alpha_predicted", "alpha of the first model with values, at this A0", &SahliRun::alpha_predicted);
}

void describe(Fields<PowerLaw>& field) {
  field("factor", "alpha at A0 = 1", &PowerLaw::factor);
  field("exponent", "of A0", &PowerLaw::exponent);
  field("exponent_stderr", "standard error of the exponent; null with two runs", &PowerLaw::exponent_stderr);
}

void describe(Fields<SahliResult>& field) {
  field("runs", "the parabola of each run", &SahliResult::runs);
  field("power_law", "alpha over the runs; null with fewer than two distinct A0", &SahliResult::power_law);
}

void describe(Fields<PeakForce>& field) {
  field("line", "line in the file", &PeakForce::line);
  field("P", "load", &PeakForce::P);
  field("peak_stress", "maximum of T over the area of Hertz", &PeakForce::peak);
  field("minimum_stress", "minimum of T over the area of Hertz", &PeakForce::minimum);
}

void describe(Fields<PredictedPeak>& field) {
  field("P", "load", &PredictedPeak::P);
  field("stress", "T at the jump over the area of Hertz", &PredictedPeak::stress);
  field("low", "the stress at one end of the parameter's interval", &PredictedPeak::low);
  field("high", "the stress at the other end", &PredictedPeak::high);
}

void describe(Fields<PredictedPeaks>& field) {
  field("model", "key of the model", &PredictedPeaks::model);
  field("loads", "measured loads at which the contact jumps", &PredictedPeaks::loads);
  field("ratio", "mean of measured over predicted first maxima", &PredictedPeaks::ratio);
  field("ratio_error", "standard error of the ratio; null with fewer than two maxima", &PredictedPeaks::ratio_error);
}

void describe(Fields<BothPeaks>& field) {
  field("path", "path of the file", [](auto& peaks) { return peaks.measured->path; });
  field("inputs", "the file and its TOML", [](auto& peaks) { return peaks.measured->inputs; });
  field("provenance", "where the data come from", [](auto& peaks) { return peaks.measured->metadata.provenance; });
  field("force_unit", "unit of loads; empty if dimensionless", [](auto& peaks) { return peaks.measured->force_unit; });
  field("stress_unit", "unit of stresses; empty if they are in units of E*/xi",
        [](auto& peaks) { return peaks.measured->stress_unit; });
  field("rows", "usable rows of the file", [](auto& peaks) { return peaks.measured->rows; });
  field("predicted", "of each model with values", [](auto& peaks) { return *peaks.predicted; });
  field("excluded", "the other rows", [](auto& peaks) { return lines_of(peaks.measured->excluded, nullptr); });
}

void describe(Fields<PredictedJump>& field) {
  field("P", "load; null where the approach is held",
        [](auto& jump) { return jump.is_approach ? std::nullopt : std::optional(jump.P); });
  field("delta", "approach that is held; null where the load is",
        [](auto& jump) { return jump.is_approach ? std::optional(jump.P) : std::nullopt; });
  field("T", "tangential load at which the contact jumps", [](auto& jump) { return jump.T.value; });
  field("T_stderr", "standard error of T", [](auto& jump) { return jump.T.standard_error; });
  field("A", "area from which the contact jumps", [](auto& jump) { return jump.A.value; });
  field("A_stderr", "standard error of A", [](auto& jump) { return jump.A.standard_error; });
  field("largest_T", "largest T that was measured at this load", &PredictedJump::largest_T);
}

void describe(Fields<Answer>& field) {
  field("model", "key of the model that describes the data best", [](auto& answer) { return answer.fit->model; });
  field("result", "its first parameter with its standard error", &Answer::result);
  field("jumps", "where the contact jumps under load control, in the units of the file", &Answer::jumps);
  field("cannot_say", "what the data cannot say, in sentences", &Answer::cannot_say);
}

void describe(Fields<ListedFigure>& field) {
  field("name", "name of its files", [](auto& listed) { return listed.figure->name; });
  field("title", "title", [](auto& listed) { return listed.figure->title; });
  field("caption", "caption", [](auto& listed) { return listed.figure->caption; });
  field("files", "paths within the report", R"({"minItems": 2})", [](const ListedFigure& listed) {
    std::vector<std::string> files;
    for (const std::string& ending : listed.report->drawn.endings.at(listed.figure->name))
      files.push_back("figures/" + listed.figure->name + ending);
    return files;
  });
}

void describe(Fields<MissingFigure>& field) {
  field("figure", "the figure", &MissingFigure::what);
  field("reason", "why it is left out", &MissingFigure::why);
}

void describe(Fields<ListedEntry>& field) {
  const auto result = [](const ListedEntry& listed) -> const Analysis& { return listed.entry->data->result; };
  field.all_of(result);
  field("answer", "the result in short; null if no fit has a value", [](const ListedEntry& listed) {
    const Answer& answer = listed.entry->data->answer;
    return answer.fit ? std::optional(answer) : std::nullopt;
  });
  field("settings", "how the fits were made, by name", [=](auto& listed) { return fit_settings(result(listed)); });
  field("findings", "what the fits show, in sentences", [=](auto& listed) { return findings(result(listed)); });
  field("assumptions", "what was assumed, in sentences", [=](auto& listed) { return assumptions(result(listed)); });
  field("sahli", "parabolas A = A0 - alpha T^2, dimensionless; null for data without loads",
        [](auto& listed) { return listed.entry->data->sahli; });
  field("peaks", "peak forces; null without a file of them", [](const ListedEntry& listed) {
    const ReportedData& data = *listed.entry->data;
    return data.peaks ? std::optional(BothPeaks{&*data.peaks, &data.predicted_peaks}) : std::nullopt;
  });
  field("figures", "figures of the report", [](const ListedEntry& listed) {
    std::vector<ListedFigure> figures;
    for (const FigureGroup& group : listed.entry->figures.groups)
      for (const Figure& figure : group.figures) figures.push_back({&figure, listed.report});
    return figures;
  });
  field("drawings", "what was read for figures of the log",
        [](auto& listed) { return listed.entry->figures.drawings; });
  field("figures_left_out", "figures that do not apply", [](auto& listed) { return listed.entry->figures.left_out; });
}

void describe(Fields<ReportContent>& field) {
  field("schema", "of this document", R"({"const": "mixity-report-1"})", [](auto&) { return "mixity-report-1"; });
  field("version", "of mixity", [](auto&) { return MIXITY_VERSION; });
  field("command", "that makes this report again", [](auto& report) { return report.settings.command; });
  field("made_with", "versions of the program and its libraries, by name", [](auto&) { return versions(); });
  field("missing", "why nothing was drawn; null if all figures were", [](auto& report) {
    const std::string& missing = report.drawn.missing;
    return missing.empty() ? std::nullopt : std::optional(missing);
  });
  field("datasets", "one for each data set", R"({"minItems": 1})", [](const ReportContent& report) {
    std::vector<ListedEntry> entries;
    for (const ReportEntry& entry : report.entries) entries.push_back({&entry, &report});
    return entries;
  });
}

std::string report_json(const ReportContent& content) { return json_text(json_of(content)); }

Json report_schema() { return schema_of<ReportContent>(); }

}  // namespace mixity
