// SpaceMouseInputLink: to a SpaceMouse: its settings one way, what is known of it and of its cap the other. Each front
// of the program finds the device in its own way, and says in its own words why there is none. UI thread.
#pragma once

#include <string_view>

#include "app/shell/input_link.h"
#include "device/report/input_choice.h"
#include "device/spacemouse/spacemouse_input.h"

namespace ghostforce {

inline constexpr InputChoice spacemouse_hand{"spacemouse", "SpaceMouse",
                                             "The goal follows the cap of a 3Dconnexion SpaceMouse."};

// What there is to do about each trouble, which the two fronts of the program answer differently.
struct SpaceMouseWords {
  std::string_view absent;
  std::string_view not_allowed;
  std::string_view not_opened;
};

// How a run ended that was to use one.
EndOfRun end_with(SpaceMouseReading::Trouble trouble);

class SpaceMouseInputLink : public InputLink {
 public:
  SpaceMouseInputLink(SpaceMouseInput& input, const Scene&, const InputOptions&, const SpaceMouseWords& words)
      : input_(input), words_(words) {}

  void poll() override;
  void fill(LoopReading& reading) const override;
  void send(Session& session, double interval_s) override;
  bool has_news() const noexcept override { return has_news_; }
  EndOfRun end() const override { return end_with(reading_.trouble); }

 protected:
  const SpaceMouseReading& newest() const noexcept { return reading_; }

 private:
  SpaceMouseInput& input_;
  SpaceMouseWords words_;
  SpaceMouseReading reading_;
  bool has_news_ = false;
};

}  // namespace ghostforce
