#include "base/message.h"

namespace mixity {

Remedy Remedy::state(const std::vector<std::string>& constants, std::string file) {
  Remedy remedy{Kind::state, {}, std::move(file)};
  for (const std::string& constant : constants) remedy.choices.push_back({constant, "...", true});
  return remedy;
}

std::string in_neutral_words(const Remedy& remedy) {
  if (remedy.kind == Remedy::Kind::given) return remedy.choices[0].option + ": ";
  if (remedy.kind == Remedy::Kind::state)
    return (remedy.choices.size() > 1 ? ": state them" : ": state it") +
           (remedy.file.empty() ? "" : " in " + remedy.file);
  std::string text;
  for (const auto& [option, value, placeholder] : remedy.choices) {
    text += (text.empty() ? "" : ", ") + option;
    if (!value.empty()) text += placeholder ? " = " + value : " = \"" + value + "\"";
  }
  return text;
}

std::string Message::text(Wording words) const {
  std::string text;
  for (const auto& part : parts_)
    text += part.index() == 0 ? std::get<std::string>(part) : words(std::get<Remedy>(part));
  return text;
}

std::vector<Remedy> Message::remedies() const {
  std::vector<Remedy> remedies;
  for (const auto& part : parts_)
    if (const auto* remedy = std::get_if<Remedy>(&part); remedy && remedy->kind != Remedy::Kind::given)
      remedies.push_back(*remedy);
  return remedies;
}

std::vector<std::string> Message::options() const {
  std::vector<std::string> options;
  for (const Remedy& remedy : remedies())
    for (const Remedy::Choice& choice : remedy.choices) options.push_back(choice.option);
  return options;
}

Message& Message::operator+=(const Message& more) {
  for (const auto& part : more.parts_)
    if (const auto* text = std::get_if<std::string>(&part))
      append(*text);
    else
      parts_.push_back(part);
  return *this;
}

void Message::append(std::string text) {
  if (text.empty()) return;
  if (!parts_.empty() && parts_.back().index() == 0)
    std::get<std::string>(parts_.back()) += text;
  else
    parts_.emplace_back(std::move(text));
}

}  // namespace mixity
