// Options that the window and the pictures share: which strategy, which theme, how large.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "app/theme.h"
#include "app/view/compose.h"
#include "core/scene.h"

namespace ghostforce {

struct PictureOptions {
  std::string strategy;  // empty: the scene's
  std::string theme = "light";
  double scale = 1.0;

  // `with_all`: "all" shows every strategy in one picture.
  void attach(CLI::App& subcommand, bool with_all);
  void apply_strategy(Scene& scene) const;
  // All in one picture only where all were asked for.
  Compare compare() const;
  const Theme& chosen_theme() const;
};

}  // namespace ghostforce
