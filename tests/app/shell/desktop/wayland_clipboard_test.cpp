// Text on a Wayland desktop's clipboard, with tools that do as they are told instead of the desktop's own.
#include "app/shell/desktop/wayland_clipboard.h"

#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <cerrno>

#include <gtest/gtest.h>

#include "app/base/failure.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::wayland_clipboard_test {
namespace {

constexpr std::int64_t for_long_ns = 300'000'000'000;

class WaylandClipboardTest : public testing::Test {
 protected:
  WaylandClipboardTest() { setenv("PATH", folder_.path().c_str(), 1); }
  ~WaylandClipboardTest() override { setenv("PATH", path_before_.c_str(), 1); }

  void make_tool(const std::string& name, const std::string& script) {
    write_whole(folder_ / name, "#!/bin/sh\n" + script);
    chmod((folder_ / name).c_str(), 0755);
  }
  static void expect_no_child() {
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
  }
  static std::string problem_of_reading(std::int64_t patience_ns) {
    try {
      WaylandClipboard::text(patience_ns);
    } catch (const Failure& failure) {
      return failure.what();
    }
    return {};
  }

  const std::string path_before_ = getenv("PATH");
  TemporaryFolder folder_;
};

TEST_F(WaylandClipboardTest, ReadsWhatTheToolPrints) {
  make_tool("wl-paste", "echo \"$*\"; /bin/cat " + (folder_ / "text"));
  write_whole(folder_ / "text", "ghostforce run wall45");
  EXPECT_EQ(WaylandClipboard::text(for_long_ns), "--no-newline --type text/plain\nghostforce run wall45");
  expect_no_child();
}

TEST_F(WaylandClipboardTest, HasNoTextWhereTheToolHasNone) {
  make_tool("wl-paste", "echo 'Nothing is copied' >&2; exit 1");
  EXPECT_EQ(WaylandClipboard::text(for_long_ns), "");
}

TEST_F(WaylandClipboardTest, DoesNotWaitForAnOwnerThatIsFrozen) {
  make_tool("wl-paste", "exec /bin/sleep 1000");
  EXPECT_NE(problem_of_reading(1'000'000).find("does not answer"), std::string::npos);
  expect_no_child();
}

TEST_F(WaylandClipboardTest, RefusesATextWithoutEnd) {
  make_tool("wl-paste", "exec /bin/cat /dev/zero");
  EXPECT_NE(problem_of_reading(for_long_ns).find("too long"), std::string::npos);
  expect_no_child();
}

TEST_F(WaylandClipboardTest, GivesItsTextToTheTool) {
  make_tool("wl-copy", "echo \"$*\" > " + (folder_ / "arguments") + "\nexec /bin/cat > " + (folder_ / "text"));
  WaylandClipboard clipboard;
  const std::string text(300'000, 't');
  ASSERT_TRUE(clipboard.copy(text));
  siginfo_t info{};
  ASSERT_EQ(waitid(P_ALL, 0, &info, WEXITED | WNOWAIT), 0);  // leaves it to be buried
  clipboard.poll();
  expect_no_child();
  EXPECT_EQ(read_whole(folder_ / "arguments"), "--type text/plain\n");
  EXPECT_TRUE(read_whole(folder_ / "text") == text);
}

// The window could copy by itself, but would wait for a frozen owner for good.
TEST_F(WaylandClipboardTest, WithoutTheToolsCopiesNothingAndSaysWhatToInstall) {
  WaylandClipboard clipboard;
  EXPECT_FALSE(clipboard.copy("text"));
  EXPECT_NE(problem_of_reading(for_long_ns).find("wl-clipboard"), std::string::npos);
}

}  // namespace
}  // namespace ghostforce::wayland_clipboard_test
