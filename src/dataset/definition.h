// Definitions of data: what was understood of files, as a TOML for others of their kind. read_metadata reads it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "dataset/metadata.h"

namespace mixity {

/// A file that was read.
struct UnderstoodFile {
  std::string path;
  Metadata metadata;                             // as it was used
  std::map<std::string, std::string> mapping{};  // of its columns, as the key columns
  std::vector<std::string> missing{};            // constants that it needs and nobody states
};

/// `placeholders`: constants with invented values, since they are missing.
UnderstoodFile understood(const Dataset& data, const std::vector<std::string>& placeholders = {});

/// The definition of the kind of these files, to be written to `path`. What differs between them is a comment, and so
/// is the load, which is that of one file. Sources and notes are left out likewise.
std::string definition_text(const std::vector<UnderstoodFile>& files, const std::string& path,
                            Wording words = in_neutral_words);

}  // namespace mixity
