// A picture for the clipboard, with tools that write down what they are given instead of the desktop's own.
#include "app/files/clipboard_tool.h"

#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <cerrno>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace ghostforce::clipboard_tool_test {
namespace {

// With a zero byte, as every PNG has, and longer than a pipe holds.
std::string some_png() {
  return std::string("\x89PNG\0\n", 6) + std::string(300'000, 'p');
}

class ClipboardToolTest : public testing::Test {
 protected:
  ClipboardToolTest() { setenv("PATH", folder_.path().c_str(), 1); }

  void make_tool(const std::string& name, const std::string& script) {
    write_whole(folder_ / name, "#!/bin/sh\n" + script);
    chmod((folder_ / name).c_str(), 0755);
  }
  // Looks until the last one has ended; what was said on the way.
  std::string look_until_the_end() {
    std::string words;
    // Leaves it to be buried by poll().
    siginfo_t info{};
    while (tool_.running() > 0 && waitid(P_ALL, 0, &info, WEXITED | WNOWAIT) == 0) words += tool_.poll();
    return words;
  }

  TemporaryFolder folder_;
  ClipboardTool tool_;
};

TEST_F(ClipboardToolTest, GetsThePictureAndItsKindWithoutAShell) {
  for (const auto& [display, name, arguments] :
       {std::tuple{DisplayKind::x11, "xclip", "-selection clipboard -t image/png -i"},
        std::tuple{DisplayKind::wayland, "wl-copy", "--type image/png"}}) {
    make_tool(name, "echo \"$*\" > " + (folder_ / "arguments") + "\nexec /bin/cat > " + (folder_ / "picture"));
    EXPECT_EQ(tool_.copy_png(some_png(), display), "");
    EXPECT_EQ(look_until_the_end(), "");
    EXPECT_EQ(read_whole(folder_ / "arguments"), std::string(arguments) + "\n");
    EXPECT_TRUE(read_whole(folder_ / "picture") == some_png());
  }
}

TEST_F(ClipboardToolTest, LeavesNoZombieAndWaitsForNobody) {
  // It ends when somebody opens the pipe: as long as nobody does, poll() must come back.
  const std::string pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  make_tool("xclip", "echo > " + pipe);
  ASSERT_EQ(tool_.copy_png(some_png(), DisplayKind::x11), "");
  EXPECT_EQ(tool_.poll(), "");
  EXPECT_EQ(tool_.running(), 1U);
  read_whole(pipe);
  look_until_the_end();
  EXPECT_EQ(tool_.running(), 0U);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST_F(ClipboardToolTest, HoldsNoOtherFileOfTheProgram) {
  const TemporaryFolder other;
  write_whole(other / "device", "");
  FILE* const device = fopen((other / "device").c_str(), "r");
  make_tool("xclip", "exec /bin/ls -l /proc/self/fd > " + (folder_ / "files"));
  ASSERT_EQ(tool_.copy_png(some_png(), DisplayKind::x11), "");
  look_until_the_end();
  fclose(device);
  EXPECT_NE(read_whole(folder_ / "files").find("picture"), std::string::npos) << "its input";
  EXPECT_EQ(read_whole(folder_ / "files").find("device"), std::string::npos);
}

TEST_F(ClipboardToolTest, WhereThereIsNoToolItIsNamed) {
  EXPECT_NE(tool_.copy_png(some_png(), DisplayKind::x11).find("install the package xclip"), std::string::npos);
  EXPECT_NE(tool_.copy_png(some_png(), DisplayKind::wayland).find("wl-clipboard"), std::string::npos);
  EXPECT_NE(tool_.copy_png(some_png(), DisplayKind::none), "");
  EXPECT_EQ(tool_.running(), 0U);
}

TEST_F(ClipboardToolTest, OneThatFailsIsReported) {
  make_tool("xclip", "exit 1");
  EXPECT_EQ(tool_.copy_png(some_png(), DisplayKind::x11), "");
  EXPECT_NE(look_until_the_end(), "");
}

}  // namespace
}  // namespace ghostforce::clipboard_tool_test
