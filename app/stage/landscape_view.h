// LandscapeView: all that is needed to draw one picture of the landscape. Values, read only; any thread.
#pragma once

#include "app/picture/camera.h"
#include "app/picture/theme.h"
#include "app/picture/view.h"
#include "app/stage/landscape_layout.h"
#include "app/state/stage_language.h"

namespace ghostforce {

struct LandscapeView {
  const Settings& settings;
  double dial;           // from 0, naïve, to 1: what anisotropic rendering runs with
  bool has_every_motor;  // then there is no ghost force anywhere, and no dial
  const StageLanguage& language;
  const Theme& theme;
  Camera camera;
  double scale;  // UI scale, 1 is normal
  const MeasureText& measure;
};

// Where things are, as add_landscape() draws them.
inline LandscapeLayout landscape_layout(const LandscapeView& view) noexcept {
  return landscape_layout(view.camera.size, view.scale * view.theme.thickness);
}

}  // namespace ghostforce
