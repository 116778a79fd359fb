// Excludes points of a data set.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// A range of lines of the CSV, both ends included.
struct LineRange {
  std::size_t first, last;
  std::string file{};  // name without folder; empty: the only file of the data set
};
/// "17", "40-58" or "run_3.csv:17". Null for other texts.
std::optional<LineRange> parse_lines(std::string_view text);

/// These points as lines of their files in the form of parse_lines: "26,52-54". Empty if there are more than 40 ranges,
/// or if the name of a file has a comma.
std::string lines_text(const Dataset& data, const std::vector<std::size_t>& points);

/// The treatment of points without shear (PointPlace): fitted like the others, fitted with a separate toughness, or
/// left out.
enum class Unsheared { in, own, out };
constexpr std::string_view to_string(Unsheared unsheared) {
  return unsheared == Unsheared::in ? "in" : unsheared == Unsheared::own ? "own" : "out";
}

struct Exclusion {
  std::vector<LineRange> lines{};
  /// Runs by name as outputs show it, or by load ("4.68 mN") to 0.1 %, as readers may round it.
  std::vector<std::string> runs{};
  Unsheared unsheared = Unsheared::in;
};

/// Moves these points to Dataset::excluded, and removes runs left without points. Throws InputError for lines without a
/// point, for an unknown run, and if no point is left.
void exclude(Dataset& data, const Exclusion& which);

/// Moves each point that has a reason to Dataset::excluded.
void exclude_points(const std::vector<std::string_view>& reasons, Dataset& data);

}  // namespace mixity
