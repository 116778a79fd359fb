// The exception for unusable input, with its place in the file.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include "base/message.h"
#include "base/text.h"

namespace mixity {

/// 1-based line and column (in characters) in a file.
struct FilePlace {
  std::size_t line = 1, column = 1;
};

/// The message is one printable line, "file:line:column: what is wrong"; a line or column of 0 is omitted. what() is
/// the message in neutral words.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& file, std::size_t line, std::size_t column, const Message& message)
      : InputError(place(file, line, column) + message) {}
  InputError(const std::string& file, FilePlace at, const Message& message)
      : InputError(file, at.line, at.column, message) {}
  InputError(const std::string& file, const Message& message) : InputError(file, 0, 0, message) {}
  /// An error about an option that was given.
  InputError(const Remedy& given, const Message& message) : InputError(given + message) {}

  std::string text(Wording words) const { return printable(message_.text(words)); }
  const Message& message() const { return message_; }

 private:
  explicit InputError(const Message& message) : std::runtime_error(printable(message.text())), message_(message) {}

  static Message place(const std::string& file, std::size_t line, std::size_t column) {
    std::string text = file;
    if (line > 0) text += ":" + std::to_string(line);
    if (line > 0 && column > 0) text += ":" + std::to_string(column);
    return text + ": ";
  }

  Message message_;
};

}  // namespace mixity
