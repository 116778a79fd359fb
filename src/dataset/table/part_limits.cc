// What parts of a zip file are read, whatever unpacks them.
#include "base/files.h"
#include "base/input_error.h"
#include "base/text.h"
#include "dataset/table/archive.h"

namespace mixity {

void Archive::require_readable(const Part& part) const {
  constexpr std::uint64_t kOrdinary = std::uint64_t{1} << 26, kMostRatio = 500;
  constexpr unsigned long kLocked = 1, kStored = 0, kDeflated = 8;
  if (part.size > most_) refuse("unpacks to more than " + std::to_string(most_ >> 20) + " MB");
  if (part.size > kOrdinary && part.size / kMostRatio > part.packed)
    refuse("unpacks to more than " + std::to_string(kMostRatio) + " times its size, as no measurement does");
  if (part.flags & kLocked) refuse("is protected by a password");
  if (part.method != kStored && part.method != kDeflated)
    refuse("is packed by an unknown method (" + std::to_string(part.method) + ")");
}

void Archive::refuse(const std::string& what) const {
  throw InputError(path_, what + "; save the sheet that holds the data as CSV");
}

void Archive::refuse_missing(const std::string& part) const {
  throw InputError(path_, "is damaged: its part '" + printable(part, 60) + "' is missing; save it again");
}

void Archive::refuse_damaged(const std::string& part) const {
  throw InputError(path_, "is damaged (part '" + printable(part, 60) + "'); save or copy it again");
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
