// A set-up as one line that a person can paste into a terminal, a mail or a lesson:
//
//   ghostforce run wall45 --set wall.normal_deg=120.0 --goal-mm=25,-10 --strategy naive --view stage --mode why
//
// It names the shipped scene that is nearest, and only what differs from it; the scene's title and about are not part of
// it. The face is always named, since `ghostforce run` alone opens the one that was used last. Not for the servo thread.
#pragma once

#include <string>
#include <string_view>

#include "app/state/set_up.h"

namespace ghostforce {

// The scene must be one that a file can hold: see rounded_to_file(). Reading the line gives the same set-up, bit for bit.
// Where the path does not end at the goal, the line moves its end there. Words are quoted for a POSIX shell.
std::string set_up_line(const SetUp& set_up);

// The words "ghostforce" and "run" at its beginning, a shell's prompt before them, quotes round words and line breaks
// between them may be there or not. Options have the names and meanings of `ghostforce run`; what a set-up does not hold
// is refused, and so are scenes that do not come with the program. Without --view: the stage. Throws ReadError(wrong),
// with the nearest word for what is unknown.
SetUp read_set_up_line(std::string_view line);

}  // namespace ghostforce
