// What the application makes pictures of: the screen as it is, and the last seconds of the stage.
#include <array>

#include "app/files/png_writer.h"
#include "app/shell/application.h"
#include "app/state/set_up.h"
#include "app/state/set_up_of.h"
#include "app/state/stage_action.h"
#include "app/state/stage_view.h"
#include "app/state/target.h"
#include "app/workbench/save_path.h"

namespace ghostforce {

void Application::restart_drawing() {
  screen_.restart_drawing();
  drawn_.reset();
}

void Application::copy_picture(const CopyPicture& request) {
  const DisplayKind display = window_.display_kind();
  const std::string png = png_bytes(screen_.picture(session_, shown(), history_, reading(),
                                                    request.scene_alone ? Part::scene : Part::window, request.density),
                                    picture_texts(set_up_of(session_, shown())));
  const std::string problem = clipboard_tool_.copy_png(png, display);
  if (!problem.empty()) return show_notice(problem, true);
  show_notice(std::string(notice_words().copied_picture), false, session_.language);
}

void Application::save_clip(const SaveClip& request) {
  const Scene& scene = *session_.scene;
  const double scale = session_.appearance.scale * static_cast<double>(window_.display_scale());
  const ShownMoment last = history_.moments().at(request.end_s).value_or(shown());
  clip_saving_.begin(request, scene, history_.moments(),
                     {.language = &stage_language(session_.language),
                      .keys = stage_keys(),
                      .theme = &shown_theme(session_),
                      .measure = painter_.measure,
                      .shown = session_.stage_shown,
                      .reference_force = reference_force_of(scene.settings, scene.goal.points.back()),
                      .size = screen_.scene_size(),
                      .scale = scale,
                      .target = target_of(session_, report_.motors)},
                     painter_, set_up_line(set_up_of(session_, last)));
  dismiss_notice();
  clip_saving_.poll(session_);  // says at once that it has begun
}

std::string Application::picture_bytes(const SavePicture& request) {
  constexpr std::array vectors{"svg", "pdf"};
  if (format_of(request.path, vectors) == nullptr) {
    return png_bytes(screen_.picture(session_, shown(), history_, reading(),
                                     request.scene_alone ? Part::scene : Part::window, request.density),
                     picture_texts(set_up_of(session_, shown())));
  }
  // As large as on this display, without the handles, which are for a pointer.
  const double scale = session_.appearance.scale * static_cast<double>(window_.display_scale());
  const Theme& theme = shown_theme(session_);
  const ShownMoment moment = shown();
  const std::vector<Pane> panes = screen_.panes_for_file(session_, moment, history_, reading(), painter_.measure);
  return painter_.paint({.panes = panes,
                         .theme = theme,
                         .size = screen_.scene_size(),
                         .text_scale = text_scale_of(session_.face, scale, theme),
                         .title = picture_title(session_.scene->title, set_up_of(session_, moment))},
                        request.path);
}

}  // namespace ghostforce
