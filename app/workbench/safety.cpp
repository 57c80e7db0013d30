// The motors: whether they may push, with what, and why not.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "app/state/front_keys.h"
#include "app/state/stage_action.h"
#include "app/state/stage_language.h"
#include "app/widgets/controls.h"
#include "app/workbench/motor_control.h"
#include "app/workbench/panel_catalog.h"
#include "core/force_limiter.h"

namespace ghostforce {
namespace {

// Nothing is said of a key that does not reach the window.
std::string_view words_about_esc(const MotorReport& motors) {
  return motors.has_focus ? " Esc is the emergency stop." : "";
}

std::string words_about(const MotorReport& motors) {
  const std::string_view status_key = front_keys().device_status.shown;
  switch (motors.state) {
    case SafetyState::off:
      if (motors.may_still_push) return fmt::format("They may still push. {} says what to do.", status_key);
      if (motors.reason == OffReason::none) {
        return motors.is_ready ? std::string("Off. The button at the top right arms the motors.")
                               : fmt::format("Off. The device is not ready. {} says what to do next.", status_key);
      }
      return fmt::format("Off: {}. {}", entry_of(motors.reason).title, remedy_words(motors, status_key));
    case SafetyState::arming:
      return fmt::format("Arming: {}.", filled(entry_of(motors.obstacle).sentence, status_key));
    case SafetyState::ramp:
      if (motors.is_checking) return fmt::format("Being checked: hold the handle still.{}", words_about_esc(motors));
      return fmt::format("Turning on: {:.0f} %.{}", 100.0 * motors.gain, words_about_esc(motors));
    case SafetyState::on:
      return fmt::format("On.{}", words_about_esc(motors));
    case SafetyState::fade:
      return fmt::format("Turning off: {}.", entry_of(motors.reason).title);
  }
  return {};
}

void draw_limits(const PanelContext& context) {
  SafetyOptions safety = context.session.safety;
  if (!begin_rows("safety", context)) return;
  row("Force limit", "The largest force that is asked of the motors. A larger one is reduced and keeps its direction.");
  bool is_changed = slider("##limit", safety.force_limit, {0.5, force_ceiling}, "%.1f N");
  row("Stiffest wall",
      "k_r is limited to this while the motors are on. For more than 800 N/m, Ctrl+click and type the value.");
  is_changed |= slider("##stiffest", safety.greatest_k_r, {50.0, SafetyOptions{}.greatest_k_r}, "%.0f N/m",
                       ImGuiSliderFlags_None);
  row("Deadman switch", "Motors are on only while a grip button is held.");
  is_changed |= ImGui::Checkbox("only while a button is held", &safety.needs_button);
  if (is_changed) context.apply(ChangeSafety{safety});
  end_rows();
}

}  // namespace

void draw_safety(const PanelContext& context) {
  const MotorReport& motors = context.loop.motors;
  // The words change by themselves, and nothing below them may move away from under a pointer.
  constexpr float lines_of_words = 3.0F;
  const float below = ImGui::GetCursorPosY() + lines_of_words * ImGui::GetTextLineHeightWithSpacing();
  std::string words = words_about(motors);
  if (motors.held_k_r > 0.0) words += fmt::format(" k_r is limited to {:.0f} N/m.", motors.held_k_r);
  wrapped_text(words);
  ImGui::Dummy({0.0F, std::max(0.0F, below - ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y)});
  ImGui::PushFont(context.fonts.number, 0.0F);
  // What was sent last need not have arrived.
  const std::string force =
      motors.may_still_push ? fmt::format("{:>4}", "?") : fmt::format("{:4.2f}", glm::length(motors.sent));
  wrapped_text(fmt::format("{} of {:4.2f} N{:9}  {:4.2f} m/s", force, motors.limit,
                           motors.is_saturated ? ", limited" : "", motors.handle_speed));
  ImGui::PopFont();
  tooltip("The force sent to the motors after all limits, the largest force allowed, and the speed of the handle.");
  draw_motor_heat(context);
  if (ImGui::TreeNodeEx("Limits", ImGuiTreeNodeFlags_SpanAvailWidth)) {
    draw_limits(context);
    ImGui::TreePop();
  }
}

}  // namespace ghostforce
