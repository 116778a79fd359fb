#include "report/page/answer_section.h"

#include "base/number_text.h"
#include "report/fit_table.h"
#include "report/page/document.h"

namespace mixity {
namespace {

std::string percent(double share) { return rounded(100 * share, share < 0.1 ? 1 : 2) + " %"; }

/// Parts of the variance as one bar with its words below it.
void add_budget(pugi::xml_node parent, const Answer& answer) {
  if (answer.budget.empty()) return;
  pugi::xml_node box = add(parent, "div", {}, "budget");
  add(box, "p", "Where the variance comes from", "soft");
  pugi::xml_node bar = add(box, "div", {}, "bar");
  bar.append_attribute("aria-hidden").set_value("true");
  pugi::xml_node words = add(box, "p", {}, "key");
  std::size_t number = 0;
  for (const auto& [name, share] : answer.budget) {
    const std::string paint = "--part:var(--color-" + std::to_string(1 + number++ % 7) + ")";
    add(bar, "span").append_attribute("style").set_value((paint + ";flex:" + rounded(share, 4)).c_str());
    pugi::xml_node word = add(words, "span", name + " " + percent(share));
    word.append_attribute("style").set_value(paint.c_str());
    add_text(words, " ");
  }
}

void add_jumps(pugi::xml_node parent, const Answer& answer, const Dataset& data) {
  const auto rows = jump_table(answer, data);
  if (rows.empty()) return;
  pugi::xml_node body = add_table(parent, "jumps", rows.front(),
                                  "Where the contact jumps under a tangential load, ± one standard error");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    pugi::xml_node line = add(body, "tr");
    for (const std::string& cell : rows[i]) add(line, "td", cell);
  }
}

}  // namespace

void add_answer(pugi::xml_node section, const Answer& answer, const Dataset& data,
                const std::function<void(pugi::xml_node)>& add_figure) {
  if (!answer.fit) {
    add(section, "p", "No fit has a value: see All models.", "alert");
    return;
  }
  pugi::xml_node box = add(section, "div", {}, "answer");
  pugi::xml_node words = add(box, "div");
  add(words, "p", answer.result, "result");
  add(words, "p", answer.model);
  if (!answer.interval.empty()) add(words, "p", answer.interval);
  if (!answer.doubt.empty()) add(words, "p", with_powers(answer.doubt) + ".", "alert");
  add_budget(words, answer);
  add_jumps(words, answer, data);
  add_figure(box);
  if (answer.cannot_say.empty()) return;
  add(section, "h3", "What these data cannot say");
  add_list(section, answer.cannot_say);
}

}  // namespace mixity
