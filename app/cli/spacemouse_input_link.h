// SpaceMouseInputLink: to a SpaceMouse: its settings one way, what is known of it and of its cap the other. UI thread.
#pragma once

#include "app/live/input_link.h"
#include "device/spacemouse/spacemouse_input.h"

namespace ghostforce {

// How a visit ended that was to use one.
EndOfVisit end_with(SpaceMouseReading::Trouble trouble);

class SpaceMouseInputLink final : public InputLink {
 public:
  SpaceMouseInputLink(SpaceMouseInput& input, const Scene&, const InputOptions&) : input_(input) {}

  void look() override;
  void fill(LoopReading& reading) const override;
  void send(Session& session, double interval_s) override;
  bool has_news() const noexcept override { return has_news_; }
  EndOfVisit end() const override { return end_with(reading_.trouble); }

 private:
  SpaceMouseInput& input_;
  SpaceMouseReading reading_;
  bool has_news_ = false;
};

}  // namespace ghostforce
