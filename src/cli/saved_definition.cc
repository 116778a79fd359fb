#include "cli/saved_definition.h"

#include "cli/flag_words.h"
#include "cli/flags.h"

namespace mixity::cli {

std::string save_definition(const std::vector<UnderstoodFile>& files, const Arguments& arguments) {
  if (FLAGS_save.empty()) return {};
  const std::string& path = path_to_save();
  std::vector<std::string> inputs(arguments);
  for (const std::string& file : arguments) inputs.push_back(metadata_path(file));
  write_outputs({{path, definition_text(files, path, in_flags)}}, inputs);
  return "Written to " + path + "; " + in_flags(Remedy::set("definition", path)) + " reads other files so\n";
}

}  // namespace mixity::cli
