// Hints: three sentences, one after another, for somebody who sees the program for the first time. Each goes when it
// has been followed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "app/widgets/panel_context.h"

namespace ghostforce {

// What of the screen a hint is about.
enum class HintTarget : std::uint8_t { goal, third_strategy, motor_axis };

// How things stood when a hint appeared, and what has been done since.
struct HintProgress {
  bool has_dragged = false;
  double actuated_angle = 0.0;  // at first [rad]
};

struct Hint {
  std::string_view sentence;
  std::string_view detail;  // what to look at
  HintTarget target;
  bool (*is_followed)(const Session&, const HintProgress&);
  bool (*is_possible)(const Session&);  // with this input and set-up; it is passed over where it is not
};
// In their order.
std::span<const Hint> hint_catalog() noexcept;

// The target of the hint that is on the screen now.
bool points_at(const Session& session, HintTarget target) noexcept;

class Hints {
 public:
  // Goes on to the next hint when this one has been followed, or cannot be.
  void follow(Session& session);

 private:
  std::optional<std::size_t> begun_;    // the hint that the progress belongs to,
  std::shared_ptr<const Scene> scene_;  // and its scene
  HintProgress progress_;
};

// The hint that is on, in the window that is current.
void draw_hint(const PanelContext& context);

}  // namespace ghostforce
