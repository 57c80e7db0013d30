// A file that the program keeps for itself: what comes back, what is set aside, and what is never overwritten. The
// preferences' own tests go through more kinds of damage (tests/app/shell/preferences_test.cpp).
#include "app/files/kept_file.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "app/base/failure.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::kept_file_test {
namespace {

class KeptFileTest : public testing::Test {
 protected:
  // What stands in the file under the key `score`; empty where the file cannot be used.
  std::optional<double> score() {
    double number = 0.0;
    const auto read = [&](TomlReader& reader) {
      reader.read_values(std::array{TomlKey{"", "score", number_into(number, {.least = 0.0, .greatest = 10.0})}});
    };
    return load(file_, read, remarks_) ? std::optional(number) : std::nullopt;
  }

  TemporaryFolder folder_;
  KeptFile file_{.path = folder_ / "a/b/progress.toml",
                 .contents = "the progress is",
                 .comment = "how far one is.",
                 .without = "all lessons begin anew"};
  std::vector<std::string> remarks_;
  const std::string beginning_ = "# Written by ghostforce: how far one is.\nformat = 1\n";
};

TEST_F(KeptFileTest, ComesBackAsItWasSaved) {
  EXPECT_FALSE(score());
  save(file_, "score = 3\n");
  EXPECT_EQ(score(), 3.0);
  save(file_, "score = 4\n");
  EXPECT_EQ(score(), 4.0);
  EXPECT_TRUE(remarks_.empty());
}

TEST_F(KeptFileTest, KeepsWhatStandsUnderOtherKeys) {
  constexpr std::array<std::string_view, 1> keys{"score"};
  save(file_, "score = 3\nrank = 7\n[more]\nx = 1\n");
  save(file_, "score = 4\n", keys);
  EXPECT_EQ(read_whole(file_.path), beginning_ + "score = 4\nrank = 7\n\n[more]\nx = 1\n");
  save(file_, "score = 5\n");
  EXPECT_EQ(read_whole(file_.path), beginning_ + "score = 5\n");
}

TEST_F(KeptFileTest, IsLeftAsItIsWhenItsFormatIsNewer) {
  save(file_, "score = 3\n");
  const std::string newer = "format = 2\nscore = \"three\"\n";
  std::ofstream(file_.path) << newer;
  EXPECT_FALSE(score());
  ASSERT_EQ(remarks_.size(), 1U);
  EXPECT_NE(remarks_.front().find("was written by a newer version of ghostforce, so all lessons begin anew"),
            std::string::npos)
      << remarks_.front();
  try {
    save(file_, "score = 4\n");
    ADD_FAILURE() << "it was overwritten";
  } catch (const Failure& failure) {
    EXPECT_NE(std::string_view(failure.what()).find("move it away"), std::string_view::npos) << failure.what();
  }
  EXPECT_EQ(read_whole(file_.path), newer);
}

TEST_F(KeptFileTest, IsForgotten) {
  forget(file_);
  save(file_, "score = 3\n");
  forget(file_);
  EXPECT_FALSE(std::filesystem::exists(file_.path));
  EXPECT_FALSE(score());
  EXPECT_TRUE(remarks_.empty());
  std::filesystem::create_directories(file_.path / "full");
  EXPECT_THROW(forget(file_), Failure);
}

TEST_F(KeptFileTest, IsNowhereWithoutAHome) {
  file_.path.clear();
  forget(file_);
  save(file_, "score = 3\n");
  EXPECT_FALSE(score());
  EXPECT_TRUE(remarks_.empty());
}

TEST_F(KeptFileTest, IsSetAsideWhenDamagedAndSaysWhatFollows) {
  for (const char* aside : {"a/b/progress.toml.damaged", "a/b/progress.toml.damaged-2"}) {
    save(file_, "score = 11\n");
    EXPECT_FALSE(score());
    EXPECT_EQ(read_whole(folder_ / aside), beginning_ + "score = 11\n");
    ASSERT_EQ(remarks_.size(), 1U);
    EXPECT_NE(remarks_[0].find("progress.toml was damaged (line 3: the key score: 11 is out of range; give 0 to 10)"),
              std::string::npos)
        << remarks_[0];
    EXPECT_TRUE(remarks_[0].ends_with("; all lessons begin anew")) << remarks_[0];
    remarks_.clear();
  }
}

TEST_F(KeptFileTest, IsNotOverwrittenWhereSomethingElseIs) {
  std::filesystem::create_directories(folder_ / "a/b/progress.toml");
  EXPECT_FALSE(score());
  ASSERT_EQ(remarks_.size(), 1U);
  EXPECT_TRUE(remarks_[0].ends_with(" is not a file, so all lessons begin anew")) << remarks_[0];
  try {
    save(file_, "score = 3\n");
    FAIL() << "a folder was overwritten";
  } catch (const Failure& failure) {
    EXPECT_NE(std::string(failure.what()).find("is a folder, and the progress is kept in a file of this name"),
              std::string::npos)
        << failure.what();
  }
}

}  // namespace
}  // namespace ghostforce::kept_file_test
