// Hints: three sentences, one after another, for somebody who sees the program for the first time. Each goes when it
// has been followed.
#pragma once

#include <span>
#include <string_view>

#include <imgui.h>

#include "app/panels/panel.h"

namespace ghostforce {

// In their order. Which part of the screen each is about is told by its number: the goal, the third strategy's button,
// the motor axis.
enum class HintTarget : std::uint8_t { goal, third_strategy, motor_axis };
struct Hint {
  std::string_view sentence;
  HintTarget target;
};
std::span<const Hint> hint_catalog() noexcept;

// The target of the hint that is on the screen now.
bool points_at(const Session& session, HintTarget target) noexcept;

class Hints {
 public:
  // Goes on to the next hint when this one has been followed.
  void follow(Session& session);

  // Above the scene, whose rectangle this is, with a line to `goal` on the screen where the hint is about it.
  void draw(const PanelContext& context, ImVec2 corner, ImVec2 size, ImVec2 goal) const;

 private:
  bool is_followed(const Session& session);

  std::optional<std::size_t> begun_;  // the hint that the following belong to
  bool has_dragged_ = false;
  double angle_ = 0.0;  // of the motor axis when the hint appeared [rad]
};

}  // namespace ghostforce
