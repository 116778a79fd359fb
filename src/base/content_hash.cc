#include "base/content_hash.h"

#define XXH_INLINE_ALL         // header only, also for browsers
#define XXH_NO_INLINE_HINTS 1  // with little optimisation, compilers refuse to inline what the header demands
#include <xxhash.h>

#include <array>
#include <cstdio>
#include <filesystem>

namespace mixity {

struct ContentHash::State {
  XXH3_state_t xxh3;
};

ContentHash::ContentHash() : state_(new State) { XXH3_128bits_reset(&state_->xxh3); }
ContentHash::ContentHash(ContentHash&&) noexcept = default;
ContentHash& ContentHash::operator=(ContentHash&&) noexcept = default;
ContentHash::~ContentHash() = default;

void ContentHash::add(std::string_view bytes) { XXH3_128bits_update(&state_->xxh3, bytes.data(), bytes.size()); }

std::string ContentHash::text() const {
  XXH128_canonical_t digits;
  XXH128_canonicalFromHash(&digits, XXH3_128bits_digest(&state_->xxh3));
  std::string text;
  for (const unsigned char byte : digits.digest)
    for (const int half : {byte >> 4, byte & 15}) text += "0123456789abcdef"[half];
  return text;
}

std::string content_hash(std::string_view bytes) {
  ContentHash hash;
  hash.add(bytes);
  return hash.text();
}

std::string file_hash(const std::string& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return {};  // a pipe may have no end
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return {};
  ContentHash hash;
  std::array<char, 1 << 16> part;
  while (const std::size_t got = std::fread(part.data(), 1, part.size(), file.get())) hash.add({part.data(), got});
  return std::ferror(file.get()) ? std::string() : hash.text();
}

}  // namespace mixity
