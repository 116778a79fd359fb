// What becomes of results when the disk is full, a folder is closed, or a file that was read would be written over.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/started_program.h"
#include "dataset/temporary_folder.h"

namespace mixity::cli {
namespace output_safety_test {

void redirect_output(const char* path) { ::dup2(::open(path, O_WRONLY), STDOUT_FILENO); }

TEST(OutputSafety, AFullDiskBehindStandardOutputEndsWithFour) {
  const TemporaryFolder folder;
  const std::string err = folder.path("err");
  const std::string plot = folder.write("plot.csv", "run 1,\nX,Y\n0,19.6\n5,19.2\n");
  const std::string not_ok = folder.write("one.csv", "P,T,A\n1,0,19.6\n");  // by itself the fit would end with 1
  for (const Words& words : std::vector<Words>{
           {},
           {"fit", not_ok},
           {"fit", kDefinition},
           {"fit", kDefinition, "--format=json"},
           {"fit", kDefinition, "--format=csv"},
           {"check", MIXITY_ROOT "/data/mergel2018.csv"},
           {"sahli", MIXITY_ROOT "/data/mergel2018.csv"},
           {"import", plot, "--x=T", "--y=A", "--loads=1"},
           {"predict", "--model=c", "--lambda=0.1", "--load=1", "--shear=0,1"},
           {"curve", "--model=c", "--lambda=0.1", "--load=1"},
           {"instability", "--model=c", "--lambda=0.1", "--load=1"},
           {"help"},
           {"--version"},
       }) {
    const ProgramResult result = finish(start(words, err, [] { redirect_output("/dev/full"); }), err);
    EXPECT_EQ(result.exit_code, 4) << joined(words);
    EXPECT_EQ(result.complaint(), "mixity: standard output cannot be written") << joined(words);
  }
}

TEST(OutputSafety, AFolderForTemporaryFilesThatIsNoneEndsWithFour) {
  const TemporaryFolder folder;
  const std::string err = folder.path("err");
  const Words words{"figures", "--paper", "--formats=pdf", "--out", folder.path("out")};
  const ProgramResult result = finish(start(words, err, [] { ::setenv("TMPDIR", "/nonexistent", 1); }), err);
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(result.complaint(), "mixity: TMPDIR names no folder for temporary files: No such file or directory");
}

/// As on a full disk, a file can only be written in part: beyond this size, write() fails.
void limit_files() {
  const rlimit limit{600, 600};
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

TEST(OutputSafety, AFileThatDoesNotFitLeavesTheEarlierResults) {
  const TemporaryFolder folder;
  const std::string err = folder.path("err"), out = folder.path("out");
  for (const Words& words : std::vector<Words>{{"fit", kDefinition, "--out", out},
                                               {"report", kDefinition, "--out", out},
                                               {"figures", "--paper", "--out", out}}) {
    std::filesystem::remove_all(out);
    ASSERT_EQ(run_program(words).exit_code, 0) << joined(words);
    const Contents before = contents_of(out);
    const ProgramResult result = finish(start(words, err, limit_files), err);
    EXPECT_EQ(result.exit_code, 4) << joined(words);
    EXPECT_NE(result.complaint().find(": cannot be written: File too large"), std::string::npos) << result.err;
    EXPECT_TRUE(contents_of(out) == before) << joined(words);
  }
}

TEST(OutputSafety, FilesOfLawsAndHeadingsAreNotWrittenOver) {
  const TemporaryFolder folder;
  const std::string law = "[mine]\nf = \"1 + (1-l)*tan(psi)^2\"\nl = [0, 1]\n", laws = folder.write("laws.toml", law);
  const std::string name = "[T]\nnames = [\"Querkraft\"]\n", headings = folder.write("headings.toml", name);
  for (const Words& words : std::vector<Words>{
           {"fit", MIXITY_ROOT "/data/mergel2018.csv", "--models=c", "--laws", laws, "--save", laws},
           {"fit", MIXITY_ROOT "/data/mergel2018.csv", "--models=c", "--headings", headings, "--save", headings},
           {"simulate", "--model=c", "--lambda=0.1", "--loads=1mN", "--radius=9mm", "--modulus=2MPa",
            "--toughness=30mJ/m^2", "--laws", laws, "--out", folder.path("laws.csv")}}) {
    const ProgramResult result = run_program(words);
    EXPECT_NE(result.exit_code, 0) << joined(words);
    EXPECT_NE(result.complaint().find("is an input and is not written over"), std::string::npos) << result.err;
  }
  EXPECT_EQ(content_of(laws), law);
  EXPECT_EQ(content_of(headings), name);
}

TEST(OutputSafety, NoFileThatWasReadIsWrittenOverByAnyCommand) {
  const TemporaryFolder folder;
  const std::string constants = "radius = \"9 mm\"\nmodulus = \"2 MPa\"\ntoughness = \"27 mJ/m^2\"\n",
                    data = folder.write("d.csv", "P [mN],T [mN],A [mm^2]\n8,0,0.46\n8,60,0.448\n8,110,0.402\n"),
                    beside = folder.write("d.toml", constants), lab = folder.write("lab.toml", constants);
  const auto refuses = [&](const Words& words) {
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 4) << joined(words);
    EXPECT_NE(result.complaint().find("is an input and is not written over"), std::string::npos) << result.err;
  };
  refuses({"points", data, "--out", beside, "--force"});
  refuses({"points", data, "--definition", lab, "--out", lab, "--force"});
  refuses({"check", data, "--definition", lab, "--save", lab, "--force"});
  refuses({"fit", data, "--definition", lab, "--save", lab, "--force"});
  refuses({"simulate", "--model=c", "--lambda=0.1", "--loads=1mN", "--definition", lab, "--out", folder.path("lab.csv"),
           "--force"});
  std::filesystem::create_hard_link(beside, folder.path("hard.toml"));
  refuses({"points", data, "--out", folder.path("hard.toml"), "--force"});
  std::filesystem::copy_file(data, folder.path("figures.html"));
  std::filesystem::copy_file(beside, folder.path("figures.toml"));
  refuses({"figures", "--paper", folder.path("figures.html"), "--out", folder.path(), "--force"});
  EXPECT_EQ(content_of(beside), constants);
  EXPECT_EQ(content_of(lab), constants);
}

TEST(OutputSafety, CutsThatWereReadStayAsTheyAre) {
  const TemporaryFolder folder;
  const std::string log = MIXITY_ROOT "/data/shear_log.csv", out = folder.path("out"), cuts = out + "/cuts.toml";
  ASSERT_EQ(run_program({"runs", log, "--out", out}).exit_code, 0);
  std::string edited = "# mine\n" + content_of(cuts);
  folder.write("out/cuts.toml", edited);
  const ProgramResult again = run_program({"runs", log, "--cuts", cuts, "--out", out});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(content_of(cuts), edited);
  EXPECT_FALSE(std::filesystem::exists(cuts + ".old"));
}

TEST(OutputSafety, AFileOfSomebodyElseIsReplacedByForceAlone) {
  const std::string data = MIXITY_ROOT "/data/mergel2018.csv";
  const TemporaryFolder folder;
  const std::string out = folder.path("out"), plot = folder.write("plot.csv", "run 1,\nX,Y\n0,19.6\n5,19.2\n");
  std::filesystem::create_directory(out);
  const auto check = [&](const std::string& name, Words words) {
    const std::string file = folder.write("out/" + name, "theirs");
    const ProgramResult refused = run_program(words);
    EXPECT_EQ(refused.exit_code, 4) << joined(words);
    EXPECT_EQ(refused.complaint(),
              "mixity: " + file + ": was not written by mixity and is not replaced: take another name, or --force")
        << joined(words);
    EXPECT_EQ(content_of(file), "theirs") << joined(words);
    words.push_back("--force");
    EXPECT_EQ(run_program(words).exit_code, 0) << joined(words);
    EXPECT_NE(content_of(file), "theirs") << joined(words);
    words.pop_back();
    EXPECT_EQ(run_program(words).exit_code, 0) << "its own file: " << joined(words);
    folder.write("out/" + name, "edited");
    words.push_back("--force");
    EXPECT_EQ(run_program(words).exit_code, 0) << joined(words);
  };
  check("fits.csv", {"fit", data, "--models=c", "--out", out});
  check("fit.toml", {"fit", data, "--models=c", "--save", out + "/fit.toml"});
  check("report.html", {"report", data, "--models=c", "--out", out});
  check("runs.csv", {"runs", MIXITY_ROOT "/data/shear_log.csv", "--out", out});
  check("points.csv", {"points", data, "--out", out + "/points.csv"});
  check("import.csv", {"import", plot, "--x=T", "--y=A", "--loads=1", "--out", out + "/import.csv"});
  check("simulated.csv", {"simulate", "--model=c", "--lambda=0.1", "--loads=1mN", "--radius=9mm", "--modulus=2MPa",
                          "--toughness=30mJ/m^2", "--out", out + "/simulated.csv"});
  check("figures.html", {"figures", "--paper", "--out", out});
}

TEST(OutputSafety, FiguresThatAReportNoLongerMakesAreRemoved) {
  const TemporaryFolder folder;
  const std::string data = MIXITY_ROOT "/data/mergel2018.csv", out = folder.path("out");
  ASSERT_EQ(run_program({"report", data, "--models=a,c", "--out", out}).exit_code, 0);
  ASSERT_TRUE(std::filesystem::exists(out + "/figures/mergel2018_area_a.svg"));
  folder.write("out/figures/mine.svg", "<svg/>");
  ASSERT_EQ(run_program({"report", data, "--models=c", "--out", out}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(out + "/figures/mergel2018_area_a.svg"));
  EXPECT_TRUE(std::filesystem::exists(out + "/figures/mergel2018_area_c.svg"));
  EXPECT_EQ(content_of(folder.path("out/figures/mine.svg")), "<svg/>");
}

TEST(OutputSafety, FiguresOfRunsThatALogNoLongerHasAreRemoved) {
  const TemporaryFolder folder;
  const std::string log = MIXITY_ROOT "/data/shear_log.csv", out = folder.path("out");
  ASSERT_EQ(run_program({"runs", log, "--out", out}).exit_code, 0);
  ASSERT_TRUE(std::filesystem::exists(out + "/figures/run_3_T.svg"));
  const std::string all = content_of(out + "/cuts.toml"), last = all.substr(all.rfind("run = "));
  const std::string cuts =
      folder.write("cuts.toml", "[[cuts]]\n" + last.substr(0, last.find('\n')) + "\nleave_out = true\n");
  ASSERT_EQ(run_program({"runs", log, "--cuts", cuts, "--out", out}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(out + "/figures/run_3_T.svg"));
  EXPECT_TRUE(std::filesystem::exists(out + "/figures/run_2_T.svg"));
}

/// Results of one run and the definition that another run saved do not stand side by side.
TEST(OutputSafety, ResultsAndTheSavedDefinitionAreWrittenTogether) {
  const TemporaryFolder folder;
  const std::string saved = folder.write("fit.toml", "old"), out = folder.write("out", "a file, no folder");
  EXPECT_EQ(
      run_program({"fit", MIXITY_ROOT "/data/mergel2018.csv", "--models=c", "--out", out, "--save", saved}).exit_code,
      4);
  EXPECT_EQ(content_of(saved), "old");
  const std::string reading = folder.path("reading.toml");
  EXPECT_EQ(run_program({"runs", MIXITY_ROOT "/data/shear_log.csv", "--out", out, "--save", reading}).exit_code, 4);
  EXPECT_FALSE(std::filesystem::exists(reading));
}

TEST(OutputSafety, AnImportThatDoesNotFitLeavesTheEarlierOne) {
  const TemporaryFolder folder;
  std::string plot = "run 1,\nX,Y\n";
  for (int i = 0; i < 200; ++i) plot += std::to_string(i) + ",19.6\n";
  const std::string err = folder.path("err"), data = folder.write("data.csv", "mine");
  const Words words{"import", folder.write("plot.csv", plot), "--x=T", "--y=A", "--loads=1", "--out", data};
  EXPECT_EQ(finish(start(words, err, limit_files), err).exit_code, 4);
  EXPECT_EQ(content_of(data), "mine");
}

/// As a user without rights, whoever runs the test.
void become_nobody() {
  if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(126);
}

TEST(OutputSafety, AFolderOrFileThatIsClosedToWritingEndsWithFourAndKeepsWhatItHolds) {
  const TemporaryFolder folder, complaints;
  // Program and data are copied to where nobody may read them: the build may lie in a private folder.
  const std::string out = folder.path("out"), err = complaints.write("err", ""), program = folder.path("mixity"),
                    data = folder.path("run.csv");
  std::filesystem::copy_file(MIXITY_PROGRAM, program);
  std::filesystem::copy_file(MIXITY_ROOT "/data/mergel2018.csv", data);
  std::filesystem::copy_file(MIXITY_ROOT "/data/mergel2018.toml", folder.path("run.toml"));
  for (const std::string& path : {folder.path(), complaints.path(), err})
    std::filesystem::permissions(path, std::filesystem::perms::all);
  ASSERT_EQ(run_program({"fit", data, "--out", out}).exit_code, 0);
  const ProgramResult allowed = finish(start({"check", data}, err, become_nobody, program), err);
  ASSERT_EQ(allowed.exit_code, 0) << allowed.err;
  const Contents before = contents_of(out);
  const auto refuses = [&](const char* command) {
    const ProgramResult result = finish(start({command, data, "--out", out}, err, become_nobody, program), err);
    EXPECT_EQ(result.exit_code, 4) << command;
    EXPECT_NE(result.complaint().find("Permission denied"), std::string::npos) << result.err;
    EXPECT_TRUE(contents_of(out) == before) << command;
  };
  std::filesystem::permissions(out, std::filesystem::perms(0555));
  refuses("fit");
  refuses("report");
  std::filesystem::permissions(out, std::filesystem::perms::all);
  for (const auto& file : std::filesystem::directory_iterator(out))
    std::filesystem::permissions(file.path(), std::filesystem::perms(0444));
  refuses("fit");
}

TEST(OutputSafety, AFileThatWasReadIsNotWrittenOver) {
  const TemporaryFolder folder;
  const std::string& here = folder.path();
  const auto refuses = [&](const Words& words, const std::string& data) {
    const Contents before = contents_of(here);
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 4) << words[0];
    EXPECT_NE(result.complaint().find(data + ": is an input and is not written over"), std::string::npos) << result.err;
    EXPECT_TRUE(contents_of(here) == before) << words[0];
  };
  const std::string data = "P,T,A\n1,0,20\n1,3,19\n1,5,17\n";
  refuses({"fit", folder.write("fits.csv", data), "--out", here}, "fits.csv");
  refuses({"report", folder.write("curves.csv", data), "--out", here}, "curves.csv");
  std::filesystem::create_directory(folder.path("figures"));
  refuses({"report", folder.write("d.csv", data), folder.write("figures/d_toughness.dat", data), "--formats=gnuplot",
           "--out", here},
          "d_toughness.dat");
  const std::string plot = folder.write("plot.csv", "a,\nX,Y\n1,2\n");
  std::filesystem::create_symlink(plot, folder.path("link.csv"));
  refuses({"import", plot, "--x=T", "--y=A", "--loads=1", "--out", folder.path("link.csv")}, "link.csv");
}

TEST(OutputSafety, NoFileThatADefinitionNamesIsWrittenOver) {
  const TemporaryFolder folder;
  const std::string &here = folder.path(),
                    constants = "radius = \"9 mm\"\nmodulus = \"2 MPa\"\ntoughness = \"27 mJ/m^2\"\n";
  folder.write("g.csv", "P [mN],T [mN],A [mm^2]\n8,0,0.46\n8,60,0.448\n8,110,0.402\n");
  folder.write("g.toml", constants);
  folder.write("g_residuals.csv", "P [mN],T_max [mN]\n1,2\n");
  const std::string definition =
      folder.write("fit.toml", "data = \"g.csv\"\nmodels = [\"c\"]\npeaks = \"g_residuals.csv\"\n");
  const auto refuses = [&](const std::string& name) {
    const ProgramResult result = run_program({"fit", definition, "--out", here});
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_NE(result.complaint().find(name + ": is an input and is not written over"), std::string::npos) << result.err;
  };
  refuses("g_residuals.csv");
  folder.write("fit.toml", "data = \"g.csv\"\nmodels = [\"c\"]\n");
  for (const std::string target : {"g.toml", "fit.toml"}) {
    const std::string link = folder.path("fits.txt");
    std::filesystem::remove(link);
    std::filesystem::create_symlink(folder.path(target), link);
    refuses("fits.txt");
  }
  EXPECT_EQ(content_of(folder.path("g.toml")), constants);
}

TEST(OutputSafety, AFileWhereAFolderIsWantedStaysAsItIs) {
  const TemporaryFolder folder;
  const std::string file = folder.write("out", "mine");
  for (const char* command : {"fit", "report"}) {
    const ProgramResult result = run_program({command, kDefinition, "--out", file});
    EXPECT_EQ(result.exit_code, 4) << command;
    EXPECT_NE(result.complaint().find(file), std::string::npos) << result.complaint();
    EXPECT_EQ(content_of(file), "mine");
  }
}

}  // namespace output_safety_test
}  // namespace mixity::cli
