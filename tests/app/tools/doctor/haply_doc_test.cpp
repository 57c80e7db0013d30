// docs/haply.md is what a person has in hand when a Haply 2DIY does not do what it should: it leaves out no fault that can
// be tried, and no key of a calibration.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include <fmt/format.h>

#include "app/files/haply_calibration_file.h"
#include "device/virtual_haply/haply_fault.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::haply_doc_test {
namespace {

class HaplyDoc : public testing::Test {
 protected:
  bool has(const std::string& words) const { return doc_.find(words) != std::string::npos; }

 private:
  const std::string doc_ = read_whole(source_path("/docs/haply.md"));
};

TEST_F(HaplyDoc, TellsWhatEachInjectedFaultComesTo) {
  for (const InjectedHaplyFaultKind& kind : injected_haply_fault_catalog()) {
    // The second of two that are alike is named by its end alone.
    const bool is_second = kind.name == "wrong-sign-2";
    EXPECT_TRUE(has(fmt::format("`{}`", is_second ? "-2" : kind.name))) << kind.name;
  }
}

TEST_F(HaplyDoc, TellsEachKeyOfACalibration) {
  std::istringstream text(haply_calibration_text(usual_haply_variant().calibration));
  int keys = 0;
  for (std::string line; std::getline(text, line);) {
    const std::size_t end = line.find(" = ");
    if (end == std::string::npos) continue;
    ++keys;
    EXPECT_TRUE(has("\n" + line.substr(0, end) + " = ")) << line;
  }
  EXPECT_GE(keys, 10);
}

}  // namespace
}  // namespace ghostforce::haply_doc_test
