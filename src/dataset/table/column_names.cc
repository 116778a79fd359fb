#include "dataset/table/column_names.h"

#include <algorithm>

#include "base/input_error.h"
#include "base/text.h"
#include "dataset/table/channel_clocks.h"
#include "dataset/table/column_advice.h"
#include "dataset/table/mapped_columns.h"

namespace mixity {
namespace {

/// Advice on a mass where a force is wanted: "if it is the weight of grams: --columns="P=Load (gf)"".
Message weight_of(const std::string& unit, ColumnId id, const std::vector<Heading>& headings, std::size_t index) {
  return "it is a mass; if a weight is meant: " +
         Message(Remedy::set("columns", mapping_with(unit + "f", id, headings, index)));
}

/// The columns named so far.
class Names {
 public:
  Names(const std::string& path, const std::vector<Heading>& headings, const ColumnRules& rules)
      : path_(path), headings_(headings), rules_(rules) {}

  void add_mapped() {
    const std::vector<ColumnId> here = rules_.shared_mapping ? mapped_in(headings_, rules_) : std::vector<ColumnId>{};
    for (const auto& [name, heading] : rules_.mapping) {
      if (rules_.shared_mapping && std::find(here.begin(), here.end(), *column_named(name)) == here.end()) continue;
      NamedColumn column = mapped_column(path_, headings_, *column_named(name), rules_.mapping);
      if (const NamedColumn* other = at(column.index))
        throw InputError(
            path_, column.heading.place,
            "column " + std::to_string(column.index + 1) + " is mapped to " + name + " and to " + name_of(other->id));
      columns_.push_back(std::move(column));
    }
  }

  /// Adds columns that have one of the program's own names and a fitting unit.
  void add_own_names() {
    for (std::size_t i = 0; i < headings_.size(); ++i) {
      const auto id = column_named(headings_[i].name);
      if (!id || at(i) || !is_read(*id) || is_mapped(*id) || (rules_.vocabulary && !unit_fits(headings_[i].unit, *id)))
        continue;
      if (const NamedColumn* before = find(*id))
        throw InputError(
            path_, headings_[i].place,
            "column '" + headings_[i].name + "' stands twice" +
                (rules_.vocabulary
                     ? ", in columns " + std::to_string(before->index + 1) + " and " + std::to_string(i + 1) + "; " +
                           Remedy::set("columns", headings_[i].name + "=" + std::to_string(i + 1)) +
                           " says which; if these are runs side by side, put them below one another with a column "
                           "'curve'"
                     : Message()));
      columns_.push_back({*id, i, headings_[i]});
    }
  }

  /// "a" beside "b", as `predict --shape=ellipse` writes the semi-axes: no radius then.
  void take_a_and_b_as_axes() {
    const auto radius =
        std::find_if(columns_.begin(), columns_.end(), [](const NamedColumn& one) { return one.id == ColumnId::a; });
    if (radius == columns_.end() || is_mapped(ColumnId::a) || find(ColumnId::a_par) || find(ColumnId::a_perp)) return;
    for (std::size_t i = 0; i < headings_.size(); ++i) {
      const Heading& heading = headings_[i];
      const bool alike = heading.unit.has_value() == radius->heading.unit.has_value();
      if (heading.name != "b" || at(i) || !alike || !unit_fits(heading.unit, ColumnId::a_perp)) continue;
      radius->id = ColumnId::a_par;
      columns_.push_back({ColumnId::a_perp, i, heading});
      return;
    }
  }

  /// "sigma_b", "sigma_d_par", "sigma_Major" (error_of_axis).
  void add_errors_of_axes() {
    for (std::size_t i = 0; i < headings_.size(); ++i)
      if (const ErrorOfAxis* const error = error_of_axis(headings_[i].name);
          error && !at(i) && !find(error->id) && find(error->beside) && unit_fits(headings_[i].unit, error->id))
        columns_.push_back({error->id, i, headings_[i]});
  }

  /// "T (s)", as testers of friction write it: T is a time where its unit is one.
  void add_times_called_T() {
    for (std::size_t i = 0; i < headings_.size() && rules_.log; ++i)
      if (is_time_called_T(headings_[i]) && !at(i) && !find(ColumnId::time) && !is_mapped(ColumnId::time))
        columns_.push_back({ColumnId::time, i, headings_[i]});
  }

  /// "Zeit  1 - Standardmessrate (s)", "Messzeit [hh:mm:ss]": the only column of times, whose name has other words,
  /// too.
  void add_time_with_other_words() {
    if (!rules_.log || find(ColumnId::time) || is_mapped(ColumnId::time)) return;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < headings_.size(); ++i)
      if (!at(i) && headings_[i].unit && unit_fits(headings_[i].unit, ColumnId::time) &&
          has_word_of_time(headings_[i].name, rules_.known_names()))
        found.push_back(i);
    if (found.size() == 1) columns_.push_back({ColumnId::time, found[0], headings_[found[0]]});
  }

  /// If the set is complete, adds only optional columns.
  void add_by_vocabulary() {
    const bool complete = is_complete();
    const auto is_wanted = [&](ColumnId id) { return is_read(id) && (!complete || is_beside(id)); };
    for (std::size_t i = 0; i < headings_.size(); ++i) {
      if (at(i) || column_named(headings_[i].name)) continue;  // an own name whose unit does not fit
      auto column = rules_.known_names().read(headings_[i], i);
      if (!column || !is_wanted(column->id)) continue;
      const NamedColumn* before = find(column->id);
      if (!before)
        columns_.push_back(std::move(*column));
      else if (!is_mapped(column->id) && !repeats_clock(*before, i) && !column_named(headings_[before->index].name))
        throw InputError(path_, headings_[i].place,
                         "'" + before->heading.text + "' and '" + headings_[i].text + "' may both be " +
                             name_of(column->id) + "; say which: " + mapping(column->id, headings_, before->index) +
                             " or " + mapping(column->id, headings_, i));
    }
    // "_N" of "normal force_N" may be an index; it is a unit if other headings end in units. No own name ends in one
    if (std::any_of(columns_.begin(), columns_.end(), [](const NamedColumn& column) { return column.heading.unit; }))
      for (NamedColumn& column : columns_)
        if (!column.heading.unit && !is_mapped(column.id) && is_wanted(column.id) && !column_named(column.heading.name))
          if (auto better = rules_.known_names().read(headings_[column.index], column.index, true);
              better && better->id == column.id)
            column = std::move(*better);
    if (!is_complete()) refuse_unit(rules_.log && !find(ColumnId::P) && !find(ColumnId::T));
  }

  /// Adds own names whose unit does not fit if no other column is that quantity. Reading them rejects the unit.
  void add_misfits() {
    for (std::size_t i = 0; i < headings_.size(); ++i)
      if (const auto id = column_named(headings_[i].name);
          id && is_read(*id) && !find(*id) && !at(i) && !is_time_called_T(headings_[i]))
        columns_.push_back({*id, i, headings_[i]});
  }

  /// Whether these columns suffice for points.
  bool is_complete() const {
    using enum ColumnId;
    // false for a log of forces or areas alone
    if (rules_.log) return holds_loads() && (find(ColumnId::time) || find(ColumnId::frame));
    if (find(P_c) && (find(T) || find(ColumnId::u))) return true;
    const bool toughness = (find(psi) || find(mode_ratio)) && (find(Gc) || find(Gc_over_GIc));
    return holds_loads() || toughness || (find(G_I) && find(G_II));
  }

  /// Removes radii or axes beside areas computed from them, or the reverse. If two names denote one quantity and only
  /// one is mapped, removes the other.
  void drop_redundant_sizes() {
    using enum ColumnId;
    const auto drop = [&](ColumnId id) {
      if (!is_mapped(id)) std::erase_if(columns_, [&](const NamedColumn& column) { return column.id == id; });
    };
    const auto is_called_a = [](const Heading& heading) { return column_named(heading.name) == ColumnId::a; };
    for (const auto& [one, other] :
         {std::pair(A, ColumnId::a), std::pair(psi, mode_ratio), std::pair(Gc, Gc_over_GIc)}) {
      if (is_mapped(other)) drop(one);
      if (is_mapped(one)) drop(other);
    }
    if (find(A) && std::none_of(headings_.begin(), headings_.end(), is_called_a)) drop(ColumnId::a);
    if (find(A) || find(ColumnId::a)) drop(diameter);
  }

  /// Pull-off loads are read where the table has no areas: then of T or else u, and their errors.
  void drop_what_pull_off_lacks() {
    using enum ColumnId;
    const bool pull_off = find(P_c) && !rules_.approach_held && !holds_loads();
    const auto stays = [&](ColumnId id) {
      if (id == sigma_P && rules_.approach_held) return true;
      const bool of_pull_off = id == P_c || id == ColumnId::u || id == sigma_P || id == sigma_u;
      if (!pull_off) return !of_pull_off;
      if (id == ColumnId::u || id == sigma_u) return !find(T);
      return of_pull_off || id == T || id == sigma_T || id == curve || id == include;
    };
    std::erase_if(columns_, [&](const NamedColumn& column) { return !is_mapped(column.id) && !stays(column.id); });
  }

  /// Where each channel has a column of times, takes that of the first channel that is read.
  void take_clock_of_channels() {
    const NamedColumn* const time = find(ColumnId::time);
    if (!time || is_mapped(ColumnId::time)) return;
    std::optional<std::size_t> first;
    for (const NamedColumn& column : columns_)
      if (column.id < ColumnId::psi) first = std::min(first.value_or(column.index), column.index);
    const auto clock = first ? clock_of(headings_, time->index, *first, *first) : std::nullopt;
    if (!clock || *clock == time->index || at(*clock)) return;
    for (NamedColumn& column : columns_)
      if (column.id == ColumnId::time) column = {ColumnId::time, *clock, headings_[*clock]};
  }

  std::vector<NamedColumn> sorted() && {
    std::sort(columns_.begin(), columns_.end(),
              [](const NamedColumn& one, const NamedColumn& other) { return one.index < other.index; });
    return std::move(columns_);
  }

 private:
  static bool has_word_of_time(std::string_view name, const Vocabulary& vocabulary) {
    constexpr std::string_view kBetween = " _-.:/,";
    for (std::size_t at = 0; at < name.size();) {
      const std::size_t end = std::min(name.find_first_of(kBetween, at), name.size());
      const std::string word = folded(name.substr(at, end - at));
      if (end > at + 1 && (vocabulary.find(word) == ColumnId::time || word.ends_with("zeit") || word.ends_with("time")))
        return true;
      at = end + 1;
    }
    return false;
  }
  static bool is_time_called_T(const Heading& heading) {
    const auto unit = (heading.name == "T" || heading.name.ends_with(".T")) && heading.unit ? parse_unit(*heading.unit)
                                                                                            : std::nullopt;
    return unit && unit->dimension == dimension::time;
  }
  /// Whether a column repeats the clock: frames, or the times of another channel.
  bool repeats_clock(const NamedColumn& before, std::size_t index) const {
    if (before.id == ColumnId::frame) return true;
    if (before.id != ColumnId::time) return false;
    const std::vector<std::size_t> clocks = clocks_of_channels(headings_, before.index);
    return before.heading.text == headings_[index].text ||
           std::find(clocks.begin(), clocks.end(), index) != clocks.end();
  }

  template <class Value>
  const NamedColumn* column_with(Value NamedColumn::*member, Value value) const {
    const auto found = std::find_if(columns_.begin(), columns_.end(),
                                    [&](const NamedColumn& column) { return column.*member == value; });
    return found == columns_.end() ? nullptr : &*found;
  }
  const NamedColumn* find(ColumnId id) const { return column_with(&NamedColumn::id, id); }
  const NamedColumn* at(std::size_t index) const { return column_with(&NamedColumn::index, index); }
  bool is_mapped(ColumnId id) const { return rules_.mapping.contains(name_of(id)); }
  bool is_read(ColumnId id) const {
    if (id == ColumnId::delta) return rules_.approach_held;
    return rules_.log || !is_clock(id);
  }
  /// Whether it is a standard error of the columns that make points, a name of runs, or a column that selects rows.
  bool is_beside(ColumnId id) const {
    using enum ColumnId;
    if (id == angle) return find(major);
    if (rules_.log) return false;
    if (id == sigma_T || id == sigma_A) return find(T);
    if (id == sigma_P && rules_.approach_held) return find(P);
    if (id == sigma_P || id == sigma_u) return find(P_c);
    if (id == sigma_a_par || id == sigma_a_perp) return find(a_par) || find(d_par) || find(major);
    if (id == sigma_Gc) return find(Gc) || find(Gc_over_GIc);
    if (id == sigma_GI || id == sigma_GII) return find(G_I);
    return id == curve || id == include;
  }
  bool holds_loads() const {
    using enum ColumnId;
    const bool held = rules_.approach_held ? find(delta) != nullptr : find(P) || rules_.load_stated;
    return find(T) && held && is_sized();
  }
  bool is_sized() const {
    using enum ColumnId;
    return find(A) || std::any_of(kContactLengths.begin(), kContactLengths.end(), [&](const ContactLengths& lengths) {
             return find(lengths.one) && find(lengths.other);
           });
  }

  /// Throws for a heading of a quantity that is still needed, if its unit is unknown or does not fit. `masses`: only
  /// for a unit of mass, as a log of areas needs no forces.
  void refuse_unit(bool masses) const {
    for (std::size_t i = 0; i < headings_.size(); ++i) {
      const Heading& heading = headings_[i];
      if (masses && !(heading.unit && is_mass(*heading.unit))) continue;
      const auto id = rules_.known_names().find(heading.name);
      if (!id || unit_fits(heading.unit, *id) || find(*id)) continue;
      if (*id == ColumnId::T || (*id == ColumnId::P && !rules_.load_stated) || (*id == ColumnId::A && !is_sized()))
        throw InputError(
            path_, heading.place,
            "'" + printable(heading.text, 60) + "' may be " + name_of(*id) + ", but '" + *heading.unit + "' is not " +
                describe(kind_of(*id).dimension) +
                (is_mass(*heading.unit) ? ": " + weight_of(*heading.unit, *id, headings_, i)
                                        : "; if it is another way to write one: " + mapping(*id, headings_, i)));
    }
  }

  const std::string& path_;
  const std::vector<Heading>& headings_;
  const ColumnRules& rules_;
  std::vector<NamedColumn> columns_;
};

}  // namespace

std::vector<NamedColumn> name_columns(const std::string& path, const std::vector<Heading>& headings,
                                      const ColumnRules& rules) {
  Names names(path, headings, rules);
  names.add_mapped();
  names.add_own_names();
  names.take_a_and_b_as_axes();
  names.add_times_called_T();
  if (rules.vocabulary) {
    names.add_by_vocabulary();
    names.add_time_with_other_words();
    names.add_misfits();
  }
  if (!rules.log) names.add_errors_of_axes();
  names.drop_redundant_sizes();
  names.drop_what_pull_off_lacks();
  names.take_clock_of_channels();
  return std::move(names).sorted();
}

std::vector<NamedColumn> number_columns(const std::string& path, const std::vector<Heading>& headings,
                                        const ColumnRules& rules) {
  try {
    std::vector<NamedColumn> columns = name_columns(path, headings, rules);
    std::erase_if(columns, [](const NamedColumn& column) { return column.id == ColumnId::curve; });
    return columns;
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace mixity
