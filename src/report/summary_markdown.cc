#include "report/summary_markdown.h"

#include "analysis/answer.h"
#include "base/text.h"
#include "report/budget_text.h"
#include "report/fit_table.h"
#include "report/versions.h"

namespace mixity {
namespace {

/// Foreign text within a table or a line.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '*' || c == '_' || c == '`' || c == '<' || c == '\\') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

std::string table_line(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

std::string data_set(const ReportEntry& entry) {
  const Analysis& result = entry.data->result;
  const Dataset& data = result.data;
  std::string text =
      "## " + escaped(data.name) + "\n\n**Provenance: " + std::string(to_string(data.metadata.provenance)) + ".**";
  if (data.metadata.provenance == Provenance::reconstructed) text += " " + std::string(kReconstructedNotice);
  text += "\n\n" + std::to_string(data.rows) + " data rows, " + std::to_string(data.points.size()) + " used, " +
          std::to_string(data.excluded.size()) + " excluded.\n\n";
  const Answer& answer = entry.answer;
  if (answer.fit) {
    text += "**" + escaped(answer.result) + "**, " + escaped(answer.model) + ".";
    if (!answer.interval.empty()) text += " " + answer.interval + ".";
    if (!answer.doubt.empty()) text += " **" + escaped(with_powers(answer.doubt)) + ".**";
    text += "\n\n";
    const auto rows = jump_table(answer, data);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      std::vector<std::string> cells;
      for (const std::string& cell : rows[i]) cells.push_back(with_powers(cell));
      text += table_line(cells) + (i == 0 ? "|---|---|---|---|\n" : "");
    }
    if (!rows.empty()) text += "\n";
    for (const std::string& sentence : answer.cannot_say) text += "- " + escaped(sentence) + "\n";
    if (!answer.cannot_say.empty()) text += "\n";
  }
  for (const std::string& sentence : findings(result)) text += escaped(with_powers(sentence)) + "\n";
  if (!findings(result).empty()) text += "\n";
  const FitTable table = fit_table(result);
  text += table_line(table.headings) + "|";
  for (std::size_t i = 0; i < table.headings.size(); ++i) text += "---|";
  text += "\n";
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (const FitTable::Cell& cell : row) {
      std::string joined;
      for (const std::string& line : cell.lines) joined += (joined.empty() ? "" : "; ") + escaped(with_powers(line));
      cells.push_back(cell.alert ? "**" + joined + "**" : joined);
    }
    text += table_line(cells);
  }
  std::string budgets;
  if (result.unsheared) budgets += "- " + escaped(with_powers(unsheared_sentence(*result.unsheared))) + "\n";
  for (const FitResult& fit : result.fits)
    for (const std::string& line : budget_and_consistency(fit, result))
      budgets += "- Model " + fit.model + ": " + escaped(with_powers(line)) + "\n";
  if (!budgets.empty()) text += "\nError budget and consistency:\n\n" + budgets;
  text += "\nAssumed:\n\n";
  for (const std::string& assumption : assumptions(result)) text += "- " + escaped(assumption) + "\n";
  text += "\n";
  return text;
}

}  // namespace

std::string summary_markdown(const ReportContent& content) {
  std::string text = "# Mode-mixity fits\n\n";
  for (const ReportEntry& entry : content.entries) text += data_set(entry);
  text += "Made by\n\n    " + printable(content.settings.command, std::string::npos) + "\n\nwith";
  std::string separator = " ";
  for (const auto& [name, version] : versions()) {
    text += separator + name + " " + version;
    separator = ", ";
  }
  return text + ".\n";
}

}  // namespace mixity
