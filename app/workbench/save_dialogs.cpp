// The dialogs that end with a file: a picture of the screen, the last seconds of the stage, what the plots show,
// the scene.
#include <array>
#include <span>
#include <string>

#include <fmt/format.h>

#include "app/files/file_exchange.h"
#include "app/files/video_encoder.h"
#include "app/state/front_keys.h"
#include "app/state/proposed_path.h"
#include "app/state/session.h"
#include "app/widgets/controls.h"
#include "app/workbench/dialogs.h"
#include "app/workbench/save_path.h"

namespace ghostforce {
namespace {

constexpr std::array picture_formats{"png", "svg", "pdf"};
constexpr std::array all_clip_formats{"png", "mp4", "webm"};  // the last two are videos
constexpr std::array clip_lengths{2, 5, 10, 30, 60};          // [s]
constexpr std::array plot_formats{"csv", "png", "svg", "pdf"};

// A program that paints no files has the first one only.
std::span<const char* const> offered(std::span<const char* const> formats) {
  return save_place().paints_files ? formats : formats.first(1);
}

void draw_density_choice(Form& form) {
  for (int density = 1; density <= 4; ++density) {
    if (density > 1) ImGui::SameLine();
    if (ImGui::RadioButton(fmt::format("{}×", density).c_str(), form.density == density)) form.density = density;
  }
}

// True when the file shall be written. A name without one of the endings gets the first of them.
bool draw_save_path_with(std::span<const char* const> formats, const PanelContext& context) {
  if (!draw_save_path(context)) return false;
  std::string& path = context.memory.form.path;
  if (format_of(path, formats) == nullptr) path += fmt::format(".{}", formats.front());
  return true;
}

}  // namespace

void draw_save_picture(const PanelContext& context) {
  Form& form = context.memory.form;
  if (form.belongs_to != Dialog::save_picture) form.path = proposed_path(context.session, Dialog::save_picture);
  const std::span<const char* const> formats = offered(picture_formats);
  const char* const format = format_of(form.path, formats);
  const bool is_png = format == nullptr || format == picture_formats.front();
  if (begin_rows("picture", context)) {
    if (formats.size() > 1) {
      row("Format", "PNG: pixels, as on the screen. SVG and PDF: sharp at any size, for papers and slides.");
      draw_format_choice(form.path, formats);
    }
    ImGui::BeginDisabled(!is_png);
    row("Size", "How many pixels the picture has for each pixel of the screen.");
    draw_density_choice(form);
    row("Part", formats.size() > 1
                    ? "The whole window, or the scene without bars and panels. SVG and PDF contain only the scene."
                    : "The whole window, or the scene without bars and panels.");
    if (ImGui::RadioButton("window", is_png && !form.scene_alone)) form.scene_alone = false;
    ImGui::SameLine();
    if (ImGui::RadioButton("scene", !is_png || form.scene_alone)) form.scene_alone = true;
    ImGui::EndDisabled();
    end_rows();
  }
  const bool shall_save = draw_save_path_with(formats, context);
  ImGui::SameLine();
  ImGui::BeginDisabled(!is_png);
  if (ImGui::Button("Copy to clipboard")) {
    context.apply(CopyPicture{form.density, form.scene_alone});
    context.apply(CloseDialog{});
  }
  ImGui::EndDisabled();
  tooltip(fmt::format("The picture as PNG, for other programs to paste. {}.", front_keys().copy_picture.shown));
  if (save_place().paints_files) {
    ImGui::SameLine();
    if (ImGui::Button("Clip…")) context.apply(OpenDialog{Dialog::save_clip});
    tooltip("The last seconds of the stage, as a moving picture.");
  }
  if (!shall_save) return;
  context.apply(SavePicture{form.path, form.density, form.scene_alone});
  context.apply(CloseDialog{});
}

void draw_save_clip(const PanelContext& context) {
  const std::span<const char* const> clip_formats(all_clip_formats.data(),
                                                  can_make_videos() ? all_clip_formats.size() : 1);
  Form& form = context.memory.form;
  if (form.belongs_to != Dialog::save_clip) {
    form.path = proposed_path(context.session, Dialog::save_clip);
    form.clip_end_s = context.snapshot.time_s;
  }
  if (begin_rows("clip", context)) {
    row("Format",
        can_make_videos()
            ? "PNG: an animated PNG, for web pages and slides. MP4 and WebM: videos, made by ffmpeg if it is installed."
            : "An animated PNG, for web pages and slides.");
    draw_format_choice(form.path, clip_formats);
    row("Last", "How much of what the stage has shown, up to the moment when this form was opened.");
    for (const int seconds : clip_lengths) {
      if (seconds != clip_lengths.front()) ImGui::SameLine();
      if (ImGui::RadioButton(fmt::format("{} s", seconds).c_str(), form.clip_seconds == seconds)) {
        form.clip_seconds = seconds;
      }
    }
    end_rows();
  }
  if (!draw_save_path_with(clip_formats, context)) return;
  context.apply(
      SaveClip{.path = form.path, .seconds = static_cast<double>(form.clip_seconds), .end_s = form.clip_end_s});
  context.apply(CloseDialog{});
}

void draw_save_plots(const PanelContext& context) {
  const Session& session = context.session;
  Form& form = context.memory.form;
  if (form.belongs_to != Dialog::save_plots) form.path = proposed_path(session, Dialog::save_plots);
  const std::span<const char* const> formats = offered(plot_formats);
  if (begin_rows("plots", context)) {
    if (formats.size() > 1) {
      row("Format", "CSV: the numbers, for a spreadsheet or a script. PNG, SVG and PDF: the picture.");
      draw_format_choice(form.path, formats);
    }
    ImGui::BeginDisabled(!is_over_time(session.plots.tab));
    row("Times", "The times shown, or all that the plots keep: one minute at 1000 ticks a second.");
    if (ImGui::RadioButton("shown", !form.whole_history)) form.whole_history = false;
    ImGui::SameLine();
    if (ImGui::RadioButton("all", form.whole_history)) form.whole_history = true;
    ImGui::EndDisabled();
    end_rows();
  }
  if (!draw_save_path_with(formats, context)) return;
  context.apply(SavePlots{form.path, form.whole_history});
  context.apply(CloseDialog{});
}

void draw_save_scene(const PanelContext& context) {
  Form& form = context.memory.form;
  if (form.belongs_to != Dialog::save_scene) form.path = proposed_path(context.session, Dialog::save_scene);
  ImGui::TextUnformatted("The scene with its current settings, and a path that ends at the goal:");
  if (!draw_save_path(context)) return;
  context.apply(SaveScene{form.path});
  context.apply(CloseDialog{});
}

}  // namespace ghostforce
