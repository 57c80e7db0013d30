#include "app/tools/doctor/measure_output.h"

#include <ctime>
#include <system_error>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "app/base/quoted.h"

namespace ghostforce {

std::string now_in_words() {
  return fmt::format("{:%Y-%m-%d %H:%M UTC}", fmt::gmtime(std::time(nullptr)));
}

MeasureOutput::MeasureOutput(const std::string& report, const std::optional<std::string>& calibration)
    : report_path_(report), calibration_path_(calibration), report_(report) {
  std::error_code error;
  is_there_ = calibration && std::filesystem::exists(*calibration, error);
  if (calibration) calibration_.emplace(*calibration);
}

void MeasureOutput::write(const MeasuredTexts& texts) {
  report_.write(texts.report);
  report_.commit();
  if (report_path_ != "-") texts.tell(fmt::format("The report is in {}.", quoted_text(report_path_, longest_path)));
  if (!texts.is_virtual)
    texts.tell("Please open an issue with the report attached, at the place where you got this program.");
  write_calibration(texts);
}

void MeasureOutput::write_calibration(const MeasuredTexts& texts) {
  if (calibration_) {
    const std::string shown = quoted_text(*calibration_path_, longest_path);
    if (is_there_ &&
        !texts.says_yes(fmt::format("{} already exists. Replace it with the new calibration? Type y or n.", shown))) {
      texts.tell("It was not changed. The report also contains the calibration.");
      return;
    }
    calibration_->write(texts.calibration);
    calibration_->commit();
    texts.tell(fmt::format("The calibration is in {}.", shown));
    return;
  }
  if (texts.is_virtual) {
    texts.tell(
        "The calibration is in the report. It is not kept, because this device is simulated; --calibration FILE writes "
        "it to a file.");
    return;
  }
  const bool wants = texts.says_yes(
      texts.is_kept
          ? fmt::format("There is already a calibration for this {}. Replace it with the new one, for every "
                        "later start? Type y or n.",
                        texts.device)
          : fmt::format("Keep this calibration for this {}, for every later start? Type y or n.", texts.device));
  if (!wants) {
    texts.tell("It was not kept. The report contains it.");
    return;
  }
  texts.tell(fmt::format("The calibration is in {}.", quoted_text(texts.keep().string(), longest_path)));
}

}  // namespace ghostforce
