// What `mixity check` prints.
#pragma once

#include <optional>
#include <string>

#include "dataset/dataset.h"
#include "fitting/unsheared.h"

namespace mixity {

/// `unsheared`: null where nothing is to be said of areas without shear.
std::string check_text(const Dataset& data, const std::optional<UnshearedTest>& unsheared = {},
                       Wording words = in_neutral_words);

/// How a file was read, of one whose constants are not known: columns, rows, runs.
std::string reading_text(const Dataset& data);

}  // namespace mixity
