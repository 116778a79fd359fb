#include "analysis/settings.h"

#include <stdexcept>

#include "analysis/laws.h"
#include "analysis/setting_forms.h"
#include "base/nearest_name.h"
#include "mechanics/contact_model.h"

namespace mixity {
namespace {

// Where a value is stored in a request.
struct WholeRequest {};
auto& part(auto& request, WholeRequest) { return request; }
template <class Value>
auto& part(auto& request, Value FitRequest::*member) {
  return request.*member;
}
template <class Value>
auto& part(auto& request, Value FitOptions::*member) {
  return request.options.*member;
}
template <class Value>
auto& part(auto& request, Value BootstrapOptions::*member) {
  return request.options.bootstrap.*member;
}
template <class Value>
auto& part(auto& request, Value Exclusion::*member) {
  return request.exclusion.*member;
}

template <class Form>
Setting setting(std::string name, auto member, Form form, std::string help) {
  return {std::move(name), std::move(help), std::is_same_v<Form, Switch>,
          [=](std::string_view text, FitRequest& request) { return form.read(text, part(request, member)); },
          [=](const FitRequest& request) { return form.write(part(request, member)); }};
}

struct Model : Name {
  static Complaint read(const std::string& model, std::vector<std::string>& models) {
    provide_law(model);
    if (is_model(model)) return Name::read(model, models);
    return "names the unknown model " + in_quotes(model) + known_names(model, known_models());
  }
};

struct Objectives {
  static Complaint read(std::string_view text, std::optional<Objective>& objective) {
    if (text == "area") return "is 'area'; " + std::string(kNoAreaObjective);
    objective = parse_objective(text);
    return objective ? Complaint() : must_be(text, "toughness or curve");
  }
  static std::string write(const std::optional<Objective>& objective) {
    return objective ? std::string(to_string(*objective)) : "";
  }
};

struct Held {
  static Complaint read(std::string_view text, std::vector<HeldParameter>& hold) {
    hold.clear();
    return for_each_item(split_assignments(text), [&](const std::string& item) { return read_one(item, hold); });
  }
  static Complaint read_one(const std::string& item, std::vector<HeldParameter>& hold) {
    const auto held = parse_held(item);
    const std::string meant = held ? "" : two_readings(item.substr(item.find('=') + 1));
    if (!held || parse_number(item))
      return "has " + in_quotes(item) +
             (meant.empty() ? ", which is neither a parameter nor PARAMETER=NUMBER" : "; write " + meant);
    if (std::any_of(hold.begin(), hold.end(), [&](const HeldParameter& other) { return other.name == held->name; }))
      return "names " + in_quotes(held->name) + " twice";
    return hold.push_back(*held), Complaint();
  }
  static std::string write_one(const HeldParameter& held) {
    return held.name + (held.value ? "=" + shortest(*held.value) : "");
  }
  static std::string write(const std::vector<HeldParameter>& hold) { return joined(texts_of(hold, write_one), ","); }
};

/// What the couplings of elliptic contacts have in common.
struct Tie {
  static Complaint read(std::string_view text, FitRequest& request) {
    if (text == "equal") return request.equal_couplings = true, Complaint();
    const auto held = parse_held(std::string(text));
    if (!held || !held->value) return must_be(text, "equal, or PARAMETER=NUMBER, such as lambda_III=0");
    request.tied = *held;
    return {};
  }
  static std::string write(const FitRequest& request) {
    return request.equal_couplings ? "equal" : request.tied ? Held::write_one(*request.tied) : "";
  }
};

/// Constants of the experiment. Parameters of models may also be named; they are free unless held.
struct Free {
  static Complaint read(std::string_view text, FitRequest& request) {
    request.options.free.clear();
    request.free_parameters.clear();
    return for_each_item(split(text), [&](const std::string& name) -> Complaint {
      const auto found = std::find(kConstantNames.begin(), kConstantNames.end(), name);
      if (found != kConstantNames.end())
        request.options.free.push_back(static_cast<Constant>(found - kConstantNames.begin()));
      else if (has_parameter(model_keys(), name))
        request.free_parameters.push_back(name);
      else
        return "names " + in_quotes(name) + ", which cannot be fitted" +
               known_names(name, {kConstantNames.begin(), kConstantNames.end()}, "model parameters");
      return {};
    });
  }
  static std::string write(const FitRequest& request) {
    std::vector<std::string> names;
    for (const Constant constant : request.options.free) names.emplace_back(kConstantNames[constant]);
    names.insert(names.end(), request.free_parameters.begin(), request.free_parameters.end());
    return joined(names, ",");
  }
};

/// Constants whose drift is fitted.
struct Drift {
  static Complaint read(const std::string& name, std::vector<Constant>& drift) {
    if (name != "modulus" && name != "toughness")
      return "names " + in_quotes(name) + ", which has no drift" + known_names(name, {"modulus", "toughness"});
    drift.push_back(name == "modulus" ? kModulus : kToughness);
    return {};
  }
  static std::string write(Constant constant) { return std::string(kConstantNames[constant]); }
};

/// A quantity that may differ from run to run.
struct RunQuantity {
  static Complaint read(const std::string& name, std::vector<std::string>& names) {
    const auto found = std::find(kConstantNames.begin(), kConstantNames.end(), name);
    const bool constant = found != kConstantNames.end() && !is_change(name);
    if (!constant && !has_parameter(model_keys(), name))
      return "names " + in_quotes(name) + ", which cannot differ from run to run" +
             known_names(name, {kConstantNames.begin(), kConstantNames.begin() + kModulusDrift}, "model parameters");
    return names.push_back(name), Complaint();
  }
  static std::string write(const std::string& name) { return name; }
};

struct Lines {
  static Complaint read(const std::string& item, std::vector<LineRange>& lines) {
    const auto range = parse_lines(item);
    if (!range) return "has " + in_quotes(item) + ", which is neither a line of the file nor lines such as 40-58";
    return lines.push_back(*range), Complaint();
  }
  static std::string write(const LineRange& range) {
    return (range.file.empty() ? "" : range.file + ":") + std::to_string(range.first) +
           (range.last == range.first ? "" : "-" + std::to_string(range.last));
  }
};

/// Names with commas come in parts, which may repeat ("0,5 mN, 1,5 mN"); exclude() knows the runs and joins the parts.
struct Runs {
  static Complaint read(std::string_view text, std::vector<std::string>& runs) {
    runs.clear();
    for (const std::string_view name : split(text)) {
      if (name.empty()) return "has an empty entry at position " + std::to_string(runs.size() + 1);
      runs.emplace_back(name);
    }
    return {};
  }
  static std::string write(const std::vector<std::string>& runs) { return joined(runs, ","); }
};

struct Formats {
  static Complaint read(std::string_view text, FigureFormats& formats) {
    FigureFormats wanted;
    if (text != "none") {
      Complaint problem = for_each_item(split(text), [&](const std::string& name) -> Complaint {
        if (name != "pdf" && name != "png" && name != "gnuplot")
          return "names the unknown format " + in_quotes(name) + known_names(name, {"pdf", "png", "gnuplot", "none"});
        (name == "pdf" ? wanted.pdf : name == "png" ? wanted.png : wanted.gnuplot) = true;
        return {};
      });
      if (!problem.empty()) return problem;
    }
    formats = wanted;
    return {};
  }
  static std::string write(const FigureFormats& formats) {
    std::vector<std::string> names;
    if (formats.pdf) names.emplace_back("pdf");
    if (formats.png) names.emplace_back("png");
    if (formats.gnuplot) names.emplace_back("gnuplot");
    return names.empty() ? "none" : joined(names, ",");
  }
};

}  // namespace

const std::vector<Setting>& settings() {
  constexpr std::uint64_t kMostReplicates = 10000000, kMostThreads = 4096,
                          kMostSeed = std::numeric_limits<std::int64_t>::max();
  static const std::vector<Setting> all{
      setting("models", &FitRequest::models, ListOf<Model>{},
              "models to fit, comma-separated (mixity help lists them); KEY-ellipse has elliptic contacts"),
      setting("objective", &FitOptions::objective, Objectives{},
              "what is fitted: curve (distance from the curve in T and A; the default where there are loads) or "
              "toughness (Gc/GIc against psi, as the paper does)"),
      setting("scale", &FitOptions::scale, Choice<Scale>{{Scale::log, Scale::linear}},
              "objective toughness: fit ln(Gc/GIc) (log) or Gc/GIc (linear)"),
      setting("weighted", &FitOptions::weighted, Switch{},
              "objective toughness: weight each point by its standard error"),
      setting("sigma_T", &FitOptions::sigma_T, ErrorSize{},
              "standard error of T for all points: \"0.5%\", or \"0.2 mN\""),
      setting("sigma_A", &FitOptions::sigma_A, ErrorSize{},
              "standard error of A for all points: \"1%\", or \"0.002 mm^2\""),
      setting("sigma_factor", &FitOptions::free_sigma_factor, Word{"free", "1"},
              "1: stated errors are as stated; free: they are right up to one common factor, which the scatter tells"),
      setting("fitted_errors", &FitOptions::fitted_errors, Switch{},
              "curve: errors at the fitted curve, estimated with it where none are stated; false: at the readings, "
              "independent, as ODRPACK takes them"),
      setting(
          "loss", &FitOptions::loss, Choice<Loss>{{Loss::none, Loss::huber, Loss::cauchy, Loss::t}},
          "none, or a loss that limits the influence of outliers: huber, cauchy, or t, from 20 points on, Student's "
          "likelihood, which is fitted with the rest"),
      setting("loss_scale", &FitOptions::loss_scale, PositiveNumber{},
              "residual beyond which points are down-weighted, in standard errors (default 1.345 huber, 2.385 cauchy)"),
      setting("hold", &FitOptions::hold, Held{},
              "parameters to hold fixed, comma-separated: NAME=VALUE, or NAME for the data set's own value"),
      setting("tie", WholeRequest{}, Tie{},
              "elliptic contacts: equal (one coupling for modes II and III), or one of them at a value: lambda_III=0"),
      setting(
          "free", WholeRequest{}, Free{},
          "constants to fit as well, common to all loads: toughness, modulus, radius, area_scale, force_gain, "
          "load_offset, shear_offset, area_offset, approach_offset, modulus_drift, toughness_drift, shape, hysteresis"),
      setting("by_run", &FitOptions::by_run, ListOf<RunQuantity>{},
              "what differs from run to run by chance: toughness, modulus, area_scale, load_offset, lambda; its spread "
              "is fitted"),
      setting("drift", &FitRequest::drift, ListOf<Drift>{},
              "what changes in the order of the runs: modulus, toughness; the change is fitted"),
      setting("unsheared", &Exclusion::unsheared, Choice<Unsheared>{{Unsheared::in, Unsheared::own, Unsheared::out}},
              "points without shear: in, own (with a toughness of their own) or out"),
      setting("exclude", &Exclusion::lines, ListOf<Lines>{}, "lines of the data file to leave out: \"17,40-58\""),
      setting("leave_out", &Exclusion::runs, Runs{}, "runs to leave out, by name or load: \"4.68 mN\""),
      setting("interval", &FitOptions::intervals, Word{"profile", "none"}, "confidence intervals: profile or none"),
      setting("confidence", &FitOptions::confidence, PositiveNumber{1}, "confidence of intervals, above 0 and below 1"),
      setting("checks", &FitOptions::checks, Switch{},
              "test the consistency of each fit and compute its evidence; without checks no fit is suspect"),
      setting("lambda_prior", &FitOptions::lambda_prior,
              Choice<RangePrior>{{RangePrior::uniform, RangePrior::log_uniform}},
              "prior of lambda for evidence and credible interval: uniform or log_uniform"),
      setting("lambda_prior_from", &FitOptions::lambda_prior_from, PositiveNumber{1},
              "where a log-uniform prior of lambda begins (default 1e-6 of the largest lambda)"),
      setting("bootstrap", &BootstrapOptions::replicates, Whole{kMostReplicates},
              "refits of resampled points for bootstrap intervals"),
      setting("resample", &BootstrapOptions::resample, Choice<Resample>{{Resample::points, Resample::curves}},
              "what the bootstrap resamples: points within their runs, or whole runs (curves)"),
      setting("seed", &BootstrapOptions::seed, Whole{kMostSeed}, "seed of the bootstrap"),
      setting("threads", &BootstrapOptions::threads, Whole{kMostThreads},
              "threads for bootstrap and influence (0: one per processor)"),
      setting("influence", &FitOptions::influence, Switch{},
              "compute how much each point and each run moves the fit: jackknife, leverage, Cook's distance"),
      setting("compare", &FitRequest::compare, Switch{},
              "compare the models: AICc, weights, error on loads left out of the fit"),
      setting("per", &FitRequest::per_curve, Word{"curve", ""},
              "curve: also fit each run separately, and test whether one value describes all runs"),
      setting(
          "formats", &FitRequest::formats, Formats{},
          "further formats of the figures, made by gnuplot: pdf, png, gnuplot (script and data), comma-separated, or "
          "none"),
  };
  return all;
}

std::string set_option(FitRequest& request, std::string_view name, std::string_view text) {
  for (const Setting& one : settings()) {
    if (one.name != name) continue;
    std::string problem = one.read(text, request);
    if (problem.empty()) request.stated.insert(one.name);
    return problem;
  }
  throw std::invalid_argument("there is no option '" + std::string(name) + "'" +
                              known_names(name, texts_of(settings(), &Setting::name)));
}

std::vector<std::pair<std::string, std::string>> stated_options(const FitRequest& request) {
  std::vector<std::pair<std::string, std::string>> list;
  for (const Setting& one : settings())
    if (request.stated.contains(one.name)) list.emplace_back(one.name, one.write(request));
  std::sort(list.begin(), list.end());
  return list;
}

namespace {

std::string no_parameter(const std::string& name, const std::vector<std::string>& models) {
  std::vector<std::string> known;
  for (const std::string& key : models)
    if (const auto model = ContactModel::find(key))
      for (const ParameterInfo& parameter : model->parameters())
        if (std::find(known.begin(), known.end(), parameter.name) == known.end()) known.emplace_back(parameter.name);
  return "names " + in_quotes(name) + ", which no fitted model has" + known_names(name, known);
}

}  // namespace

std::optional<Contradiction> contradiction(const FitRequest& request) {
  const FitOptions& options = request.options;
  const auto curve = Objective::curve, toughness = Objective::toughness;
  for (const HeldParameter& held : options.hold) {
    if (!has_parameter(request.models, held.name))
      return Contradiction{"hold", no_parameter(held.name, request.models)};
    if (std::find(request.free_parameters.begin(), request.free_parameters.end(), held.name) !=
        request.free_parameters.end())
      return Contradiction{"free", "names " + in_quotes(held.name) + ", which is to be held"};
  }
  if (request.stated.contains("tie") && std::none_of(request.models.begin(), request.models.end(), is_elliptic))
    return Contradiction{"tie", "needs elliptic contacts (shape=ellipse)"};
  if (request.tied && !has_parameter(request.models, request.tied->name))
    return Contradiction{"tie", no_parameter(request.tied->name, request.models)};
  for (const std::string& name : request.free_parameters)
    if (!has_parameter(request.models, name)) return Contradiction{"free", no_parameter(name, request.models)};
  if (options.scale && options.objective == curve) return Contradiction{"scale", "needs objective=toughness"};
  if (options.weighted && options.objective == curve)
    return Contradiction{"weighted", "needs objective=toughness; curve weighs the points anyway"};
  if ((options.sigma_T || options.sigma_A) && options.objective == toughness && !options.weighted)
    return Contradiction{options.sigma_A ? "sigma_A" : "sigma_T", "needs objective=curve, or weighted"};
  if (options.free_sigma_factor && options.objective == toughness && !options.weighted)
    return Contradiction{"sigma_factor", "needs objective=curve, or weighted"};
  if (options.loss == Loss::t && request.per_curve)
    return Contradiction{"loss",
                         "cannot be t with per=curve, since each run would have its own t; use huber or cauchy"};
  if (options.loss_scale && (options.loss == Loss::none || options.loss == Loss::t))
    return Contradiction{"loss_scale", "needs loss=huber or cauchy"};
  if (options.lambda_prior_from && options.lambda_prior != RangePrior::log_uniform)
    return Contradiction{"lambda_prior_from", "needs lambda_prior=log_uniform"};
  const bool resampled = options.bootstrap.replicates > 0;
  for (const char* name : {"resample", "seed"})
    if (request.stated.contains(name) && !resampled) return Contradiction{name, "needs bootstrap"};
  if (request.stated.contains("threads") && !resampled && !options.influence)
    return Contradiction{"threads", "needs bootstrap or influence"};
  if (request.stated.contains("confidence") && !options.intervals && !resampled)
    return Contradiction{"confidence", "needs interval=profile, or bootstrap"};
  return std::nullopt;
}

}  // namespace mixity
