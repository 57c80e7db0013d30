// CircleMeter: what one turn after another of the circle test made of energy, strategy by strategy, beside what the
// formula says for the loop that the device really went round. Fed with every tick's snapshot. UI thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/circle.h"
#include "core/loop_meter.h"
#include "core/settings.h"
#include "core/snapshot.h"

namespace ghostforce {

// Of one strategy. Areas and energies per turn, of the last one and the mean over all.
struct CircleEnergy {
  MeasuredLoop last;
  MeasuredLoop mean;
  double predicted = 0.0;    // by energy_per_loop(), for the mean area [J]
  bool stays_inside = true;  // the device was in contact all the way; if not, the formula does not hold
};

struct CircleReading {
  Circle circle;
  int turns = 0;       // complete, under the present settings
  double share = 0.0;  // of the turn that is being measured; 0 before the first begins
  PerStrategy<CircleEnergy> strategies{};
};

class CircleMeter {
 public:
  // Forgets all turns: another run, other settings, another circle.
  void start(const Settings& settings, const Circle& circle) noexcept;

  void add(const Snapshot& snapshot) noexcept;

  const CircleReading& reading() const noexcept { return reading_; }

 private:
  void begin_turn(const Snapshot& snapshot) noexcept;
  void end_turn() noexcept;

  Settings settings_;
  CircleReading reading_;
  double begins_s_ = -1.0;  // of the first turn; negative: not known yet
  double began_s_ = 0.0;    // of the turn that is being measured
  std::int64_t last_tick_ = 0;
  PerStrategy<std::optional<LoopMeter>> meters_{};
  PerStrategy<bool> in_contact_{};
};

}  // namespace ghostforce
