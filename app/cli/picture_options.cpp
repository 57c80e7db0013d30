#include "app/cli/picture_options.h"

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/console/quoted.h"

namespace ghostforce {

void PictureOptions::attach(CLI::App& command, bool with_all) {
  std::vector<std::string_view> strategies = names_of(strategy_catalog());
  if (with_all) strategies.push_back(every_strategy);
  command
      .add_option("--strategy", strategy,
                  with_all ? "full, naive or anisotropic alone, or all in one picture; default: the scene's own"
                           : "full, naive or anisotropic: the one to start with; default: the scene's own")
      ->type_name("NAME")
      ->check(one_of(strategies));
  command.add_option("--theme", theme, "light, dark or projector; default: light")
      ->type_name("NAME")
      ->check(one_of(names_of(theme_catalog())));
  command.add_option("--scale", scale, "Size of letters and lines, 0.75 to 3; default: 1")
      ->type_name("FACTOR")
      ->check(number_between(Appearance::least_scale, Appearance::greatest_scale, ""));
}

void PictureOptions::apply_strategy(Scene& scene) const {
  if (const auto id = find_strategy(strategy)) scene.settings.active = *id;
}

void PictureOptions::apply_appearance(Appearance& appearance) const {
  if (!theme.empty()) appearance.theme = find_theme(theme);
  if (scale) appearance.scale = *scale;
}

}  // namespace ghostforce
