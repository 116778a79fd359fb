// Several logs as one set of runs: a file for each load, files in pairs, a clock that starts anew.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <thread>

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
                    two = folder.write("two.csv", kHeadings + text),
                    both = folder.write("both.csv", kHeadings + text + text);
  const ReducedLogs files = reduce_logs({one, two}, {}, {}), anew = reduce_logs({both}, {}, {});
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
                    areas = folder.write("a.csv", "time [s],A [mm^2]\n" + rows_text(pictures, {0, 3})),
                    more_forces = folder.write("f2.csv", "time [s],P [mN],T [mN]\n" + rows_text(rows, {0, 1, 2})),
                    more_areas = folder.write("a2.csv", "time [s],A [mm^2]\n" + rows_text(pictures, {0, 3}));
  const ReducedLogs logs = reduce_logs({forces, areas, more_areas, more_forces}, {}, {.lag = 0.0});
  ASSERT_EQ(logs.size(), 2u);
  EXPECT_EQ(logs[0].areas_path, areas);
  EXPECT_EQ(logs[1].areas_path, more_areas);
  EXPECT_EQ(logs[0].runs.runs.size(), logs[1].runs.runs.size());
  EXPECT_EQ(folder.left_out_of(input_error([&] {
    reduce_logs({forces, areas, more_forces}, {}, {});
  })),
            "f2.csv: holds no areas; name the file that does, too: mixity runs FORCES.csv AREAS.csv");
  EXPECT_EQ(folder.left_out_of(input_error([&] {
    reduce_logs({forces, more_forces}, {}, {});
  })),
            "f2.csv: holds no areas");
  EXPECT_EQ(folder.left_out_of(input_error([&] {
    reduce_logs({forces, areas, forces, areas}, {}, {});
  })),
            "f.csv: is named twice: its runs would count twice");
}

/// Not "base.csv as forces of more.csv".
TEST(SeveralLogs, MayBeFilesOfBothBesidePairs) {
  const TemporaryFolder folder;
  const auto rows = shipped_rows();
  auto pictures = rows;
  std::erase_if(pictures, [](const auto& row) { return row[3].empty(); });
  const std::string both = folder.write("both.csv", kHeadings + rows_text(rows, {0, 1, 2, 3})),
                    forces = folder.write("f.csv", "time [s],P [mN],T [mN]\n" + rows_text(rows, {0, 1, 2})),
                    areas = folder.write("a.csv", "time [s],A [mm^2]\n" + rows_text(pictures, {0, 3}));
  const auto paths = [&](const std::vector<std::string>& files) {
    std::string text;
    for (const ReducedLog& log : reduce_logs(files, {}, {.lag = 0.0}))
      text += (text.empty() ? "" : " ") + log.forces.path + "+" + log.areas_path;
    return folder.left_out_of(text);
  };
  const auto log = [](const std::string& one, const std::string& other) { return one + "+" + other; };
  const std::string own = folder.left_out_of(log(both, both)), pair = folder.left_out_of(log(forces, areas));
  EXPECT_EQ(paths({both, forces, areas}), own + " " + pair);
  EXPECT_EQ(paths({areas, forces, both}), pair + " " + own);
  // areas of the second file where the first has some, too
  EXPECT_EQ(paths({both, areas}), folder.left_out_of(log(both, areas)));
  EXPECT_EQ(paths({forces, both}), folder.left_out_of(log(forces, both)));
}

/// The names of the others stay as cuts.toml has them.
TEST(SeveralLogs, KeepTheirNamesIfOneRunIsLeftOut) {
  const TemporaryFolder folder;
  const std::string log = folder.write("1.csv", kHeadings + rows_text(shipped_rows(), {0, 1, 2, 3})),
                    other = folder.write("2.csv", kHeadings + rows_text(shipped_rows(), {0, 1, 2, 3}));
  std::vector<std::string> expected = names(reduce_logs({log, other}, {}, {}));
  const std::string cuts =
      folder.write("cuts.toml", "[[cuts]]\nrun = \"" + expected.front() + "\"\nleave_out = true\n");
  expected.erase(expected.begin());
  EXPECT_EQ(names(reduce_logs({log, other}, {}, {.cuts_path = cuts})), expected);
}

TEST(SeveralLogs, RefuseToLeaveOutARunThatIsNotThere) {
  const TemporaryFolder folder;
  const std::string log = folder.write("1.csv", kHeadings + rows_text(shipped_rows(), {0, 1, 2, 3})),
                    cuts = folder.write("cuts.toml", "[[cuts]]\nrun = \"P=1 N\"\nleave_out = true\n");
  EXPECT_EQ(
      folder.left_out_of(input_error([&] { reduce_logs({log}, {}, {.cuts_path = cuts}); })),
      "cuts.toml: leaves out a run 'P=1 N', which the log does not have (it has P=7.73 mN, P=2.92 mN, P=0.942 mN)");
}

/// A stated load has no zero to be read out of contact.
TEST(SeveralLogs, HaveTheLoadsThatAreStated) {
  const TemporaryFolder folder;
  std::vector<std::vector<std::string>> first, second;
  for (const auto& row : shipped_rows()) (std::stod(row[0]) < 7.5 ? first : second).push_back(row);
  std::erase_if(second, [](const auto& row) { return std::stod(row[0]) > 14.8; });
  const std::string headings = "time [s],T [mN],A [mm^2]\n";
  const std::string one = folder.write("1.csv", headings + rows_text(first, {0, 2, 3})),
                    two = folder.write("2.csv", headings + rows_text(second, {0, 2, 3}));
  folder.write("1.toml", "load = \"7.73 mN\"\n");
  folder.write("2.toml", "load = \"2.92 mN\"\n");
  const ReducedLogs logs = reduce_logs({one, two}, {}, {});
  EXPECT_EQ(names(logs), (std::vector<std::string>{"P=7.73 mN", "P=2.92 mN"}));
  for (const ReducedLog& log : logs) EXPECT_EQ(log.runs.zero_P, 0);
}

TEST(SeveralLogs, DoNotBeginWhereAClockGoesBackForARow) {
  const TemporaryFolder folder;
  for (const std::size_t fault : {1u, 3u}) {
    auto rows = shipped_rows();
    for (std::size_t i = 0; i < fault; ++i) rows[1800 + i][0] = rows[i][0];
    const std::string log = folder.write("1.csv", kHeadings + rows_text(rows, {0, 1, 2, 3}));
    EXPECT_EQ(folder.left_out_of(input_error([&] { reduce_logs({log}, {}, {}); })),
              "1.csv:" + std::to_string(1802 + fault) +
                  ":1: column 'time': after 4.4975 s the clock goes back to 0 s, "
                  "and on from " +
                  rows[1800 + fault][0] +
                  " s, so that no log begins there; give each row its own time: "
                  "row number divided by the sampling rate");
  }
}

/// A mapping of columns of two files is tested with what was read: a pipe has nothing to read again.
TEST(SeveralLogs, OfPipesAreReadOnce) {
  const TemporaryFolder folder;
  const auto rows = shipped_rows();
  auto pictures = rows;
  std::erase_if(pictures, [](const auto& row) { return row[3].empty(); });
  const std::string forces = folder.path("f.csv"), areas = folder.path("a.csv");
  ASSERT_EQ(::mkfifo(forces.c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo(areas.c_str(), 0600), 0);
  std::thread writer([&] {
    std::ofstream(forces) << "time [s],Kanal 1 [mN],Kanal 2 [mN]\n" + rows_text(rows, {0, 1, 2});
    std::ofstream(areas) << "time [s],A [mm^2]\n" + rows_text(pictures, {0, 3});
  });
  const ReducedLogs logs = reduce_logs({forces, areas}, {{"columns", "P=Kanal 1,T=Kanal 2"}}, {.lag = 0.0});
  writer.join();
  EXPECT_EQ(logs.front().runs.runs.size(), 3u);
}

/// A time of the log itself, though another log has it, too.
TEST(SeveralLogs, HaveCutsOnTheirOwnClocks) {
  const TemporaryFolder folder;
  const std::string log = folder.write("1.csv", kHeadings + rows_text(shipped_rows(), {0, 1, 2, 3})),
                    other = folder.write("2.csv", kHeadings + rows_text(shipped_rows(), {0, 1, 2, 3}));
  const ReducedLogs found = reduce_logs({log, other}, {}, {});
  const LoadingRun& run = found[1].runs.runs.front();
  const double onset = run.onset->time - 0.25;
  const std::string cuts =
      folder.write("cuts.toml", "[[cuts]]\nrun = \"" + run.name + "\"\nonset = \"" + rounded(onset, 9) + " s\"\n");
  const ReducedLogs cut = reduce_logs({log, other}, {}, {.cuts_path = cuts});
  EXPECT_EQ(cut[0].runs.runs.front().onset->time, found[0].runs.runs.front().onset->time);
  EXPECT_NEAR(cut[1].runs.runs.front().onset->time, onset, 1e-6);
}

}  // namespace several_logs_test
}  // namespace mixity
