// Files that are no text: workbooks, and the own forms of programs.
#pragma once

#include <string>
#include <string_view>

namespace mixity {

/// Throws InputError, which says how to export the data as text, if the first bytes of a file are those of a form that
/// is known and no text.
void refuse_binary(const std::string& path, std::string_view start);

}  // namespace mixity
