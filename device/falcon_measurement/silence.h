// Whether a Falcon's firmware drops a force by itself when it receives nothing: from where the handle was after a
// silence, between where the force had held it and where the hand alone does. Pure; allocates nothing, any thread.
#pragma once

#include <cstdint>
#include <span>

namespace ghostforce {

struct SilenceReading {
  double silence_s = 0.0;
  double held = 0.0;    // how far the force had moved the handle before the silence [m]
  double after = 0.0;   // how far it was moved still, when the silence ended [m]
  double tremor = 0.0;  // how far the handle wandered while the force was held with frames, peak to peak [m]
};

enum class SilenceOutcome : std::uint8_t {
  undecidable,  // the handle wandered too much, or moved too little
  stays,        // the force was there after the longest silence
  drops,        // it was gone
};

struct SilenceVerdict {
  SilenceOutcome outcome = SilenceOutcome::undecidable;
  double still_there_s = 0.0;  // the longest silence after which it surely was
  double gone_s = 0.0;         // the shortest after which it surely was not; for drops
};

// In any order. Readings of one length that disagree decide nothing.
SilenceVerdict judge_silences(std::span<const SilenceReading> readings) noexcept;

}  // namespace ghostforce
