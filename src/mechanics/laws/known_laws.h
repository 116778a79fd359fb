// The process-wide registry of user laws by key. Thread-safe.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/laws/user_law.h"

namespace mixity {

/// Adds a law, or returns the same law if it is known already. Null, with the reason in `error`, if the definition is
/// invalid or a different law has this key.
std::shared_ptr<const UserLaw> define_law(const LawDefinition& definition, LawError& error);
std::shared_ptr<const UserLaw> add_law(const std::shared_ptr<const UserLaw>& made, LawError& error);

/// The law with this key; null if there is none.
std::shared_ptr<const UserLaw> find_law(std::string_view key);

/// The keys in order of definition.
std::vector<std::string> law_keys();

/// Frees all keys. A law itself is freed with its last user.
void forget_laws();

}  // namespace mixity
