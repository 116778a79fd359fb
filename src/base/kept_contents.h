// Which contents of inputs stay in memory once they are read.
#pragma once

#include <vector>

#include "base/inputs.h"

namespace mixity {

/// Forgets contents of more than a megabyte: content_of reads those files again.
void forget_large_contents(std::vector<InputFile>& files);

}  // namespace mixity
