// Messages that recommend options. An option is a flag of the program, a keyword in Python and a field of the page. A
// message therefore stores its recommendations as data, which each interface puts into its own words.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace mixity {

/// Something that the reader of a message can set.
struct Remedy {
  enum class Kind {
    set,         // set these options
    set_or_key,  // set this option, or the key of the same name in the TOML file of the data
    state,       // state these constants, as options or in `file`; the text begins with a colon
    given,       // no recommendation: the option that the message is about; the text ends in a colon
  };
  struct Choice {
    std::string option, value{};  // empty value: only the option is named
    bool placeholder = false;     // the reader has to fill in the value, such as "..."
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

/// Converts a remedy to the words of an interface.
using Wording = std::string (*)(const Remedy& remedy);

/// In the syntax of fit definitions: `free = "modulus"`.
std::string in_neutral_words(const Remedy& remedy);

/// Text with remedies between its parts. Texts and remedies convert to a Message; + joins them.
class Message {
 public:
  Message() = default;
  Message(std::string text) { append(std::move(text)); }
  Message(std::string_view text) : Message(std::string(text)) {}
  Message(const char* text) : Message(std::string(text)) {}
  Message(Remedy remedy) { parts_.emplace_back(std::move(remedy)); }

  bool empty() const { return parts_.empty(); }
  std::string text(Wording words = in_neutral_words) const;
  /// What is recommended, in order.
  std::vector<Remedy> remedies() const;
  /// The recommended options, in order.
  std::vector<std::string> options() const;

  Message& operator+=(const Message& more);
  friend bool operator==(const Message& one, const Message& other) { return one.text() == other.text(); }

 private:
  void append(std::string text);

  std::vector<std::variant<std::string, Remedy>> parts_;
};

inline Message operator+(Message one, const Message& other) { return one += other; }

}  // namespace mixity
