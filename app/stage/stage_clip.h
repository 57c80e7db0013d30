// StageClip: the stage over a time that is past, picture by picture, for a file: what was the hand's, the wall's and
// the motors' at each moment, under the settings and the strategy of that moment, and the change from one strategy to
// the next as the stage shows it. The view stands still, no mode is on, and nobody can take hold of anything. Any
// one thread.
#pragma once

#include <optional>

#include "app/picture/label_placer.h"
#include "app/picture/panes.h"
#include "app/picture/theme.h"
#include "app/picture/view.h"
#include "app/stage/stage_places.h"
#include "app/stage/stage_transition.h"
#include "app/state/stage_language.h"
#include "core/scene.h"

namespace ghostforce {

struct ClipMoment {
  Settings settings;
  Snapshot snapshot;
};

struct StageClipLook {
  const StageLanguage* language;  // of the catalog, as the theme
  StageKeys keys;
  const Theme* theme;
  MeasureText measure;
  SceneView shown;
  double reference_force = 1.0;       // whose arrow has the usual length [N]
  Vector<2> size{1.0};                // of the picture [points]
  double scale = 1.0;                 // UI scale
  std::optional<Vector<2>> target{};  // that the hand at a device was told to press at [m]
};

class StageClip {
 public:
  explicit StageClip(StageClipLook look) : look_(std::move(look)) {}

  // The next picture; `interval_s`: since the one before.
  Pane next(const ClipMoment& moment, double interval_s);

 private:
  StageClipLook look_;
  LabelMemory memory_;
  std::optional<StageTransition> transition_;  // empty: before the first picture
};

}  // namespace ghostforce
