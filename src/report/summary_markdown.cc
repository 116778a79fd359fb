#include "analysis/answer.h"
#include "base/phrases.h"
#include "base/text.h"
#include "report/data_text.h"
#include "report/fit_fields.h"
#include "report/fit_table.h"
#include "report/fit_text.h"
#include "report/report.h"
#include "report/set_table.h"

namespace mixity {
namespace {

/// Escapes text for a table or a line.
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

/// The separator line below the headings of a table with this many columns.
std::string table_rule(std::size_t columns) {
  std::string line = "|";
  for (std::size_t i = 0; i < columns; ++i) line += "---|";
  return line + "\n";
}

std::string marked(const std::string& text) { return escaped(with_powers(text)); }

std::string answer_text(const Answer& answer, const Dataset& data) {
  if (!answer.fit) return {};
  std::string text = "**" + escaped(answer.result) + "**, " + escaped(answer.model) + ".";
  if (!answer.interval.empty()) text += " " + answer.interval + ".";
  if (!answer.doubt.empty()) text += " **" + marked(answer.doubt) + ".**";
  text += "\n\n";
  const auto rows = jump_table(answer, data);
  for (std::size_t i = 0; i < rows.size(); ++i)
    text += with_powers(table_line(rows[i])) + (i == 0 ? table_rule(rows[i].size()) : "");
  if (!rows.empty()) text += "\n";
  for (const std::string& sentence : answer.cannot_say) text += "- " + escaped(sentence) + "\n";
  return answer.cannot_say.empty() ? text : text + "\n";
}

std::string table_text_of(const FitTable& table) {
  std::string text = table_line(table.headings) + table_rule(table.headings.size());
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (const FitTable::Cell& cell : row) {
      const std::string lines = marked(joined(cell.lines, "; "));
      cells.push_back(cell.alert ? "**" + lines + "**" : lines);
    }
    text += table_line(cells);
  }
  return text;
}

std::string data_set_text(const ReportEntry& entry) {
  const Analysis& result = entry.shown->result;
  const Dataset& data = result.data;
  std::string text =
      "## " + escaped(data.title()) + "\n\n**Provenance: " + std::string(to_string(data.metadata.provenance)) + ".**";
  if (const auto meaning = meaning_of(data.metadata.provenance); !meaning.empty()) text += " " + std::string(meaning);
  text += "\n\n" + row_counts(data) + ".\n\n" + answer_text(entry.shown->answer, data);
  for (const std::string& sentence : findings(result)) text += marked(sentence) + "\n";
  if (!findings(result).empty()) text += "\n";
  text += table_text_of(fit_table(result));
  std::string budgets;
  if (result.unsheared) budgets += "- " + marked(unsheared_sentence(*result.unsheared)) + "\n";
  for (const FitResult& fit : result.fits)
    for (const std::string& line : budget_and_consistency(fit, result))
      budgets += "- Model " + fit.model + ": " + marked(line) + "\n";
  if (!budgets.empty()) text += "\nError budget and consistency:\n\n" + budgets;
  text += "\nAssumed:\n\n";
  for (const std::string& assumption : assumptions(result)) text += "- " + escaped(assumption) + "\n";
  return text + "\n";
}

}  // namespace

std::string summary_markdown(const ReportContent& content) {
  std::string text = "# Mode-mixity fits\n\n";
  if (const FitTable sets = set_table(content); !sets.rows.empty()) text += table_text_of(sets) + "\n";
  for (const ReportEntry& entry : content.entries) text += data_set_text(entry);
  std::vector<std::string> made_with;
  for (const auto& [name, version] : versions()) made_with.push_back(name + " " + version);
  return text + "Made by\n\n    " + printable(content.settings.command, std::string::npos) + "\n\nwith " +
         joined(made_with) + ".\n";
}

}  // namespace mixity
