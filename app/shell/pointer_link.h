// PointerLink: to an input whose goal the pointer of the window moves. UI thread.
#pragma once

#include "app/shell/input_link.h"
#include "device/input/pointer_target.h"

namespace ghostforce {

class PointerLink : public InputLink {
 public:
  PointerLink(PointerTarget& target, const Scene&, const InputOptions&) : target_(target) {}

  void begin(Session& session) override;
  void fill(LoopReading& reading) const override { reading.refused += target_.ignored_moves(); }
  void send(Session& session, double interval_s) override;

 private:
  PointerTarget& target_;
  Vector<2> sent_goal_{0.0};
  std::uint32_t restarts_ = 0;
};

}  // namespace ghostforce
