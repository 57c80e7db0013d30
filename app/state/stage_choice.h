// StageChoice: what the person does on the stage. Part of the session.
#pragma once

#include <cstdint>
#include <optional>

#include "app/state/face.h"
#include "app/state/stage_mode.h"
#include "core/conventions.h"

namespace ghostforce {

struct StageChoice {
  StageMode mode = StageMode::none;
  bool switches_slowly = false;             // the strategy was chosen with Shift, or by a clicker's step
  std::optional<Vector<2>> guess{};         // of where the handle comes to rest, while predicting [m]
  bool guess_is_open = true;                // it can still be moved, and the answer is hidden
  std::uint32_t reveals_asked = 0;          // of the truth about the guess
  int why_step = 0;                         // 1 to 4, of Why?; 0: not begun
  std::optional<double> landscape_dial{};   // 0 naïve, 1 anisotropic, as it was dragged; empty: as the strategy has it
  std::optional<double> looks_back_to_s{};  // the moment of the last minute that is shown, model time; empty: now
  bool is_black = false;                    // the picture is hidden, as clickers do
  std::optional<int> demo_step{};           // of the talk that a clicker goes through; empty: not begun
};

}  // namespace ghostforce
