// Who moves the goal; and for a device, its status.
#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "app/state/front_keys.h"
#include "app/widgets/controls.h"
#include "app/workbench/motor_control.h"
#include "app/workbench/panel_catalog.h"

namespace ghostforce {
namespace {

// Returns the name of the one that was chosen just now, or nothing. `remark`: what the list says below them.
std::string_view choose(const char* id, std::span<const InputChoice> choices, std::string_view chosen_name,
                        std::string_view remark = {}) {
  std::string_view picked;
  const auto chosen = std::ranges::find(choices, chosen_name, &InputChoice::name);
  const bool is_known = chosen != choices.end();
  const bool is_open = ImGui::BeginCombo(id, is_known ? chosen->title.data() : "",
                                         remark.empty() ? ImGuiComboFlags_None : ImGuiComboFlags_HeightLarge);
  if (!is_open) {
    if (is_known) tooltip(chosen->sentence);
    return picked;
  }
  close_popup_on_escape();
  for (const InputChoice& choice : choices) {
    if (ImGui::Selectable(choice.title.data(), choice.name == chosen_name)) picked = choice.name;
    tooltip(choice.sentence);
  }
  if (!remark.empty()) {
    ImGui::Separator();
    wrapped_text(remark, ImGui::GetCursorPosX() + 16.0F * ImGui::GetFontSize());
  }
  ImGui::EndCombo();
  return picked;
}

// The step that is to be reached now, with its words; all of them are a key away.
void draw_step(const PanelContext& context) {
  // The words come last: they change by themselves, and nothing below them may move away from under a pointer.
  draw_zero_pose(context);
  if (context.loop.motors.waits_for_zero_pose) ImGui::SameLine();
  const std::string status = fmt::format("{}  Device status", front_keys().device_status.shown);
  if (ImGui::SmallButton(status.c_str())) context.apply(ToggleDialog{Dialog::doctor});
  const auto step = std::ranges::find_if(context.loop.readiness, &ReadinessStepState::is_current);
  ImGui::PushTextWrapPos(0.0F);
  if (step != context.loop.readiness.end()) {
    ImGui::TextUnformatted((std::string(step->title) + ". " + step->words).c_str());
  } else {
    ImGui::TextUnformatted("The device is ready, and its motors are on.");
  }
  if (!context.loop.device_remark.empty()) ImGui::TextUnformatted(context.loop.device_remark.c_str());
  ImGui::PopTextWrapPos();
}

// Which of two motors pushes. With both the device is fully actuated.
void draw_motor_choice(const PanelContext& context) {
  row("Motors",
      "One motor alone makes the device underactuated, along a line that turns with its handle. With both "
      "it is fully actuated.");
  const Session& session = context.session;
  const bool has_both = session.settings.active == StrategyId::full;
  const auto choose_motors = [&](const char* title, MotorsInUse motors, bool is_chosen) {
    if (ImGui::RadioButton(title, is_chosen)) context.apply(UseMotors{motors});
  };
  choose_motors("1", MotorsInUse::first, !has_both && session.device_motor == 0);
  ImGui::SameLine();
  choose_motors("2", MotorsInUse::second, !has_both && session.device_motor == 1);
  ImGui::SameLine();
  choose_motors("both", MotorsInUse::both, has_both);
}

}  // namespace

void draw_input(const PanelContext& context) {
  if (begin_rows("input", context)) {
    row("Goal from", "What moves the goal of the hand.");
    const std::string_view input =
        choose("##input", context.loop.inputs, context.session.input, context.loop.why_no_falcon);
    if (!input.empty()) context.apply(ChooseInput{std::string(input)});
    if (!context.loop.injected_faults.empty()) {
      row("Injected fault", "Makes the virtual device misbehave, to show how the program reacts.");
      const std::string_view wrong =
          choose("##fault", context.loop.injected_faults,
                 context.session.injected_fault.empty() ? "none" : context.session.injected_fault);
      if (!wrong.empty()) context.apply(InjectFault{std::string(wrong)});
    }
    if (context.loop.motors.line_turns) draw_motor_choice(context);
    if (context.loop.motors.has_motors) {
      row("Aim at a target",
          "Draws a target on the wall. Press straight into the wall there, and ghost force and drift are measured "
          "relative to the target. Without a target, nobody knows where a hand aims.");
      bool aims = context.session.aims_at_target;
      if (ImGui::Checkbox("##target", &aims)) context.apply(AimAtTarget{aims});
    }
    end_rows();
  }
  if (!context.loop.readiness.empty()) draw_step(context);
  if (context.loop.draw_input) context.loop.draw_input(context);
}

}  // namespace ghostforce
