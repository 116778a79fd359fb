// What tests of file readers share: a folder that goes away, and the text of the error that a call throws.
#pragma once

#include <stdlib.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/input_error.h"
#include "cli/flag_words.h"

namespace mixity {

/// A fresh folder below the system's temporary one, removed with all it holds at the end of the scope.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_((std::filesystem::temp_directory_path() / "mixity_test_XXXXXX").string()) {
    if (!::mkdtemp(path_.data())) throw std::runtime_error("no temporary folder: " + path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string path(std::string_view name) const { return path_ + "/" + std::string(name); }

  /// Writes a file byte for byte and returns its path.
  std::string write(std::string_view name, std::string_view text) const {
    const std::string file = path(name);
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  /// The text without the folder wherever it names a file in it: "a.csv:2:3: ...".
  std::string left_out_of(std::string text) const {
    const std::string prefix = path_ + "/";
    for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
    return text;
  }

 private:
  std::string path_;
};

/// What the program says of the InputError that `call` throws; empty if it throws none. Any other exception is passed
/// on.
template <class Call>
std::string input_error(Call&& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.text(cli::in_flags);
  }
  return {};
}

/// Messages as the program says them.
inline std::vector<std::string> texts_of(const std::vector<Message>& messages) {
  std::vector<std::string> texts;
  for (const Message& message : messages) texts.push_back(message.text(cli::in_flags));
  return texts;
}

/// The error, without the folder, that read(path) throws for a file of this name and text; empty if it throws none.
template <class Read>
std::string file_error(std::string_view name, std::string_view text, Read&& read) {
  const TemporaryFolder folder;
  const std::string path = folder.write(name, text);
  return folder.left_out_of(input_error([&] { read(path); }));
}

}  // namespace mixity
