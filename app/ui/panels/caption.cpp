#include "app/ui/panels/caption.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/session/measurement_guide.h"
#include "app/ui/panels/hints.h"
#include "app/ui/widgets/controls.h"
#include "core/prediction.h"

namespace ghostforce {
namespace {

constexpr double visible_force = 0.01;  // as in the table [N]
constexpr float large = 1.2F;           // of the panels' letters
constexpr double parallel = 0.02;       // sine of an angle that looks like none

}  // namespace

std::string_view caption_of(const Settings& settings, const Vector<2>& goal) {
  const Wall<2> wall = wall_of(settings);
  if (depth(wall, goal) <= 0.0) {
    return "The goal is in front of the wall: there is nothing to push back. Drag it into the hatched side.";
  }
  const Strategy& active = strategy(settings.active);
  if (!active.has_every_motor && std::abs(glm::dot(wall.normal, direction_at(settings.actuated_angle))) < parallel) {
    return "The motor pushes along the wall: it cannot hold the hand back at all. Turn its arrow.";
  }
  const Vector<2> ghost = predicted_equilibria(settings, goal)[index_of(settings.active)].ghost_force;
  return glm::length(ghost) < visible_force ? active.without_ghost : active.with_ghost;
}

namespace {

// Where the goal is only inferred, what theory says of it would be said of the belief.
std::string words_in_hand(const PanelContext& context) {
  const Strategy& active = strategy(context.settings.active);
  const StrategySnapshot<2>& now = context.snapshot.strategies[index_of(active.id)];
  if (!now.in_contact) return "In your hand: push the handle into the wall.";
  const double ghost = glm::length(now.ghost_force);
  if (!context.snapshot.has_target || context.snapshot.measured != active.id || std::isnan(ghost)) {
    return "In your hand: where you aim is only inferred, so the ghost force cannot be known.";
  }
  return fmt::format("{} In your hand, against the target.",
                     ghost < visible_force ? active.without_ghost : active.with_ghost);
}

// A device that is on its way says how far it is; one in the hand, what is felt.
std::string words_of(const PanelContext& context) {
  const MotorReport& motors = context.loop.motors;
  const auto step = std::ranges::find_if(context.loop.readiness, &ReadinessStepState::is_current);
  if (motors.has_motors && !motors.is_ready && step != context.loop.readiness.end()) {
    return fmt::format("{}: {}. {}", context.loop.input_title, step->title, step->words);
  }
  if (motors.is_saturated) {
    return fmt::format("The wall wants to push harder than the motors may: they give {:.1f} N. Press less deep.",
                       glm::length(motors.sent));
  }
  if (is_measuring(context.session)) return "The hand is being measured: the panel says what to do.";
  if (context.snapshot.measured) return words_in_hand(context);
  return std::string(caption_of(context.settings, context.snapshot.goal));
}

}  // namespace

void draw_caption(const PanelContext& context) {
  if (context.session.hint) {
    draw_hint(context);
    return;
  }
  const std::string words = words_of(context);
  // Large, to be read from the last row, where two lines have room for it.
  const float needed = large * ImGui::CalcTextSize(words.c_str()).x;
  const bool fits = needed < 1.8F * ImGui::GetContentRegionAvail().x;
  ImGui::PushFont(context.fonts.regular, (fits ? large : 1.0F) * ImGui::GetStyle().FontSizeBase);
  const std::size_t i = index_of(context.settings.active);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight();
  draw_glyph(*ImGui::GetWindowDrawList(), {corner.x + 0.6F * line, corner.y + 0.5F * line}, 0.42F * line,
             strategy_style(context.settings.active).shape, context.theme.strategy[i]);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.6F * line);
  wrapped_text(words);
  ImGui::PopFont();
}

}  // namespace ghostforce
