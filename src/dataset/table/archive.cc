#include "dataset/table/archive.h"

#include <zip.h>

#include "base/files.h"
#include "base/input_error.h"
#include "base/text.h"

namespace mixity {
namespace {

constexpr zip_flags_t kAnyCase = ZIP_FL_NOCASE;

std::string words(zip_error_t* error) {
  std::string text = zip_error_strerror(error);
  zip_error_fini(error);
  return text;
}

}  // namespace

Archive::Archive(const std::string& path, std::string_view bytes, std::size_t most)
    : path_(path), most_(most), zip_(nullptr, &zip_discard) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source) zip_.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
  if (zip_) return;
  if (source) zip_source_free(source);
  throw InputError(
      path, "is a workbook or an archive that is damaged or incomplete (" + words(&error) + "); save or copy it again");
}

bool Archive::holds(const std::string& part) const { return zip_name_locate(zip_.get(), part.c_str(), kAnyCase) >= 0; }

void Archive::read(const std::string& part, const std::function<bool(std::string_view)>& use) const {
  constexpr zip_uint64_t kOrdinary = zip_uint64_t{1} << 26, kMostRatio = 500;
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  zip_stat_t about;
  if (zip_stat(zip_.get(), part.c_str(), kAnyCase, &about) != 0)
    throw InputError(path_, "is damaged: its part '" + printable(part, 60) + "' is missing; save it again");
  const auto refuse = [&](const std::string& what) {
    throw InputError(path_, what + "; save the sheet that holds the data as CSV");
  };
  if (about.size > most_) refuse("unpacks to more than " + std::to_string(most_ >> 20) + " MB");
  if (about.size > kOrdinary && about.size / kMostRatio > about.comp_size)
    refuse("unpacks to more than " + std::to_string(kMostRatio) + " times its size, as no measurement does");
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(zip_fopen(zip_.get(), part.c_str(), kAnyCase),
                                                               &zip_fclose);
  if (!file) {
    zip_error_t* const error = zip_get_error(zip_.get());
    if (zip_error_code_zip(error) == ZIP_ER_NOPASSWD) refuse("is protected by a password");
    refuse("cannot be unpacked (" + std::string(zip_error_strerror(error)) + ")");
  }
  std::string piece(kPiece, '\0');
  for (std::size_t total = 0;;) {
    const zip_int64_t length = zip_fread(file.get(), piece.data(), piece.size());
    if (length < 0)
      throw InputError(path_, "is damaged (part '" + printable(part, 60) + "': " +
                                  zip_error_strerror(zip_file_get_error(file.get())) + "); save or copy it again");
    total += static_cast<std::size_t>(length);
    if (total > most_) refuse("unpacks to more than it states");
    if (length == 0 || !use(std::string_view(piece).substr(0, static_cast<std::size_t>(length)))) return;
  }
}

std::string Archive::read(const std::string& part) const {
  std::string text;
  read(part, [&](std::string_view piece) {
    text += piece;
    if (text.size() > kMostText)
      throw InputError(path_, "is damaged: its part '" + printable(part, 60) + "' is too large");
    return true;
  });
  return text;
}

}  // namespace mixity
