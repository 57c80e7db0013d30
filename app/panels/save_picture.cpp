// Ctrl+P: what is on the screen, as pixels or as vectors.
#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "app/panels/controls.h"
#include "app/panels/dialogs.h"
#include "app/panels/save_path.h"

namespace ghostforce {
namespace {

constexpr std::array formats{"png", "svg", "pdf"};

bool has_extension(const std::string& path, std::string_view extension) {
  if (path.size() <= extension.size() || path[path.size() - extension.size() - 1] != '.') return false;
  return std::equal(extension.begin(), extension.end(), path.end() - static_cast<std::ptrdiff_t>(extension.size()),
                    [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

// Of the formats; null for any other ending.
const char* format_of(const std::string& path) {
  const auto found = std::ranges::find_if(formats, [&](const char* format) { return has_extension(path, format); });
  return found == formats.end() ? nullptr : *found;
}

void draw_format_choice(Form& form) {
  const char* const present = format_of(form.path);
  for (const char* const format : formats) {
    if (format != formats.front()) ImGui::SameLine();
    if (ImGui::RadioButton(format, present == format)) {
      if (present != nullptr) form.path.resize(form.path.size() - std::string_view(present).size() - 1);
      form.path += fmt::format(".{}", format);
      return;
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
    const std::string stem =
        fmt::format("{}-{}", file_stem(session.scene->title), strategy(session.settings.active).name);
    form.path = proposed_path(stem, formats.front());
  }
  const char* const format = format_of(form.path);
  const bool is_png = format == nullptr || format == formats.front();
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
  // A name without one of the endings is a PNG's.
  if (format_of(form.path) == nullptr) form.path += fmt::format(".{}", formats.front());
  session.wishes.save_picture = PictureWish{form.path, form.density, form.scene_alone};
  session.dialog = Dialog::none;
}

}  // namespace ghostforce
