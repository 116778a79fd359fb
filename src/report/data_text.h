// A data set as text for a terminal: how it was read, its constants, its runs, its notes and the excluded points.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/unsheared.h"

namespace mixity {

/// A constant of the experiment as it was stated.
struct StatedConstant {
  const char *name, *label;      // the label has the symbol: "modulus E*"
  double value, standard_error;  // in SI; error 0: taken as exact
  const char* unit;              // of SI; empty if dimensionless
};
std::vector<StatedConstant> stated_constants(const Metadata& metadata);

/// Label and value of each constant: {"modulus E*", "2.13 +/- 0.11 MPa"}. Units suit the size of the value; offsets are
/// in those of the file, and left out if the data have no loads or no dimensions. With loads, the last is the
/// convention of mode III.
std::vector<std::pair<std::string, std::string>> shown_constants(const Dataset& data);

/// The first lines: the heading, the name and the path, without a line end.
std::string data_heading(const Dataset& data);

/// A line for reconstructed data, else empty.
std::string reconstructed_note(const Dataset& data);
/// That line, and one for each note on the data.
std::string data_notes(const Dataset& data, Wording words);

/// "40 data rows, 38 used, 2 excluded".
std::string row_counts(const Dataset& data);
/// Rows that became points or pull-off loads.
std::size_t usable_rows(const Dataset& data);
/// ", in 8 loading runs", ", 6 pull-off loads"; empty for data without loads.
std::string runs_of_points(const Dataset& data);

/// The first 8 excluded points with their reasons, one a line beginning with `beginning`, and the number of the others.
/// `elsewhere`: where all of them are listed.
std::string first_excluded(const Dataset& data, const std::vector<Excluded>& list, std::string_view beginning,
                           const std::string& elsewhere);
/// The same for all models, under a heading; empty if no point is excluded.
std::string excluded_text(const Dataset& data, const std::string& elsewhere);

/// For `mixity check`: how the file was read, the runs, the excluded points and the oddities. `unsheared`: null if not
/// tested.
std::string check_text(const Dataset& data, const std::optional<UnshearedTest>& unsheared,
                       Wording words = in_neutral_words);

/// The part of it that needs no constants: no comparison with JKR, no search for oddities.
std::string reading_text(const Dataset& data);

}  // namespace mixity
