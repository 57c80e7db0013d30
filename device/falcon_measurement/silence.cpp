#include "device/falcon_measurement/silence.h"

#include <algorithm>

namespace ghostforce {
namespace {

// Less than this cannot be told from a hand that moves by itself [m].
constexpr double least_held = 0.0008;
constexpr double most_tremor_share = 0.3;
// Of the displacement: above the one the force was there, below the other it was gone; in between the handle is on its
// way back.
constexpr double there_share = 0.75;
constexpr double gone_share = 0.3;

bool is_readable(const SilenceReading& reading) noexcept {
  return reading.held >= least_held && reading.tremor <= most_tremor_share * reading.held;
}
bool was_there(const SilenceReading& reading) noexcept {
  return is_readable(reading) && reading.after >= there_share * reading.held;
}
bool was_gone(const SilenceReading& reading) noexcept {
  return is_readable(reading) && reading.after <= gone_share * reading.held;
}

}  // namespace

SilenceVerdict judge_silences(std::span<const SilenceReading> readings) noexcept {
  SilenceVerdict verdict;
  double longest = 0.0;
  bool has_gone = false;
  for (const SilenceReading& reading : readings) {
    longest = std::max(longest, reading.silence_s);
    if (was_there(reading)) verdict.still_there_s = std::max(verdict.still_there_s, reading.silence_s);
    if (was_gone(reading)) {
      verdict.gone_s = has_gone ? std::min(verdict.gone_s, reading.silence_s) : reading.silence_s;
      has_gone = true;
    }
  }
  if (has_gone && verdict.still_there_s < verdict.gone_s) {
    verdict.outcome = SilenceOutcome::drops;
  } else if (!has_gone && longest > 0.0 && verdict.still_there_s == longest) {
    verdict.outcome = SilenceOutcome::stays;
  }
  return verdict;
}

}  // namespace ghostforce
