#include "dataset/table/archive.h"

#include <unzip.h>

#include <cstdint>

#include "base/files.h"
#include "base/input_error.h"
#include "base/text.h"

namespace mixity {
namespace {

constexpr int kAnyCase = 2;  // of unzLocateFile

// Bytes in memory as the file that minizip reads.
struct Stream {
  std::string_view bytes;
  std::size_t at = 0;
  bool ended = false;  // within something that was read, which minizip asks for: it takes what is missing for zeros

  static Stream& of(void* file) { return *static_cast<Stream*>(file); }
  static void* open(void* bytes, const void*, int) { return new Stream{*static_cast<const std::string_view*>(bytes)}; }
  static uLong read(void*, void* file, void* to, uLong most) {
    Stream& from = of(file);
    const std::size_t length = from.bytes.copy(static_cast<char*>(to), most, from.at);
    from.at += length;
    from.ended |= length < most;
    return length;
  }
  static ZPOS64_T tell(void*, void* file) { return of(file).at; }
  static long seek(void*, void* file, ZPOS64_T offset, int origin) {
    Stream& in = of(file);
    const std::size_t start = origin == ZLIB_FILEFUNC_SEEK_SET   ? 0
                              : origin == ZLIB_FILEFUNC_SEEK_CUR ? in.at
                                                                 : in.bytes.size();
    const std::size_t to = start + offset;  // a negative offset wraps
    if (to > in.bytes.size()) return -1;
    in.at = to;
    return 0;
  }
  static int close(void*, void* file) {
    delete &of(file);
    return 0;
  }
  static int error(void*, void* file) { return of(file).ended; }
};

}  // namespace

Archive::Archive(const std::string& path, std::string_view bytes, std::size_t most)
    : path_(path), most_(most), zip_(nullptr, &unzClose) {
  zlib_filefunc64_def functions{&Stream::open, &Stream::read,  nullptr,        &Stream::tell,
                                &Stream::seek, &Stream::close, &Stream::error, &bytes};
  zip_.reset(unzOpen2_64("", &functions));
  if (!zip_) throw InputError(path, "is a workbook or an archive that is damaged or incomplete; save or copy it again");
}

bool Archive::holds(const std::string& part) const {
  return unzLocateFile(zip_.get(), part.c_str(), kAnyCase) == UNZ_OK;
}

void Archive::read(const std::string& part, const std::function<bool(std::string_view)>& use) const {
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  unz_file_info64 about;
  if (!holds(part)) refuse_missing(part);
  if (unzGetCurrentFileInfo64(zip_.get(), &about, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK) refuse_damaged(part);
  require_readable({about.compressed_size, about.uncompressed_size, about.flag, about.compression_method});
  if (unzOpenCurrentFile(zip_.get()) != UNZ_OK) refuse_damaged(part);
  std::unique_ptr<void, int (*)(void*)> opened(zip_.get(), &unzCloseCurrentFile);
  std::string piece(kPiece, '\0');
  for (std::uint64_t total = 0;;) {
    const int length = unzReadCurrentFile(zip_.get(), piece.data(), kPiece);
    if (length == 0 && total == about.uncompressed_size) break;
    if (length <= 0) refuse_damaged(part);
    total += static_cast<std::uint64_t>(length);
    if (!use(std::string_view(piece).substr(0, static_cast<std::size_t>(length)))) return;
  }
  if (unzCloseCurrentFile(opened.release()) != UNZ_OK) refuse_damaged(part);
}

}  // namespace mixity
