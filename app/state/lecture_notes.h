// What a lecturer reads in the first window while the audience has the second: what to say at the present step of the
// talk or of the lesson, and what comes next. Pure, any thread.
#pragma once

#include <string>

#include "app/state/session.h"

namespace ghostforce {

struct LectureNotes {
  std::string title;  // of the step, and how many there are
  std::string words;  // what to say; empty: what stands on the stage says it
  std::string next;
};

LectureNotes lecture_notes(const Session& session);

}  // namespace ghostforce
