// Laws that are typed: in a fit definition, as a flag, and those of data/laws.toml, which the program carries with it.
#pragma once

#include <toml++/toml.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/laws/law.h"

namespace mixity {

/// A law that was defined, and what was noticed about it.
struct DefinedLaw {
  std::shared_ptr<const ExpressionLaw> law;
  std::vector<std::string> warnings{};
};

/// "mine: 1 + (1-l)*tan(psi)^2; l=0..1", "mine: 1 + p*t^n; p=0..1, n=0.5..4 start 2; normalised", or without a key,
/// which then is law_1, law_2, ... `what` names the text in messages. Throws InputError, with the column in the text,
/// for what is no such law, fails a check (law_traits.h), or has the key of another model.
DefinedLaw define_law_text(const std::string& what, std::string_view text);

/// Only what the text says; `expression_at`: where its expression begins. Throws InputError for what has not this form.
LawDefinition read_law_text(const std::string& what, std::string_view text, std::size_t* expression_at = nullptr);

/// The same of a definition; an empty key becomes law_ and digits that follow from it. Columns count in its text.
DefinedLaw define_law_checked(const std::string& what, LawDefinition definition);

/// The table [laws] of the file at `path`: each law a table with f (or criterion, an equation), its parameters as
/// [least, greatest] or {range = [...], start = ...}, and name, source, normalised. Throws InputError as above, with
/// line and column in the file.
std::vector<DefinedLaw> define_laws(const std::string& path, const toml::table& laws);

/// A law as a table [laws.KEY] of a fit definition. Throws InputError for one that is a function.
std::string law_toml(const LawDefinition& law);

/// The same as read_law_text has it, without its key and name.
std::string law_text(const LawDefinition& law);

/// Where nothing is said of it: the middle of a range, in the logarithm of one over decades.
double usual_start(double lower, double upper);

/// Whether a model, published or defined, has this key.
bool is_model(std::string_view key);

/// Makes a law of data/laws.toml a model, if it has one of this key and it is none yet.
void provide_law(std::string_view key);

/// Keys of all models: published, defined, and of data/laws.toml.
std::vector<std::string> known_models();

/// What data/laws.toml holds.
struct ShippedLaw {
  std::string key, name, shown, source;
  std::vector<LawParameter> parameters;
};
const std::vector<ShippedLaw>& shipped_laws();
bool is_shipped(const ExpressionLaw& law);

}  // namespace mixity
