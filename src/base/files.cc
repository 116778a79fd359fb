#include "base/files.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "base/input_error.h"

namespace mixity {

std::string read_file(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw InputError(path, std::string("cannot be opened: ") + std::strerror(errno));
  std::string text;
  std::array<char, 1 << 14> part;
  while (const std::size_t got = std::fread(part.data(), 1, part.size(), file.get())) {
    text.append(part.data(), got);
    if (text.size() > kMostText) throw InputError(path, "is larger than 256 MB");
  }
  if (std::ferror(file.get())) throw InputError(path, std::string("cannot be read: ") + std::strerror(errno));
  return text;
}

}  // namespace mixity
