// Input files, each read once and stored with its content.
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

/// A file as it was read; later changes on disk do not affect it.
struct InputFile {
  std::string path;
  std::size_t bytes = 0;
  std::string hash;                              // of the content (content_hash.h)
  std::shared_ptr<const std::string> content{};  // null if longer than Inputs::kMostKept bytes
  std::string whole_path{};  // of such a file: where it is read again, also from another working directory
};

/// The input files of a data set or another result, in the order of reading.
class Inputs {
 public:
  static constexpr std::size_t kMostKept = std::size_t{1} << 26;

  Inputs() = default;
  /// Which files are read from disk, besides those that are given.
  enum class Others { none, from_disk };
  /// Serves these files, which were read before.
  explicit Inputs(const std::vector<InputFile>& given, Others others = Others::none);

  bool exists(const std::string& path) const;
  /// The content of a file of at most kMostText bytes; a file is read only once. Throws InputError as read_file does.
  std::string read(const std::string& path);
  /// Null if the file is to be read from disk. Throws InputError if it is not among those given and none others are
  /// read.
  std::shared_ptr<const std::string> given(const std::string& path) const;

  void add(InputFile file);
  const std::vector<InputFile>& files() const { return files_; }
  /// To be listed, which needs no contents.
  std::vector<InputFile> without_contents() const;

 private:
  std::map<std::string, InputFile> given_;  // by path
  Others others_ = Others::from_disk;
  std::vector<InputFile> files_;
  std::map<std::string, std::size_t> index_;  // of files_, by path
};

/// Reads a file from beginning to end in blocks.
class InputStream {
 public:
  /// Opens the file, or its content in `inputs`. Throws InputError if it cannot be opened.
  InputStream(const std::string& path, Inputs& inputs);

  /// Appends up to this many bytes to the text; fewer only at the end of the file, where it is added to the inputs.
  /// Throws InputError if it cannot be read, or if a file on disk changed during reading.
  void read(std::size_t bytes, std::string& text);
  bool at_end() const { return at_end_; }
  std::size_t bytes_read() const { return file_.bytes; }
  /// Null for a pipe.
  std::optional<std::size_t> size() const { return size_; }

 private:
  void finish();

  Inputs& inputs_;
  std::shared_ptr<const std::string> given_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream_;
  std::optional<std::size_t> size_;
  long long changed_ = 0;  // modification time in ns
  bool at_end_ = false;
  InputFile file_;
  ContentHash hash_;
  std::shared_ptr<std::string> content_;
};

/// From now on the paths of files that are read from disk are remembered: a program that runs once writes over none of
/// them (write_files).
void remember_files_read();
/// Empty if they are not remembered.
std::vector<std::string> files_remembered();

/// The content of a file as it was read. Reads a large one again; throws InputError if it has changed since.
std::string content_of(const InputFile& file);

/// Forgets contents of more than a megabyte: content_of reads those files again.
void forget_large_contents(std::vector<InputFile>& files);

}  // namespace mixity
