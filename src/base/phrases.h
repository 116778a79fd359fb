// Parts of the text for readers: lists, counts, values with their errors, aligned columns.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mixity {

/// `before` and then the texts with separators between them; empty without texts.
std::string joined(const std::vector<std::string>& texts, std::string_view separator = ", ",
                   std::string_view before = "");

/// "1 point" or "2 points".
std::string counted(std::size_t n, const std::string& noun);

/// A value and its standard error as rounded_to_error rounds them: "2.13 +/- 0.11".
std::string with_error(double value, double error, const char* sign = " +/- ");

/// The rows as lines with aligned columns, two blanks apart, after `indent`. Widths are in characters.
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::string_view indent = "");

}  // namespace mixity
