// Messages that recommend options. An option is a flag of the program, a keyword in Python and a field of the page. A
// message therefore stores its recommendations as data, and each of these interfaces puts them into its own words.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace mixity {

/// What the reader of a message can set.
struct Remedy {
  enum class Kind {
    set,         // set these options
    set_or_key,  // set this option, or the key of the same name in the TOML file of the data
    state,       // state these constants, as options or in `file`; its text begins with a colon
    given,       // no recommendation: the option that the message is about; its text ends in a colon
  };
  struct Choice {
    std::string option, value{};  // an empty value: only the option is named
    bool placeholder = false;     // the value, such as "...", is to be filled in by the reader
  };
  Kind kind;
  std::vector<Choice> choices;
  std::string file{};

  static Remedy set(std::string option, std::string value = {}) {
    return {Kind::set, {{std::move(option), std::move(value)}}};
  }
  static Remedy fill_in(std::string option, std::string value = "...") {
    return {Kind::set, {{std::move(option), std::move(value), true}}};
  }
  static Remedy set_or_key(std::string option, std::string value) {
    return {Kind::set_or_key, {{std::move(option), std::move(value)}}};
  }
  static Remedy state(const std::vector<std::string>& constants, std::string file);
  static Remedy given(std::string option) { return {Kind::given, {{std::move(option)}}}; }
};

/// Puts a remedy into the words of an interface.
using Wording = std::string (*)(const Remedy& remedy);

/// As a fit definition states options: `free = "modulus"`.
std::string in_neutral_words(const Remedy& remedy);

/// Text with remedies between its parts. Texts and remedies convert to it; + joins.
class Message {
 public:
  Message() = default;
  Message(std::string text) { append(std::move(text)); }
  Message(std::string_view text) : Message(std::string(text)) {}
  Message(const char* text) : Message(std::string(text)) {}
  Message(Remedy remedy) { parts_.emplace_back(std::move(remedy)); }

  bool empty() const { return parts_.empty(); }
  std::string text(Wording words = in_neutral_words) const;
  /// The options that are recommended, in order.
  std::vector<std::string> options() const;

  Message& operator+=(const Message& more);
  friend bool operator==(const Message& one, const Message& other) { return one.text() == other.text(); }

 private:
  void append(std::string text);

  std::vector<std::variant<std::string, Remedy>> parts_;
};

inline Message operator+(Message one, const Message& other) { return one += other; }

}  // namespace mixity
