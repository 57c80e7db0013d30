// Ctrl+P: what is on the screen, as pixels or as vectors.
#include <array>
#include <string>

#include <fmt/format.h>

#include "app/ui/panels/dialogs.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/save_path.h"

namespace ghostforce {
namespace {

constexpr std::array formats{"png", "svg", "pdf"};

void draw_density_choice(Form& form) {
  for (int density = 1; density <= 4; ++density) {
    if (density > 1) ImGui::SameLine();
    if (ImGui::RadioButton(fmt::format("{}×", density).c_str(), form.density == density)) form.density = density;
  }
}

}  // namespace

void draw_save_picture(const PanelContext& context) {
  Session& session = context.session;
  Form& form = session.form;
  if (form.belongs_to != Dialog::save_picture) {
    const std::string stem =
        fmt::format("{}-{}", file_stem(session.scene->title), strategy(session.settings.active).name);
    form.path = proposed_path(stem, formats.front());
  }
  const char* const format = format_of(form.path, formats);
  const bool is_png = format == nullptr || format == formats.front();
  if (begin_rows("picture", context)) {
    row("Format", "PNG: pixels, as on the screen. SVG and PDF: lines and letters of any size, for papers and slides.");
    draw_format_choice(form.path, formats);
    ImGui::BeginDisabled(!is_png);
    row("Size", "Pixels of the picture for each pixel of the screen.");
    draw_density_choice(form);
    row("Part", "The whole window, or the scene without bars and panels; SVG and PDF hold the scene.");
    if (ImGui::RadioButton("window", is_png && !form.scene_alone)) form.scene_alone = false;
    ImGui::SameLine();
    if (ImGui::RadioButton("scene", !is_png || form.scene_alone)) form.scene_alone = true;
    ImGui::EndDisabled();
    end_rows();
  }
  if (!draw_save_path(context)) return;
  // A name without one of the endings is a PNG's.
  if (format_of(form.path, formats) == nullptr) form.path += fmt::format(".{}", formats.front());
  session.wishes.save_picture = PictureWish{form.path, form.density, form.scene_alone};
  session.dialog = Dialog::none;
}

}  // namespace ghostforce
