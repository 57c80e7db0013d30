// The pieces of which stage_controls.h makes its tree. Values; UI thread. Pure, but for the names of files, which a
// saving button looks for when it is pressed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/stage/stage.h"
#include "app/stage/stage_control.h"
#include "app/state/session.h"
#include "app/state/stage_language.h"

namespace ghostforce {

// What the pieces are made from.
struct ControlSource {
  const Session& session;
  const LoopReading& loop;
  const StageReading& reading;
  const StageLanguage& language;
};

using ControlParts = std::vector<StageControl>;

StageControl text_control(std::string id, StageControlKind kind, std::string words);
StageControl group_control(std::string id, StageControlKind kind, std::string_view words, ControlParts parts);
// Why it cannot be pressed now is asked of permit.h.
StageControl button_control(const ControlSource& source, std::string id, std::string words, const Action& action);

struct ControlRange {
  double value = 0.0;
  double least = 0.0;
  double greatest = 1.0;
  double step = 1.0;
};
// Can be moved where the Actions that its value leads to are permitted.
StageControl range_control(const ControlSource& source, std::string id, std::string_view words, std::string about,
                           const ControlRange& range, StageControl::Act act);

// "hand: 12.0 mm deep in the wall, 3.0 mm along it".
std::string hand_words(const ControlSource& source);

// Hand and guess, each as a depth and as a place along the wall.
void add_hand_controls(const ControlSource& source, ControlParts& parts);
void add_guess_controls(const ControlSource& source, ControlParts& parts);

// Title, place, answers, slider, task and the ways on. Only in a lesson.
StageControl lesson_control(const ControlSource& source);
// Lists of all that there is, folded: the lessons that come with the program, keys, actions.
StageControl lesson_list(const ControlSource& source);
StageControl key_list(const ControlSource& source);
StageControl action_list(const ControlSource& source);

// What the dialog that is open shows and can do, and its way out. Nothing where none is open.
void add_dialog(const ControlSource& source, ControlParts& parts);

}  // namespace ghostforce
