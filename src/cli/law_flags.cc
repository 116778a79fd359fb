#include "cli/law_flags.h"

#include <algorithm>
#include <iostream>

#include "analysis/laws.h"
#include "base/toml_file.h"
#include "cli/flags.h"

DEFINE_string(
    law, "",
    "a law of one's own: \"mine: 1 + (1-l)*tan(psi)^2; l=0..1\", of psi, B = sin^2 psi, t = tan psi, or an equation "
    "in K_I and K_II; several are parted by |, or the flag is given again");
DEFINE_string(laws, "", "a TOML of laws in the form of data/laws.toml");

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
      // padded, so that columns in messages count from the start of the flag's value
      add(define_law_text("--law", std::string(at - line, ' ') + all.substr(at, next - at)));
    }
  }
  if (FLAGS_laws.empty()) return;
  for (const DefinedLaw& one : define_laws(FLAGS_laws, read_toml(FLAGS_laws))) add(one);
}

const std::vector<std::string>& laws_of_flags() { return keys(); }

}  // namespace mixity::cli
