// Ctrl+P: what is on the screen, as pixels or as vectors.
#include <array>
#include <string>

#include <fmt/format.h>

#include "app/panels/controls.h"
#include "app/panels/dialogs.h"
#include "app/panels/save_path.h"

namespace ghostforce {
namespace {

constexpr std::array formats{"png", "svg", "pdf"};

std::string_view extension_of(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  const std::size_t slash = path.rfind('/');
  if (dot == std::string_view::npos || (slash != std::string_view::npos && dot < slash)) return {};
  return path.substr(dot + 1);
}

void draw_format_choice(Form& form) {
  const std::string_view present = extension_of(form.path);
  for (const char* format : formats) {
    if (format != formats.front()) ImGui::SameLine();
    if (ImGui::RadioButton(format, present == format)) {
      form.path.resize(form.path.size() - (present.empty() ? 0 : present.size() + 1));
      form.path += fmt::format(".{}", format);
    }
  }
}

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
    const std::string stem = fmt::format("{}-{}", file_stem(session.scene->title), strategy(session.settings.active).name);
    form.path = proposed_path(stem, formats.front());
  }
  const bool is_png = extension_of(form.path) == formats.front();
  if (begin_rows("picture", context)) {
    row("Format", "PNG: pixels, as on the screen. SVG and PDF: lines and letters of any size, for papers and slides.");
    draw_format_choice(form);
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
  session.wishes.save_picture = PictureWish{form.path, form.density, form.scene_alone};
  session.dialog = Dialog::none;
}

}  // namespace ghostforce
