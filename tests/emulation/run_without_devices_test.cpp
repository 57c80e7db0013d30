// The program on a display, on a machine with nothing plugged in, as a script starts it.
#include <string>

#include <gtest/gtest.h>

#include "tests/emulation/test_bed.h"
#include "tests/support/display.h"
#include "tests/support/program.h"

namespace ghostforce::run_without_devices_test {
namespace {

Outcome visit(const Display& display, const std::string& input) {
  ProgramCall call;
  call.words = {"run", "--no-hints", "--exit-after", "1", "--input", input};
  call.environment = display.environment();
  return run_ghostforce(call);
}

TEST(RunWithoutDevices, SaysWhichOneIsMissing) {
  const Display display(1024, 640);
  const TestBed bed;
  const Outcome spacemouse = visit(display, "spacemouse");
  EXPECT_EQ(spacemouse.exit_code, 3);
  EXPECT_NE(spacemouse.err.find("No SpaceMouse is plugged in"), std::string::npos) << spacemouse.err;
  const Outcome falcon = visit(display, "falcon");
  EXPECT_EQ(falcon.exit_code, 3);
  EXPECT_NE(falcon.err.find("No device is plugged in"), std::string::npos) << falcon.err;
  const Outcome mouse = visit(display, "mouse");
  EXPECT_EQ(mouse.exit_code, 0);
  EXPECT_EQ(mouse.err, "");
}

}  // namespace
}  // namespace ghostforce::run_without_devices_test
