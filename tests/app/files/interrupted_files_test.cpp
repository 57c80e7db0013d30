// Files that are pipes, with nobody at their other end: an interruption in the moment before they are waited for ends
// that too. Each in a process of its own, because what remembers an interruption is for a whole process.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <string>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/files/input_file.h"
#include "app/files/output_file.h"
#include "tests/support/before_waiting.h"
#include "tests/support/exit_code_of.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::interrupted_files_test {
namespace {

[[noreturn]] void interrupt_before_waiting(const std::function<void()>& work) {
  remember_interruptions([]() noexcept {});
  before_waiting([] { std::raise(SIGTERM); });
  std::exit(exit_code_of(work));
}

const testing::ExitedWithCode interrupted_exit(static_cast<int>(ExitCode::interrupted));

class InterruptedFilesDeathTest : public testing::Test {
 protected:
  InterruptedFilesDeathTest() {
    mkfifo(path_.c_str(), 0600);
    other_end_ = open(path_.c_str(), O_RDWR | O_CLOEXEC);
  }
  ~InterruptedFilesDeathTest() override { close(other_end_); }

  TemporaryFolder folder_;
  const std::string path_ = folder_ / "pipe";
  int other_end_ = -1;
};

// A pipe holds less.
const std::string much(1 << 20, 'x');

TEST_F(InterruptedFilesDeathTest, ReadFromAPipeThatNobodyWritesTo) {
  EXPECT_EXIT(interrupt_before_waiting([&] { file_contents(path_); }), interrupted_exit, "");
}

TEST_F(InterruptedFilesDeathTest, WrittenToAPipeThatNobodyReads) {
  const auto write_it = [&] { OutputFile(path_).write(much); };
  EXPECT_EXIT(interrupt_before_waiting(write_it), interrupted_exit, "");
}

// One that others have open too, and that may wait in write(2).
TEST_F(InterruptedFilesDeathTest, WrittenToTheStandardOutputThatNobodyReads) {
  const auto write_it = [&] {
    dup2(other_end_, STDOUT_FILENO);
    OutputFile("-").write(much);
  };
  EXPECT_EXIT(interrupt_before_waiting(write_it), interrupted_exit, "");
}

TEST_F(InterruptedFilesDeathTest, NotEvenALastLineIsWaitedForAnyLonger) {
  const auto write_it = [&] {
    dup2(other_end_, STDOUT_FILENO);
    OutputFile file("-");
    file.finish_despite_interruption();
    file.write(much);
  };
  EXPECT_EXIT(interrupt_before_waiting(write_it), interrupted_exit, "");
}

}  // namespace
}  // namespace ghostforce::interrupted_files_test
