#include "cli/law_flags.h"

#include <algorithm>
#include <iostream>

#include "analysis/laws.h"
#include "base/toml_file.h"
#include "cli/flags.h"

namespace mixity::cli {
namespace {

std::vector<std::string>& keys() {
  static std::vector<std::string> all;
  return all;
}

void add(const DefinedLaw& defined) {
  const std::string& key = defined.law->definition().key;
  keys().push_back(key);
  for (const std::string& warning : defined.warnings) std::cerr << "mixity: law " << key << ": " << warning << '\n';
}

}  // namespace

std::vector<std::string_view> with_law_flags(std::vector<std::string_view> flags) {
  flags.insert(flags.end(), {"law", "laws"});
  return flags;
}

void define_laws_of_flags() {
  const std::string& all = FLAGS_law;
  for (std::size_t line = 0, end; line < all.size(); line = end + 1) {
    end = std::min(all.find(kNextLaw, line), all.size());
    for (std::size_t at = line, next; at < end; at = next + 1) {
      next = std::min(all.find('|', at), end);
      // behind blanks for those before it, so that columns are those of the flag
      add(define_law_text("--law", std::string(at - line, ' ') + all.substr(at, next - at)));
    }
  }
  if (FLAGS_laws.empty()) return;
  for (const DefinedLaw& one : define_laws(FLAGS_laws, read_toml(FLAGS_laws))) add(one);
}

const std::vector<std::string>& laws_of_flags() { return keys(); }

}  // namespace mixity::cli
