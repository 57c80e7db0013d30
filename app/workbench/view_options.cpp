// What of the scene is drawn, and how the screen looks.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/state/front_keys.h"
#include "app/state/stage_language.h"
#include "app/widgets/controls.h"
#include "app/workbench/dialogs.h"
#include "app/workbench/panel_catalog.h"

namespace ghostforce {
namespace {

void draw_theme_choice(const PanelContext& context) {
  for (const Theme& theme : theme_catalog()) {
    const float width = ImGui::GetFrameHeightWithSpacing() + ImGui::CalcTextSize(theme.name.data()).x;
    if (&theme != theme_catalog().data()) same_line_if_room(width);
    Appearance look = context.session.appearance;
    if (!ImGui::RadioButton(theme.name.data(), look.theme == &theme)) continue;
    look.theme = &theme;
    context.apply(ChangeAppearance{look});
  }
}

// In steps: a slider would run away from the pointer as the screen grows.
void draw_scale_choice(const PanelContext& context, const char* id, double Appearance::*which, double least,
                       double greatest) {
  constexpr double step = 0.25;
  Appearance look = context.session.appearance;
  double& scale = look.*which;
  ImGui::PushID(id);
  const auto button = [&](const char* words, double direction) {
    if (ImGui::Button(words, {ImGui::GetFrameHeight(), 0.0F})) {
      scale = std::clamp((std::round(scale / step) + direction) * step, least, greatest);
      context.apply(ChangeAppearance{look});
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

void draw_motion_choice(const PanelContext& context) {
  struct Choice {
    ScreenMotion motion;
    const char* words;
  };
  constexpr std::array choices{Choice{ScreenMotion::as_system, "as the system"}, Choice{ScreenMotion::full, "full"},
                               Choice{ScreenMotion::reduced, "reduced"}};
  for (const Choice& choice : choices) {
    const float width = ImGui::GetFrameHeightWithSpacing() + ImGui::CalcTextSize(choice.words).x;
    if (&choice != choices.data()) same_line_if_room(width);
    if (ImGui::RadioButton(choice.words, context.session.motion == choice.motion)) {
      context.apply(ChangeMotion{choice.motion});
    }
  }
}

}  // namespace

void draw_view_options(const PanelContext& context) {
  const Session& session = context.session;
  const auto option = [&](const char* words, bool ViewOptions::*shown, Term term) {
    ViewOptions options = session.options;
    if (ImGui::Checkbox(words, &(options.*shown))) context.apply(ChangeViewOptions{options});
    tooltip(term);
  };
  option("ghost force", &ViewOptions::ghost_forces, Term::ghost_force);
  ImGui::SameLine();
  option("prediction", &ViewOptions::predictions, Term::prediction);
  ImGui::SameLine();
  option("trails", &ViewOptions::trails, Term::trail);
  if (!begin_rows("view", context)) return;
  row("Theme", fmt::format("Light, dark, or black on white for a projector. {} switches to the next one.",
                           front_keys().next_theme.shown));
  draw_theme_choice(context);
  row("Text size", front_keys().text_size_sentence);
  draw_scale_choice(context, "size", &Appearance::scale, Appearance::least_scale, Appearance::greatest_scale);
  row("Arrows", "The length of the force arrows, 25 to 400 %. The scale bar shows how long a force is drawn.");
  draw_scale_choice(context, "arrows", &Appearance::arrow_scale, Appearance::least_arrow_scale,
                    Appearance::greatest_arrow_scale);
  row("Motion",
      "Reduced: the stage changes at once, and shows nothing by itself while nobody does anything. The simulation goes "
      "on. As the system: what its settings say about animations.");
  draw_motion_choice(context);
  row("Language", "The language of the stage, of lessons and of Ctrl+P. The workbench is in English.");
  draw_language_choice(context);
  if (session.offers_audience) {
    row("Audience",
        "A second window with the stage alone, on the second monitor if there is one. What to say stands in this one.");
    bool has_audience = session.has_audience;
    if (ImGui::Checkbox("second window", &has_audience)) context.apply(ToggleAudience{});
  }
  if (session.offers_speech) {
    row("Speech", "Reads the stage's sentence aloud when it changes. This needs the package speech-dispatcher.");
    bool speaks = session.speaks;
    if (ImGui::Checkbox("read aloud", &speaks)) context.apply(SwitchSpeech{speaks});
    if (!session.speech_problem.empty()) {
      wrapped_text(fmt::format("{} To try again, switch it off and on.", session.speech_problem));
    }
  }
  row("Preferences", "What you have chosen in this panel, and more, is kept from one run to the next.");
  if (ImGui::Button("Reset all…")) context.apply(OpenDialog{Dialog::reset_preferences});
  end_rows();
}

void draw_language_choice(const PanelContext& context) {
  const StageLanguage& shown = stage_language(context.session.language);
  for (const StageLanguage* const language : stage_languages) {
    const float width = ImGui::GetFrameHeightWithSpacing() + ImGui::CalcTextSize(language->name.data()).x;
    if (language != stage_languages.front()) same_line_if_room(width);
    if (ImGui::RadioButton(language->name.data(), &shown == language)) {
      context.apply(ChooseLanguage{std::string(language->code)});
    }
  }
}

void draw_reset_preferences(const PanelContext& context) {
  const StageLanguage::Reset& said = stage_language(context.session.language).reset;
  const float width = std::min(32.0F * ImGui::GetFontSize(), 0.8F * ImGui::GetIO().DisplaySize.x);
  wrapped_text(said.about, ImGui::GetCursorPosX() + width);
  if (ImGui::Button(said.yes.data())) {
    context.apply(ResetPreferences{});
    context.apply(CloseDialog{});
  }
  ImGui::SameLine();
  if (ImGui::Button(said.no.data())) context.apply(CloseDialog{});
}

}  // namespace ghostforce
