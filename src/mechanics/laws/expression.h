// An expression given as text, with exact derivatives: ExprTk (A. Partow, MIT licence) on Taylor numbers. Only
// arithmetic and elementary functions are allowed: no assignment, local variable, loop, condition or string.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/laws/taylor.h"

namespace mixity {

/// Why a text or a definition is invalid, and at which character of the text (from 0) if the error is there.
struct LawError {
  std::optional<std::size_t> at;
  std::string message;
};

/// Functions that an expression may call: sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log (natural), sqrt,
/// abs, min, max. Also the constant pi.
const std::vector<std::string>& expression_functions();

/// Whether names may contain this character: letters, digits and underscores.
bool is_name_character(char c);

/// Whether a variable may have this name: a letter, then letters, digits and underscores; not a word of ExprTk.
bool is_variable_name(std::string_view name);

/// Not thread-safe: an evaluation writes to the expression's own variables.
class Expression {
 public:
  static constexpr std::size_t kLongest = 1000;  // characters
  static constexpr std::size_t kDeepest = 60;    // brackets in brackets

  /// The names must satisfy is_variable_name. Construction takes about 20 microseconds.
  Expression(std::string_view text, const std::vector<std::string>& variables);
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;
  ~Expression();

  /// Null if the expression can be evaluated.
  const std::optional<LawError>& error() const { return error_; }

  /// The value at these variables, one for each name. Where a function is not defined, any number or NaN.
  Taylor operator()(std::span<const Taylor> variables) const;

 private:
  struct Compiled;
  std::unique_ptr<Compiled> compiled_;
  std::optional<LawError> error_;
};

}  // namespace mixity
