// What the program reports on data and on the runs of a log, and reports.
#include <limits>

#include "analysis/reported_data.h"
#include "analysis/settings.h"
#include "dataset/logs/reduced_log.h"
#include "python/bindings.h"
#include "python/keyword_words.h"
#include "report/data_check.h"
#include "report/report.h"
#include "report/runs_files.h"

namespace mixity {
namespace {

/// Not the vector itself, which would become a list.
struct Reduction {
  ReducedLogs logs;
  std::string cuts_path;
};

/// Writes a definition, unless `path` is null.
void save_definition(const std::vector<UnderstoodFile>& understood, const std::optional<std::string>& path, bool force,
                     const std::vector<std::string>& inputs) {
  if (!path) return;
  if (!path->ends_with(".toml")) throw InputError("save", "is '" + *path + "'; it must end in .toml");
  std::vector<OutputFile> files{{*path, definition_text(understood, *path, in_keywords)}};
  keep_former(files);
  write_files(files, {inputs, force, {}});
}

std::string checked_files(const std::vector<std::string>& paths, const Stated& constants,
                          const std::optional<std::string>& save, bool force, const Contents& made) {
  const std::vector<InputFile> given = inputs_of(made);
  const Released released;
  std::vector<std::string> read;
  const auto load = [&](const Overrides& with) {
    Inputs inputs(given, Inputs::Others::from_disk);
    Dataset data = load_files(paths, with, inputs);
    for (const InputFile& one : inputs.files()) read.push_back(one.path);
    return data;
  };
  read = paths;
  for (const std::string& path : paths) read.push_back(metadata_path(path));
  const CheckedData found = check_data(load, constants, in_keywords);
  save_definition({found.file}, save, force, read);
  return found.text;
}

std::string checked_data(const Dataset& data, const std::optional<std::string>& save, bool force) {
  const Released released;
  const CheckedData found = check_data([&](const Overrides&) { return data; }, {}, in_keywords);
  std::vector<std::string> inputs;
  for (const InputFile& one : data.inputs) inputs.push_back(one.path);
  save_definition({found.file}, save, force, inputs);
  return found.text;
}

FigureFormats formats_of(const std::string& text) {
  FitRequest request;
  if (text.empty()) return request.formats;
  if (const std::string problem = set_option(request, "formats", text); !problem.empty())
    throw InputError("formats", problem);
  return request.formats;
}

/// The page as text; with a folder, writes the report and returns what could not be drawn.
std::string report(const std::vector<std::pair<Dataset*, Stated>>& fits, const std::optional<std::string>& folder,
                   const std::string& formats, bool force, const nb::object& progress) {
  std::vector<FitRequest> requests;
  for (const auto& [data, options] : fits) {
    requests.push_back(request_of(*data, options));
    requests.back().formats = formats_of(formats);
  }
  Watch watch(progress);
  const nb::gil_scoped_release released;
  const Progress whole = [&](double share) { watch(share); };
  constexpr double kFits = 0.7;  // share of the time
  const double share = kFits / static_cast<double>(fits.size());
  std::vector<Analysis> results;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const auto before = static_cast<double>(i);
    results.push_back(
        run_for_report(requests[i], *fits[i].first, stretch(whole, share * before, share * (before + 1))));
  }
  const std::vector<ReportedData> data = reported_data(results);
  ReportSettings settings{"mixity.report(fits)", stretch(whole, kFits, 1), {}, {{}, force, {}}};
  if (folder) return write_report(results, data, *folder, settings).missing;
  settings.most_inside = std::numeric_limits<std::size_t>::max();
  return std::move(report_files(results, data, "", settings).files.back().content);
}

nb::dict shown_cut(const CutTime& cut) {
  nb::dict one;
  one["time"] = cut.time;
  one["low"] = cut.low;
  one["high"] = cut.high;
  one["stated"] = cut.stated;
  return one;
}

nb::dict shown(const LoadingRun& run) {
  nb::dict one;
  one["name"] = run.name;
  one["P"] = run.P;
  one["P_scatter"] = run.scatter_P;
  one["T_zero"] = run.baseline;
  one["T_noise"] = run.noise_T;
  one["frames"] = run.end - run.begin;
  one["shear"] = shown_cut(run.shear);
  one["sliding"] = run.onset ? nb::object(shown_cut(*run.onset)) : nb::object(nb::none());
  return one;
}

}  // namespace

void bind_reports(nb::module_& m) {
  m.def("checked_files", &checked_files, nb::arg(), nb::arg(), nb::arg().none(), nb::arg(), nb::arg());
  m.def("checked_data", &checked_data, nb::arg(), nb::arg().none(), nb::arg());
  m.def("report", &report, nb::arg(), nb::arg().none(), nb::arg(), nb::arg(), nb::arg().none());
  nb::class_<Reduction>(m, "ReducedLog")
      .def("csv", [](const Reduction& of) { return runs_csv(of.logs); })
      .def("toml", [](const Reduction& of) { return runs_toml(of.logs); })
      .def("peaks", [](const Reduction& of) { return peaks_csv(of.logs); })
      .def("phases", [](const Reduction& of) { return phases_csv(of.logs); })
      .def("text", [](const Reduction& of) { return runs_text(of.logs, in_keywords); })
      .def("save",
           [](const Reduction& of, const std::string& folder, const std::string& formats, bool force,
              const std::vector<std::string>& inputs) {
             const FigureFormats wanted = formats_of(formats);
             const Released released;
             RunsOutput output = runs_output(of.logs, folder, wanted, of.cuts_path, in_keywords);
             keep_former(output.files);
             std::vector<std::string> read = inputs;
             for (const std::string& path : inputs) read.push_back(metadata_path(path));
             write_files(output.files, {read, force, {folder + "/figures"}});
             return output.missing;
           })
      .def("save_definition",
           [](const Reduction& of, const std::string& path, bool force, const std::vector<std::string>& inputs) {
             const Released released;
             std::vector<std::string> read = inputs;
             for (const std::string& one : inputs) read.push_back(metadata_path(one));
             save_definition(understood(of.logs), path, force, read);
           })
      .def("runs", [](const Reduction& of) {
        nb::list all;
        for (const ReducedLog& log : of.logs)
          for (const LoadingRun& run : log.runs.runs) all.append(shown(run));
        return all;
      });
  m.def(
      "runs",
      [](const std::vector<std::string>& paths, const Stated& constants, std::optional<double> lag,
         std::optional<bool> drift, const std::string& cuts, const Contents& made) {
        const Inputs inputs(inputs_of(made), Inputs::Others::from_disk);
        const Released released;
        ReducedLogs logs = reduce_logs(paths, constants, {lag, drift, cuts, inputs});
        if (has_no_run(logs)) refuse_without_runs(paths[0]);
        return Reduction{std::move(logs), cuts};
      },
      nb::arg(), nb::arg(), nb::arg().none(), nb::arg().none(), nb::arg(), nb::arg());
}

}  // namespace mixity
