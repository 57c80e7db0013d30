#include "app/shell/spacemouse_input_link.h"

#include <algorithm>
#include <string_view>

#include "app/widgets/controls.h"

namespace ghostforce {
namespace {

std::string_view words_about(const SpaceMouseReading& reading, const SpaceMouseWords& words) {
  switch (reading.trouble) {
    case SpaceMouseReading::Trouble::none:
      return reading.name.data();
    case SpaceMouseReading::Trouble::absent:
      return words.absent;
    case SpaceMouseReading::Trouble::not_allowed:
      return words.not_allowed;
    case SpaceMouseReading::Trouble::not_opened:
      return words.not_opened;
  }
  return {};
}

// A bar from the middle for each axis of the cap, live.
void draw_axes(const PanelContext& context, const SpaceMouseReading& reading) {
  const float height = 0.5F * ImGui::GetTextLineHeight();
  const float gap = 4.0F * context.scale;
  const float width = (ImGui::GetContentRegionAvail().x - 5.0F * gap) / 6.0F;
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  for (std::size_t i = 0; i < reading.axes.size(); ++i) {
    const float left = corner.x + static_cast<float>(i) * (width + gap);
    const float middle = left + 0.5F * width;
    draw_list.AddRectFilled({left, corner.y}, {left + width, corner.y + height}, packed(context.theme.panel_field));
    const float end = middle + 0.5F * width * static_cast<float>(reading.axes[i]);
    draw_list.AddRectFilled({std::min(middle, end), corner.y}, {std::max(middle, end), corner.y + height},
                            packed(context.theme.accent));
    draw_list.AddLine({middle, corner.y}, {middle, corner.y + height}, packed(context.theme.text), context.scale);
  }
  ImGui::Dummy({ImGui::GetContentRegionAvail().x, height});
  tooltip("How far the cap is deflected: to the right, towards you, down, and turned about each of these.");
}

// In the panel Input: which SpaceMouse it is, or why there is none; its cap, live; its settings.
void draw_spacemouse(const PanelContext& context, const SpaceMouseReading& reading, const SpaceMouseWords& words) {
  SpaceMouseSettings settings = context.session.spacemouse;
  wrapped_text(words_about(reading, words));
  draw_axes(context, reading);
  if (!begin_rows("spacemouse", context)) return;
  row("Cap sets", "Whether the cap sets the position of the goal or its speed.");
  int mode = static_cast<int>(settings.mode);
  ImGui::RadioButton("position", &mode, static_cast<int>(SpaceMouseSettings::Mode::position));
  ImGui::SameLine();
  ImGui::RadioButton("speed", &mode, static_cast<int>(SpaceMouseSettings::Mode::rate));
  settings.mode = static_cast<SpaceMouseSettings::Mode>(mode);
  row("Up is", "Which motion of the cap moves the goal up.");
  int up = static_cast<int>(settings.up);
  ImGui::RadioButton("lifting", &up, static_cast<int>(SpaceMouseSettings::Up::lift));
  ImGui::SameLine();
  ImGui::RadioButton("pushing away", &up, static_cast<int>(SpaceMouseSettings::Up::push_away));
  settings.up = static_cast<SpaceMouseSettings::Up>(up);
  row("Dead zone", "A smaller deflection of the cap does not move the goal.");
  double percent = 100.0 * settings.dead_zone;
  if (slider("##dead", percent, {0.0, 50.0}, "%.0f %%")) settings.dead_zone = percent / 100.0;
  if (settings != context.session.spacemouse) context.apply(ChangeSpaceMouse{settings});
  end_rows();
}

}  // namespace

EndOfRun end_with(SpaceMouseReading::Trouble trouble) {
  switch (trouble) {
    case SpaceMouseReading::Trouble::none:
      return {};
    case SpaceMouseReading::Trouble::absent:
      return {ExitCode::device_absent, "No SpaceMouse is plugged in. Plug one in, or choose another --input."};
    case SpaceMouseReading::Trouble::not_allowed:
      return {ExitCode::device_refused,
              "This user may not open the SpaceMouse. Run 'ghostforce doctor --install-udev' once, then plug it in "
              "again."};
    case SpaceMouseReading::Trouble::not_opened:
      return {ExitCode::device_refused, "The SpaceMouse cannot be opened. Close the other program that has it."};
  }
  return {};
}

void SpaceMouseInputLink::fill(LoopReading& reading) const {
  reading.draw_input = [this](const PanelContext& context) { draw_spacemouse(context, reading_, words_); };
}

void SpaceMouseInputLink::poll() {
  const SpaceMouseReading& now = input_.reading();
  has_news_ = has_news_ || now.trouble != reading_.trouble || now.connection != reading_.connection ||
              now.reports != reading_.reports;
  reading_ = now;
}

void SpaceMouseInputLink::send(Session& session, double /*interval_s*/) {
  input_.set(session.spacemouse);
  has_news_ = false;
}

}  // namespace ghostforce
