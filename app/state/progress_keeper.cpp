#include "app/state/progress_keeper.h"

#include <string>
#include <utility>
#include <vector>

namespace ghostforce {

ProgressKeeper::ProgressKeeper(LessonProgress progress) : kept_(std::move(progress)) {}

void ProgressKeeper::keep(const LessonProgress& progress) {
  if (progress == kept_) return;
  const LessonProgress before = std::exchange(kept_, progress);
  LessonProgress both = progress;
  merge(both, before);
  if (both != progress) {
    forgets_ = true;
    unsaved_ = progress;
  } else {
    for (const auto& [key, record] : progress.lessons) {
      const auto old = before.lessons.find(key);
      if (old == before.lessons.end() || old->second != record) unsaved_.lessons[key] = record;
    }
  }
  std::vector<std::string> problems;
  LessonProgress stored = forgets_ ? LessonProgress{} : load_lesson_progress(problems);
  // A file that has been damaged meanwhile is aside now, and what this window knows of it takes its place.
  merge(stored, problems.empty() ? unsaved_ : kept_);
  save(stored);
  unsaved_ = {};
  forgets_ = false;
}

}  // namespace ghostforce
