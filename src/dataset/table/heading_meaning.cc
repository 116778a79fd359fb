#include "dataset/table/heading_meaning.h"

#include "dataset/table/vocabulary.h"

namespace mixity {
namespace {

/// The quantity of a name, by the program's own names or the vocabulary.
std::optional<ColumnId> meaning(std::string_view name, const Vocabulary& vocabulary) {
  if (const auto own = column_named(name)) return own;
  if (const auto found = vocabulary.find(name)) return found;
  // "Normal force F_N", "friction force, T": a name and the symbol of the same
  const std::size_t behind = name.find_last_of(" ,");
  if (behind == std::string_view::npos) return std::nullopt;
  const auto first = vocabulary.find(trim_name(name.substr(0, name.find_last_not_of(" ,", behind) + 1)));
  const std::string_view symbol = name.substr(behind + 1);
  const auto second = column_named(symbol) ? column_named(symbol) : vocabulary.find(symbol);
  return first && first == second ? first : std::nullopt;
}

}  // namespace

bool is_pixels(const Dimension& found, const Dimension& wanted) {
  // a number of pixels is an area, and so are square pixels
  const bool area = wanted == dimension::area;
  return found == Dimension{0, 0, 0, 0, 1} ? area || wanted == dimension::length
                                           : area && found == Dimension{0, 0, 0, 0, 2};
}

bool unit_fits(const std::optional<std::string>& unit, ColumnId id) {
  if (!unit) return true;
  const ColumnKind& kind = kind_of(id);
  const auto parsed = parse_unit(*unit);
  if (!parsed) return false;
  if (parsed->text == "%") return kind.name.starts_with("sigma_");
  if (kind.always_a_number) return parsed->dimension == dimension::none;
  return parsed->dimension == kind.dimension || is_pixels(parsed->dimension, kind.dimension);
}

std::optional<NamedColumn> read_heading(const Heading& heading, std::size_t index, const Vocabulary& vocabulary,
                                        bool with_unit) {
  const auto named = [&](std::string_view name, const std::optional<std::string>& unit) -> std::optional<NamedColumn> {
    const auto id = meaning(trim_name(name), vocabulary);
    if (!id || !unit_fits(unit, *id)) return std::nullopt;
    NamedColumn column{*id, index, heading};
    column.heading.unit = unit;
    return column;
  };
  if (!with_unit)
    if (auto found = named(heading.name, heading.unit)) return found;
  if (heading.unit && heading.closed) {
    // "Normal force (F_N)": a symbol in brackets
    if (!parse_unit(*heading.unit)) return named(heading.name + " " + *heading.unit, std::nullopt);
    // "F_N (cell 2) [mN]", with a name that is none before the first bracket
    return named(without_brackets(heading.text), heading.unit);
  }
  std::string_view text = heading.text;
  while (text.ends_with('_')) text.remove_suffix(1);  // what MATLAB makes of a closing bracket
  for (const std::string_view sign : {"/", " in ", " en ", ",", "_", " "}) {
    const std::size_t at = text.rfind(sign);
    if (at == std::string_view::npos || at == 0) continue;
    const std::string unit(without_brackets(text.substr(at + sign.size())));
    if (!parse_unit(unit) || parse_unit(unit)->text == "1") continue;
    if (auto found = named(text.substr(0, at), unit)) return found;
  }
  return std::nullopt;
}

}  // namespace mixity
