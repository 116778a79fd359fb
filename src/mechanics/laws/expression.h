// An expression that somebody typed, with exact derivatives: ExprTk (A. Partow, MIT licence) on Taylor numbers. Of what
// ExprTk knows, arithmetic and the elementary functions are left: no assignment, no variable of its own, no loop, no
// condition, no text.
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

/// Why a text is no expression, and at which of its characters, counted from 0.
struct ExpressionError {
  std::size_t at;
  std::string message;
};

/// Functions that an expression may call: sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log (natural), sqrt,
/// abs, min, max. Also the constant pi.
const std::vector<std::string>& expression_functions();

/// Whether a variable may have this name: a letter, then letters, digits and underscores, and none of ExprTk's words.
bool is_variable_name(std::string_view name);

/// Cheap to keep, not to share between threads: it is evaluated on variables of its own.
class Expression {
 public:
  static constexpr std::size_t kLongest = 1000;  // characters
  static constexpr std::size_t kDeepest = 60;    // brackets in brackets

  /// Of variables with these names, each of which is_variable_name. Costs some 20 microseconds.
  Expression(std::string_view text, const std::vector<std::string>& variables);
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;
  ~Expression();

  /// Null: it can be evaluated.
  const std::optional<ExpressionError>& error() const { return error_; }

  /// Of as many variables as there are names. May be anything, such as NaN, where a function is not defined.
  Taylor operator()(std::span<const Taylor> variables) const;

 private:
  struct Compiled;
  std::unique_ptr<Compiled> compiled_;
  std::optional<ExpressionError> error_;
};

}  // namespace mixity
