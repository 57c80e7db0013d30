// The whole program as the first half of a pipe: what it prints, and that it ends with its reader.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

#include "tests/support/display.h"
#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::print_values_program_test {
namespace {

ProgramCall printing_on(const Display& display, std::vector<std::string> more) {
  ProgramCall call;
  call.words = {"run", "--print-values", "60", "--no-hints"};
  call.words.insert(call.words.end(), more.begin(), more.end());
  call.environment = display.environment();
  return call;
}

TEST(PrintValuesProgram, PrintsWhatTheStageSays) {
  const Display display(1280, 800);
  RunningProgram program(ghostforce_program(), printing_on(display, {}));
  const auto next_line = [&] { return program.next_line().value_or(""); };
  std::string line = next_line();
  EXPECT_TRUE(line.starts_with("# sentence\tstrategy\t")) << line;
  const std::string wanted = "A ghost force drags the handle along the wall.\tnaive\t3.39\t2.12\t1.27\t12.0\t";
  while (!line.empty() && !line.starts_with(wanted)) line = next_line();
  EXPECT_NE(line, "") << "not a line of it";
  program.send(SIGTERM);
  EXPECT_EQ(program.wait_for_end(), 130);
}

TEST(PrintValuesProgram, EndsAtTheEndOfALine) {
  const Display display(1280, 800);
  const Outcome outcome = run_ghostforce(printing_on(display, {"--exit-after", "0"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("# sentence\tstrategy\t")) << outcome.out;
  EXPECT_EQ(outcome.out.find('\n'), outcome.out.size() - 1) << outcome.out;
}

// It has no other reason to end.
TEST(PrintValuesProgram, EndsInSilenceWhenItsReaderGoes) {
  const Display display(1280, 800);
  ProgramCall call = printing_on(display, {"--input", "circle"});
  call.close_after_first_piece = true;
  const Outcome outcome = run_ghostforce(call);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(read_whole(display.layout_file()), "") << "it ends as if the window had been closed";
}

TEST(PrintValuesProgram, AFullDiskIsAnExitCode) {
  const Display display(1280, 800);
  ProgramCall call = printing_on(display, {"--exit-after", "0"});
  call.out_to = "/dev/full";
  const Outcome outcome = run_ghostforce(call);
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_NE(outcome.err.find("not all values were printed: No space left on device"), std::string::npos) << outcome.err;
}

TEST(PrintValuesProgram, RefusesWhatNobodyCouldReadOrWaitFor) {
  for (const char* hz : {"61", "0", "nan", "five"}) {
    const Outcome outcome = run_ghostforce({"run", "--print-values", hz});
    EXPECT_EQ(outcome.exit_code, 2) << hz;
    EXPECT_NE(outcome.err.find("0.1 to 60 Hz"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace ghostforce::print_values_program_test
