// `ghostforce doctor --measure` as a script calls it: answers out of a file, a report, a calibration, exit codes.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "app/files/falcon_calibration_file.h"
#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::measure_command_test {
namespace {

class MeasureCommand : public testing::Test {
 protected:
  // Its standard input is `answers`; words of both outputs are in the outcome.
  Outcome measure(const std::string& answers, const std::string& options) const {
    write_whole(folder_ / "answers", answers);
    return run_program("/bin/sh", shell(fmt::format("exec '{}' doctor --measure --input virtual-falcon {} <'{}'",
                                                    ghostforce_program(), options, folder_ / "answers")));
  }
  ProgramCall shell(const std::string& line) const {
    ProgramCall call;
    call.words = {"-c", line};
    call.environment = {"XDG_CONFIG_HOME=" + folder_ / "config", "GHOSTFORCE_FIRMWARE="};
    return call;
  }

  TemporaryFolder folder_;
};

const std::string enters(200, '\n');

TEST_F(MeasureCommand, WritesReportAndCalibration) {
  const std::string report = folder_ / "report.md";
  const std::string calibration = folder_ / "falcon.toml";
  const Outcome outcome = measure(enters, fmt::format("-o '{}' --calibration '{}'", report, calibration));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(read_falcon_calibration(read_whole(calibration), calibration).serial.text(), "VIRTUAL1");
  EXPECT_NE(read_whole(report).find("# Measurement of a Novint Falcon"), std::string::npos);
  EXPECT_NE(read_whole(report).find(read_whole(calibration)), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "config")) << "It is not kept, because this device is simulated";
}

TEST_F(MeasureCommand, ReportGoesToTheStandardOutput) {
  const Outcome outcome = measure("s\ns\ns\ns\ns\ns\ns\ns\n", "");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("# Measurement of a Novint Falcon")) << outcome.out;
  EXPECT_NE(outcome.out.find("Skipped."), std::string::npos);
}

TEST_F(MeasureCommand, OverwritesNoCalibrationUnasked) {
  const std::string calibration = folder_ / "falcon.toml";
  write_whole(calibration, "mine\n");
  const std::string skips = "s\ns\ns\ns\n";  // the steps in between have nothing to build on
  EXPECT_EQ(measure(skips + "n\n", fmt::format("--calibration '{}'", calibration)).exit_code, 1);
  EXPECT_EQ(read_whole(calibration), "mine\n");
  EXPECT_EQ(measure(skips, fmt::format("--calibration '{}'", calibration)).exit_code, 1);
  EXPECT_EQ(read_whole(calibration), "mine\n") << "no answer is no";
  EXPECT_EQ(measure(skips + "y", fmt::format("--calibration '{}'", calibration)).exit_code, 1);
  EXPECT_EQ(read_whole(calibration), "mine\n") << "half an answer is none";
  EXPECT_EQ(measure(skips + "y\n", fmt::format("--calibration '{}'", calibration)).exit_code, 1);
  EXPECT_NE(read_whole(calibration).find("serial = \"VIRTUAL1\""), std::string::npos);
}

TEST_F(MeasureCommand, EndOfInputWritesNothing) {
  const std::string report = folder_ / "report.md";
  const Outcome outcome = measure("\n\n", fmt::format("-o '{}'", report));
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("The input ended before the measurement did"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(report));
}

TEST_F(MeasureCommand, InterruptedIs130AndWritesNothing) {
  ASSERT_EQ(mkfifo((folder_ / "typing").c_str(), 0600), 0);
  const int typing = open((folder_ / "typing").c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_GE(typing, 0);
  const std::string report = folder_ / "report.md";
  RunningProgram program("/bin/sh",
                         shell(fmt::format("exec '{}' doctor --measure --input virtual-falcon -o '{}' <'{}' 2>&1",
                                           ghostforce_program(), report, folder_ / "typing")));
  bool is_asking = false;
  while (!is_asking) {
    const auto line = program.next_line();
    ASSERT_TRUE(line) << "it never asked";
    is_asking = line->find("the simulated hand does it") != std::string::npos;
  }
  program.send(SIGINT);
  EXPECT_EQ(program.wait_for_end(), 130);
  EXPECT_FALSE(std::filesystem::exists(report));
  close(typing);
}

TEST_F(MeasureCommand, ExitCodesOfWhatIsInTheWay) {
  EXPECT_EQ(measure(enters, "--misbehave absent").exit_code, 3);
  EXPECT_EQ(measure(enters, "--misbehave busy").exit_code, 4);
  EXPECT_EQ(measure(enters, "--misbehave always-corrupted-echo").exit_code, 5);
  EXPECT_EQ(measure(enters, "--misbehave never-homes").exit_code, 5);
  EXPECT_EQ(measure(enters, "-o /nowhere/report.md").exit_code, 8);
  EXPECT_EQ(measure(enters, "--json").exit_code, 2);
  EXPECT_EQ(run_ghostforce({"doctor", "--calibration", "f.toml"}).exit_code, 2);
}

}  // namespace
}  // namespace ghostforce::measure_command_test
