// A part of a list of files, for one of several machines.
#pragma once

#include "base/units.h"
#include "cli/commands.h"
#include "cli/flags.h"
#include "cli/usage_error.h"

namespace mixity::cli {

/// With --shard=i/n every n-th argument from the i-th on; `mixity merge` puts what is made of the parts in order again.
/// Throws UsageError.
inline Arguments shard_of(const Arguments& arguments) {
  if (FLAGS_shard.empty()) return arguments;
  const std::size_t slash = FLAGS_shard.find('/');
  const auto part = parse_number(FLAGS_shard.substr(0, slash)),
             parts = slash == std::string::npos ? std::nullopt : parse_number(FLAGS_shard.substr(slash + 1));
  const auto whole = [](double value) {
    return value >= 1 && value <= 1e6 && value == static_cast<double>(static_cast<std::size_t>(value));
  };
  if (!part || !parts || !whole(*part) || !whole(*parts) || *part > *parts)
    throw UsageError("flag '--shard' is '" + FLAGS_shard + "'; it must be i/n, such as 2/10");
  Arguments mine;
  for (auto i = static_cast<std::size_t>(*part) - 1; i < arguments.size(); i += static_cast<std::size_t>(*parts))
    mine.push_back(arguments[i]);
  return mine;
}

}  // namespace mixity::cli
