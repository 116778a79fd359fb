// A number that tells contents of files apart.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace mixity {

/// XXH3 of 128 bits, as 32 hexadecimal digits: what xxh128sum prints. It notices changes; it is no proof against
/// forgery.
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

/// Of a file, read in blocks; empty if it cannot be read.
std::string file_hash(const std::string& path);

}  // namespace mixity
