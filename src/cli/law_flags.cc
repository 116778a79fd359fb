#include "cli/law_flags.h"

#include <algorithm>
#include <iostream>

#include "cli/flags.h"
#include "dataset/toml_file.h"
#include "jobs/laws.h"

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
  std::string_view rest = FLAGS_law;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('|'), rest.size());
    add(define_law_text("--law", rest.substr(0, end)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  if (FLAGS_laws.empty()) return;
  for (const DefinedLaw& one : define_laws(FLAGS_laws, read_toml(FLAGS_laws))) add(one);
}

const std::vector<std::string>& laws_of_flags() { return keys(); }

}  // namespace mixity::cli
