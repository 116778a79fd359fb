// The rate of the rows as instruments write it above their tables.
#include "dataset/logs/stated_rate.h"

#include <gtest/gtest.h>

#include "base/input_error.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace stated_rate_test {

TEST(StatedRates, AreReadInTheWordsOfInstruments) {
  for (const auto& [line, rate] :
       std::vector<std::pair<std::string, double>>{{"Sampling rate [Hz]:\t400", 400},
                                                   {"Sample rate: 400 Hz", 400},
                                                   {"Sampling interval, 2.5 ms", 400},
                                                   {"Delta_X\t0.0025\t0.0025\t0.0025\t", 400},
                                                   {"Delta_X\t0,0025", 400},
                                                   {"# acquisition rate = 1 kHz", 1000},
                                                   {"\"Data Acquisition Rate\",\"100\",\"Hz\"", 100},
                                                   {"Abtastrate;0,5 kHz", 500},
                                                   {"Abtastrate in Hz;50,0", 50},
                                                   {"Frame rate (fps),25,,,", 25},
                                                   {"FPS: 12.5", 12.5},
                                                   {"Sampling Rate 128 S/s", 128},
                                                   {"% dt = 0.01", 100},
                                                   {"Sample Interval,1.000000e-03,s", 1000},
                                                   {"Samples per second: 20", 20},
                                                   {"Fréquence d'échantillonnage : 200 Hz", 200},
                                                   {"Scan interval (µs)\t500", 2000},
                                                   {"Rate: 40 Hz", 40},
                                                   {"Sample rate: 0.4 kS/s", 400},
                                                   {"Sample rate 400/s", 400},
                                                   {"Sample Rate\t2\tMSa/s", 2e6},
                                                   {"Sample rate: 0.4 kHz (of 4 kHz)", 400},
                                                   {"Sample rate: 0.4 kHz, 16 bit", 400},
                                                   {"Acquisition rate: 400 pts/sec", 400},
                                                   {"Bildrate [1/s]: 25 Bilder", 25},
                                                   {"Sample rate [samples/min]: 24000", 400},
                                                   {"Sample rate [samples/min];24000", 400},
                                                   {"Sample rate: 24000 samples/min", 400},
                                                   {"Sample rate: 24 ksamples/min", 400},
                                                   {"Sampling rate: 24000 per minute", 400},
                                                   {"Sampling rate: 24000/min", 400},
                                                   {"Sample rate: 72000 readings per hour", 20},
                                                   {"Sample rate: 2.5 ms/sample", 400},
                                                   {"Sampling interval: 2.5 ms per sample", 400},
                                                   {"Sampling interval [s/pt]: 0.0025", 400},
                                                   {"Abtastrate: 400 Werte pro Sekunde", 400},
                                                   {"Actual sampling rate of the channels: 400 Hz", 400}}) {
    const auto found = stated_rate("a.txt", "Test 7, 3.5.2026\n" + line + "\nSpeed: 0.1 mm/s\n");
    ASSERT_TRUE(found) << line;
    EXPECT_NEAR(found->rate, rate, 1e-9 * rate) << line;  // a quotient of two decimal numbers
    EXPECT_EQ(found->line, 2u);
  }
}

TEST(StatedRates, AreNotTakenFromOtherNumbers) {
  for (const std::string line :
       {"Shear rate: 0.1 1/s", "Oscillation frequency: 1 Hz", "Sampling interval: 2.5", "Loading rate (mN/s): 4",
        "Sample: 400", "Samples\t400\t400", "Rate: 0.1", "Sample rate: fast", "Sample rate: 1,000 Hz",
        "Date: 2026-05-01", "Sample rate: 0 Hz", "X0\t0.5", "Sample rate: 1/400 s",
        "Sampling rate: 1 sample every 2.5 ms", "Sampling rate: 0.4k", "Sample rate, 12,5 Hz", "Data rate,1,5 kHz"})
    EXPECT_FALSE(stated_rate("a.txt", line + "\n")) << line;
}

TEST(StatedRates, OfAnotherKindOrUnitAreNamedAndNotTaken) {
  for (const std::string line :
       {"Max. sampling rate: 10 kHz", "Maximum sample rate 10 kHz", "max_sample_rate = 10000",
        "Default sampling rate: 50 Hz", "Allowed sampling rates: 50 Hz", "ADC sampling rate: 100 kHz",
        "Internal data rate: 4.8 kHz", "Camera frame rate: 25 fps", "Maximale Abtastrate: 10 kHz",
        "Sample rate [foo]: 400", "Sample rate: 400 furlongs", "Data rate: 9600 baud",
        "Sample rate [Hz]: 24000 samples/min", "Sampling interval: 2.5", "Sampling interval: 2.5 ticks",
        "Sample rate: 1,000 Hz"}) {
    std::string not_taken;
    EXPECT_FALSE(stated_rate("a.txt", "Test\n" + line + "\n", &not_taken)) << line;
    EXPECT_EQ(not_taken, "line 2, '" + line + "'");
    const auto beside = stated_rate("a.txt", line + "\nSampling rate: 400 Hz\n");
    ASSERT_TRUE(beside) << line;
    EXPECT_EQ(beside->rate, 400) << line;
  }
}

TEST(StatedRates, ThatContradictEachOtherAreRefused) {
  EXPECT_EQ(stated_rate("a.txt", "Sample rate: 400 Hz\r\nInterval\r\nSampling interval: 2.5 ms\r\n")->line, 1u);
  EXPECT_EQ(
      input_error([] { stated_rate("a.txt", "Sample rate: 400 Hz\r\n\r\nFrame rate: 25 Hz\r\n"); }),
      "a.txt:3:1: states a rate of 25 Hz, line 1 one of 400 Hz; say which is that of the rows: --rate=\"400 Hz\", "
      "or the key rate");
}

}  // namespace stated_rate_test
}  // namespace mixity
