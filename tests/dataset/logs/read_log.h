// A log from its text.
#pragma once

#include <string>

#include "base/input_error.h"
#include "dataset/logs/recording.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace read_log {

inline Recording read(const std::string& text, const std::string& columns = "") {
  const TemporaryFolder folder;
  Metadata metadata;
  if (!columns.empty()) set_field(metadata, "columns", columns);
  return read_recordings(folder.write("log.csv", text), metadata).front();
}
inline std::string error_of(const std::string& text) {
  const TemporaryFolder folder;
  const std::string path = folder.write("log.csv", text);
  return folder.left_out_of(input_error([&] { read_recordings(path, Metadata{}); }));
}

}  // namespace read_log
}  // namespace mixity
