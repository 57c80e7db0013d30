// The stage: one hand, one handle, one wall; the force as the wall's share and the ghost; two numbers, one true
// sentence, three buttons. From values to marks and to what can be pressed, and nothing else: it reads no clock, no
// device, no global, so the same input gives the same picture, in the window, in a PNG and in a test. Pure but for the
// memory of where labels stood, which is handed in.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/label_placer.h"
#include "app/picture/panes.h"
#include "app/stage/landscape_layout.h"
#include "app/stage/ribbon_layers.h"
#include "app/stage/stage_content.h"
#include "app/stage/stage_scene.h"

namespace ghostforce {

// The picture, and what of it a person can take hold of.
struct StagePicture {
  struct RibbonPlace {
    ScreenBox box;
    RibbonAxis axis;
  };
  Pane pane{};
  double unit = 1.0;  // a point of the design
  std::vector<StageButton> buttons{};
  ScreenBox scene{};                                      // where everything can be seen,
  std::optional<ScreenBox> numbers{};                     // but for below these,
  std::optional<ScreenBox> inset{};                       // and below the small picture of the device
  ScreenBox reach{};                                      // where a hand can be dragged to
  Vector<2> pivot{0.0};                                   // that the motor's rail turns about, see StageContent [m]
  std::optional<std::array<Vector<2>, 2>> motor_grips{};  // empty: it cannot be turned
  std::optional<std::array<Vector<2>, 2>> wall_grips{};   // empty: it cannot be turned
  std::vector<StagePart> parts{};                         // of a general scene, that can be moved
  std::optional<LandscapeLayout> landscape{};             // empty: there is no map
  std::optional<RibbonPlace> ribbon{};
  std::optional<ScreenBox> menu{};    // while it is open
  std::optional<ScreenBox> tools{};   // Fit and Reset
  std::optional<ScreenBox> motors{};  // which motors of a device push
};

// The same moment for those who do not look at it: what the stage says, its numbers, and what there is to press. Empty
// are also those numbers that the mode or the lesson hides. The sentence of an open question goes on with its answers.
struct StageReading {
  StrategyId strategy = StrategyId::naive;  // active, or on the way there
  std::string sentence{};
  StageNumbers numbers{};
  StageSecrets hides{};              // also what the mode asks for
  std::vector<std::string> steps{};  // of Why?, as far as they have been asked for
  std::optional<StageCornerButton> corner{};
  std::optional<StageMeasuringButton> measuring{};
  std::optional<StageLesson> lesson{};
  StageMoment moment{};
  Settings settings{};  // of that moment
};
StageReading stage_reading(const StageContent& content);

// `interval_s`: since the picture before, which `memory` is of.
StagePicture compose_stage(const StageContent& content, LabelMemory& memory, double interval_s, Marks earlier = {});

}  // namespace ghostforce
