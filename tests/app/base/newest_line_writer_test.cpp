// Lines for a reader that is slow, gone, or asleep.
#include "app/base/newest_line_writer.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <optional>
#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace ghostforce::newest_line_writer_test {
namespace {

class Pipe {
 public:
  Pipe() {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
    reads_ = ends[0];
    writes_ = ends[1];
  }
  ~Pipe() {
    close_reader();
    close_writer();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int writer() const { return writes_; }
  void close_reader() { close_end(reads_); }
  void close_writer() { close_end(writes_); }

  // As much as fits, so that the next write waits. Returns how many bytes.
  std::size_t fill() const {
    fcntl(writes_, F_SETFL, O_NONBLOCK);
    const std::string much(4096, '.');
    std::size_t all = 0;
    for (ssize_t written = 0; (written = write(writes_, much.data(), much.size())) > 0;) {
      all += static_cast<std::size_t>(written);
    }
    fcntl(writes_, F_SETFL, 0);
    return all;
  }
  void skip(std::size_t bytes) {
    std::string much(4096, ' ');
    while (bytes > 0) {
      const ssize_t taken = read(reads_, much.data(), std::min(bytes, much.size()));
      ASSERT_GT(taken, 0);
      bytes -= static_cast<std::size_t>(taken);
    }
  }
  // Without its end; waits for it. Empty: there is nothing more to come.
  std::optional<std::string> next_line() {
    std::string line;
    for (char letter = 0; read(reads_, &letter, 1) == 1;) {
      if (letter == '\n') return line;
      line += letter;
    }
    EXPECT_EQ(line, "") << "half a line";
    return std::nullopt;
  }

 private:
  static void close_end(int& end) {
    if (end >= 0) close(end);
    end = -1;
  }
  int reads_ = -1;
  int writes_ = -1;
};

TEST(NewestLineWriter, WritesWhatIsReadAtOnce) {
  Pipe pipe;
  NewestLineWriter writer(pipe.writer(), "# first\n");
  EXPECT_EQ(pipe.next_line(), "# first");
  for (const char* line : {"one", "two", "three"}) {
    writer.put(std::string(line) + "\n");
    EXPECT_EQ(pipe.next_line(), line);
  }
  EXPECT_EQ(writer.problem(), 0);
}

TEST(NewestLineWriter, HasTheLastLineInTheEnd) {
  Pipe pipe;
  {
    NewestLineWriter writer(pipe.writer(), "# first\n");
    writer.put("last\n");
  }
  pipe.close_writer();
  EXPECT_EQ(pipe.next_line(), "# first");
  EXPECT_EQ(pipe.next_line(), "last");
  EXPECT_FALSE(pipe.next_line());
}

TEST(NewestLineWriter, NeverWaitsAndTheNewestLineWins) {
  Pipe pipe;
  const std::size_t before = pipe.fill();
  NewestLineWriter writer(pipe.writer(), "# first\n");
  // The first line is stuck, whoever wins the race to it; of all that follow only the last can be left.
  for (int i = 0; i <= 10000; ++i) writer.put(std::to_string(i) + "\n");
  pipe.skip(before);
  EXPECT_EQ(pipe.next_line(), "# first");
  EXPECT_EQ(pipe.next_line(), "10000");
}

// Returns in the end though nobody reads; else this test would never end.
TEST(NewestLineWriter, LeavesAReaderThatSleeps) {
  Pipe pipe;
  const std::size_t before = pipe.fill();
  {
    NewestLineWriter writer(pipe.writer(), "# first\n");
    writer.put("never\n");
  }
  // What is left behind is whole all the same.
  pipe.skip(before);
  EXPECT_EQ(pipe.next_line(), "# first");
  EXPECT_EQ(pipe.next_line(), "never");
}

TEST(NewestLineWriter, FindsThatItsReaderHasGone) {
  signal(SIGPIPE, SIG_IGN);  // as main() has it
  Pipe pipe;
  pipe.close_reader();
  NewestLineWriter writer(pipe.writer(), "# first\n");
  while (writer.problem() == 0) std::this_thread::yield();
  EXPECT_EQ(writer.problem(), EPIPE);
  writer.put("nowhere\n");
}

TEST(NewestLineWriter, WaitsForAPipeThatSomebodyMadeNonBlocking) {
  Pipe pipe;
  const std::size_t before = pipe.fill();
  fcntl(pipe.writer(), F_SETFL, O_NONBLOCK);
  NewestLineWriter writer(pipe.writer(), "# first\n");
  writer.put("one\n");
  pipe.skip(before);
  EXPECT_EQ(pipe.next_line(), "# first");
  EXPECT_EQ(pipe.next_line(), "one");
  EXPECT_EQ(writer.problem(), 0);
}

}  // namespace
}  // namespace ghostforce::newest_line_writer_test
