#include "dataset/table/vocabulary.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <iterator>

#include "base/toml_file.h"

namespace mixity {

extern const char* const kShippedHeadings;  // data/headings.toml, made into a source file by CMake

const Vocabulary& Vocabulary::shipped() {
  static const Vocabulary vocabulary = [] {
    Vocabulary made;
    made.add("headings.toml", toml::parse(kShippedHeadings));
    return made;
  }();
  return vocabulary;
}

Vocabulary Vocabulary::with(const std::string& path, Inputs& inputs) {
  Vocabulary vocabulary = shipped();
  vocabulary.add(path, read_toml(path, inputs));
  return vocabulary;
}

namespace {

/// "CH1 Normal load", "Kanal 3: Fx" or "AI0_Fx" without the channel of a recorder; empty if none is named.
std::string_view without_channel(std::string_view name) {
  constexpr std::string_view kDigits = "0123456789", kSigns = " .:_-#";
  const std::size_t number = name.find_first_of(kDigits);
  if (number == std::string_view::npos || number == 0) return {};
  const std::size_t behind = std::min(name.find_first_not_of(kDigits, number), name.size());
  const std::size_t rest = name.find_first_not_of(kSigns, behind);
  if (rest == std::string_view::npos || rest == behind) return {};
  const std::string device = folded(name.substr(0, number));
  for (const std::string_view known : {"ch", "chan", "channel", "kanal", "ai", "voie", "canal", "canale", "input"})
    if (device == known) return name.substr(rest);
  return {};
}

}  // namespace

template <class TomlTable>
void Vocabulary::add(const std::string& path, const TomlTable& table) {
  for (const auto& [key, lists] : table) {
    const auto id = column_named(key.str());
    if (!id && key != "error")
      fail_at(path, key,
              "no quantity is called \"" + std::string(key.str()) + "\"" + did_you_mean(key.str(), column_names()));
    if (!lists.is_table()) fail_at(path, lists, "must be a table with lists of symbols and names");
    for (const auto& [kind, list] : *lists.as_table()) {
      const bool symbols = kind == "symbols";
      if (!symbols && kind != "names") fail_at_unknown(path, kind, {"symbols", "names"});
      if (!list.is_array()) fail_at(path, list, std::string(kind.str()) + " must be a list of strings");
      for (const toml::node& entry : *list.as_array()) {
        if (!entry.is_string()) fail_at(path, entry, std::string(kind.str()) + " must be a list of strings");
        const std::string& text = entry.as_string()->get();
        const std::string name = symbols ? text : folded(text);
        if (name.empty()) fail_at(path, entry, "\"" + text + "\" holds neither letters nor digits");
        const auto [at, is_new] = (symbols ? symbols_ : names_).try_emplace(name, id);
        if (!is_new && at->second != id)
          fail_at(path, entry,
                  "\"" + text + "\" already is a name of " +
                      (at->second ? std::string(to_string(*at->second)) : std::string("error")));
        if (symbols || !id) continue;
        // Words that name two quantities in two orders are ambiguous when sorted.
        const auto [same, first] = words_.try_emplace(sorted_words(text), id);
        if (!first && same->second != id) same->second = std::nullopt;
      }
    }
  }
}

std::optional<ColumnId> Vocabulary::find_quantity(std::string_view name) const {
  if (const auto symbol = symbols_.find(name); symbol != symbols_.end()) return symbol->second;
  const std::string bare = folded(name);
  if (const auto found = bare.empty() ? names_.end() : names_.find(bare); found != names_.end()) return found->second;
  const auto found = words_.find(sorted_words(name));
  return found == words_.end() ? std::nullopt : found->second;
}

/// "T_err", "err_T", "T std", "standard error of shear force", "u_T".
std::optional<ColumnId> Vocabulary::find_error(std::string_view name) const {
  using enum ColumnId;
  constexpr std::pair<ColumnId, ColumnId> kErrors[] = {{T, sigma_T},    {A, sigma_A},     {P_c, sigma_P},
                                                       {u, sigma_u},    {Gc, sigma_Gc},   {Gc_over_GIc, sigma_Gc},
                                                       {G_I, sigma_GI}, {G_II, sigma_GII}};
  const auto is_error = [&](std::string_view text) {
    const auto found = names_.find(folded(text));
    return text == "\xC2\xB1" || text == "+/-" || text == "+-" || (found != names_.end() && !found->second);
  };
  const auto is_symbol = [&](std::string_view text) {
    const auto found = symbols_.find(text);
    return found != symbols_.end() && !found->second;
  };
  for (std::size_t at = name.find_first_of(" _-."); at < name.size(); at = name.find_first_of(" _-.", at + 1)) {
    const std::string_view head = trim_name(name.substr(0, at));
    std::string_view tail = trim_name(name.substr(at + 1));
    const bool before = is_error(head) || (is_symbol(head) && tail.find_first_of(" _") == std::string_view::npos);
    if (!before && !is_error(tail)) continue;
    for (const std::string_view of : {"of ", "of the ", "der ", "de ", "de la ", "di ", "del "})
      if (before && tail.starts_with(of)) tail.remove_prefix(of.size());
    const std::string_view quantity = before ? tail : head;
    const auto id = column_named(quantity) ? column_named(quantity) : find_quantity(quantity);
    for (const auto& [of, error] : kErrors)
      if (id == of) return error;
  }
  return std::nullopt;
}

std::optional<ColumnId> Vocabulary::find(std::string_view name) const {
  const auto quantity = find_quantity(name);
  return quantity ? quantity : find_error(name);
}

/// "Fn_Kraft", "Fx force", "sensor Fz": the symbol of a force beside a word for one. A symbol that is a unit, too, is
/// none: "Force N".
std::optional<ColumnId> Vocabulary::find_symbol_of_force(std::string_view name) const {
  constexpr std::string_view kBetween = " _-.:",
                             kWords[] = {"force", "load",   "kraft", "forza",  "carico",   "fuerza",
                                         "carga", "effort", "cell",  "sensor", "loadcell", "signal"};
  const auto is_word = [&](std::string_view text) {
    return std::find(std::begin(kWords), std::end(kWords), folded(text)) != std::end(kWords);
  };
  const std::size_t first = name.find_first_of(kBetween), last = name.find_last_of(kBetween);
  if (first == std::string_view::npos) return std::nullopt;
  std::string_view symbol;
  if (is_word(name.substr(last + 1)))
    symbol = name.substr(0, last);
  else if (is_word(name.substr(0, first)))
    symbol = name.substr(first + 1);
  const auto found = symbols_.find(symbol);
  const bool is_force = found != symbols_.end() && (found->second == ColumnId::P || found->second == ColumnId::T);
  return is_force && !parse_unit(symbol) ? found->second : std::nullopt;
}

/// "F_R", "FR", "A_k": the letter of a force or an area with one or two more, as laboratories choose them.
bool is_symbol_of(ColumnId id, std::string_view text) {
  const bool force = id == ColumnId::P || id == ColumnId::T;
  if (text.size() < 2 || !(force ? text[0] == 'F' : id == ColumnId::A && text[0] == 'A')) return false;
  const std::string_view below = text.substr(text[1] == '_' ? 2 : 1);
  return (below.size() == 1 || below.size() == 2) &&
         std::all_of(below.begin(), below.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
}

/// Like find; also understands a name followed by a symbol of the quantity: "Normal force F_N", "friction force, T".
std::optional<ColumnId> Vocabulary::find_with_symbol(std::string_view name) const {
  const auto own_or_found = [&](std::string_view text) { return column_named(text) ? column_named(text) : find(text); };
  if (const auto found = own_or_found(name)) return found;
  // "DAQ.Fx": of a device, not "max.Fx"
  constexpr std::string_view kNoDevices[] = {"max", "min", "mean",   "avg",   "std",
                                             "abs", "set", "target", "delta", "cmd"};
  const auto is_device = [&](std::string_view text) {
    return text.size() > 1 &&
           std::find(std::begin(kNoDevices), std::end(kNoDevices), folded(text)) == std::end(kNoDevices);
  };
  const std::size_t dot = name.rfind('.'), colon = name.find(": ");
  if (dot != std::string_view::npos && name.find(' ') == std::string_view::npos && is_device(name.substr(0, dot)))
    if (const auto of_device = own_or_found(name.substr(dot + 1))) return of_device;
  if (colon != std::string_view::npos && is_device(name.substr(0, colon)))  // "Latest: Normal force"
    if (const auto of_device = own_or_found(trim_name(name.substr(colon + 2)))) return of_device;
  if (const auto of_channel = find(without_channel(name))) return of_channel;
  if (const auto force = find_symbol_of_force(name)) return force;
  const std::size_t behind = name.find_last_of(" ,");
  if (behind == std::string_view::npos) return std::nullopt;
  const auto first = find(trim_name(name.substr(0, name.find_last_not_of(" ,", behind) + 1)));
  const std::string_view symbol = name.substr(behind + 1);
  const auto second = own_or_found(symbol);
  return first && (first == second || (!second && is_symbol_of(*first, symbol))) ? first : std::nullopt;
}

std::optional<NamedColumn> Vocabulary::read(const Heading& heading, std::size_t index, bool with_unit) const {
  const auto named = [&](std::string_view name, const std::optional<std::string>& unit) -> std::optional<NamedColumn> {
    const auto id = find_with_symbol(trim_name(name));
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
    // a name with brackets, as users may list it: "F_N (cell 2) [mN]"
    return named(without_brackets(heading.text), heading.unit);
  }
  std::string_view text = heading.text;
  // MATLAB replaces a closing bracket by an underscore, R replaces both by dots: "Fn..mN."
  while (text.ends_with('_') || text.ends_with('.')) text.remove_suffix(1);
  for (const std::string_view sign : {"/", " in ", " en ", ",", "_", ".", " "}) {
    const std::size_t at = text.rfind(sign);
    if (at == std::string_view::npos || at == 0) continue;
    const std::string unit(without_brackets(text.substr(at + sign.size())));
    if (!parse_unit(unit) || parse_unit(unit)->text == "1") continue;
    std::string_view name = text.substr(0, at);
    while (sign == "." && name.ends_with('.')) name.remove_suffix(1);
    if (auto found = named(name, unit)) return found;
  }
  return std::nullopt;
}

bool unit_fits(const std::optional<std::string>& unit, ColumnId id) {
  if (!unit) return true;
  const ColumnKind& kind = kind_of(id);
  const auto parsed = parse_unit(*unit);
  if (!parsed) return false;
  if (parsed->text == "%") return kind.name.starts_with("sigma_");
  return parsed->dimension == kind.dimension || is_pixels(parsed->dimension, kind.dimension);
}

bool is_mass(std::string_view unit) { return unit == "g" || unit == "mg" || unit == "kg"; }

bool is_pixels(const Dimension& found, const Dimension& wanted) {
  constexpr Dimension kPixels{0, 0, 0, 0, 1}, kSquarePixels{0, 0, 0, 0, 2};
  // an area may also be a number of pixels
  return wanted == dimension::area ? found == kPixels || found == kSquarePixels
                                   : wanted == dimension::length && found == kPixels;
}

}  // namespace mixity
