#include "mechanics/laws/expression.h"

#include <algorithm>
#include <charconv>
#include <mutex>

#include "base/phrases.h"
#include "mechanics/laws/exprtk_taylor.h"

namespace mixity {
namespace {

using Parser = exprtk::parser<Taylor>;
using Settings = Parser::settings_t;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Errors that ExprTk does not detect or explain.
std::optional<LawError> problem_of(std::string_view text, const std::vector<std::string>& variables) {
  if (text.size() > Expression::kLongest)
    return LawError{Expression::kLongest, "an expression has " + std::to_string(Expression::kLongest) +
                                              " characters at most, this one " + std::to_string(text.size())};
  std::vector<std::size_t> open;
  bool anything = false;
  bool behind_operand = false;  // here ExprTk would continue reading, and drop what came before
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == ' ') {
      ++i;
      continue;
    }
    anything = true;
    if (behind_operand && (is_name_character(c) || c == '.' || c == '('))
      return LawError{i, "a * is missing before this"};
    behind_operand = false;
    std::size_t end = i + 1;
    if (is_letter(c)) {
      while (end < text.size() && is_name_character(text[end])) ++end;
      const std::string name(text.substr(i, end - i));
      const std::size_t next = text.find_first_not_of(' ', end);
      const bool called = next != std::string_view::npos && text[next] == '(';
      if (contains(expression_functions(), name)) {
        if (!called) return LawError{i, "function '" + name + "' needs its argument in brackets"};
      } else if (!contains(variables, name) && name != "pi") {
        return LawError{i, "'" + name + "' is not known; there are " + joined(variables) + ", pi and " +
                               joined(expression_functions())};
      } else if (called) {
        return LawError{i, "'" + name + "' is no function: a * is missing behind it"};
      } else {
        behind_operand = true;
      }
    } else if (is_digit(c) || c == '.') {
      double number = 0;
      const auto [behind, status] = std::from_chars(text.data() + i, text.data() + text.size(), number);
      if (status != std::errc{}) return LawError{i, "a number cannot be read here"};
      end = static_cast<std::size_t>(behind - text.data());
      const std::size_t next = std::min(text.find_first_not_of(' ', end), text.size());
      if (next < text.size() && text[next] == '.') return LawError{next, "a number has one point"};
      behind_operand = true;
    } else if (c == '(') {
      open.push_back(i);
      if (open.size() > Expression::kDeepest)
        return LawError{i, "brackets stand in one another " + std::to_string(Expression::kDeepest) + " times at most"};
    } else if (c == ')') {
      if (open.empty()) return LawError{i, "this bracket closes none"};
      open.pop_back();
      behind_operand = true;
    } else if (std::string_view("+-*/^,").find(c) == std::string_view::npos) {
      const bool printable = static_cast<unsigned char>(c) > ' ' && static_cast<unsigned char>(c) < 127;
      return LawError{i, printable ? std::string("'") + c + "' has no place in an expression"
                                   : "an expression is made of letters, digits and + - * / ^ ( ) , alone"};
    }
    i = end;
  }
  if (!anything) return LawError{0, "the expression is empty"};
  if (!open.empty()) return LawError{open.back(), "this bracket is not closed"};
  return std::nullopt;
}

/// One parser for all threads, since it costs more to construct than an expression. It keeps the last compiled
/// expression, whose reference counts are not atomic, so expressions are made and freed under its lock.
class SharedParser {
 public:
  std::mutex mutex;
  Parser parser{settings()};

 private:
  static Settings settings() {
    Settings settings(Settings::e_joiner + Settings::e_numeric_check + Settings::e_bracket_check +
                      Settings::e_sequence_check + Settings::e_strength_reduction + Settings::e_disable_vardef);
    settings.disable_all_control_structures().disable_all_assignment_ops().disable_all_logic_ops();
    return settings;
  }
};

/// Never destroyed: an expression in a static variable may be destroyed later.
SharedParser& shared_parser() {
  static SharedParser& one = *new SharedParser;
  return one;
}

}  // namespace

bool is_name_character(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

const std::vector<std::string>& expression_functions() {
  static const std::vector<std::string> names{"sin",  "cos", "tan", "asin", "acos", "atan", "sinh", "cosh",
                                              "tanh", "exp", "log", "sqrt", "abs",  "min",  "max"};
  return names;
}

bool is_variable_name(std::string_view name) {
  return !name.empty() && is_letter(name[0]) && std::all_of(name.begin(), name.end(), is_name_character) &&
         name != "pi" && !contains(expression_functions(), name) &&
         !exprtk::details::is_reserved_symbol(std::string(name));
}

struct Expression::Compiled {
  std::vector<Taylor> variables;
  std::optional<exprtk::expression<Taylor>> expression;

  Compiled() = default;
  Compiled(const Compiled&) = delete;
  Compiled& operator=(const Compiled&) = delete;
  ~Compiled() {
    const std::lock_guard lock(shared_parser().mutex);
    expression.reset();
  }
};

Expression::Expression(std::string_view text, const std::vector<std::string>& variables)
    : compiled_(std::make_unique<Compiled>()), error_(problem_of(text, variables)) {
  if (error_) return;
  compiled_->variables.resize(variables.size());
  SharedParser& shared = shared_parser();
  const std::lock_guard lock(shared.mutex);
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
