#include "report/fit_json.h"

#include "analysis/laws.h"
#include "analysis/settings.h"
#include "base/number_text.h"
#include "fitting/consistency.h"
#include "mechanics/laws/known_laws.h"
#include "report/data_text.h"
#include "report/fit_fields.h"

namespace mixity {
namespace {

/// A parameter of a run's own fit.
struct RunParameter {
  const FittedParameter* fitted;
};

struct Campaign {
  std::vector<std::string> files;
  std::map<std::string, std::string> flags;
};

struct FitDocument {
  std::span<const Analysis> results;
  const Shard* shard;
};

/// A load in the unit of the file.
auto shown_load(const double& P, const Within& in) { return as_decimal(P * in.result->data.held_scale()); }

}  // namespace

void describe(Fields<StatedConstant>& field) {
  field("constant", "name of the constant", &StatedConstant::name);
  field("value", "in SI units", &StatedConstant::value);
  field("standard_error", "0 if the constant is taken as exact", &StatedConstant::standard_error);
  field("unit", "SI unit; empty if dimensionless", &StatedConstant::unit);
}

void describe(Fields<UnshearedTest::Implied>& field) {
  field("constant", "name of the constant", &UnshearedTest::Implied::constant);
  field("unit", "unit of the values", &UnshearedTest::Implied::unit);
  field("stated", "stated value", &UnshearedTest::Implied::stated);
  field("value", "value that the areas without shear imply", &UnshearedTest::Implied::value);
  field("standard_error", "of that value", &UnshearedTest::Implied::standard_error);
  field("chi2", "chi^2 with that value", &UnshearedTest::Implied::chi2);
  field("p_value", "probability of so large a chi^2", &UnshearedTest::Implied::p_value);
}

void describe(Fields<UnshearedTest>& field) {
  field("points", "number of points without shear", &UnshearedTest::points);
  field("loads", "number of their loads", &UnshearedTest::loads);
  field("chi2", "chi^2 of JKR with the constants as stated", &UnshearedTest::chi2);
  field("p_value", "probability of so large a chi^2", &UnshearedTest::p_value);
  field("agrees", "whether the areas agree with JKR", [](auto& test) { return test.p_value >= kChance; });
  field("implied", "value of one constant, the others as stated, that these areas imply", &UnshearedTest::implied);
}

void describe(Fields<LeftOut::Run>& field) {
  field("curve", "name of the run", &LeftOut::Run::curve);
  field("load", "load, in the unit of the file", [](auto& run, auto& in) { return shown_load(run.P, in); });
  field("rmse_area", "root mean square error of its areas", R"({"minimum": 0})", &LeftOut::Run::rmse_area);
  field("points", "number of points", &LeftOut::Run::points);
  field("beyond_fold", "of these, points beyond the last equilibrium", &LeftOut::Run::beyond_fold);
}

void describe(Fields<ComparedModel>& field) {
  const auto of_left_out = [](const auto member) {
    return [member](const ComparedModel& one) {
      return one.left_out ? std::optional((*one.left_out).*member) : std::nullopt;
    };
  };
  field("model", "key of the model", &ComparedModel::model);
  const char* const kInformation =
      "null for a model that could not use all the points that the others used, and under a robust loss in units of "
      "the scatter";
  field("aicc", kInformation, &ComparedModel::aicc);
  field("bic", kInformation, &ComparedModel::bic);
  field("weight", "Akaike weight by AICc; null without AICc", &ComparedModel::weight);
  field("probability",
        "by the evidence, all models equally probable beforehand; null unless all models have an evidence",
        &ComparedModel::probability);
  field(
      "loo_rmse_area",
      "root mean square error of the areas at loads left out of the fit, in the unit of the file; null with more than "
      "200 runs, and where the law defines no area",
      of_left_out(&LeftOut::rmse_area));
  field("loo_beyond_fold", "points beyond the last equilibrium there", of_left_out(&LeftOut::beyond_fold));
  field("loo_curves", "the same of each run",
        [](auto& one) { return one.left_out ? one.left_out->runs : std::vector<LeftOut::Run>{}; });
}

void describe(Fields<RunParameter>& field) {
  field("value", "best value", [](auto& one) { return one.fitted->value; });
  field("stderr", "standard error", [](auto& one) { return one.fitted->stderr_; });
  field("interval", "confidence interval", [](auto& one) { return one.fitted->interval; });
}

void describe(Fields<CurveFit>& field) {
  const auto if_loads = [](const Within& in, double value) {
    return in.result->data.has_loads ? std::optional(value) : std::nullopt;
  };
  field("curve", "name of the run", &CurveFit::curve);
  field("load", "in the unit of the file", [=](auto& run, auto& in) { return if_loads(in, shown_load(run.P, in)); });
  field("load_dimensionless", "P/(R G_Ic)", [=](auto& run, auto& in) { return if_loads(in, run.P); });
  field("points", "number of points", [](auto& run) { return run.fit.used.size(); });
  field("status", "as of a fit", [](auto& run) { return run.fit.status; });
  field("parameters", "by name", [](const CurveFit& run) {
    Named<RunParameter> named;
    for (const FittedParameter& parameter : run.fit.parameters) named.push_back({parameter.name, {&parameter}});
    return named;
  });
}

void describe(Fields<PerCurve::Test>& field) {
  field("kind", "chi_squared where the standard errors are known", R"({"enum": ["F", "chi_squared"]})",
        [](auto& test) { return test.chi_squared ? "chi_squared" : "F"; });
  field("statistic", "F or chi^2", &PerCurve::Test::statistic);
  field("freedom", "degrees of freedom", &PerCurve::Test::freedom);
  field("residual_freedom", "degrees of freedom of the separate fits", &PerCurve::Test::residual_freedom);
  field("p_value", "of one value for all runs", R"({"minimum": 0, "maximum": 1})", &PerCurve::Test::p_value);
  field("aicc_pooled", "AICc with one value for all runs", &PerCurve::Test::aicc_pooled);
  field("aicc_separate", "AICc with one value for each run", &PerCurve::Test::aicc_separate);
}

void describe(Fields<PerCurve>& field) {
  field("model", "key of the model", &PerCurve::model);
  field("curves", "each run's own fit", &PerCurve::curves);
  field("fitted", "number of runs whose own fit has a value", &PerCurve::fitted);
  field("test", "test of one value for all runs against one for each", &PerCurve::test);
  field("untested", "why there is no test; else null",
        [](auto& one) { return one.test ? std::nullopt : std::optional(one.untested); });
}

void describe(Fields<InputFile>& field) {
  field("path", "path as it was read", &InputFile::path);
  field("bytes", "its size", &InputFile::bytes);
  field("xxh128", "XXH3 of 128 bits of its content, as xxh128sum prints it", &InputFile::hash);
}

void describe(Fields<Analysis>& field) {
  field("path", "path as it was given; of several files, the first", [](auto& result) { return result.data.path; });
  field("name", "name of the data set", [](auto& result) { return result.data.name; });
  field("provenance", "where the data come from", [](auto& result) { return result.data.metadata.provenance; });
  field("notice", "warning, if the data are reconstructed", [](auto& result) { return notice_on(result.data); });
  field("source", "source, as it was stated", [](auto& result) { return result.data.metadata.source; });
  field("inputs", "what was read for it: data, TOML, names of columns, definition, laws", [](auto& result) {
    std::vector<InputFile> files = result.data.inputs;
    files.insert(files.end(), result.request.inputs.begin(), result.request.inputs.end());
    return files;
  });
  field("notes", "what of the file was ignored or reinterpreted", [](auto& result) { return result.data.notes; });
  field("points", "number of rows in the file", [](auto& result) { return result.data.rows; });
  field("used", "number of usable rows", [](auto& result) { return result.data.points.size(); });
  field("excluded", "the other rows", [](auto& result) { return lines_of(result.data.excluded, &result.data); });
  field("constants", "constants that were stated", [](auto& result) { return stated_constants(result.data.metadata); });
  field("mode_III", "half: mode III is weighted by 1/2; averaged: over the edge; null without loads", [](auto& result) {
    return result.data.has_loads ? std::optional(to_string(result.data.metadata.mode_III)) : std::nullopt;
  });
  field("control",
        "what is held in the normal direction, which fields called P then are: load, or approach; null without loads",
        [](auto& result) {
          return result.data.has_loads ? std::optional(to_string(result.data.metadata.control)) : std::nullopt;
        });
  field(
      "kappa", "what T^2 is multiplied by: 1 if mode_III is half, (2 - nu)/(2 - 2 nu) if it is averaged",
      [](auto& result) { return result.data.has_loads ? std::optional(result.data.metadata.kappa()) : std::nullopt; });
  field("unsheared", "test of the areas without shear against JKR; null if there are none", &Analysis::unsheared);
  field("fits", "a fit for each model", R"({"minItems": 1})", &Analysis::fits);
  field("comparison", "comparison of the models; empty with one model", &Analysis::comparison);
  field("per_curve", "fits of each run by itself, if asked for", &Analysis::per_curve);
}

void describe(Fields<Campaign>& field) {
  field("files", "the whole list of files, as it was given", &Campaign::files);
  field("flags", "flags that decide the results, by name", &Campaign::flags);
}

void describe(Fields<FitDocument>& field) {
  field("schema", "of this document", R"({"const": "mixity-fit-1"})", [](auto&) { return "mixity-fit-1"; });
  field("version", "of mixity", [](auto&) { return MIXITY_VERSION; });
  field("shard", "\"i/n\": this is part i of n", [](const FitDocument& document) {
    const std::string& part = document.shard->part;
    return IfAny<std::string>{part.empty() ? std::nullopt : std::optional(part)};
  });
  field("campaign", "of a part: what all parts share", [](const FitDocument& document) {
    const auto& [part, files, flags] = *document.shard;
    return IfAny<Campaign>{part.empty() ? std::nullopt : std::optional(Campaign{files, flags})};
  });
  field("datasets", "one for each data set", &FitDocument::results);
}

std::string worded(const Message& message, const Within& within) {
  return message.text(within.result ? within.result->request.words : in_neutral_words);
}

std::string json_text(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json fits_document(std::span<const Analysis> results, const Shard& shard) {
  return json_of(FitDocument{results, &shard});
}

std::string to_json(std::span<const Analysis> results, const Shard& shard) {
  return json_text(fits_document(results, shard));
}
std::string to_json(const Analysis& result) { return to_json({&result, 1}); }

Json fits_schema() { return schema_of<FitDocument>(); }

Json request_fields(const FitRequest& request, const Overrides& constants) {
  Json options = Json::object(), laws = Json::object();
  for (const auto& [name, text] : stated_options(request))
    if (name != "models" && name != "bootstrap" && name != "influence" && name != "per" && name != "threads")
      options[name] = text;
  for (const std::string& model : request.models)
    if (const auto law = find_law(model)) laws[model] = law_text(law->definition());
  return {{"constants", json_of(constants)}, {"options", options}, {"models", request.models}, {"laws", laws}};
}

}  // namespace mixity
