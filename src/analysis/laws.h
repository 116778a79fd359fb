// Laws that users define by a flag or in a fit definition, and the laws of data/laws.toml, which are compiled in.
#pragma once

#include <toml++/toml.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/laws/user_law.h"

namespace mixity {

/// A law that was defined, and warnings about it.
struct DefinedLaw {
  std::shared_ptr<const UserLaw> law;
  std::vector<std::string> warnings{};
};

/// Defines "mine: 1 + (1-l)*tan(psi)^2; l=0..1" or "mine: 1 + p*t^n; p=0..1, n=0.5..4 start 2; normalised". Without a
/// key the law becomes law_1, law_2, ... `what` names the text in messages. Throws InputError, with the column in the
/// text, for a syntax error, a failed check (law_check.h), or the key of another model.
DefinedLaw define_law_text(const std::string& what, std::string_view text);

/// Reads the text without defining the law; `expression_at`: where its expression begins. Throws InputError for a
/// syntax error.
LawDefinition read_law_text(const std::string& what, std::string_view text, std::size_t* expression_at = nullptr);

/// Defines a law. Without a key it becomes law_ and a hash of its definition. Error columns count in its text.
DefinedLaw define_law_checked(const std::string& what, LawDefinition definition);

/// Defines the laws of the table [laws] of the file at `path`. Each is a table with f (or criterion, an equation), its
/// parameters as [least, greatest] or {range = [...], start = ...}, and name, source, normalised. Throws InputError as
/// above, with line and column in the file.
std::vector<DefinedLaw> define_laws(const std::string& path, const toml::table& laws);

/// The law as a table [laws.KEY] of a fit definition. Throws InputError for a law given as a function.
std::string law_toml(const LawDefinition& law);

/// The law in the form that read_law_text reads, without its key and name.
std::string law_text(const LawDefinition& law);

/// The default start value: the middle of the range, in the logarithm if the range spans decades.
double usual_start(double lower, double upper);

/// Whether a model, published or defined, has this key.
bool is_model(std::string_view key);

/// Defines the law of data/laws.toml with this key, if it exists and no model has the key yet.
void provide_law(std::string_view key);

/// Keys of all models: published, defined, and of data/laws.toml.
std::vector<std::string> known_models();

/// A law as stated in a file, with the source of its publication.
struct StatedLaw {
  LawDefinition definition;
  std::string source;
};
/// The laws of data/laws.toml.
const std::vector<StatedLaw>& shipped_laws();
bool is_shipped(const UserLaw& law);

}  // namespace mixity
