#include "app/workbench/bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/stage/hints.h"
#include "app/state/user_measurement_guide.h"
#include "app/widgets/controls.h"
#include "app/widgets/symbol_text.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

constexpr double visible_force = 0.01;  // as in the table [N]
constexpr float large = 1.2F;           // of the panels' letters
constexpr float paused_letters = 1.7F;
constexpr double parallel = 0.02;  // sine of an angle that looks like none

}  // namespace

std::string_view caption_of(const Settings& settings, const Vector<2>& goal) {
  if (depth_in_wall(settings, goal) <= 0.0) {
    return "The goal is in front of the wall: there is nothing to push back. Drag it into the hatched side.";
  }
  const Strategy& active = strategy(settings.active);
  const auto rest = rest_of(settings.active, settings, goal);
  if (!rest) return "The handle runs away: it comes to rest nowhere under this goal. Press 3, or move the goal.";
  const MotorReach motors = motor_reach(settings, rest->at.device);
  const Vector<2> normal = wall_near(settings, rest->at.device).normal;
  const bool is_along_wall = motors.is_one_line() && std::abs(glm::dot(normal, motors.directions[0])) < parallel;
  if (!active.has_every_motor && is_along_wall) {
    return "The motor pushes along the wall: it cannot hold the hand back at all. Turn its arrow.";
  }
  const bool has_ghost = glm::length(rest->ghost_force) >= visible_force;
  if (has_ghost && active.id == StrategyId::naive && has_strings(settings)) {
    return "Strings only pull, but are rendered as if they could push, too: a ghost force drags the hand along the "
           "wall.";
  }
  return has_ghost ? active.with_ghost : active.without_ghost;
}

namespace {

// Where the goal is only inferred, what theory says of it would be said of the belief.
std::string words_in_hand(const PanelContext& context) {
  const Strategy& active = strategy(context.settings.active);
  const StrategySnapshot<2>& now = context.snapshot.strategies[index_of(active.id)];
  if (!now.in_contact) return "Push the handle into the wall.";
  const double ghost = glm::length(now.ghost_force);
  if (!context.snapshot.has_target || context.snapshot.measured != active.id || std::isnan(ghost)) {
    return "Where you aim is only estimated from the force, so the ghost force cannot be known.";
  }
  return fmt::format("{} Measured relative to the target.",
                     ghost < visible_force ? active.without_ghost : active.with_ghost);
}

// A device that is on its way says how far it is; one at its limit, what to do. Else empty.
std::string words_of_device(const PanelContext& context) {
  const MotorReport& motors = context.loop.motors;
  const auto step = std::ranges::find_if(context.loop.readiness, &ReadinessStepState::is_current);
  if (motors.has_motors && !motors.is_ready && step != context.loop.readiness.end()) {
    return fmt::format("{}: {}. {}", context.loop.input_title, step->title, step->words);
  }
  if (motors.is_saturated) {
    return fmt::format("The wall would push harder than the motors may: they give {:.1f} N. Do not press so deep.",
                       glm::length(motors.sent));
  }
  return {};
}

// Null: time goes on.
const char* words_of_stillness(const Session& session) {
  if (session.stage.looks_back_to_s) return "LAST MINUTE";
  return session.paused ? "PAUSED" : nullptr;
}

std::string words_of(const PanelContext& context) {
  if (std::string words = words_of_device(context); !words.empty()) return words;
  if (is_measuring(context.session)) return "The hand is being measured: follow the panel “Measure the hand”.";
  if (context.snapshot.measured) return words_in_hand(context);
  return std::string(caption_of(context.settings, context.snapshot.goal));
}

// At the right edge, as high as the bar: to be read from the last row. Returns where it begins.
float draw_stillness(const PanelContext& context, const char* words) {
  const char* const remedy = context.session.stage.looks_back_to_s ? "Space: back to now" : "Space: resume";
  const float regular = ImGui::GetStyle().FontSizeBase;
  const ImVec2 corner = ImGui::GetCursorPos();
  const float right = ImGui::GetContentRegionMax().x;
  ImGui::PushFont(context.fonts.bold, paused_letters * regular);
  const float left = right - ImGui::CalcTextSize(words).x;
  ImGui::SetCursorPosX(left);
  text_in(context.theme.accent, words);
  ImGui::PopFont();
  ImGui::SetCursorPosX(right - ImGui::CalcTextSize(remedy).x);
  text_in(context.theme.faint_text, remedy);
  ImGui::SetCursorPos(corner);
  return left;
}

}  // namespace

std::vector<std::string> warnings_of_caption(const PanelContext& context) {
  std::vector<std::string> words;
  if (const char* const still = words_of_stillness(context.session)) words.emplace_back(still);
  if (std::string device = words_of_device(context); !device.empty()) words.push_back(std::move(device));
  return words;
}

void draw_caption(const PanelContext& context) {
  const char* const still = words_of_stillness(context.session);
  const bool is_still = still != nullptr;
  const float end =
      is_still ? draw_stillness(context, still) - ImGui::GetStyle().ItemSpacing.x : ImGui::GetContentRegionMax().x;
  if (context.session.hint && !is_still) {
    draw_hint(context);
    return;
  }
  const std::string words = words_of(context);
  // Large, to be read from the last row, where two lines have room for it.
  const float needed = ImGui::CalcTextSize(words.c_str()).x;
  const float room = end - ImGui::GetCursorPosX();
  const bool fits = large * needed < 1.8F * room;
  if (is_still && needed > 2.2F * room) return;  // more lines than the bar has beside the large word
  ImGui::PushFont(context.fonts.regular, (fits ? large : 1.0F) * ImGui::GetStyle().FontSizeBase);
  const std::size_t i = index_of(context.settings.active);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight();
  draw_glyph(*ImGui::GetWindowDrawList(), {corner.x + 0.6F * line, corner.y + 0.5F * line}, 0.42F * line,
             strategy_style(context.settings.active).shape, context.theme.strategy[i]);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.6F * line);
  const ImVec2 left{end - ImGui::GetCursorPosX(), ImGui::GetWindowHeight() - ImGui::GetCursorPosY()};
  const std::string shown = as_much_as_fits(words, left);
  wrapped_text(shown, end);
  ImGui::PopFont();
  if (shown != words) tooltip(words);
}

}  // namespace ghostforce
