#include "app/cli/picture_options.h"
#include "app/cli/option.h"

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"

namespace ghostforce {

void PictureOptions::attach(CLI::App& command, bool with_all) {
  std::vector<std::string_view> strategies = names_of(strategy_catalog());
  if (with_all) strategies.push_back(every_strategy);
  add_option(command, "--strategy NAME", strategy,
             with_all ? "full, naive or anisotropic alone, or all in one picture; default: the scene's own"
                      : "full, naive or anisotropic: the strategy to start with; default: the scene's own")
      ->check(one_of(strategies));
  add_option(command, "--view FACE", view,
             with_all
                 ? "stage, what the window opens with, or workbench, with panels and numbers; default: workbench, and "
                   "stage for a scene of format 2"
                 : "stage or workbench; default: the one used last, at first the stage")
      ->check(one_of(names_of(face_catalog)));
  add_option(command, "--mode NAME", mode,
             "A mode of the stage: predict, why, landscape, round, ribbon or measure; default: none")
      ->check(one_of(names_of(stage_mode_catalog())));
  add_option(command, "--theme NAME", theme, "light, dark or projector; default: light")
      ->check(one_of(names_of(theme_catalog())));
  add_option(command, "--scale FACTOR", scale, "Size of text and lines, 0.75 to 3; default: 1")
      ->check(number_between(Appearance::least_scale, Appearance::greatest_scale, ""));
}

Face PictureOptions::face_or(Face usual) const {
  if (mode.empty()) return find_face(view).value_or(usual);
  if (view == face_name(Face::workbench)) {
    throw Failure(ExitCode::wrong_call,
                  fmt::format("--mode {} belongs to the stage; leave out --view workbench", mode));
  }
  return Face::stage;
}

StageMode PictureOptions::stage_mode() const {
  return find_stage_mode(mode).value_or(StageMode::none);
}

void PictureOptions::apply_strategy(Scene& scene) const {
  if (const auto id = find_strategy(strategy)) scene.settings.active = *id;
}

void PictureOptions::apply_appearance(Appearance& appearance) const {
  if (!theme.empty()) appearance.theme = find_theme(theme);
  if (scale) appearance.scale = *scale;
}

void attach_renderer(CLI::App& command, std::optional<Renderer>& renderer) {
  std::string words = "What draws";
  const char* separator = ": ";
  for (const RendererEntry& entry : renderer_catalog()) {
    words += fmt::format("{}{}, {}", separator, entry.name, entry.sentence);
    separator = "; ";
  }
  command
      .add_option_function<std::string>(
          "--renderer", [&renderer](const std::string& name) { renderer = find_renderer(name); },
          words + "; default: egl, or osmesa where it is missing")
      ->type_name("NAME")
      ->check(one_of(names_of(renderer_catalog())));
}

void SetUpOptions::attach(CLI::App& command, FileOptions& files) {
  scene.attach(command, files, false);
  add_option(command, "--goal-mm X,Y", goal_mm,
             "Where your hand starts, at rest, in mm; default: the scene's last waypoint");
  picture.attach(command, false);
}

SetUp SetUpOptions::set_up(Scene loaded, Face usual) const {
  picture.apply_strategy(loaded);
  if (goal_mm) loaded.goal.points.back() = position_from_mm("--goal-mm", *goal_mm);
  const Vector<2> goal = loaded.goal.points.back();
  return {std::move(loaded), goal, picture.face_or(usual), picture.stage_mode()};
}

}  // namespace ghostforce
