// --kiosk beside other options, as the program itself takes them.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/cli/command.h"
#include "tests/support/program.h"

namespace ghostforce::kiosk_options_test {
namespace {

// Without a display it would end there, with another code.
Outcome run_kiosk(std::vector<std::string> more) {
  more.insert(more.begin(), {"run", "--kiosk"});
  ProgramCall call;
  call.words = std::move(more);
  call.environment = {"DISPLAY=", "WAYLAND_DISPLAY="};
  return run_ghostforce(call);
}

TEST(KioskOptions, ContradictionsAreRefusedInWords) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"fig1"},
           {"--set", "wall.normal_deg=90"},
           {"--set", "wall.normal_deg=90", "--set", "device.mass_kg=0.1"},
           {"--goal-mm=1,2"},
           {"--strategy", "full"},
           {"--mode", "why"},
           {"--view", "workbench"},
           {"--record", "visit.csv"},
           {"--audience"},
           {"--shader-dir", "shaders"},
           {"--input", "script"},
           {"--input", "circle"},
           {"--input", "replay:nothing.csv"},
       }) {
    const Outcome outcome = run_kiosk(words);
    EXPECT_EQ(outcome.exit_code, 2) << words.front() << '\n' << outcome.err;
    EXPECT_NE(outcome.err.find("--kiosk and "), std::string::npos) << words.front() << '\n' << outcome.err;
    EXPECT_NE(outcome.err.find("leave out one of them"), std::string::npos) << outcome.err;
  }
}

TEST(KioskOptions, TheRestGoesTogether) {
  const Outcome outcome =
      run_kiosk({"--lesson", "ghost", "--language", "es", "--theme", "projector", "--scale", "1.5", "--input",
                 "virtual-falcon", "--no-hints", "--exit-after", "1", "--view", "stage"});
  EXPECT_EQ(outcome.exit_code, 6) << outcome.err;
  EXPECT_EQ(outcome.err.find("contradict"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace ghostforce::kiosk_options_test
