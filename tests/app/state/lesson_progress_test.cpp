// Progress in lessons, from one run to the next.
#include "app/state/lesson_progress.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "app/base/failure.h"
#include "app/state/lesson_file.h"
#include "app/state/stage_language.h"
#include "tests/app/state/lesson_text.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::lesson_progress_test {
namespace {

class LessonProgressFile : public testing::Test {
 protected:
  LessonProgressFile() { setenv("XDG_STATE_HOME", folder_.path().c_str(), 1); }

  LessonProgress load() {
    remarks_.clear();
    return load_lesson_progress(remarks_);
  }
  std::string file() const { return folder_ / "ghostforce/lessons.toml"; }
  void write(std::string_view text) {
    std::filesystem::create_directories(folder_ / "ghostforce");
    write_whole(file(), text);
  }

  TemporaryFolder folder_;
  std::vector<std::string> remarks_;
};

TEST_F(LessonProgressFile, IsReadAsItWasSaved) {
  EXPECT_EQ(load(), LessonProgress{});
  LessonProgress progress;
  progress.lessons["ghost"] = {.farthest = 4, .right = {"press", "gently"}, .is_finished = false};
  progress.lessons["my own.lesson \"1\""] = {.farthest = 0, .right = {}, .is_finished = true};
  save(progress);
  EXPECT_EQ(load(), progress) << read_whole(file());
  EXPECT_TRUE(remarks_.empty());
  save(LessonProgress{});
  EXPECT_EQ(load(), LessonProgress{}) << "reset";
}

TEST_F(LessonProgressFile, TellsALessonOfOnesOwnFromAShippedOne) {
  write_whole(folder_ / "ghost.toml", small_lesson);
  const Lesson own = load_lesson(folder_ / "ghost.toml");
  EXPECT_EQ(own.name, "ghost");
  EXPECT_EQ(progress_key(own), folder_ / "ghost.toml");
  EXPECT_EQ(progress_key(load_lesson(folder_ / "./ghost.toml")), progress_key(own));
  EXPECT_EQ(progress_key(load_lesson("ghost")), "ghost");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder_.path());
  EXPECT_EQ(progress_key(load_lesson("ghost.toml")), progress_key(own));
  std::filesystem::current_path(before);
  write_whole(folder_ / "gh\xffst.toml", small_lesson);
  LessonProgress progress;
  progress.lessons[progress_key(load_lesson(folder_ / "gh\xffst.toml"))].farthest = 1;
  save(progress);
  EXPECT_EQ(load(), progress) << "whatever the file is called";
}

TEST_F(LessonProgressFile, LeavesAloneWhatANewerProgramWrote) {
  write(
      "version = 7\n[lesson.ghost]\nfarthest = 3\nstars = 5\n[lesson.unheard-of]\nfinished = true\n[picker]\nx = 1\n");
  const LessonProgress progress = load();
  EXPECT_TRUE(remarks_.empty());
  EXPECT_EQ(progress.lessons.at("ghost").farthest, 2U);
  EXPECT_TRUE(progress.lessons.at("unheard-of").is_finished) << "a lesson that is not here at the moment";
}

TEST_F(LessonProgressFile, IsSetAsideWhereItIsDamaged) {
  for (const std::string_view text : {"[lesson.ghost]\nfarthest = -1\n", "lesson = 4\n", "[lesson]\nghost = 1\n",
                                      "[lesson.ghost]\nright = [1]\n", "\xff\xfe", "[lesson.ghost"}) {
    write(text);
    EXPECT_EQ(load(), LessonProgress{}) << text;
    ASSERT_EQ(remarks_.size(), 1U) << text;
    EXPECT_NE(remarks_[0].find("no lesson counts as begun"), std::string::npos) << remarks_[0];
    EXPECT_FALSE(std::filesystem::exists(file())) << "it has another name now";
  }
  EXPECT_TRUE(std::filesystem::exists(file() + ".damaged"));
}

TEST_F(LessonProgressFile, IsWholeOrAsItWas) {
  LessonProgress progress;
  progress.lessons["ghost"].farthest = 1;
  save(progress);
  std::filesystem::remove_all(folder_ / "ghostforce");
  write_whole(folder_ / "ghostforce", "a file where the folder should be");
  EXPECT_THROW(save(progress), Failure);
}

TEST_F(LessonProgressFile, IsNowhereWithoutAHome) {
  unsetenv("XDG_STATE_HOME");
  unsetenv("HOME");
  EXPECT_NO_THROW(save(LessonProgress{}));
  EXPECT_EQ(load(), LessonProgress{});
}

TEST(LessonProgressWords, SayOfHowManyQuestionsOnlyAtTheEnd) {
  const Lesson lesson = load_lesson("an-arm");  // it asks four times
  const auto words = [&](const LessonRecord& record, std::string_view language) {
    LessonProgress progress;
    progress.lessons["an-arm"] = record;
    return progress_words(lesson, progress, stage_language(language).picker);
  };
  const std::set<std::string> right{"predict", "cure", "joint"};
  EXPECT_EQ(words({.farthest = 6, .right = right, .is_finished = false}, "en"), "7 of 8 steps seen · 3 right");
  EXPECT_EQ(words({.farthest = 7, .right = right, .is_finished = true}, "en"), "Done · 3 of 4 right");
  EXPECT_EQ(words({.farthest = 7, .right = right, .is_finished = true}, "es"), "Hecha · aciertos: 3 de 4");
  EXPECT_EQ(words({.farthest = 7, .right = {}, .is_finished = true}, "en"), "Done");
}

}  // namespace
}  // namespace ghostforce::lesson_progress_test
