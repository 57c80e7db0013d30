// An interruption in the moment before something waits: after the last look at the flag, before the system call that a
// signal could end. Each in a process of its own, because what remembers an interruption is for a whole process.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <thread>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/words.h"
#include "tests/support/before_waiting.h"
#include "tests/support/exit_code_of.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::interruption_test {
namespace {

int stops = 0;  // how often motors were told to stop

struct Pipe {
  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC) != 0) std::abort();
  }
  int read_end() const { return ends[0]; }
  int write_end() const { return ends[1]; }
  // Until it takes no more.
  void fill() const {
    fcntl(write_end(), F_SETFL, O_NONBLOCK);
    const std::array<char, 4096> piece{};
    while (write(write_end(), piece.data(), piece.size()) > 0) {
    }
    fcntl(write_end(), F_SETFL, 0);
  }
  std::array<int, 2> ends{};
};

const auto interrupt_itself = [] { std::raise(SIGINT); };

// As main() does.
[[noreturn]] void run(const std::function<void()>& work, const std::function<void()>& before_it_waits) {
  remember_interruptions([]() noexcept { ++stops; });
  before_waiting(before_it_waits);
  std::exit(exit_code_of(work));
}

const testing::ExitedWithCode interrupted_exit(static_cast<int>(ExitCode::interrupted));

TEST(InterruptionDeathTest, EndsAReadThatHasNotBegun) {
  const Pipe pipe;
  const auto read_it = [&] {
    wait_to_read(pipe.read_end());
    char letter = 0;
    std::exit(static_cast<int>(read(pipe.read_end(), &letter, 1)));
  };
  EXPECT_EXIT(run(read_it, interrupt_itself), interrupted_exit, "");
}

TEST(InterruptionDeathTest, EndsAWriteThatHasNotBegun) {
  const Pipe pipe;
  pipe.fill();
  EXPECT_EXIT(run([&] { wait_to_write(pipe.write_end()); }, interrupt_itself), interrupted_exit, "");
}

// Whichever thread the system gives the signal to.
TEST(InterruptionDeathTest, EndsAWaitOfAnotherThread) {
  const Pipe pipe;
  const auto interrupted_elsewhere = [] { std::thread(interrupt_itself).join(); };
  EXPECT_EXIT(run([&] { wait_to_read(pipe.read_end()); }, interrupted_elsewhere), interrupted_exit, "");
}

TEST(InterruptionDeathTest, EndsEveryLaterWaitToo) {
  const Pipe pipe;
  const auto twice = [&] {
    EXPECT_THROW(wait_to_read(pipe.read_end()), Failure);
    wait_to_read(pipe.read_end());
  };
  EXPECT_EXIT(run(twice, interrupt_itself), interrupted_exit, "");
}

TEST(InterruptionDeathTest, OfTheProgramItselfEndsAWaitToo) {
  const Pipe pipe;
  EXPECT_EXIT(run([&] { wait_to_read(pipe.read_end()); }, interrupt), interrupted_exit, "");
}

TEST(InterruptionDeathTest, EndsTheWaitForTheOtherEndOfAPipe) {
  const TemporaryFolder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const auto read_it = [&] { wait_to_read(open_unless_interrupted(path.c_str(), O_RDONLY | O_CLOEXEC)); };
  EXPECT_EXIT(run(read_it, interrupt_itself), interrupted_exit, "");
  const auto write_it = [&] { open_unless_interrupted(path.c_str(), O_WRONLY | O_CLOEXEC); };
  EXPECT_EXIT(run(write_it, interrupt_itself), interrupted_exit, "");
}

TEST(Interruption, NobodyWaitsForWhatIsNoPipe) {
  const TemporaryFolder folder;
  EXPECT_EQ(open_unless_interrupted((folder / "nothing").c_str(), O_RDONLY | O_CLOEXEC), -1);
  EXPECT_EQ(errno, ENOENT);
  EXPECT_EQ(open_unless_interrupted(folder.path().c_str(), O_WRONLY | O_CLOEXEC), -1);
  EXPECT_EQ(errno, EISDIR);
}

// What can be had without waiting is had.
TEST(InterruptionDeathTest, IsNoEndOfWhatIsThere) {
  const Pipe pipe;
  ASSERT_EQ(write(pipe.write_end(), "x", 1), 1);
  const auto read_it = [&] {
    interrupt_itself();
    wait_to_read(pipe.read_end());
    wait_to_write(pipe.write_end());
  };
  EXPECT_EXIT(run(read_it, {}), testing::ExitedWithCode(0), "");
}

TEST(InterruptionDeathTest, OfAForkedProcessIsItsOwn) {
  const auto fork_one = [] {
    const pid_t child = fork();
    if (child == 0) {
      interrupt_itself();
      _exit(interrupted() ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (status != 0 || interrupted()) std::exit(1);
    wait_to_read(interruption_descriptor());  // in vain
  };
  EXPECT_EXIT(run(fork_one, {}), testing::ExitedWithCode(would_wait_for_ever), "");
}

// The error output that nobody reads: words are lost, and the program goes on to its end.
TEST(InterruptionDeathTest, WordsThatNobodyReadsAreLost) {
  const Pipe pipe;
  pipe.fill();
  const auto speak = [&] {
    dup2(pipe.write_end(), STDERR_FILENO);
    say("{}\n", "words");
    stop_if_interrupted();
  };
  EXPECT_EXIT(run(speak, interrupt_itself), interrupted_exit, "");
}

// --- Motors ----------------------------------------------------------------------------------------------------------

TEST(InterruptionDeathTest, TheFirstStopsMotorsBeforeAnybodyHasHeardOfIt) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const auto stops_at_first = [&] {
      remember_interruptions([]() noexcept { ++stops; });
      std::raise(number);
      std::exit(stops);
    };
    EXPECT_EXIT(stops_at_first(), testing::ExitedWithCode(1), "") << number;
  }
}

// As by a service manager or a shell script that blocks them for itself.
TEST(InterruptionDeathTest, SignalsThatWereBlockedAreHeard) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const auto starts_with_it_blocked = [&] {
      sigset_t blocked;
      sigemptyset(&blocked);
      sigaddset(&blocked, number);
      pthread_sigmask(SIG_BLOCK, &blocked, nullptr);
      remember_interruptions([]() noexcept { ++stops; });
      kill(getpid(), number);
      std::exit(stops);
    };
    EXPECT_EXIT(starts_with_it_blocked(), testing::ExitedWithCode(1), "") << number;
  }
}

TEST(InterruptionDeathTest, TheSecondEndsAtOnce) {
  const auto twice = [] {
    remember_interruptions([]() noexcept {
      const ssize_t ignored = write(STDERR_FILENO, "stopped", 7);
      static_cast<void>(ignored);
    });
    std::raise(SIGTERM);
    std::raise(SIGINT);
  };
  EXPECT_EXIT(twice(), testing::KilledBySignal(SIGINT), "^stoppedstopped$");
}

}  // namespace
}  // namespace ghostforce::interruption_test
