// Files that are read: each once, with what was in it.
#pragma once

#include <cstddef>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/content_hash.h"

namespace mixity {

/// A file as it was read. Whatever happens to it later, its content is here.
struct InputFile {
  std::string path;
  std::size_t bytes = 0;
  std::string hash;                              // of the content (content_hash.h)
  std::shared_ptr<const std::string> content{};  // null of more than Inputs::kMostKept bytes
};

/// The files of a data set or another result, in the order in which they were read.
class Inputs {
 public:
  static constexpr std::size_t kMostKept = std::size_t{1} << 26;

  Inputs() = default;
  /// Of files that were read before: no file is read from disk.
  explicit Inputs(const std::vector<InputFile>& given);

  bool exists(const std::string& path) const;
  /// The content of a file of at most kMostText bytes; a file that was read is not read again. Throws InputError as
  /// read_file does.
  std::string read(const std::string& path);
  /// Null if files are read from disk. Throws InputError if the file is not among those that were read before.
  std::shared_ptr<const std::string> given(const std::string& path) const;

  void add(InputFile file);
  const std::vector<InputFile>& files() const { return files_; }

 private:
  std::optional<std::map<std::string, InputFile>> given_;  // by path
  std::vector<InputFile> files_;
  std::map<std::string, std::size_t> index_;  // of files_, by path
};

/// A file that is read from its beginning to its end in blocks.
class InputStream {
 public:
  /// Opens it, or the content that `inputs` has of it. Throws InputError if it cannot be opened.
  InputStream(const std::string& path, Inputs& inputs);

  /// Appends up to this many bytes to the text; fewer only at the end, which adds the file to the inputs. Throws
  /// InputError if it cannot be read, or if a file on disk changed while it was read.
  void read(std::size_t bytes, std::string& text);
  bool at_end() const { return at_end_; }
  std::size_t bytes_read() const { return file_.bytes; }
  /// Null of a pipe.
  std::optional<std::size_t> size() const { return size_; }

 private:
  void finish();

  Inputs& inputs_;
  std::shared_ptr<const std::string> given_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream_;
  std::optional<std::size_t> size_;
  long long changed_ = 0;  // when the file was, in ns
  bool at_end_ = false;
  InputFile file_;
  ContentHash hash_;
  std::shared_ptr<std::string> content_;
};

/// The content of a file as it was read. Reads a large one again; throws InputError if it is another since.
std::string content_of(const InputFile& file);

}  // namespace mixity
