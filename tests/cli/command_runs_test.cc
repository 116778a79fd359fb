// mixity runs: from a log to points, to a fit; and several files as one data set.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/content_hash.h"
#include "cli/run_program.h"
#include "cli/shown_lines.h"

namespace mixity::cli {
namespace command_runs_test {

const std::string kLog = MIXITY_ROOT "/data/shear_log.csv";

TEST(RunsCommand, MakesOfAShippedLogPointsThatGiveItsLambda) {
  const TemporaryFolder folder;
  const ProgramResult made = run_program({"runs", kLog, "--out=" + folder.path("log")});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  for (const char* name : {"runs.csv", "runs.toml", "peaks.csv", "peaks.toml", "phases.csv", "cuts.toml", "log.json"})
    EXPECT_FALSE(content_of(folder.path("log/") + name).empty()) << name;
  const ProgramResult fit =
      run_program({"fit", folder.path("log/runs.csv"), "--models=c", "--compare=false", "--format=json"});
  EXPECT_EQ(fit.exit_code, 0) << fit.out;
  const auto data = nlohmann::json::parse(fit.out)["datasets"][0];
  EXPECT_EQ(data["provenance"], "reconstructed");  // it goes with the points
  const auto lambda = data["fits"][0]["parameters"]["lambda"];
  EXPECT_LE(lambda["interval"]["low"].get<double>(), 0.004);  // what the log was made with
  EXPECT_GE(lambda["interval"]["high"].get<double>(), 0.004);
  // the cuts that were written, stated, are the same cuts
  const ProgramResult again =
      run_program({"runs", kLog, "--cuts=" + folder.path("log/cuts.toml"), "--out=" + folder.path("again")});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(lines_of(content_of(folder.path("again/runs.csv"))).size(),
            lines_of(content_of(folder.path("log/runs.csv"))).size());
}

/// Name and hash of what was read stand in the results.
TEST(RunsCommand, NamesWhatItReadWithItsHash) {
  const TemporaryFolder folder;
  const std::string log = folder.path("l.csv"), cuts = folder.write("cuts.toml", ""),
                    constants = folder.write("l.toml", content_of(MIXITY_ROOT "/data/shear_log.toml"));
  std::filesystem::copy_file(kLog, log);
  ASSERT_EQ(run_program({"runs", log, "--cuts", cuts, "--out=" + folder.path("log")}).exit_code, 0);
  const auto listed = [](const nlohmann::json& files) {
    std::map<std::string, std::string> hashes;
    for (const auto& file : files) hashes[file["path"]] = file["xxh128"];
    return hashes;
  };
  auto files = listed(nlohmann::json::parse(content_of(folder.path("log/log.json")))["inputs"]);
  EXPECT_EQ(files.size(), 3u);
  for (const std::string& path : {log, constants, cuts}) EXPECT_EQ(files[path], content_hash(content_of(path))) << path;
  ASSERT_LE(run_program({"report", folder.path("log/fit.toml"), "--checks=false", "--models=c",
                         "--out=" + folder.path("report")})
                .exit_code,
            1);
  const auto data = nlohmann::json::parse(content_of(folder.path("report/results.json")))["datasets"][0];
  files = listed(data["drawings"]);
  const std::string drawing = folder.path("log/figures/run_1_T.svg");
  EXPECT_EQ(files[drawing], content_hash(content_of(drawing)));
}

TEST(RunsCommand, HasItsFiguresOfTheShearInTheReport) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program({"runs", kLog, "--out=" + folder.path("log")}).exit_code, 0);
  EXPECT_NE(content_of(folder.path("log/fit.toml")).find("log_figures = ['figures/run_1_T.svg', 'figures/run_2_T.svg'"),
            std::string::npos);
  const ProgramResult made =
      run_program({"report", folder.path("log/fit.toml"), "--models=c", "--out=" + folder.path("report")});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const auto data = nlohmann::json::parse(content_of(folder.path("report/results.json")))["datasets"][0];
  std::size_t shown = 0;
  for (const auto& figure : data["figures"])
    if (figure["title"].get<std::string>().starts_with("T(t) at")) {
      ++shown;
      EXPECT_NE(figure["caption"].get<std::string>().find("Squares: maxima of T"), std::string::npos);
      ASSERT_EQ(figure["files"].size(), 1u);
      EXPECT_FALSE(content_of(folder.path("report/") + figure["files"][0].get<std::string>()).empty());
    }
  EXPECT_GE(shown, 2u);
  EXPECT_NE(content_of(folder.path("report/report.html")).find("From the log"), std::string::npos);
}

TEST(RunsCommand, SpreadsTheRowsOfACoarseClock) {
  const TemporaryFolder folder;
  std::string coarse;  // the log has 400 rows a second; its times are cut to tenths of a second
  for (const std::string& line : lines_of(content_of(kLog))) {
    const bool number = !line.empty() && std::isdigit(static_cast<unsigned char>(line[0]));
    coarse += !number
                  ? line + "\n"
                  : std::to_string(std::floor(10 * std::stod(line) + 1e-6) / 10) + line.substr(line.find(',')) + "\n";
  }
  const std::string path = folder.write("coarse.csv", coarse);
  folder.write("coarse.toml", content_of(MIXITY_ROOT "/data/shear_log.toml"));
  const ProgramResult made = run_program({"runs", path, "--out=" + folder.path("out")});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.out.find(" rows share a stamp of 0.1 s: spread evenly"), std::string::npos) << made.out;
  const auto log = nlohmann::json::parse(content_of(folder.path("out/log.json")));
  EXPECT_NEAR(log["times"][0]["stamp_s"].get<double>(), 0.1, 1e-9);  // a difference of decimal times
  EXPECT_EQ(log["lag"]["source"], "one clock");
}

TEST(RunsCommand, GivesTheLagOfTwoClocksAnError) {
  const TemporaryFolder folder;
  std::string forces, areas;  // the log in two files, the areas 1.5 s ahead
  for (const std::string& line : lines_of(content_of(kLog))) {
    if (line.starts_with('#')) continue;
    const auto fields = fields_of(line);
    const bool number = std::isdigit(static_cast<unsigned char>(line[0]));
    forces += fields[0] + "," + fields[1] + "," + fields[2] + "\n";
    if (!fields[3].empty())
      areas += (number ? std::to_string(std::stod(fields[0]) + 1.5) : fields[0]) + "," + fields[3] + "\n";
  }
  const std::string one = folder.write("forces.csv", forces), other = folder.write("areas.csv", areas);
  folder.write("forces.toml", content_of(MIXITY_ROOT "/data/shear_log.toml"));
  const ProgramResult made = run_program({"runs", one, other, "--out=" + folder.path("out")});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.out.find("lag of the clocks 1."), std::string::npos) << made.out;
  EXPECT_NE(content_of(folder.path("out/runs.toml")).find("# lag of the clocks 1."), std::string::npos);
  const auto lag = nlohmann::json::parse(content_of(folder.path("out/log.json")))["lag"];
  EXPECT_LE(std::abs(lag["value_s"].get<double>() - 1.5), 4 * lag["stderr_s"].get<double>()) << lag.dump();
  EXPECT_FALSE(lag["disagree"].get<bool>()) << lag.dump();
  EXPECT_EQ(lag["parts"].size(), 3u) << lag.dump();
}

TEST(RunsCommand, SaysInOneLineWhatItCannotUse) {
  const TemporaryFolder folder;
  const std::string points = folder.write("points.csv", "P [mN],T [mN],A [mm^2]\n1,2,3\n2,3,4\n"),
                    still = folder.write(
                        "still.csv", "time [s],P [mN],T [mN],A [mm^2]\n0,1,0,0.1\n1,1,0,0.1\n2,1,0,0.1\n3,1,0,0.1\n"),
                    cuts = folder.write("cuts.toml", "[[cuts]]\nrun = \"P=99 mN\"\nonset = \"1 s\"\n");
  const auto complaint = [&](const Words& words) { return folder.left_out_of(run_program(words).complaint()); };
  EXPECT_EQ(run_program({"runs"}).exit_code, 2);
  EXPECT_EQ(run_program({"runs", kLog, "--lag=3"}).exit_code, 2);
  EXPECT_EQ(complaint({"runs", points}),
            "mixity: points.csv:1:1: column 'time' is missing; state the rate of the rows, such as --rate=\"400 Hz\", "
            "or which "
            "column it is: --columns=\"time=HEADING (s)\"");
  EXPECT_EQ(complaint({"runs", still}),
            "mixity: still.csv: holds no loading run: no contact under one load in which T rises");
  EXPECT_NE(run_program({"runs", still}).out.find("4: the load changes, or is held for fewer than 10 frames or 0.2 s"),
            std::string::npos);
  EXPECT_EQ(complaint({"runs", kLog, "--cuts=" + cuts}),
            "mixity: cuts.toml: states cuts of a run 'P=99 mN', which the log does not have (it has "
            "P=7.73 mN, P=2.92 mN, P=0.942 mN)");
  EXPECT_EQ(run_program({"runs", kLog, "--cuts=" + cuts}).exit_code, 3);
  const std::string late = folder.write("late.toml", "[[cuts]]\nrun = \"P=7.73 mN\"\nonset = \"7000 s\"\n");
  const std::string outside = complaint({"runs", kLog, "--cuts=" + late});
  EXPECT_TRUE(outside.starts_with("mixity: late.toml:3:9: 7000 s is no time of run 'P=7.73 mN', which is held from "))
      << outside;
}

TEST(RunsCommand, TurnsALogRoundThatHasCompressionAsNegative) {
  const TemporaryFolder folder;
  std::string text;
  for (const std::string& line : lines_of(content_of(kLog))) {
    const std::size_t first = line.find(',') + 1, second = line.find(',', first);
    const std::string P = line.substr(first, second - first);
    const bool number = !line.empty() && (std::isdigit(static_cast<unsigned char>(line[0])));
    text += !number ? line + "\n"
                    : line.substr(0, first) + (P.starts_with('-') ? P.substr(1) : "-" + P) + line.substr(second) + "\n";
  }
  const std::string negative = folder.write("negative.csv", text);
  folder.write("negative.toml", content_of(MIXITY_ROOT "/data/shear_log.toml"));
  ASSERT_EQ(run_program({"runs", kLog, "--out=" + folder.path("one")}).exit_code, 0);
  const ProgramResult turned = run_program({"runs", negative, "--out=" + folder.path("other")});
  ASSERT_EQ(turned.exit_code, 0) << turned.err;
  EXPECT_NE(turned.out.find("P is negative in compression there and was reversed (P -> -P)"), std::string::npos);
  EXPECT_EQ(content_of(folder.path("one/runs.csv")), content_of(folder.path("other/runs.csv")));
}

TEST(PooledFiles, GiveTheNumbersOfOneFileAndOfTheDefinitionThatIsSaved) {
  const TemporaryFolder folder;
  const auto lines = lines_of(content_of(MIXITY_ROOT "/data/mergel2018.csv"));
  std::vector<std::string> names;
  std::string before, header, text;
  Words words{"fit"};
  for (const std::string& line : lines) {
    const auto fields = fields_of(line);
    if (line.starts_with('#')) continue;
    if (header.empty()) {
      header = line.substr(line.find(',') + 1);
      continue;
    }
    if (fields[0] != before) words.push_back(folder.path("run_" + std::to_string(words.size()) + ".csv"));
    text = (fields[0] != before ? header + "\n" : content_of(words.back())) + line.substr(line.find(',') + 1) + "\n";
    folder.write(words.back().substr(folder.path().size() + 1), text);
    before = fields[0];
  }
  const Words flags{"--models=c", "--format=csv", "--radius=9.42 mm", "--modulus=2.133 MPa", "--toughness=27 mJ/m^2"};
  words.insert(words.end(), flags.begin(), flags.end());
  words.insert(words.end(), {"--pool", "--save=" + folder.path("all.toml")});
  const ProgramResult pooled = run_program(words),
                      single = run_program({"fit", MIXITY_ROOT "/data/mergel2018.csv", "--models=c", "--format=csv"}),
                      saved = run_program({"fit", folder.path("all.toml"), "--format=csv"});
  ASSERT_EQ(pooled.exit_code, 0) << pooled.err;
  EXPECT_EQ(pooled.out, saved.out);
  const auto one = fields_of(lines_of(pooled.out).at(1)), other = fields_of(lines_of(single.out).at(1)),
             head = fields_of(lines_of(pooled.out).at(0));
  for (std::size_t i = 0; i < head.size(); ++i)
    if (head[i] == "value" || head[i] == "stderr") {
      EXPECT_EQ(one[i], other[i]) << head[i];
    }
}

TEST(RunsCommand, MapsColumnsInTheFileThatHasThem) {
  const TemporaryFolder folder;
  const auto seen = [&](const std::string& mapping, const std::string& forces, const std::string& areas,
                        const std::string& constant = "--lag=0 s") {
    return run_program(
        {"runs", folder.write("F.csv", forces), folder.write("A.csv", areas), "--columns=" + mapping, constant});
  };
  const std::string forces = "time [s],Kanal 1 [mN],Kanal 2 [mN]\n0,0,0\n0.1,4,0\n0.2,4,5\n0.3,4,10\n",
                    areas = "time [s],A [mm^2]\n0,0\n0.1,0.35\n0.2,0.349\n0.3,0.347\n",
                    german = "Zeit [s];Kanal 7 [mm^2]\n0;0\n0,1;0,35\n0,2;0,349\n0,3;0,347\n";
  for (const ProgramResult& one :
       {seen("P=Kanal 1 (mN),T=Kanal 2 (mN)", forces, areas), seen("P=Kanal 1,T=Kanal 2", forces, areas),
        seen("P=2,T=3", forces, areas), seen("P=2,T=3,A=2", forces, german),
        seen("P=Kanal 1,T=Kanal 2,A=Kanal 7,time=1", forces, german)})
    EXPECT_NE(one.out.find("4 frames, 10 a second"), std::string::npos) << one.out << one.err;
  const ProgramResult swapped = run_program(
      {"runs", folder.path("A.csv"), folder.path("F.csv"), "--columns=P=Kanal 1,T=Kanal 2,A=Kanal 7", "--lag=0 s"});
  EXPECT_NE(swapped.out.find("4 frames, 10 a second"), std::string::npos) << swapped.err;
  EXPECT_EQ(
      folder.left_out_of(seen("P=Kanal 1,T=Kanal 9", forces, areas).complaint()),
      "mixity: F.csv: no column 'Kanal 9', which is to be T, and none in A.csv; there are time [s], Kanal 1 [mN], "
      "Kanal 2 [mN]; time [s], A [mm^2]");
  EXPECT_EQ(folder.left_out_of(seen("P=Kanal 1 (N),T=Kanal 2 (N)", forces, areas).complaint()),
            "mixity: F.csv:1:10: column 'Kanal 1 [mN]' is in mN, the mapping says N; to read it as the file says: "
            "--columns=\"P=Kanal 1,T=Kanal 2\"");
}

/// The lines that README.md shows of its example are those that the commands print.
TEST(RunsCommand, GivesTheNumbersOfTheReadme) {
  const TemporaryFolder folder;
  const std::string out = folder.path("log");
  std::string printed = run_program({"runs", kLog, "--out", out}).out;
  printed += run_program({"fit", out + "/fit.toml", "--models=c"}).out;
  printed += run_program({"fit", out + "/fit.toml", "--models=c", "--modulus=2.133 MPa +/- 5%"}).out;
  printed += run_program({"instability", out + "/fit.toml"}).out;
  const std::string section = section_of("README.md", "## From a log to a number");
  EXPECT_EQ(count_of_shown_lines(section, printed), 10);
  for (const char* const said :
       {"simulated with lambda = 0.004", "shift lambda by 0.0005", "to 0.12 %", "T = 103.51 mN"})
    EXPECT_NE(section.find(said), std::string::npos) << said;
}

}  // namespace command_runs_test
}  // namespace mixity::cli
