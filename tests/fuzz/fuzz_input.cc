#include "fuzz_input.h"

#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "analysis/fit_definition.h"
#include "analysis/laws.h"
#include "base/units.h"
#include "dataset/check.h"
#include "dataset/dataset.h"
#include "dataset/peak_forces.h"
#include "dataset/table/columns.h"
#include "dataset/table/csv_file.h"
#include "dataset/table/plot_import.h"
#include "dataset/temporary_folder.h"
#include "mechanics/laws/law_check.h"
#include "promise.h"

namespace mixity::fuzz {
namespace {

/// A file that each input overwrites, in a temporary folder of the process.
class Scratch {
 public:
  explicit Scratch(std::string_view name) : path_(folder().path(name)) {
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    promise(file_ >= 0, "the scratch file opens");
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { ::close(file_); }

  const std::string& write(std::string_view text) const {
    promise(::ftruncate(file_, 0) == 0, "the scratch file is emptied");
    promise(::pwrite(file_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size()), "and written");
    return path_;
  }

 private:
  static const TemporaryFolder& folder() {
    static const TemporaryFolder folder;
    return folder;
  }
  std::string path_;
  int file_;
};

/// The text before the separator and the text behind it, which is empty if there is no separator.
std::pair<std::string_view, std::string_view> cut(std::string_view text, std::string_view separator) {
  const std::size_t at = text.find(separator);
  if (at == std::string_view::npos) return {text, {}};
  return {text.substr(0, at), text.substr(at + separator.size())};
}

void check_rows(std::string_view text) {
  for (const bool comments : {true, false}) {
    std::size_t last_line = 0;
    const auto use = [&](const CsvRow& row) {
      promise(row.line() > last_line, "lines count upwards");
      last_line = row.line();
      promise(row.size() > 0, "a row has a field");
      std::pair<std::size_t, std::size_t> last_place{row.line(), 0};
      for (std::size_t i = 0; i < row.size(); ++i) {
        const auto [line, column] = row.place(i);
        promise(std::pair(line, column) >= last_place && column <= text.size() + 1, "a field lies behind the last");
        last_place = {line, column};
        const std::string field(trim(row[i]));
        if (field.find('\r') != std::string::npos) continue;  // where a line ends depends on the whole file
        std::size_t again = 0;
        read_csv_text("x,x," + csv_field(field) + "\n", "again", true, [&](const CsvRow& copy) {
          ++again;
          promise(copy.size() == 3 && trim(copy[2]) == field, "a field that was written is read back", field);
        });
        promise(again == 1, "a field that was written is one row", field);
      }
    };
    accepts({"rows.csv:"}, [&] { read_csv_text(text, "rows.csv", comments, use); });
  }
}

void check_metadata(const Metadata& metadata) {
  for (const auto& value : {metadata.radius, metadata.modulus, metadata.youngs_modulus, metadata.toughness,
                            metadata.toughness_II, metadata.shear_strength})
    promise(!value || (std::isfinite(*value) && *value > 0), "a constant is finite and positive");
  if (metadata.poisson_ratio) promise(*metadata.poisson_ratio >= 0 && *metadata.poisson_ratio <= 0.5, "poisson_ratio");
}

/// Rows do not depend on the size of blocks.
void check_blocks(const std::string& path) {
  Inputs inputs;
  CsvFile whole(path, inputs), parts(path, inputs, {}, 1);
  whole.start();
  parts.start();
  if (whole.encoding() != parts.encoding()) return;  // the first block decides it
  CsvRow row, same;
  while (whole.next(row)) {
    promise(parts.next(same) && row.line() == same.line() && row.size() == same.size(), "a row comes once", path);
    for (std::size_t i = 0; i < row.size(); ++i) {
      promise(row[i] == same[i], "a field is itself in blocks of any size", path);
      double value = 0;
      promise(!row.number(i, value) || !row[i].empty(), "an empty field is no number");
    }
  }
  promise(!parts.next(same), "no row comes twice", path);
}

void check_data(const Dataset& data) {
  check_metadata(data.metadata);
  promise(data.points.size() + data.excluded.size() == data.rows && data.rows > 0, "each row is used or excluded");
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Point& point = data.points[i];
    const PointErrors errors = data.errors_of(i);
    for (const double value : {point.P, point.T, point.A, errors.T, errors.A, errors.ratio})
      promise(std::isfinite(value), "an accepted point is finite");
    const auto toughness = data.toughness(i);
    promise(toughness || data.has_loads, "a point of a toughness has one");
    if (toughness) {
      for (const double value : {toughness->ratio, toughness->mixity.cos, toughness->mixity.sin})
        promise(std::isfinite(value), "what is known of the toughness is finite");
      promise(toughness->psi() >= 0 && toughness->psi() < 1.5708, "psi lies in 0..90 degrees");
    }
    promise(point.curve < data.curves.size(), "a point belongs to a run");
    if (data.has_loads) promise(point.A > 0, "an area is positive");
  }
  promise(data.energies.size() == (data.has_energies ? data.points.size() : 0),
          "energies are of each point or of none");
  for (const PointEnergies& point : data.energies) {
    for (const double value : {point.G_I, point.G_II, point.sigma_GI, point.sigma_GII})
      promise(std::isfinite(value), "an accepted energy is finite");
    promise(point.G_I + point.G_II > 0 && (point.sigma_GI >= 0 || point.sigma_GI == kNotStated) &&
                (point.sigma_GII >= 0 || point.sigma_GII == kNotStated),
            "a toughness is positive");
  }
  for (const double scale : {data.display.force_scale, data.display.area_scale, data.display.energy_scale})
    promise(std::isfinite(scale) && scale > 0, "a scale is finite and positive");
  for (const std::string& line : find_oddities(data)) promise(!line.empty(), "an oddity is a sentence");
  for (const Message& note : data.notes)
    promise(is_one_printable_line(note.text()), "a note is one printable line", note.text());
}

void check_dataset(std::string_view text) {
  static const Scratch table("a.csv"), metadata("a.toml");
  const auto [toml, csv] = cut(text, "\n---\n");
  const std::string &path = table.write(csv), &beside = metadata.write(toml);
  accepts({path + ":", beside + ":"}, [&] { check_data(load_dataset(path)); });
  accepts({path + ":"}, [&] { check_blocks(path); });
}

void check_peaks(std::string_view text) {
  static const Scratch table("p.csv"), metadata("p.toml");
  const auto [toml, csv] = cut(text, "\n---\n");
  const std::string &path = table.write(csv), &beside = metadata.write(toml);
  accepts({path + ":", beside + ":"}, [&] {
    const PeakForces forces = load_peak_forces(path);
    check_metadata(forces.metadata);
    promise(forces.rows.size() + forces.excluded.size() > 0, "an accepted file has rows");
    for (const PeakForce& row : forces.rows) {
      promise(std::isfinite(row.P) && row.P > 0 && (row.peak || row.minimum), "a row has a load and a stress");
      promise(std::isfinite(row.peak.value_or(0)) && std::isfinite(row.minimum.value_or(0)), "a stress is finite");
    }
  });
}

void check_constants(std::string_view text) {
  static const Scratch file("m.toml");
  const std::string& path = file.write(text);
  accepts({path + ":"}, [&] { check_metadata(read_metadata(path)); });
}

void check_definition(std::string_view text) {
  static const Scratch file("f.toml");
  const std::string& path = file.write(text);
  accepts({path + ":"}, [&] {
    const FitRequest request = read_fit_definition(path);
    promise(!request.data_path.empty() && !request.models.empty(), "a definition names data and models");
    for (const HeldParameter& held : request.options.hold)
      promise(!held.value || std::isfinite(*held.value), "a held value is finite");
    for (const auto& [model, numbers] : request.published)
      for (const Published& number : numbers)
        promise(std::isfinite(number.value) && number.tolerance >= 0, "a published number can be compared with");
  });
}

void check_units(std::string_view text) {
  if (const auto unit = parse_unit(text))
    promise(std::isfinite(unit->factor) && unit->factor > 0, "a unit has a finite, positive factor", text);
  if (const auto quantity = parse_quantity(text))
    promise(std::isfinite(quantity->si()) && !std::isnan(quantity->value), "a quantity is finite", text);
  if (const auto number = parse_number(text)) {
    const double other = std::strtod(std::string(trim(text)).c_str(), nullptr);
    promise(
        *number == other || (std::isnan(*number) && std::isnan(other)) || (*number == 0 && std::abs(other) < 1e-300),
        "a number is what the C library reads", text);
  }
}

void check_import(std::string_view text) {
  static const Scratch file("i.csv");
  PlotImport options;
  const auto [x, after_x] = cut(text, "\n");
  const auto [y, after_y] = cut(after_x, "\n");
  auto [loads, plot] = cut(after_y, "\n");
  options.x_column = x;
  options.y_column = y;
  while (!loads.empty()) {
    const auto [load, rest] = cut(loads, ",");
    const auto quantity = parse_quantity(load);
    const bool force = quantity && (quantity->unit.text.empty() || quantity->unit.dimension == dimension::force);
    if (!force || (!options.loads.empty() && options.loads[0].unit.text != quantity->unit.text)) return;
    options.loads.push_back(*quantity);
    loads = rest;
  }
  const std::string& path = file.write(plot);
  std::string made;
  if (!accepts({path + ":"}, [&] { made = import_plot(path, options); })) return;
  std::size_t width = 0;
  read_csv_text(made, "made", true, [&](const CsvRow& row) {
    if (width == 0) Columns("made", headings_of(row));
    if (width == 0) width = row.size();
    promise(row.size() == width, "what import writes is read back", made);
    double value = 0;
    for (std::size_t i = 1; i < width && row.line() > 1; ++i)
      promise(number_at("made", row, i, "any", value), "what import writes are numbers", made);
  });
}

void check_a_law(std::string_view text) {
  accepts({"--law:"}, [&] {
    const LawDefinition definition = read_law_text("--law", text);
    LawError error;
    const auto law = UserLaw::make(definition, error);
    promise(law || !error.message.empty(), "a law is read, or it is said why not");
    promise(law || !error.at || *error.at <= definition.text.size(), "what is wrong lies in the text");
    if (!law) return;
    const LawCheck check = check_law(*law);
    if (check.error) return;
    std::vector<double> start;
    for (const LawParameter& one : definition.parameters) start.push_back(one.start);
    promise(std::abs(law->toughness(0, start) - 1) < 1e-8, "f is 1 at psi = 0 where a law passed its checks");
    promise(law->toughness(0.7, start) > 0, "f is positive where a law passed its checks");
  });
}

}  // namespace

int fuzz_input(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  switch (bytes[0]) {
    case 'c':
      return check_rows(text), 0;
    case 'd':
      return check_dataset(text), 0;
    case 'p':
      return check_peaks(text), 0;
    case 'm':
      return check_constants(text), 0;
    case 'f':
      return check_definition(text), 0;
    case 'u':
      return check_units(text), 0;
    case 'i':
      return check_import(text), 0;
    case 'l':
      return check_a_law(text), 0;
    default:
      return 0;
  }
}

}  // namespace mixity::fuzz
