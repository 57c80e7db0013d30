// The desktop's dialogs for files, against a bus and a portal of the test's own.
#include "app/shell/desktop/portal_file_chooser.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "tests/support/becomes.h"
#include "tests/support/fake_portal.h"

namespace ghostforce::portal_file_chooser_test {
namespace {

using Paths = std::vector<std::string>;

class PortalTest : public testing::Test {
 protected:
  PortalTest() { setenv("DBUS_SESSION_BUS_ADDRESS", portal_.address().c_str(), 1); }

  bool comes_to(const std::function<bool()>& as_wanted) { return portal_.comes_to(as_wanted); }
  void begin() {
    chooser_.emplace("x11:1a");
    ASSERT_TRUE(comes_to([&] { return chooser_->is_there(); }));
  }
  // Until the portal has been asked.
  void ask(const FileQuestion& question = {}) {
    const std::size_t before = portal_.calls.size();
    chooser_->ask(question);
    ASSERT_TRUE(comes_to([&] { return portal_.calls.size() > before; }));
  }
  FileAnswer answer() {
    EXPECT_TRUE(comes_to([&] { return chooser_->has_answer(); }));
    EXPECT_TRUE(has_chosen_files());
    const FileAnswer given = take_chosen_files();
    EXPECT_FALSE(has_chosen_files()) << "it is given once";
    return given;
  }
  void expect_failure() {
    const FileAnswer given = answer();
    EXPECT_EQ(given.paths, Paths{});
    EXPECT_NE(given.problem.find("Type the path instead"), std::string::npos) << given.problem;
  }

  FakePortal portal_;
  std::optional<PortalFileChooser> chooser_;
};

TEST_F(PortalTest, GivesTheFileThatThePersonChooses) {
  EXPECT_FALSE(offers_file_chooser());
  begin();
  EXPECT_TRUE(offers_file_chooser());
  EXPECT_TRUE(offers_place_chooser());
  ask();
  const FakePortal::Call& call = portal_.calls.back();
  EXPECT_EQ(call.method, "OpenFile");
  EXPECT_EQ(call.parent, "x11:1a");
  EXPECT_FALSE(has_chosen_files());
  portal_.respond(0, {"file:///home/ana/una%20pared%C3%B1.toml"});
  const FileAnswer given = answer();
  EXPECT_EQ(given.paths, Paths{"/home/ana/una paredñ.toml"});
  EXPECT_FALSE(given.question.new_file);
  EXPECT_EQ(given.problem, "");
}

TEST_F(PortalTest, ProposesTheNameAndTheFolderOfANewFile) {
  begin();
  ask({.new_file = "/home/ana/my wall.toml"});
  const FakePortal::Call call = portal_.calls.back();
  EXPECT_EQ(call.method, "SaveFile");
  EXPECT_EQ(call.name, "my wall.toml");
  EXPECT_EQ(call.folder, std::string("/home/ana") + '\0');
  portal_.respond(0, {"file:///home/ana/other.toml"});
  const FileAnswer given = answer();
  EXPECT_EQ(given.paths, Paths{"/home/ana/other.toml"});
  EXPECT_EQ(given.question.new_file, "/home/ana/my wall.toml");
}

TEST_F(PortalTest, HearsAnAnswerThatComesBeforeTheCallIsAnswered) {
  begin();
  portal_.answer_at_once = {"file:///a.toml"};
  ask();
  EXPECT_EQ(answer().paths, Paths{"/a.toml"});
}

TEST_F(PortalTest, HearsAPortalThatGivesTheRequestAnotherPath) {
  begin();
  portal_.other_handle = "/org/freedesktop/portal/desktop/request/1";
  ask();
  EXPECT_FALSE(has_chosen_files());
  for (int step = 0; step < 20; ++step) {  // until the call has been answered
    portal_.step();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  portal_.respond(0, {"file:///a.toml"});
  EXPECT_EQ(answer().paths, Paths{"/a.toml"});
}

TEST_F(PortalTest, WhoCancelsHasChosenNothingAndIsToldNothing) {
  begin();
  ask();
  portal_.respond(1);
  const FileAnswer given = answer();
  EXPECT_EQ(given.paths, Paths{});
  EXPECT_EQ(given.problem, "");
}

TEST_F(PortalTest, ADialogThatEndsOtherwiseIsTold) {
  begin();
  ask();
  portal_.respond(2);
  expect_failure();
  ask();
  portal_.respond(0);  // and nothing in it
  expect_failure();
}

TEST_F(PortalTest, ARefusalIsTold) {
  begin();
  portal_.refuses = true;
  ask();
  expect_failure();
  portal_.refuses = false;
  ask();
  portal_.respond(0, {"file:///a.toml"});
  EXPECT_EQ(answer().paths, Paths{"/a.toml"});
}

TEST_F(PortalTest, APortalThatDiesEndsItsDialog) {
  begin();
  ask();
  portal_.die();
  expect_failure();
  EXPECT_TRUE(comes_to([] { return !offers_file_chooser(); }));
  portal_.appear();
  EXPECT_TRUE(comes_to([] { return offers_file_chooser(); }));
}

TEST_F(PortalTest, ABusThatEndsEndsTheDialog) {
  begin();
  ask();
  portal_.end_bus();
  EXPECT_TRUE(becomes([&] { return chooser_->has_answer(); }));
  EXPECT_NE(take_chosen_files().problem, "");
  EXPECT_FALSE(offers_file_chooser());
}

TEST_F(PortalTest, AFileOfAnotherComputerIsRefusedInWords) {
  begin();
  ask();
  portal_.respond(0, {"sftp://host/a.toml"});
  const FileAnswer given = answer();
  EXPECT_EQ(given.paths, Paths{});
  EXPECT_NE(given.problem.find("sftp://host/a.toml"), std::string::npos) << given.problem;
}

TEST_F(PortalTest, AnAnswerToAnotherProgramIsNone) {
  begin();
  ask();
  portal_.respond(0, {"file:///b.toml"}, "/org/freedesktop/portal/desktop/request/1_99/other");
  portal_.respond(0, {"file:///a.toml"});
  EXPECT_EQ(answer().paths, Paths{"/a.toml"});
}

TEST_F(PortalTest, ASecondQuestionClosesTheFirstDialog) {
  begin();
  ask();
  const std::string first = portal_.calls.back().request;
  ask({.new_file = "b.toml"});
  EXPECT_TRUE(comes_to([&] { return portal_.closed == 1; }));
  EXPECT_NE(portal_.calls.back().request, first);
  portal_.respond(0, {"file:///a.toml"}, first);
  portal_.respond(0, {"file:///b.toml"});
  const FileAnswer given = answer();
  EXPECT_EQ(given.paths, Paths{"/b.toml"});
  EXPECT_EQ(given.question.new_file, "b.toml");
}

TEST(PortalWithout, IsNotThereWithoutAPortalOrABus) {
  FakePortal bus(false);
  setenv("DBUS_SESSION_BUS_ADDRESS", bus.address().c_str(), 1);
  {
    PortalFileChooser chooser("");
    for (int step = 0; step < 50; ++step) {
      bus.step();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_FALSE(offers_file_chooser());
    bus.appear();
    EXPECT_TRUE(bus.comes_to([] { return offers_file_chooser(); })) << "it has come later";
  }
  EXPECT_FALSE(offers_file_chooser());
  setenv("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nonexistent/socket", 1);
  PortalFileChooser chooser("");
  chooser.ask({});
  EXPECT_TRUE(becomes([&] { return chooser.has_answer(); })) << "nobody waits for a dialog that does not come";
}

}  // namespace
}  // namespace ghostforce::portal_file_chooser_test
