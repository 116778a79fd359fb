// A hash that distinguishes contents of files.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace mixity {

/// XXH3 with 128 bits, as 32 hexadecimal digits, the same as xxh128sum prints. It detects changes, but not forgery.
class ContentHash {
 public:
  ContentHash();
  ContentHash(ContentHash&&) noexcept;
  ContentHash& operator=(ContentHash&&) noexcept;
  ~ContentHash();
  void add(std::string_view bytes);
  std::string text() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string content_hash(std::string_view bytes);

/// The hash of a file, read in blocks; empty if it cannot be read or is no regular file.
std::string file_hash(const std::string& path);

}  // namespace mixity
