// Who moves the goal; and for a device, how far it is.
#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "app/session/keys.h"
#include "app/ui/panels/panel_catalog.h"
#include "app/ui/widgets/controls.h"

namespace ghostforce {
namespace {

// Returns the name of the one that was chosen just now, or nothing.
std::string_view choose(const char* id, std::span<const InputChoice> choices, std::string_view chosen_name) {
  std::string_view picked;
  const auto chosen = std::ranges::find(choices, chosen_name, &InputChoice::name);
  const bool is_known = chosen != choices.end();
  const bool is_open = ImGui::BeginCombo(id, is_known ? chosen->title.data() : "");
  if (!is_open) {
    if (is_known) explain(chosen->sentence);
    return picked;
  }
  close_popup_on_escape();
  for (const InputChoice& choice : choices) {
    if (ImGui::Selectable(choice.title.data(), choice.name == chosen_name)) picked = choice.name;
    explain(choice.sentence);
  }
  ImGui::EndCombo();
  return picked;
}

// The rung that is to be reached now, with its words; the whole ladder is a key away.
void draw_rung(const PanelContext& context) {
  const auto rung = std::ranges::find_if(context.loop.ladder, &RungState::is_current);
  ImGui::PushTextWrapPos(0.0F);
  if (rung != context.loop.ladder.end()) {
    ImGui::TextUnformatted((std::string(rung->title) + ": " + rung->words).c_str());
  } else {
    ImGui::TextUnformatted("The device is ready, and its motors are on.");
  }
  if (!context.loop.device_remark.empty()) ImGui::TextUnformatted(context.loop.device_remark.c_str());
  ImGui::PopTextWrapPos();
  if (ImGui::SmallButton("F2  The whole ladder")) open_dialog<Dialog::doctor>(context.session);
}

std::string words_about(const SpaceMouseReading& reading) {
  switch (reading.trouble) {
    case SpaceMouseReading::Trouble::none:
      return reading.name.data();
    case SpaceMouseReading::Trouble::absent:
      return "None is plugged in. It is looked for all the time.";
    case SpaceMouseReading::Trouble::not_allowed:
      return "There is one, and this user may not open it: run 'ghostforce doctor --install-udev' once, then plug it "
             "in again.";
    case SpaceMouseReading::Trouble::not_opened:
      return "There is one, and it cannot be opened: does another program have it?";
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
  explain("How far the cap is deflected: to the right, towards you, down, and turned about each of these.");
}

void draw_spacemouse(const PanelContext& context) {
  SpaceMouseSettings& settings = context.session.spacemouse;
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(words_about(*context.loop.spacemouse).c_str());
  ImGui::PopTextWrapPos();
  draw_axes(context, *context.loop.spacemouse);
  if (!begin_rows("spacemouse", context)) return;
  row("Cap moves", "The goal's place, or how fast it goes.");
  int mode = static_cast<int>(settings.mode);
  ImGui::RadioButton("place", &mode, static_cast<int>(SpaceMouseSettings::Mode::position));
  ImGui::SameLine();
  ImGui::RadioButton("speed", &mode, static_cast<int>(SpaceMouseSettings::Mode::rate));
  settings.mode = static_cast<SpaceMouseSettings::Mode>(mode);
  row("Up is", "Which way the cap moves the goal upwards.");
  int up = static_cast<int>(settings.up);
  ImGui::RadioButton("lifting", &up, static_cast<int>(SpaceMouseSettings::Up::lift));
  ImGui::SameLine();
  ImGui::RadioButton("pushing away", &up, static_cast<int>(SpaceMouseSettings::Up::push_away));
  settings.up = static_cast<SpaceMouseSettings::Up>(up);
  row("Dead zone", "So much of the cap's way moves nothing.");
  double percent = 100.0 * settings.dead_zone;
  constexpr double least = 0.0;
  constexpr double greatest = 50.0;
  if (ImGui::SliderScalar("##dead", ImGuiDataType_Double, &percent, &least, &greatest, "%.0f %%",
                          ImGuiSliderFlags_AlwaysClamp)) {
    settings.dead_zone = percent / 100.0;
  }
  end_rows();
}

}  // namespace

void draw_input(const PanelContext& context) {
  if (begin_rows("input", context)) {
    row("Goal from", "Who moves the goal of the hand.");
    const std::string_view input = choose("##input", context.loop.inputs, context.session.input);
    if (!input.empty()) context.session.wishes.input = input;
    if (!context.loop.misbehaviours.empty()) {
      row("Misbehaves", "What the virtual device does wrong, to see what the program makes of it.");
      const std::string_view wrong =
          choose("##misbehaviour", context.loop.misbehaviours,
                 context.session.misbehaviour.empty() ? "none" : context.session.misbehaviour);
      if (!wrong.empty()) context.session.misbehaviour = wrong;
    }
    end_rows();
  }
  if (!context.loop.ladder.empty()) draw_rung(context);
  if (context.loop.spacemouse) draw_spacemouse(context);
}

}  // namespace ghostforce
