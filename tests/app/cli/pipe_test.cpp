// Pipes in place of files, with nobody at their other end: Ctrl+C is heard all the same.
#include <sys/stat.h>
#include <sys/syscall.h>

#include <csignal>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::pipe_test {
namespace {

// It has got so far that Ctrl+C is something it handles itself.
bool handles_interruption(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string word; status >> word;) {
    if (word != "SigCgt:") continue;
    status >> word;
    return (std::stoull(word, nullptr, 16) >> (SIGINT - 1) & 1) != 0;
  }
  return false;
}

// The number of the system call that its first thread sleeps in; "running", or empty: nobody may know.
std::string system_call(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/syscall");
  std::string number;
  file >> number;
  return number;
}

bool may_see_system_calls(pid_t process) {
  return !system_call(process).empty();
}

bool waits(pid_t process) {
  const std::string number = system_call(process);
#ifdef SYS_poll
  if (number == std::to_string(SYS_poll)) return true;
#endif
  return number == std::to_string(SYS_ppoll);
}

class PipeTest : public testing::TestWithParam<std::vector<std::string>> {
 protected:
  PipeTest() {
    for (const char* const name : {"pipe", "pipe.toml", "pipe.csv", "pipe.png"}) mkfifo((folder_ / name).c_str(), 0666);
    call_.words = GetParam();
    call_.folder = folder_.path();
  }

  TemporaryFolder folder_;
  ProgramCall call_;
};

TEST_P(PipeTest, InterruptedWhileItWaitsForSomebody) {
  RunningProgram program(ghostforce_program(), call_);
  while (!handles_interruption(program.pid()) && !program.has_ended()) std::this_thread::yield();
  if (!may_see_system_calls(program.pid())) GTEST_SKIP() << "/proc does not show what a program waits for";
  while (!waits(program.pid()) && !program.has_ended()) std::this_thread::yield();
  program.send(SIGINT);
  EXPECT_EQ(program.wait_for_end(), 130);
}

// Wherever it is by then: at its beginning, waiting, or just about to wait.
TEST_P(PipeTest, InterruptedAsSoonAsItHandlesThat) {
  RunningProgram program(ghostforce_program(), call_);
  while (!handles_interruption(program.pid()) && !program.has_ended()) std::this_thread::yield();
  program.send(SIGINT);
  EXPECT_EQ(program.wait_for_end(), 130);
}

INSTANTIATE_TEST_SUITE_P(, PipeTest,
                         testing::Values(std::vector<std::string>{"simulate", "wall45", "-o", "pipe"},
                                         std::vector<std::string>{"simulate", "pipe.toml"},
                                         std::vector<std::string>{"equilibrium", "pipe.toml"},
                                         std::vector<std::string>{"render", "pipe.toml", "-o", "picture.png"},
                                         std::vector<std::string>{"render", "wall45", "-o", "pipe.png"},
                                         std::vector<std::string>{"replay", "pipe.csv"},
                                         std::vector<std::string>{"figures", "--hand", "pipe.csv", "-o", "figures"},
                                         std::vector<std::string>{"measure-user", "pipe.csv"},
                                         std::vector<std::string>{"run", "--input", "replay:pipe.csv"}));

}  // namespace
}  // namespace ghostforce::pipe_test
