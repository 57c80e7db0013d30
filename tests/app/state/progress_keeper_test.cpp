// Progress in lessons as several windows keep it in one file.
#include "app/state/lesson_progress.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/base/failure.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::progress_keeper_test {
namespace {

// A window: what has been done in it, and its keeper.
struct LearningWindow {
  LessonProgress progress;
  ProgressKeeper keeper{progress};

  void keep() { keeper.keep(progress); }
};

class KeptProgress : public testing::Test {
 protected:
  KeptProgress() { setenv("XDG_STATE_HOME", folder_.path().c_str(), 1); }

  static LessonProgress stored() {
    std::vector<std::string> remarks;
    LessonProgress progress = load_lesson_progress(remarks);
    EXPECT_TRUE(remarks.empty());
    return progress;
  }
  static LearningWindow opened() { return {.progress = stored()}; }
  std::string file() const { return folder_ / "ghostforce/lessons.toml"; }

  TemporaryFolder folder_;
};

TEST_F(KeptProgress, HasWhatWasDoneInEachWindow) {
  LearningWindow one = opened();
  LearningWindow other = opened();
  one.progress.lessons["ghost"] = {.farthest = 4, .right = {"press"}, .is_finished = true};
  one.keep();
  other.progress.lessons["ghost"] = {.farthest = 2, .right = {"gently"}};
  other.progress.lessons["why"].farthest = 1;
  other.keep();
  LessonProgress expected;
  expected.lessons["ghost"] = {.farthest = 4, .right = {"gently", "press"}, .is_finished = true};
  expected.lessons["why"].farthest = 1;
  EXPECT_EQ(stored(), expected);
  one.progress.lessons["cure"].farthest = 3;
  one.keep();
  expected.lessons["cure"].farthest = 3;
  EXPECT_EQ(stored(), expected);
}

TEST_F(KeptProgress, StaysForgotten) {
  LessonProgress before;
  before.lessons["ghost"] = {.farthest = 4, .right = {"press"}, .is_finished = true};
  before.lessons["why"].farthest = 2;
  save(before);
  LearningWindow one = opened();
  LearningWindow other = opened();
  one.progress = {};
  one.keep();
  EXPECT_EQ(stored(), LessonProgress{});
  one.progress.lessons["ghost"].farthest = 1;
  one.keep();
  EXPECT_EQ(stored(), one.progress);
  other.progress.lessons["cure"].farthest = 1;
  other.keep();
  LessonProgress expected = one.progress;
  expected.lessons["cure"].farthest = 1;
  EXPECT_EQ(stored(), expected) << "another window adds what is done in it, and nothing else";
}

// The motors were on: nothing could be stored between the two.
TEST_F(KeptProgress, IsForgottenAlsoWhereTheLessonHasBegunAnew) {
  LessonProgress before;
  before.lessons["ghost"].farthest = 4;
  save(before);
  LearningWindow window = opened();
  window.progress = {};
  window.progress.lessons["ghost"].farthest = 0;
  window.keep();
  EXPECT_EQ(stored(), window.progress);
}

TEST_F(KeptProgress, IsStoredWithTheNextChangeWhereItCouldNotBe) {
  LessonProgress before;
  before.lessons["ghost"].farthest = 4;
  save(before);
  LearningWindow window = opened();
  std::filesystem::rename(folder_ / "ghostforce", folder_ / "away");
  write_whole(folder_ / "ghostforce", "a file where the folder should be");
  window.progress = {};
  window.progress.lessons["why"].farthest = 1;
  EXPECT_THROW(window.keep(), Failure);
  EXPECT_NO_THROW(window.keep()) << "it is said once";
  std::filesystem::remove(folder_ / "ghostforce");
  std::filesystem::rename(folder_ / "away", folder_ / "ghostforce");
  window.progress.lessons["why"].farthest = 2;
  window.keep();
  EXPECT_EQ(stored(), window.progress) << "and what was to be forgotten is";
}

TEST_F(KeptProgress, IsWhatTheWindowKnowsWhereTheFileWasDamaged) {
  LessonProgress before;
  before.lessons["ghost"].farthest = 4;
  save(before);
  LearningWindow window = opened();
  write_whole(file(), "[lesson.ghost");
  window.progress.lessons["why"].farthest = 1;
  window.keep();
  EXPECT_EQ(stored(), window.progress);
  EXPECT_TRUE(std::filesystem::exists(file() + ".damaged"));
}

}  // namespace
}  // namespace ghostforce::progress_keeper_test
