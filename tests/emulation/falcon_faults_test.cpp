// Each fault of the catalog while the motors push: the force ends, and not because the device was opened anew; where
// the wire is dead a zero was tried last; and once the fault has gone the device is there again, with its motors off.
// How soon is no test's business on a machine that does other things as well: fault_table measures it.
#include <chrono>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/emulation/fault_trial.h"
#include "tests/emulation/machine_watch.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {

void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.title;
}

namespace {

constexpr std::chrono::milliseconds patience{20'000};

std::vector<Fault> quick_faults() {
  std::vector<Fault> quick;
  for (const Fault& fault : fault_catalog()) {
    if (fault.is_quick) quick.push_back(fault);
  }
  return quick;
}

class FalconFaultsTest : public testing::TestWithParam<Fault> {};

TEST_P(FalconFaultsTest, EndsTheForceAndComesBack) {
  if (const std::string_view obstacle = hold_obstacle(GetParam().hold); !obstacle.empty()) GTEST_SKIP() << obstacle;
  TestBed bed;
  FaultOutcome outcome;
  try {
    outcome = try_fault(bed, GetParam(), patience);
  } catch (const MachineTooBusy& why) {
    GTEST_SKIP() << why.what();
  }
  EXPECT_EQ(broken_promise(GetParam(), outcome, false), "")
      << "says: " << outcome.words() << "; zero after "
      << (outcome.zero_ns ? std::to_string(*outcome.zero_ns / 1'000'000) + " ms" : "never");
}

INSTANTIATE_TEST_SUITE_P(, FalconFaultsTest, testing::ValuesIn(quick_faults()),
                         [](const auto& run) { return std::string(run.param.name); });

TEST(FaultCatalog, IsToldInTheDocumentation) {
  const std::string doc = read_whole(source_path("/docs/falcon.md"));
  for (const Fault& fault : fault_catalog()) {
    EXPECT_NE(doc.find("| " + std::string(fault.title) + " | "), std::string::npos)
        << "docs/falcon.md does not tell of: " << fault.title;
  }
}

}  // namespace
}  // namespace ghostforce
