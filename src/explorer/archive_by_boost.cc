// What stands for dataset/table/archive.cc in a browser, which has no minizip: the directory of a zip file, and its
// parts unpacked by Boost.Beast.
#include <algorithm>
#include <boost/beast/zlib/inflate_stream.hpp>
#include <boost/crc.hpp>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/files.h"
#include "base/input_error.h"
#include "base/text.h"
#include "dataset/table/archive.h"

namespace mixity {
namespace {

std::string in_lower_case(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
  return name;
}

// The directory of a zip file.
struct Directory {
  struct Part {
    unsigned flags = 0, method = 0;
    std::uint32_t crc = 0;
    std::size_t packed = 0, size = 0, header = 0;  // bytes; header: where its local header begins
  };

  std::string_view bytes;
  std::map<std::string, Part> parts{};  // by name in lower case

  /// A number of n bytes, the least first. Throws std::out_of_range beyond the file.
  std::uint32_t number(std::size_t at, std::size_t n) const {
    std::uint32_t value = 0;
    if (at > bytes.size() || bytes.size() - at < n) throw std::out_of_range("it ends early");
    for (std::size_t i = n; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
  }
  std::string_view range(std::size_t at, std::size_t n) const {
    if (at > bytes.size() || bytes.size() - at < n) throw std::out_of_range("it ends early");
    return bytes.substr(at, n);
  }

  void read_directory() {
    constexpr std::size_t kEnd = 22, kLongestComment = 0xffff;
    constexpr std::uint32_t kEndMark = 0x06054b50, kPartMark = 0x02014b50, kBeyond = 0xffffffff;
    if (bytes.size() < kEnd) throw std::out_of_range("it ends early");
    std::size_t end = bytes.size() - kEnd;
    const std::size_t least = end > kLongestComment ? end - kLongestComment : 0;
    while (number(end, 4) != kEndMark)
      if (end-- == least) throw std::out_of_range("it has no directory");
    std::size_t at = number(end + 16, 4);
    for (std::size_t left = number(end + 10, 2); left > 0; --left) {
      if (number(at, 4) != kPartMark) throw std::out_of_range("its directory is not whole");
      const std::size_t name = number(at + 28, 2), more = number(at + 30, 2) + number(at + 32, 2);
      const Part part{number(at + 8, 2),  number(at + 10, 2), number(at + 16, 4),
                      number(at + 20, 4), number(at + 24, 4), number(at + 42, 4)};
      if (part.size == kBeyond || part.packed == kBeyond || part.header == kBeyond)
        throw std::out_of_range("it is in the form for more than 4 GB");
      parts.emplace(in_lower_case(std::string(range(at + 46, name))), part);
      at += 46 + name + more;
    }
  }

  std::string_view packed(const Part& part) const {
    constexpr std::uint32_t kMark = 0x04034b50;
    if (number(part.header, 4) != kMark) throw std::out_of_range("it is not where the directory says");
    return range(part.header + 30 + number(part.header + 26, 2) + number(part.header + 28, 2), part.packed);
  }

  static const Directory& of(const void* zip) { return *static_cast<const Directory*>(zip); }
  static int remove(void* zip) {
    delete static_cast<Directory*>(zip);
    return 0;
  }
};

/// Calls use(piece) for the pieces of a part until it returns false. Throws std::out_of_range if it is damaged.
void unpack(std::string_view packed, const Directory::Part& part, const std::function<bool(std::string_view)>& use) {
  namespace zlib = boost::beast::zlib;
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  boost::crc_32_type sum;
  std::size_t total = 0;
  const auto pass = [&](std::string_view piece) {
    sum.process_bytes(piece.data(), piece.size());
    total += piece.size();
    if (total > part.size) throw std::length_error("unpacks to more than it states");
    return piece.empty() || use(piece);
  };
  if (part.method == 0) {
    for (std::size_t at = 0; at < packed.size(); at += kPiece)
      if (!pass(packed.substr(at, kPiece))) return;
  } else {
    zlib::inflate_stream stream;
    std::string piece(kPiece, '\0');
    zlib::z_params state;
    state.next_in = packed.data();
    state.avail_in = packed.size();
    for (boost::system::error_code error; error != zlib::error::end_of_stream;) {
      state.next_out = piece.data();
      state.avail_out = piece.size();
      stream.write(state, zlib::Flush::sync, error);
      const std::size_t length = piece.size() - state.avail_out;
      if ((error && error != zlib::error::end_of_stream) || (!error && length == 0))
        throw std::out_of_range("it cannot be unpacked");
      if (!pass(std::string_view(piece).substr(0, length))) return;
    }
  }
  if (total != part.size || sum.checksum() != part.crc) throw std::out_of_range("its sum is wrong");
}

}  // namespace

Archive::Archive(const std::string& path, std::string_view bytes, std::size_t most)
    : path_(path), most_(most), zip_(new Directory{bytes}, &Directory::remove) {
  try {
    static_cast<Directory*>(zip_.get())->read_directory();
  } catch (const std::out_of_range&) {
    throw InputError(path, "is a workbook or an archive that is damaged or incomplete; save or copy it again");
  }
}

bool Archive::holds(const std::string& part) const {
  return Directory::of(zip_.get()).parts.contains(in_lower_case(part));
}

void Archive::read(const std::string& part, const std::function<bool(std::string_view)>& use) const {
  const Directory& zip = Directory::of(zip_.get());
  const auto found = zip.parts.find(in_lower_case(part));
  if (found == zip.parts.end()) refuse_missing(part);
  const Directory::Part& about = found->second;
  require_readable({about.packed, about.size, about.flags, about.method});
  try {
    unpack(zip.packed(about), about, use);
  } catch (const std::length_error& error) {
    refuse(error.what());
  } catch (const std::out_of_range&) {
    refuse_damaged(part);
  }
}

}  // namespace mixity
