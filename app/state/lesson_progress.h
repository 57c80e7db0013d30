// What a person has done of each lesson, kept from one run to the next in lessons.toml of the state's folder
// (app/files/xdg_folders.h); ProgressKeeper keeps that file up to date. Not for the servo thread.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/state/lesson.h"
#include "app/state/stage_language.h"

namespace ghostforce {

struct LessonRecord {
  std::size_t farthest = 0;     // step that was ever shown, from 0; the lesson may have fewer by now
  std::set<std::string> right;  // names of steps that were answered right at the first try
  bool is_finished = false;     // the person went on from the last step

  friend bool operator==(const LessonRecord&, const LessonRecord&) = default;
};

struct LessonProgress {
  std::map<std::string, LessonRecord> lessons;  // by progress_key(); also of lessons that are not here at the moment

  friend bool operator==(const LessonProgress&, const LessonProgress&) = default;
};

// A shipped lesson's name, or the path of another: a lesson of one's own is another one, whatever it is called.
const std::string& progress_key(const Lesson& lesson) noexcept;

// What is known of a lesson, in words.
std::string progress_words(const Lesson& lesson, const LessonProgress& progress, const StageLanguage::Picker& words);

// Adds what `other` has of each lesson: nothing that was done is lost.
void merge(LessonProgress& into, const LessonProgress& other);

// Never throws for what is in the file: a damaged one is set aside, and then nothing has been done yet. `remarks` gets
// what the person should know of that.
LessonProgress load_lesson_progress(std::vector<std::string>& remarks);

// Whole or not at all. To reset it, save an empty one. Throws Failure(file_trouble).
void save(const LessonProgress& progress);

// Keeps what has been done of the lessons up to date in its file, beside other windows that do the same.
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
