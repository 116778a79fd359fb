// Several logs as one set of runs: a file for each load, files in pairs, a clock that starts anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "base/files.h"
#include "base/number_text.h"
#include "dataset/logs/reduced_log.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace several_logs_test {

/// The rows of the shipped log, without its headings.
std::vector<std::vector<std::string>> shipped_rows() {
  std::istringstream text(read_file(std::string(MIXITY_ROOT) + "/data/shear_log.csv"));
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(text, line);
  while (std::getline(text, line)) {
    std::istringstream fields(line);
    rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
    rows.back().resize(4);
  }
  return rows;
}

/// These columns of them, with P larger by `zero` mN.
std::string rows_text(const std::vector<std::vector<std::string>>& rows, const std::vector<std::size_t>& columns,
                      double zero = 0) {
  std::string text;
  for (const auto& row : rows)
    for (const std::size_t k : columns)
      text += (k == 1 ? rounded(std::stod(row[1]) + zero, 9) : row[k]) + (k == columns.back() ? "\n" : ",");
  return text;
}

const std::string kHeadings = "time [s],P [mN],T [mN],A [mm^2]\n";

std::vector<std::string> names(const ReducedLogs& logs) {
  std::vector<std::string> all;
  for (const ReducedLog& log : logs)
    for (const LoadingRun& run : log.runs.runs) all.push_back(run.name);
  return all;
}

/// The second log has another zero of P, which each log takes from its own readings out of contact.
TEST(SeveralLogs, HaveZerosOfTheirOwnAndNamesThatDiffer) {
  const TemporaryFolder folder;
  const auto rows = shipped_rows();
  const std::string one = folder.write("1.csv", kHeadings + rows_text(rows, {0, 1, 2, 3})),
                    two = folder.write("2.csv", kHeadings + rows_text(rows, {0, 1, 2, 3}, 3));
  const ReducedLogs logs = reduce_logs({one, two}, {}, {});
  ASSERT_EQ(logs.size(), 2u);
  EXPECT_NEAR(logs[1].runs.zero_P - logs[0].runs.zero_P, 3e-3, 1e-9);
  ASSERT_EQ(logs[0].runs.runs.size(), logs[1].runs.runs.size());
  for (std::size_t k = 0; k < logs[0].runs.runs.size(); ++k) {
    EXPECT_NEAR(logs[0].runs.runs[k].P, logs[1].runs.runs[k].P, 1e-9);
    EXPECT_EQ(logs[0].runs.runs[k].T, logs[1].runs.runs[k].T);
  }
  std::vector<std::string> all = names(logs);
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
}

TEST(SeveralLogs, AreInOneFileIfItsClockStartsAnew) {
  const TemporaryFolder folder;
  const auto rows = shipped_rows();
  const std::string text = rows_text(rows, {0, 1, 2, 3}), one = folder.write("one.csv", kHeadings + text),
                    both = folder.write("both.csv", kHeadings + text + text);
  const ReducedLogs files = reduce_logs({one, one}, {}, {}), anew = reduce_logs({both}, {}, {});
  ASSERT_EQ(anew.size(), 2u);
  EXPECT_EQ(names(anew), names(files));
  EXPECT_EQ(anew[0].forces.line, 2u);
  EXPECT_EQ(anew[1].forces.line, 2 + rows.size());
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < files[i].runs.runs.size(); ++k) {
      EXPECT_EQ(anew[i].runs.runs[k].T, files[i].runs.runs[k].T);
      EXPECT_EQ(anew[i].runs.runs[k].shear.time, files[i].runs.runs[k].shear.time);
    }
}

TEST(SeveralLogs, MayBeFilesInPairs) {
  const TemporaryFolder folder;
  const auto rows = shipped_rows();
  auto pictures = rows;
  std::erase_if(pictures, [](const auto& row) { return row[3].empty(); });
  const std::string forces = folder.write("f.csv", "time [s],P [mN],T [mN]\n" + rows_text(rows, {0, 1, 2})),
                    areas = folder.write("a.csv", "time [s],A [mm^2]\n" + rows_text(pictures, {0, 3}));
  const ReducedLogs logs = reduce_logs({forces, areas, areas, forces}, {}, {.lag = 0.0});
  ASSERT_EQ(logs.size(), 2u);
  EXPECT_EQ(logs[0].areas_path, areas);
  EXPECT_EQ(logs[1].areas_path, areas);
  EXPECT_EQ(logs[0].runs.runs.size(), logs[1].runs.runs.size());
  EXPECT_EQ(folder.left_out_of(input_error([&] {
    reduce_logs({forces, areas, forces}, {}, {});
  })),
            "f.csv: holds no areas; name the file that does, too: mixity runs FORCES.csv AREAS.csv");
  EXPECT_EQ(folder.left_out_of(input_error([&] {
    reduce_logs({forces, forces, forces, areas}, {}, {});
  })),
            "f.csv: holds no areas");
}

/// A time of the log itself, though another log has it, too.
TEST(SeveralLogs, HaveCutsOnTheirOwnClocks) {
  const TemporaryFolder folder;
  const std::string log = folder.write("1.csv", kHeadings + rows_text(shipped_rows(), {0, 1, 2, 3}));
  const ReducedLogs found = reduce_logs({log, log}, {}, {});
  const LoadingRun& run = found[1].runs.runs.front();
  const double onset = run.onset->time - 0.25;
  const std::string cuts =
      folder.write("cuts.toml", "[[cuts]]\nrun = \"" + run.name + "\"\nonset = \"" + rounded(onset, 9) + " s\"\n");
  const ReducedLogs cut = reduce_logs({log, log}, {}, {.cuts_path = cuts});
  EXPECT_EQ(cut[0].runs.runs.front().onset->time, found[0].runs.runs.front().onset->time);
  EXPECT_NEAR(cut[1].runs.runs.front().onset->time, onset, 1e-6);
}

}  // namespace several_logs_test
}  // namespace mixity
