#include "base/inputs.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <mutex>

#include "base/files.h"
#include "base/input_error.h"
#include "base/stop.h"
#include "base/unfinished_run.h"

namespace mixity {
namespace {

struct FileState {
  std::size_t size;
  long long changed;  // ns
};

/// Null for a pipe or device.
std::optional<FileState> state_of(std::FILE* stream) {
  struct stat about {};
  if (::fstat(::fileno(stream), &about) != 0 || !S_ISREG(about.st_mode)) return std::nullopt;
  return FileState{static_cast<std::size_t>(about.st_size),
                   about.st_mtim.tv_sec * 1000000000LL + about.st_mtim.tv_nsec};
}

/// A file is read as the last run left it that wrote to its folder.
void complete_run_beside(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  complete_unfinished_run(folder.empty() ? "." : folder);
}

struct Remembered {
  std::mutex mutex;
  bool asked = false;
  std::vector<std::string> paths;
};

Remembered& remembered() {
  static Remembered all;
  return all;
}

constexpr const char* kChanged = "was changed while it was read: read it again when it is complete";

}  // namespace

Inputs::Inputs(const std::vector<InputFile>& given, Others others) : others_(others) {
  for (const InputFile& file : given) given_.emplace(file.path, file);
}

bool Inputs::exists(const std::string& path) const {
  std::error_code error;
  if (others_ == Others::none || given_.count(path) > 0) return given_.count(path) > 0;
  complete_run_beside(path);
  const auto kind = std::filesystem::status(path, error).type();
  if (kind == std::filesystem::file_type::not_found) return false;
  if (error) throw InputError(path, "cannot be looked up: " + error.message());
  return true;
}

std::string Inputs::read(const std::string& path) {
  if (const auto known = index_.find(path); known != index_.end() && files_[known->second].content)
    return *files_[known->second].content;
  InputStream stream(path, *this);
  std::string text;
  constexpr std::size_t kPart = std::size_t{1} << 16;
  while (!stream.at_end()) {
    stream.read(std::max(kPart, text.size()), text);
    if (text.size() > kMostText) throw InputError(path, "is larger than 256 MB");
  }
  return text;
}

std::shared_ptr<const std::string> Inputs::given(const std::string& path) const {
  const auto file = given_.find(path);
  if (file == given_.end() && others_ == Others::from_disk) return nullptr;
  if (file == given_.end() || !file->second.content)
    throw InputError(path, "is not among the files that were read before");
  return file->second.content;
}

void Inputs::add(InputFile file) {
  if (index_.emplace(file.path, files_.size()).second) files_.push_back(std::move(file));
}

std::vector<InputFile> Inputs::without_contents() const {
  std::vector<InputFile> list = files_;
  for (InputFile& file : list) file.content = nullptr;
  return list;
}

InputStream::InputStream(const std::string& path, Inputs& inputs)
    : inputs_(inputs), given_(inputs.given(path)), stream_(nullptr, &std::fclose) {
  file_.path = path;
  if (given_) {
    size_ = given_->size();
    return;
  }
  complete_run_beside(path);
  stream_.reset(std::fopen(path.c_str(), "rb"));
  if (!stream_) throw InputError(path, std::string("cannot be opened: ") + std::strerror(errno));
  if (Remembered& all = remembered(); all.asked) {
    const std::lock_guard lock(all.mutex);
    all.paths.push_back(path);
  }
  if (const auto state = state_of(stream_.get())) {
    size_ = state->size;
    changed_ = state->changed;
  }
  content_ = std::make_shared<std::string>();
  if (size_ && *size_ <= Inputs::kMostKept) content_->reserve(*size_);
}

void InputStream::read(std::size_t bytes, std::string& text) {
  may_go_on();
  const std::size_t before = text.size();
  if (given_) {
    text.append(*given_, file_.bytes, bytes);
  } else {
    // one byte more than is left shows the end of the file
    const std::size_t most = size_ && file_.bytes <= *size_ ? std::min(bytes, *size_ - file_.bytes + 1) : bytes;
    text.resize(before + most);
    text.resize(before + std::fread(text.data() + before, 1, most, stream_.get()));
    if (std::ferror(stream_.get()))
      throw InputError(file_.path, std::string("cannot be read: ") + std::strerror(errno));
  }
  const std::string_view part = std::string_view(text).substr(before);
  file_.bytes += part.size();
  hash_.add(part);
  if (content_) {
    if (file_.bytes > Inputs::kMostKept)
      content_.reset();
    else
      content_->append(part);
  }
  at_end_ = part.size() < bytes;
  if (at_end_) finish();
}

void InputStream::finish() {
  if (!given_ && size_) {
    const auto now = state_of(stream_.get());
    if (!now || file_.bytes != *size_ || now->size != *size_ || now->changed != changed_)
      throw InputError(file_.path, kChanged);
  }
  file_.hash = hash_.text();
  file_.content = given_ ? given_ : content_;
  if (!file_.content) file_.whole_path = std::filesystem::absolute(file_.path).string();
  inputs_.add(file_);
}

void remember_files_read() { remembered().asked = true; }

std::vector<std::string> files_remembered() {
  Remembered& all = remembered();
  const std::lock_guard lock(all.mutex);
  return all.paths;
}

void forget_large_contents(std::vector<InputFile>& files) {
  constexpr std::size_t kLarge = std::size_t{1} << 20;
  for (InputFile& file : files) {
    if (!file.content || file.bytes <= kLarge) continue;
    file.whole_path = std::filesystem::absolute(file.path).string();
    file.content = nullptr;
  }
}

std::string content_of(const InputFile& file) {
  if (file.content) return *file.content;
  Inputs again;
  InputStream stream(file.whole_path, again);
  std::string text;
  while (!stream.at_end()) stream.read(file.bytes + 1, text);
  if (again.files().front().hash != file.hash)
    throw InputError(file.path, "is another than the one that was read: its hash is not " + file.hash);
  return text;
}

}  // namespace mixity
