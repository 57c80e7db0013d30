// docs/falcon.md is what a person has in hand when a Falcon does not do what it should. Whatever the program may say
// about one must be found there in the same words.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "app/files/falcon_calibration_file.h"
#include "app/tools/doctor/readiness.h"
#include "app/tools/doctor/steps.h"
#include "core/safety.h"
#include "device/falcon/falcon_report.h"
#include "device/virtual_falcon/injected_fault.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::falcon_doc_test {
namespace {

// As rows of its tables begin and end.
void expect_row(const std::string& doc, std::string_view first, std::string_view second) {
  const std::string row = fmt::format("| {} | {} |", first, second);
  EXPECT_NE(doc.find(row), std::string::npos) << "docs/falcon.md lacks the row\n" << row;
}

class FalconDoc : public testing::Test {
 protected:
  const std::string doc_ = read_whole(source_path("/docs/falcon.md"));
};

TEST_F(FalconDoc, TellsEveryFaultAndItsRemedy) {
  for (const FalconFaultEntry& fault : falcon_fault_catalog()) {
    if (fault.id != FalconFault::none) expect_row(doc_, sentence_of(fault.id), remedy_of(fault.id));
  }
}

TEST_F(FalconDoc, TellsEveryReasonToTurnOffAndItsRemedy) {
  for (const OffReasonEntry& reason : off_reason_catalog()) {
    if (reason.id != OffReason::none) expect_row(doc_, reason.title, fmt::format(fmt::runtime(reason.remedy), "F2"));
  }
}

TEST_F(FalconDoc, TellsEveryReadinessStep) {
  for (const ReadinessEntry& step : readiness_catalog()) expect_row(doc_, step.title, step.remedy);
}

TEST_F(FalconDoc, TellsEveryInjectedFault) {
  for (const InjectedFaultKind& kind : injected_fault_catalog()) {
    expect_row(doc_, fmt::format("`{}`", kind.name), kind.sentence);
  }
}

TEST_F(FalconDoc, TellsEveryMeasurement) {
  for (const MeasureStep& step : measure_step_catalog()) expect_row(doc_, step.title, step.outline);
}

TEST_F(FalconDoc, TellsEveryKeyOfACalibration) {
  FalconCalibration calibration;
  calibration.serial = *DeviceSerial::from("12PZ657E");
  std::istringstream text(falcon_calibration_text(calibration));
  int keys = 0;
  for (std::string line; std::getline(text, line);) {
    const std::size_t end = line.find(" = ");
    if (end == std::string::npos) continue;
    ++keys;
    EXPECT_NE(doc_.find(fmt::format("| `{}` |", line.substr(0, end))), std::string::npos) << line;
  }
  EXPECT_GE(keys, 14);
}

}  // namespace
}  // namespace ghostforce::falcon_doc_test
