// SetUp: what stands on the screen and can be handed on: a scene with its settings, where the hand is, which face and
// which mode show it. One line of text holds it all: lessons are made of such lines, pictures carry them, and people
// send them to each other. A value; to write and to read it allocates: not for the servo thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/state/faces_and_modes.h"
#include "core/scene.h"

namespace ghostforce {

// The path of the scene ends where the hand is, as `run --goal-mm` and a saved scene have it: a reset brings the hand
// back to that place.
struct SetUp {
  Scene scene;          // as a file would hold it, with the active strategy; its path ends at `goal`
  Vector<2> goal{0.0};  // where the hand of a person is [m]
  Face face = Face::stage;
  StageMode mode = StageMode::none;  // of the stage; on the workbench none
};

// A set-up as one line that a person can paste into a terminal, a mail or a lesson:
//
//   ghostforce run wall45 --set wall.normal_deg=120.0 --goal-mm=25,-10 --strategy naive --view stage --mode why
//
// It names the shipped scene that is nearest, and only what differs from it; the scene's title and about are not part
// of it. The face is always named, since `ghostforce run` alone opens the one that was used last.
//
// The scene must be one that a file can hold: see rounded_to_file(). Reading the line gives the same set-up, bit for
// bit. Where the path does not end at the goal, the line moves its end there. Words are quoted for a POSIX shell.
std::string set_up_line(const SetUp& set_up);

// The set-up of such a line. The words "ghostforce" and "run" at its beginning, a shell's prompt before them, quotes
// round words and line breaks between them may be there or not. Options have the names and meanings of `ghostforce
// run`; what a set-up does not hold is refused, and so are scenes that do not come with the program. Without --view:
// the stage. Throws ReadError(wrong), with the nearest word for what is unknown.
SetUp read_set_up_line(std::string_view line);

// A position [m] as people type it: "25,-10", in mm. Empty: it is not one that a scene may hold.
std::optional<Vector<2>> read_position_mm(std::string_view text);

// "TEXT: not a position; give …, as in OPTION=-10,5"
std::string no_position_words(std::string_view option, std::string_view text);

// A position [m] as such a text. It reads back bit for bit where it came from a file or from rounded_to_file().
std::string position_mm_text(const Vector<2>& position);

}  // namespace ghostforce
