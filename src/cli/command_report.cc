// mixity report: fits, and a report with all their figures and tables.
#include <filesystem>
#include <iostream>

#include "analysis/judgement.h"
#include "analysis/reported_data.h"
#include "analysis/run_all.h"
#include "cli/commands.h"
#include "cli/fit_flags.h"
#include "cli/flags.h"
#include "cli/memory.h"
#include "cli/progress.h"
#include "report/fit_table.h"
#include "report/report.h"

namespace mixity::cli {
namespace {

/// The page of the explorer: in the installation, of an own build (tools/explorer), or of this version; empty if there
/// is none.
std::string explorer() {
  std::error_code unread;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unread);
  if (unread) return {};
  for (const char* place :
       {"../share/mixity/explorer.html", "../../explorer/explorer.html", "../../../docs/explorer.html"})
    if (const auto path = (program.parent_path() / place).lexically_normal();
        std::filesystem::is_regular_file(path, unread))
      return path.string();
  return {};
}

}  // namespace

int run_report(const Arguments& arguments) {
  if (arguments.empty()) throw UsageError("report needs a data CSV or a fit definition (see mixity help report)");
  if (FLAGS_out.empty()) throw UsageError("report needs --out=DIR");
  const Progress progress = progress_line("report");
  constexpr double kFits = 0.7;  // share of the time
  const std::vector<FitRequest> requests = requests_for(arguments);
  const auto one = [](const FitRequest& request, const Progress& part) { return run_for_report(request, part); };
  keep_freed_memory(requests);
  std::vector<Analysis> results = run_all(requests, one, stretch(progress, 0, kFits));
  const std::vector<ReportedData> data = reported_data(results);
  const WrittenReport written = write_report(
      results, data, FLAGS_out, {command_line(), stretch(progress, kFits, 1), explorer(), {{}, FLAGS_force, {}}});
  if (!written.missing.empty()) warn(written.missing);
  std::cout << written.page << '\n';
  for (const Analysis& result : results)
    std::cout << '\n'
              << result.data.name << " (" << to_string(result.data.metadata.provenance) << ")\n"
              << table_text(result);
  bool all_ok = true;
  for (const Analysis& result : results) all_ok &= can_be_believed(result);
  return all_ok ? kFine : kFitNotOk;
}

}  // namespace mixity::cli
