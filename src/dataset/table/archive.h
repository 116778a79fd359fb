// Zip files in memory, unpacked by minizip, on the page by Boost. Both share the limits and sentences of
// part_limits.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace mixity {

class Archive {
 public:
  /// The size limit in bytes of a part, unpacked.
  static constexpr std::size_t kMostUnpacked = std::size_t{1} << 31;

  /// The bytes must outlive the archive. `path`: the file named in messages. Throws InputError if they are not a whole
  /// zip file.
  Archive(const std::string& path, std::string_view bytes, std::size_t most = kMostUnpacked);

  const std::string& path() const { return path_; }
  bool holds(const std::string& part) const;
  /// Calls use(piece) for successive pieces of a part, until it returns false. Throws InputError if the part is
  /// missing, damaged or protected by a password, and if it is suspiciously large: beyond the limit, or packed to less
  /// than a 500th.
  void read(const std::string& part, const std::function<bool(std::string_view)>& use) const;
  std::string read(const std::string& part) const;

 private:
  struct Part {
    std::uint64_t packed, size;  // bytes
    unsigned long flags, method;
  };
  /// Throws InputError if the part is locked, packed in an unknown way, or suspiciously large.
  void require_readable(const Part& part) const;
  [[noreturn]] void refuse(const std::string& what) const;
  [[noreturn]] void refuse_missing(const std::string& part) const;
  [[noreturn]] void refuse_damaged(const std::string& part) const;

  std::string path_;
  std::size_t most_;
  std::unique_ptr<void, int (*)(void*)> zip_;
};

}  // namespace mixity
