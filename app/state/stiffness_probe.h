// StiffnessProbe: the stage measures the hand once, because somebody asked for it. The tones sound (core/measuring_tones.h) until
// it is known how stiff the hand is, or it gives up and says why. Only model time in the wall counts. As a value of
// the session; stiffness_probe_guide.h leads it. SI units.
#pragma once

#include <cstdint>
#include <optional>

#include "core/hand_estimator.h"

namespace ghostforce {

struct StiffnessProbe {
  enum class Stage : std::uint8_t { off, running, done };
  // In the wall, without an answer.
  static constexpr double gives_up_after_s = 6.0;

  Stage stage = Stage::off;
  double filled = 0.0;  // of the time that it takes, 0 to 1
  // While it runs, what it waits for: no_contact, no_tones (the motors are off), none. Done: why nobody knows.
  HandUnknown why = HandUnknown::none;
  HandEstimate estimate{};               // done, and known
  std::optional<HandEstimate> before{};  // the last one that was known before this one

  bool has_left_wall = false;          // since it began
  double given_k_u = 0.0;              // of the simulated hand that was measured [N/m]
  double tried_s = 0.0;                // in the wall, since it began
  std::optional<double> seen_s{};      // model time of the last look; empty: it has not begun yet
  std::optional<double> pressing_s{};  // model time since which it is in the wall; empty: it is not

  bool is_running() const noexcept { return stage == Stage::running; }
  bool is_known() const noexcept { return stage == Stage::done && why == HandUnknown::none; }
};

}  // namespace ghostforce
