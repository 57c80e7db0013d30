// Keeps what has been done of the lessons up to date in its file, beside other windows that do the same. Not for the
// servo thread.
#pragma once

#include "app/state/lesson_progress.h"

namespace ghostforce {

class ProgressKeeper {
 public:
  // `progress`: as it is stored.
  explicit ProgressKeeper(LessonProgress progress);

  // Adds what has been done since the last call to what is stored by now. If something is missing that was there, the
  // person wanted it to be forgotten: then nothing else stays stored. Throws Failure(file_trouble) where it cannot be
  // stored: once, and then it is stored with the next change.
  void keep(const LessonProgress& progress);

 private:
  LessonProgress kept_;
  LessonProgress unsaved_;
  bool forgets_ = false;  // what is stored
};

}  // namespace ghostforce
