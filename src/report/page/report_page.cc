#include "base/phrases.h"
#include "base/text.h"
#include "report/figures/svg_text.h"
#include "report/page/data_set_section.h"
#include "report/page/document.h"
#include "report/report.h"
#include "report/set_table.h"

namespace mixity {
namespace {

std::string reproduction(const std::string& command) {
  std::string tables = "Beside this page: ";
  for (const char* file : {"results.json", "fits.csv", "residuals.csv", "curves.csv", "summary.md"})
    tables += link_to(file, file) + " ";
  return text_element("h2", "To make this report again") +
         element("p", text_element("code", printable(command, std::string::npos))) + definitions_of(versions()) +
         element("p", tables, {{"class", "files"}});
}

}  // namespace

std::string report_page(const ReportContent& content) {
  std::vector<std::string> targets;
  std::string sections;
  for (const ReportEntry& entry : content.entries) {
    targets.push_back("#" + entry.shown->stem);
    sections += data_set_section(content, entry);
  }
  const bool inside = content.figures_inside, alone = targets.size() == 1;
  const std::string title = alone ? content.entries[0].shown->result.data.title() : counted(targets.size(), "data set");
  std::string header =
      text_element("h1", title) + text_element("p", "Mode-mixity fits by mixity " MIXITY_VERSION, "soft");
  if (!inside)
    header += text_element("p", "The figures lie in the folder figures beside this page" +
                                    std::string(alone ? "" : " and are shown where a data set is opened") +
                                    ": keep both together. All else is in the page.");
  if (!content.settings.explorer.empty())
    header += element("p",
                      link_to("explorer.html", "Explore these data in the browser") +
                          ": other constants, other loads, points left out, a file of your own.",
                      {{"class", "files"}});
  if (!content.drawn.missing.empty()) header += text_element("p", content.drawn.missing, "banner");
  if (!alone) header += table_of_cells(set_table(content), targets);
  return html_page(
      title,
      element("header", header) + element("main", sections) + element("footer", reproduction(content.settings.command)),
      inside ? Images::none : Images::of_files_beside);
}

}  // namespace mixity
