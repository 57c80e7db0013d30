// Options that the window and the pictures share: which strategy, which theme, how large.
#pragma once

#include <optional>
#include <string>

#include "app/session/session.h"
#include "core/scene.h"

namespace CLI {
class App;
}

namespace ghostforce {

struct PictureOptions {
  std::string strategy;  // empty: the scene's
  std::string theme;     // empty: what was used last, or the first of the catalog
  std::optional<double> scale;

  // `with_all`: "all" shows every strategy in one picture.
  void attach(CLI::App& command, bool with_all);
  void apply_strategy(Scene& scene) const;
  // What was not asked for stays as it is.
  void apply_appearance(Appearance& appearance) const;
};

}  // namespace ghostforce
