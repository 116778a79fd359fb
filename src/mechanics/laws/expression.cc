#include "mechanics/laws/expression.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <mutex>

#define exprtk_disable_break_continue
#define exprtk_disable_comments
#define exprtk_disable_caseinsensitivity
#define exprtk_disable_enhanced_features
#define exprtk_disable_return_statement
#define exprtk_disable_rtl_io
#define exprtk_disable_rtl_io_file
#define exprtk_disable_rtl_vecops
#define exprtk_disable_sc_andor
#define exprtk_disable_string_capabilities
#define exprtk_disable_superscalar_unroll

#include "mechanics/laws/taylor.h"

namespace exprtk::details {
inline bool is_true(const mixity::Taylor& x) { return x.value != 0; }
inline bool is_false(const mixity::Taylor& x) { return x.value == 0; }
}  // namespace exprtk::details

#include <exprtk.hpp>

namespace mixity {

// What ExprTk asks of a number that is not built in, found by the type of the last argument.
struct TaylorTag {};

inline bool is_nan_impl(const Taylor& x, TaylorTag) { return std::isnan(x.value); }
inline int to_int32_impl(const Taylor& x, TaylorTag) { return static_cast<int>(x.value); }
inline long long to_int64_impl(const Taylor& x, TaylorTag) { return static_cast<long long>(x.value); }
inline bool is_integer_impl(const Taylor& x, TaylorTag) { return std::fmod(x.value, 1) == 0; }
inline Taylor const_pi_impl(TaylorTag) { return 3.141592653589793; }
inline Taylor const_e_impl(TaylorTag) { return 2.718281828459045; }
inline Taylor const_qnan_impl(TaylorTag) { return std::numeric_limits<double>::quiet_NaN(); }

#define MIXITY_ONE(name, value) \
  inline Taylor name##_impl(const Taylor& x, TaylorTag) { return value; }
#define MIXITY_TWO(name, value) \
  inline Taylor name##_impl(const Taylor& x, const Taylor& y, TaylorTag) { return value; }
MIXITY_ONE(abs, abs(x))
MIXITY_ONE(acos, acos(x))
MIXITY_ONE(asin, asin(x))
MIXITY_ONE(atan, atan(x))
MIXITY_ONE(cos, cos(x))
MIXITY_ONE(cosh, cosh(x))
MIXITY_ONE(exp, exp(x))
MIXITY_ONE(log, log(x))
MIXITY_ONE(neg, -x)
MIXITY_ONE(pos, x)
MIXITY_ONE(sin, sin(x))
MIXITY_ONE(sinh, sinh(x))
MIXITY_ONE(sqrt, sqrt(x))
MIXITY_ONE(tan, tan(x))
MIXITY_ONE(tanh, tanh(x))
MIXITY_TWO(min, y < x ? y : x)
MIXITY_TWO(max, x < y ? y : x)
MIXITY_TWO(pow, pow(x, y))
// Never called, as no expression may name them.
#define MIXITY_NONE_OF_ONE(name) MIXITY_ONE(name, (static_cast<void>(x), const_qnan_impl(TaylorTag{})))
#define MIXITY_NONE_OF_TWO(name) \
  MIXITY_TWO(name, (static_cast<void>(x), static_cast<void>(y), const_qnan_impl(TaylorTag{})))
MIXITY_NONE_OF_ONE(acosh)
MIXITY_NONE_OF_ONE(asinh)
MIXITY_NONE_OF_ONE(atanh)
MIXITY_NONE_OF_ONE(ceil)
MIXITY_NONE_OF_ONE(cot)
MIXITY_NONE_OF_ONE(csc)
MIXITY_NONE_OF_ONE(d2g)
MIXITY_NONE_OF_ONE(d2r)
MIXITY_NONE_OF_ONE(erf)
MIXITY_NONE_OF_ONE(erfc)
MIXITY_NONE_OF_ONE(expm1)
MIXITY_NONE_OF_ONE(floor)
MIXITY_NONE_OF_ONE(frac)
MIXITY_NONE_OF_ONE(g2d)
MIXITY_NONE_OF_ONE(log10)
MIXITY_NONE_OF_ONE(log1p)
MIXITY_NONE_OF_ONE(log2)
MIXITY_NONE_OF_ONE(ncdf)
MIXITY_NONE_OF_ONE(notl)
MIXITY_NONE_OF_ONE(r2d)
MIXITY_NONE_OF_ONE(round)
MIXITY_NONE_OF_ONE(sec)
MIXITY_NONE_OF_ONE(sgn)
MIXITY_NONE_OF_ONE(sinc)
MIXITY_NONE_OF_ONE(trunc)
MIXITY_NONE_OF_TWO(and)
MIXITY_NONE_OF_TWO(atan2)
MIXITY_NONE_OF_TWO(equal)
MIXITY_NONE_OF_TWO(hypot)
MIXITY_NONE_OF_TWO(logn)
MIXITY_NONE_OF_TWO(modulus)
MIXITY_NONE_OF_TWO(nand)
MIXITY_NONE_OF_TWO(nequal)
MIXITY_NONE_OF_TWO(nor)
MIXITY_NONE_OF_TWO(or)
MIXITY_NONE_OF_TWO(root)
MIXITY_NONE_OF_TWO(roundn)
MIXITY_NONE_OF_TWO(shl)
MIXITY_NONE_OF_TWO(shr)
MIXITY_NONE_OF_TWO(xnor)
MIXITY_NONE_OF_TWO(xor)

inline bool string_to_real(const char*& from, const char* end, Taylor& x, TaylorTag) {
  char* behind = nullptr;
  x = std::strtod(std::string(from, end).c_str(), &behind);
  from = end;
  return std::isfinite(x.value);
}

}  // namespace mixity

namespace exprtk::details::numeric::details {
template <>
struct number_type<mixity::Taylor> {
  using type = mixity::TaylorTag;
};
template <>
struct epsilon_type<mixity::Taylor> {
  static mixity::Taylor value() { return 1e-10; }
};
}  // namespace exprtk::details::numeric::details

namespace mixity {
namespace {

using Parser = exprtk::parser<Taylor>;
using Settings = Parser::settings_t;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_of_name(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// What ExprTk would not refuse, or not in words that help.
std::optional<ExpressionError> problem_of(std::string_view text, const std::vector<std::string>& variables) {
  if (text.size() > Expression::kLongest)
    return ExpressionError{Expression::kLongest, "an expression has " + std::to_string(Expression::kLongest) +
                                                     " characters at most, this one " + std::to_string(text.size())};
  std::vector<std::size_t> open;
  bool anything = false;
  bool behind_operand = false;  // ExprTk would read on from there, and drop what came before
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == ' ') {
      ++i;
      continue;
    }
    anything = true;
    if (behind_operand && (is_of_name(c) || c == '.' || c == '('))
      return ExpressionError{i, "a * is missing before this"};
    behind_operand = false;
    std::size_t end = i + 1;
    if (is_letter(c)) {
      while (end < text.size() && is_of_name(text[end])) ++end;
      const std::string name(text.substr(i, end - i));
      const std::size_t next = text.find_first_not_of(' ', end);
      const bool called = next != std::string_view::npos && text[next] == '(';
      if (contains(expression_functions(), name)) {
        if (!called) return ExpressionError{i, "function '" + name + "' needs its argument in brackets"};
      } else if (!contains(variables, name) && name != "pi") {
        return ExpressionError{i, "'" + name + "' is not known; there are " + listed(variables) + ", pi and " +
                                      listed(expression_functions())};
      } else if (called) {
        return ExpressionError{i, "'" + name + "' is no function: a * is missing behind it"};
      } else {
        behind_operand = true;
      }
    } else if (is_digit(c) || c == '.') {
      double number = 0;
      const auto [behind, status] = std::from_chars(text.data() + i, text.data() + text.size(), number);
      if (status != std::errc{}) return ExpressionError{i, "a number cannot be read here"};
      end = static_cast<std::size_t>(behind - text.data());
      const std::size_t next = std::min(text.find_first_not_of(' ', end), text.size());
      if (next < text.size() && text[next] == '.') return ExpressionError{next, "a number has one point"};
      behind_operand = true;
    } else if (c == '(') {
      open.push_back(i);
      if (open.size() > Expression::kDeepest)
        return ExpressionError{
            i, "brackets stand in one another " + std::to_string(Expression::kDeepest) + " times at most"};
    } else if (c == ')') {
      if (open.empty()) return ExpressionError{i, "this bracket closes none"};
      open.pop_back();
      behind_operand = true;
    } else if (std::string_view("+-*/^,").find(c) == std::string_view::npos) {
      const bool printable = static_cast<unsigned char>(c) > ' ' && static_cast<unsigned char>(c) < 127;
      return ExpressionError{i, printable ? std::string("'") + c + "' has no place in an expression"
                                          : "an expression is made of letters, digits and + - * / ^ ( ) , alone"};
    }
    i = end;
  }
  if (!anything) return ExpressionError{0, "the expression is empty"};
  if (!open.empty()) return ExpressionError{open.back(), "this bracket is not closed"};
  return std::nullopt;
}

/// One for all threads: it costs more to make than an expression, and keeps what it compiled last, whose counts of
/// users are not atomic.
class SharedParser {
 public:
  std::mutex one_at_a_time;
  Parser parser{settings()};

 private:
  static Settings settings() {
    Settings settings(Settings::e_joiner + Settings::e_numeric_check + Settings::e_bracket_check +
                      Settings::e_sequence_check + Settings::e_strength_reduction + Settings::e_disable_vardef);
    settings.disable_all_control_structures().disable_all_assignment_ops().disable_all_logic_ops();
    return settings;
  }
};

/// Never destroyed, as an expression that a static variable holds may be destroyed after it.
SharedParser& shared_parser() {
  static SharedParser& one = *new SharedParser;
  return one;
}

}  // namespace

const std::vector<std::string>& expression_functions() {
  static const std::vector<std::string> names{"sin",  "cos", "tan", "asin", "acos", "atan", "sinh", "cosh",
                                              "tanh", "exp", "log", "sqrt", "abs",  "min",  "max"};
  return names;
}

bool is_variable_name(std::string_view name) {
  return !name.empty() && is_letter(name[0]) && std::all_of(name.begin(), name.end(), is_of_name) && name != "pi" &&
         !contains(expression_functions(), name) && !exprtk::details::is_reserved_symbol(std::string(name));
}

struct Expression::Compiled {
  std::vector<Taylor> variables;
  std::optional<exprtk::expression<Taylor>> expression;

  Compiled() = default;
  Compiled(const Compiled&) = delete;
  Compiled& operator=(const Compiled&) = delete;
  ~Compiled() {
    const std::lock_guard lock(shared_parser().one_at_a_time);
    expression.reset();
  }
};

Expression::Expression(std::string_view text, const std::vector<std::string>& variables)
    : compiled_(std::make_unique<Compiled>()), error_(problem_of(text, variables)) {
  if (error_) return;
  compiled_->variables.resize(variables.size());
  SharedParser& shared = shared_parser();
  const std::lock_guard lock(shared.one_at_a_time);
  exprtk::symbol_table<Taylor> symbols;
  for (std::size_t i = 0; i < variables.size(); ++i) symbols.add_variable(variables[i], compiled_->variables[i]);
  symbols.add_constant("pi", Taylor(3.141592653589793));
  compiled_->expression.emplace().register_symbol_table(symbols);
  Parser& parse = shared.parser;
  if (parse.compile(std::string(text), *compiled_->expression)) return;
  const auto first = parse.get_error(0);
  const std::size_t at = std::min<std::size_t>(first.token.position, text.size());
  const std::size_t shown = std::min(text.find_first_not_of(' ', at), text.size());
  error_ = {shown, shown < text.size()
                       ? (text[shown] == '*' && shown > 0 && text[shown - 1] == '*'
                              ? "cannot be read from here on: powers are written ^"
                          : text[shown] == ',' ? "cannot be read from here on: numbers have a decimal point"
                                               : "cannot be read from here on")
                       : "something is missing at the end"};
}

Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

Taylor Expression::operator()(std::span<const Taylor> variables) const {
  std::copy(variables.begin(), variables.end(), compiled_->variables.begin());
  return compiled_->expression->value();
}

}  // namespace mixity
