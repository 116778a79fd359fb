// The one exception of the library: input that cannot be used, with the place where it was found.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include "base/printable.h"

namespace mixity {

/// 1-based line and column (characters) of a file.
struct FilePlace {
  std::size_t line = 1, column = 1;
};

/// what() reads "file:line:column: message" with 1-based line and column (characters); 0 leaves them out.
/// One printable line, whatever it quotes.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& file, std::size_t line, std::size_t column, const std::string& message)
      : std::runtime_error(printable(place(file, line, column) + message)) {}
  InputError(const std::string& file, FilePlace at, const std::string& message)
      : InputError(file, at.line, at.column, message) {}
  InputError(const std::string& file, const std::string& message) : InputError(file, 0, 0, message) {}

 private:
  static std::string place(const std::string& file, std::size_t line, std::size_t column) {
    std::string text = file;
    if (line > 0) text += ":" + std::to_string(line);
    if (line > 0 && column > 0) text += ":" + std::to_string(column);
    return text + ": ";
  }
};

}  // namespace mixity
