// Lines of the standard input: as they come through a pipe, and where one ends without its newline.
#include "app/base/interruption.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "app/base/failure.h"
#include "tests/support/before_waiting.h"
#include "tests/support/exit_code_of.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::input_line_test {
namespace {

class Typing {
 public:
  explicit Typing(std::string_view words) {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) std::abort();
    type(words);
  }
  ~Typing() {
    close(input());
    end();
  }
  Typing(const Typing&) = delete;
  Typing& operator=(const Typing&) = delete;

  int input() const { return ends_[0]; }
  void type(std::string_view words) const {
    if (write(ends_[1], words.data(), words.size()) != static_cast<ssize_t>(words.size())) std::abort();
  }
  // Nothing more will come.
  void end() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_{};
};

void expect_line(int input, std::string_view text, bool is_whole) {
  const InputLine line = read_line(input);
  EXPECT_EQ(line.text, text);
  EXPECT_EQ(line.is_whole, is_whole) << text;
}

TEST(InputLine, IsOneOfSeveralThatComeInOnePiece) {
  const Typing typing("one\n\ntwo\n");
  expect_line(typing.input(), "one", true);
  expect_line(typing.input(), "", true);
  expect_line(typing.input(), "two", true);
}

// As when one script pipes answers into two programs, one after the other.
TEST(InputLine, LeavesTheRestToWhoeverReadsNext) {
  const Typing typing("one\ntwo\n");
  expect_line(typing.input(), "one", true);
  std::array<char, 16> rest{};
  ASSERT_EQ(read(typing.input(), rest.data(), rest.size()), 4);
  EXPECT_EQ(std::string_view(rest.data()), "two\n");
}

// In a process of its own, because what it would wait for comes only once it waits.
TEST(InputLineDeathTest, MayComeInTwoPieces) {
  const Typing typing("on");
  const auto read_it = [&] {
    before_waiting([&] { typing.type("e\n"); });
    const InputLine line = read_line(typing.input());
    std::exit(line.is_whole && line.text == "one" ? 0 : 1);
  };
  EXPECT_EXIT(read_it(), testing::ExitedWithCode(0), "");
}

TEST(InputLine, ThatTheInputEndsInIsNotWhole) {
  Typing typing("one\nhal");
  typing.end();
  expect_line(typing.input(), "one", true);
  expect_line(typing.input(), "hal", false);
  expect_line(typing.input(), "", false);
}

TEST(InputLine, IsNoneWhereTheInputEndsAtOnce) {
  Typing typing("");
  typing.end();
  expect_line(typing.input(), "", false);
}

TEST(InputLine, IsNoneWhereTheInputCannotBeRead) {
  const TemporaryFolder folder;
  const int input = open(folder.path().c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_GE(input, 0);
  expect_line(input, "", false);
  close(input);
}

TEST(InputLine, MayBeAsLongAsItSays) {
  const TemporaryFolder folder;
  const std::string longest(longest_input_line, 'a');
  write_whole(folder / "lines", longest + "\n" + longest + "a\n");
  const int input = open((folder / "lines").c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_GE(input, 0);
  EXPECT_TRUE(read_line(input).is_whole);
  EXPECT_FALSE(read_line(input).is_whole);
  close(input);
}

// A person who has begun to type, and thinks better of it.
TEST(InputLineDeathTest, IsNotWaitedForAfterAnInterruption) {
  const Typing typing("hal");
  const auto read_it = [&] {
    remember_interruptions([]() noexcept {});
    before_waiting([] { std::raise(SIGINT); });
    std::exit(exit_code_of([&] { read_line(typing.input()); }));
  };
  EXPECT_EXIT(read_it(), testing::ExitedWithCode(static_cast<int>(ExitCode::interrupted)), "");
}

}  // namespace
}  // namespace ghostforce::input_line_test
