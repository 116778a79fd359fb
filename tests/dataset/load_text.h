// A data set from text, as it would stand in a CSV and the TOML beside it.
#pragma once

#include <string>

#include "dataset/dataset.h"
#include "dataset/temporary_folder.h"

namespace mixity {

inline Dataset load_text(const std::string& csv, const std::string& toml = "", const Overrides& overrides = {}) {
  const TemporaryFolder folder;
  folder.write("a.toml", toml);
  return load_dataset(folder.write("a.csv", csv), overrides);
}

/// The error with the folder left out: "a.csv:2:3: ...".
inline std::string load_error(const std::string& csv, const std::string& toml = "") {
  const TemporaryFolder folder;
  folder.write("a.toml", toml);
  const std::string path = folder.write("a.csv", csv);
  return folder.left_out_of(input_error([&] { load_dataset(path); }));
}

/// "LINE REASON", a line each.
inline std::string excluded_lines(const Dataset& data) {
  std::string text;
  for (const Excluded& excluded : data.excluded)
    text += std::to_string(excluded.line) + " " + std::string(excluded.reason) + "\n";
  return text;
}

}  // namespace mixity
