// Logs as instruments write them.
#include "dataset/logs/recording.h"

#include <gtest/gtest.h>

#include "base/input_error.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace recording_test {

Recording read(const std::string& text, const std::string& columns = "") {
  const TemporaryFolder folder;
  Metadata metadata;
  if (!columns.empty()) set_field(metadata, "columns", columns);
  return read_recording(folder.write("log.csv", text), metadata);
}
std::string error_of(const std::string& text) {
  const TemporaryFolder folder;
  const std::string path = folder.write("log.csv", text);
  return folder.left_out_of(input_error([&] { read_recording(path, Metadata{}); }));
}

TEST(Recordings, MayHaveTimesOfAClock) {
  const std::string header = "time,P [mN],T [mN],A [mm^2]\n", rest = ",1,2,0.3\n";
  EXPECT_EQ(read(header + "23:59:59.000" + rest + "23:59:59.500" + rest + "00:00:00.250" + rest).time,
            (std::vector<double>{0, 0.5, 1.25}));
  EXPECT_EQ(
      read(header + "2026-05-01T23:59:59Z" + rest + "2026-05-02T00:00:01Z" + rest + "2026-05-02T00:00:02.5Z" + rest)
          .time,
      (std::vector<double>{0, 2, 3.5}));
  EXPECT_EQ(read("Zeit;P [mN];T [mN];A [mm^2]\n10:05:00,000;0,8;1,5;0,25\n10:05:00,500;0,8;1,5;0,25\n"
                 "10:05:01,000;0,8;1,5;0,25\n")
                .T[0],
            1.5e-3);
}

TEST(Recordings, WithOtherTimesAreRefusedByTheNameOfTheirColumn) {
  const std::string header = "time,P [mN],T [mN],A [mm^2]\n", rest = ",1,2,0.3\n";
  EXPECT_EQ(error_of(header + "10:05" + rest + "10:06" + rest + "10:07" + rest),
            "log.csv:2:1: column 'time': '10:05' is neither a number nor a time such as 10:05:00.25 or "
            "2026-05-01T10:05:00.25");
  EXPECT_EQ(error_of(header + "10:05:00" + rest + "2026-05-01T10:05:01" + rest),
            "log.csv:3:1: column 'time': '2026-05-01T10:05:01' is of another kind than the times above");
  EXPECT_EQ(error_of(header + "0,1,2,0.3\n1,x,2,0.3\n2,1,2,0.3\n"), "log.csv:3:3: column 'P': 'x' is not a number");
}

TEST(Recordings, OfLabVIEWHaveALabelBeforeTheirUnits) {
  const std::string lvm =
      "LabVIEW Measurement\t\n***End_of_Header***\t\nChannels\t3\t\t\nSamples\t3\t3\t3\n"
      "Y_Unit_Label\tmN\tmN\tmm^2\nX_Dimension\tTime\tTime\tTime\n***End_of_Header***\t\t\t\n"
      "X_Value\tNormal force\tShear force\tContact area\tComment\n0\t1\t2\t0.3\n0.5\t1\t3\t0.3\n1\t1\t4\t0.2\n";
  for (const char* columns : {"", "time=X_Value (s)"}) {
    const Recording log = read(lvm, columns);
    EXPECT_EQ(log.time, (std::vector<double>{0, 0.5, 1})) << columns;
    EXPECT_EQ(log.T[2], 4e-3) << columns;
  }
}

}  // namespace recording_test
}  // namespace mixity
