// The laws that a process knows by their keys, beside the published ones. Safe to call from several threads.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/laws/law.h"

namespace mixity {

/// Makes a law known, or finds the same law if it is known already. Null, and the reason in `error`, for what is not a
/// law, and if a different law has this key.
std::shared_ptr<const ExpressionLaw> define_law(const LawDefinition& definition, LawError& error);
std::shared_ptr<const ExpressionLaw> add_law(const std::shared_ptr<const ExpressionLaw>& made, LawError& error);

/// Null if there is none.
std::shared_ptr<const ExpressionLaw> find_law(std::string_view key);

/// In the order in which they were defined.
std::vector<std::string> law_keys();

/// Frees the keys. A law itself is freed with its last user.
void forget_law(std::string_view key);
void forget_laws();

}  // namespace mixity
