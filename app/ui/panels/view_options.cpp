// What of the scene is drawn, and how the screen looks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/ui/panels/panel_catalog.h"
#include "app/ui/widgets/controls.h"

namespace ghostforce {
namespace {

void draw_theme_choice(const PanelContext& context) {
  for (const Theme& theme : theme_catalog()) {
    if (&theme != theme_catalog().data()) ImGui::SameLine();
    if (ImGui::RadioButton(theme.name.data(), context.session.look.theme == &theme)) {
      context.session.look.theme = &theme;
    }
  }
}

// In steps: a slider would run away from the pointer as the screen grows.
void draw_scale_choice(Look& look) {
  constexpr double step = 0.25;
  const auto button = [&](const char* words, double direction) {
    if (ImGui::Button(words, {ImGui::GetFrameHeight(), 0.0F})) {
      const double next = (std::round(look.scale / step) + direction) * step;
      look.scale = std::clamp(next, Look::least_scale, Look::greatest_scale);
    }
  };
  button("−", -1.0);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fmt::format("{:3.0f} %", look.scale * 100.0).c_str());
  ImGui::SameLine();
  button("+", 1.0);
}

}  // namespace

void draw_view_options(const PanelContext& context) {
  Session& session = context.session;
  ImGui::Checkbox("ghost", &session.options.ghost_forces);
  explain(Term::ghost_force);
  ImGui::SameLine();
  ImGui::Checkbox("prediction", &session.options.predictions);
  explain(Term::prediction);
  ImGui::SameLine();
  ImGui::Checkbox("trails", &session.options.trails);
  explain(Term::trail);
  if (!begin_rows("view", context)) return;
  row("Theme", "Light, dark, or black on white for a projector. Ctrl+T takes the next one.");
  draw_theme_choice(context);
  row("Size", "Of letters and lines, 75 to 300 %. Ctrl and + or − do it too, Ctrl+0 takes the usual size.");
  draw_scale_choice(session.look);
  end_rows();
}

}  // namespace ghostforce
