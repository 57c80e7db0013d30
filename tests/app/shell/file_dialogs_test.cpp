// Files that a person chooses in the desktop's own dialogs, where it has some.
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "app/files/file_exchange.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/places.h"

namespace ghostforce::file_dialogs_test {
namespace {

class FakeChooser final : public FileChooser {
 public:
  FakeChooser() { use_file_chooser(this); }
  ~FakeChooser() override { use_file_chooser(nullptr); }

  bool is_there() const noexcept override { return there; }
  void ask(const FileQuestion& question) override { asked = question; }
  bool has_answer() const noexcept override { return answer.has_value(); }
  FileAnswer take_answer() override { return *std::exchange(answer, {}); }

  void choose(const std::string& path) { answer = FileAnswer{.question = *asked, .paths = {path}}; }

  bool there = true;
  std::optional<FileQuestion> asked;
  std::optional<FileAnswer> answer;
};

class FileDialogsTest : public DrivenWindow {
 protected:
  void show(Dialog dialog) {
    act(OpenDialog{dialog});
    frames(4);
  }

  FakeChooser chooser_;
};

TEST_F(FileDialogsTest, AreOfferedWhereTheyAre) {
  chooser_.there = false;
  show(Dialog::save_scene);
  EXPECT_FALSE(place_of("Browse…"));
  chooser_.there = true;
  frames(3);
  EXPECT_TRUE(place_of("Browse…"));
}

TEST_F(FileDialogsTest, APlaceFillsTheFieldAndSavesNothingYet) {
  show(Dialog::save_scene);
  const std::string proposed = session().form.path;
  click_on_words("Browse…");
  ASSERT_TRUE(chooser_.asked);
  EXPECT_EQ(chooser_.asked->new_file, proposed);
  chooser_.choose("/tmp/elsewhere.toml");
  EXPECT_TRUE(application_->needs_drawing());
  frames(2);
  EXPECT_EQ(session().form.path, "/tmp/elsewhere.toml");
  EXPECT_EQ(session().dialog, Dialog::save_scene);
}

TEST_F(FileDialogsTest, WhoCancelsKeepsThePath) {
  show(Dialog::save_scene);
  const std::string proposed = session().form.path;
  click_on_words("Browse…");
  chooser_.answer = FileAnswer{.question = *chooser_.asked};
  frames(2);
  EXPECT_EQ(session().form.path, proposed);
  EXPECT_FALSE(session().notice);
}

TEST_F(FileDialogsTest, APlaceForAFormThatWasClosedIsForgotten) {
  show(Dialog::save_scene);
  click_on_words("Browse…");
  act(CloseDialog{});
  frames(3);
  show(Dialog::save_picture);
  const std::string proposed = session().form.path;
  chooser_.choose("/tmp/elsewhere.toml");
  frames(2);
  EXPECT_EQ(session().form.path, proposed);
}

TEST_F(FileDialogsTest, AFileIsOpened) {
  show(Dialog::open_scene);
  click_on_words("Open a file…");
  ASSERT_TRUE(chooser_.asked);
  EXPECT_FALSE(chooser_.asked->new_file);
  chooser_.choose(source_path("/assets/scenes/fig1.toml"));
  frames(3);
  EXPECT_EQ(session().scene->title, load_scene("fig1").title);
  EXPECT_EQ(session().dialog, Dialog::none);
}

TEST_F(FileDialogsTest, AProblemIsTold) {
  show(Dialog::open_scene);
  click_on_words("Open a file…");
  chooser_.answer = FileAnswer{.question = *chooser_.asked, .problem = "It has failed."};
  frames(2);
  EXPECT_EQ(notice(), "It has failed.");
}

}  // namespace
}  // namespace ghostforce::file_dialogs_test
