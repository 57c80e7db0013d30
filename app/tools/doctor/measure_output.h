// MeasureOutput: where a measurement's report and calibration go: opened before anybody has worked for ten minutes, and
// written at the end, the calibration after the person has agreed. UI thread; throws Failure.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "app/files/output_file.h"

namespace ghostforce {

// Date and time, for a report.
std::string now_in_words();

struct MeasuredTexts {
  std::string_view device;  // "Falcon"
  bool is_virtual = false;
  bool is_kept = false;  // there is a calibration of this device already
  std::string report;
  std::string calibration;
  std::function<std::filesystem::path()> keep;  // keeps the calibration for every later start
  std::function<void(std::string_view)> tell;   // the person
  std::function<bool(std::string_view question)> says_yes;
};

class MeasureOutput {
 public:
  // Paths; report "-": the standard output; no calibration: where calibrations are kept, if the person wants that.
  MeasureOutput(const std::string& report, const std::optional<std::string>& calibration);

  void write(const MeasuredTexts& texts);

 private:
  void write_calibration(const MeasuredTexts& texts);

  std::string report_path_;
  std::optional<std::string> calibration_path_;
  OutputFile report_;
  bool is_there_ = false;  // a file where the calibration is to go
  std::optional<OutputFile> calibration_;
};

}  // namespace ghostforce
