// What of the scene is drawn, and how the screen looks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/session/front_keys.h"
#include "app/ui/panels/dialogs.h"
#include "app/ui/panels/language_choice.h"
#include "app/ui/panels/panel_catalog.h"
#include "app/ui/widgets/controls.h"

namespace ghostforce {
namespace {

void draw_theme_choice(const PanelContext& context) {
  for (const Theme& theme : theme_catalog()) {
    const float width = ImGui::GetFrameHeightWithSpacing() + ImGui::CalcTextSize(theme.name.data()).x;
    if (&theme != theme_catalog().data()) same_line_if_room(width);
    if (ImGui::RadioButton(theme.name.data(), context.session.appearance.theme == &theme)) {
      context.session.appearance.theme = &theme;
    }
  }
}

// In steps: a slider would run away from the pointer as the screen grows.
void draw_scale_choice(const char* id, double& scale, double least, double greatest) {
  constexpr double step = 0.25;
  ImGui::PushID(id);
  const auto button = [&](const char* words, double direction) {
    if (ImGui::Button(words, {ImGui::GetFrameHeight(), 0.0F})) {
      scale = std::clamp((std::round(scale / step) + direction) * step, least, greatest);
    }
  };
  button("−", -1.0);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fmt::format("{:3.0f} %", scale * 100.0).c_str());
  ImGui::SameLine();
  button("+", 1.0);
  ImGui::PopID();
}

}  // namespace

void draw_view_options(const PanelContext& context) {
  Session& session = context.session;
  Appearance& look = session.appearance;
  ImGui::Checkbox("ghost force", &session.options.ghost_forces);
  tooltip(Term::ghost_force);
  ImGui::SameLine();
  ImGui::Checkbox("prediction", &session.options.predictions);
  tooltip(Term::prediction);
  ImGui::SameLine();
  ImGui::Checkbox("trails", &session.options.trails);
  tooltip(Term::trail);
  if (!begin_rows("view", context)) return;
  row("Theme", fmt::format("Light, dark, or black on white for a projector. {} switches to the next one.",
                           front_keys().next_theme.shown));
  draw_theme_choice(context);
  row("Text size", front_keys().text_size_sentence);
  draw_scale_choice("size", look.scale, Appearance::least_scale, Appearance::greatest_scale);
  row("Arrows", "The length of the force arrows, 25 to 400 %. The scale bar shows how long a force is drawn.");
  draw_scale_choice("arrows", look.arrow_scale, Appearance::least_arrow_scale, Appearance::greatest_arrow_scale);
  row("Language", "The language of the stage and of lessons. The workbench is in English.");
  draw_language_choice(session);
  if (session.offers_speech) {
    row("Speech", "Reads the stage's sentence aloud when it changes. This needs the package speech-dispatcher.");
    ImGui::Checkbox("read aloud", &session.speaks);
    if (!session.speech_problem.empty()) {
      wrapped_text(fmt::format("{} To try again, switch it off and on.", session.speech_problem));
    }
  }
  row("Preferences", "What you have chosen in this panel, and more, is kept from one run to the next.");
  if (ImGui::Button("Reset all…")) session.dialog = Dialog::reset_preferences;
  end_rows();
}

void draw_reset_preferences(const PanelContext& context) {
  Session& session = context.session;
  const float width = std::min(32.0F * ImGui::GetFontSize(), 0.8F * ImGui::GetIO().DisplaySize.x);
  wrapped_text(
      "Everything that you have chosen about how ghostforce looks and starts goes back to what a new person sees: "
      "theme, sizes, view, plots, panels, speed, SpaceMouse, language, speech, hints, window. The scene and its "
      "settings stay as "
      "they are.",
      ImGui::GetCursorPosX() + width);
  if (ImGui::Button("Reset all")) {
    context.apply(ResetPreferences{});
    session.dialog = Dialog::none;
  }
  ImGui::SameLine();
  if (ImGui::Button("Cancel")) session.dialog = Dialog::none;
}

}  // namespace ghostforce
