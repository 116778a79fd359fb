#include "cli/saved_definition.h"

#include "cli/flag_words.h"
#include "cli/flags.h"

namespace mixity::cli {

std::vector<OutputFile> definition_to_save(const std::vector<UnderstoodFile>& files) {
  if (FLAGS_save.empty()) return {};
  const std::string& path = path_to_save();
  return {{path, definition_text(files, path, in_flags)}};
}

std::string saved_text() {
  if (FLAGS_save.empty()) return {};
  return "Written to " + FLAGS_save + "; " + in_flags(Remedy::set("definition", FLAGS_save)) +
         " reads other files so\n";
}

}  // namespace mixity::cli
