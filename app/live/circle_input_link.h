// CircleInputLink: the circle test. Leads the circle along with the wall, and measures what each turn makes of energy.
// UI thread.
#pragma once

#include "app/live/input_link.h"
#include "core/loop_energy.h"
#include "device/input/circle_input.h"

namespace ghostforce {

class CircleInputLink final : public InputLink {
 public:
  CircleInputLink(CircleInput& input, const Scene&, const InputOptions&) : input_(input) {}

  void begin(Session& session) override;
  void add(const Snapshot& snapshot) override { meter_.add(snapshot); }
  void fill(LoopReading& reading) const override { reading.circle = meter_.reading(); }
  void send(Session& session, double interval_s) override;

 private:
  CircleInput& input_;
  Circle sent_circle_;
  CircleEnergyMeter meter_;
  // What the meter measures.
  Settings settings_;
  std::uint32_t restarts_ = 0;
};

}  // namespace ghostforce
