// `ghostforce check --jobs N` says and writes what one process does, and never passes what nobody has checked.
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/tools/check/evaluation.h"
#include "app/tools/check/verdict.h"
#include "tests/app/tools/check/check_cases.h"
#include "tests/support/before_waiting.h"
#include "tests/support/no_opengl.h"
#include "tests/support/places.h"

namespace ghostforce::check_jobs_test {
namespace {

namespace fs = std::filesystem;

// --- Workers ---------------------------------------------------------------------------------------------------------

std::vector<std::string> pieces_of(std::int64_t count, int workers,
                                   const std::function<std::string(std::int64_t)>& make) {
  std::vector<std::string> pieces;
  run_in_workers(count, workers, make, [&](const std::string& piece) { pieces.push_back(piece); });
  return pieces;
}

TEST(WorkerProcesses, HandOverEachPieceOnceAndInOrder) {
  const auto make = [](std::int64_t i) { return fmt::format("{:0{}}", i, i % 7 == 0 ? 300'000 : 1); };
  std::vector<std::string> expected;
  for (std::int64_t i = 0; i < 50; ++i) expected.push_back(make(i));
  for (const int workers : {2, 5, 64}) EXPECT_TRUE(pieces_of(50, workers, make) == expected) << workers;
  EXPECT_TRUE(pieces_of(0, 2, make).empty());
}

TEST(WorkerProcesses, AreOtherProcesses) {
  const std::vector<std::string> makers = pieces_of(8, 2, [](std::int64_t) { return std::to_string(getpid()); });
  const std::set<std::string> each(makers.begin(), makers.end());
  EXPECT_LE(each.size(), 2U);
  EXPECT_FALSE(each.contains(std::to_string(getpid())));
}

TEST(WorkerProcesses, LeaveToThisOneWhatThrowsInThem) {
  const pid_t parent = getpid();
  const auto fails_elsewhere = [&](std::int64_t i) {
    if (getpid() != parent && i % 2 == 1) throw std::runtime_error("not here");
    return std::to_string(i);
  };
  EXPECT_EQ(pieces_of(4, 2, fails_elsewhere), (std::vector<std::string>{"0", "1", "2", "3"}));
  const auto fails = [](std::int64_t i) -> std::string {
    if (i == 2) throw Failure(ExitCode::no_display, "no OpenGL");
    return "";
  };
  std::size_t taken = 0;
  EXPECT_THROW(run_in_workers(4, 2, fails, [&](const std::string&) { ++taken; }), Failure);
  EXPECT_EQ(taken, 2U) << "what comes before it is handed over, what comes after is not";
}

TEST(WorkerProcesses, TellWhichPieceWasLostAndHow) {
  const pid_t parent = getpid();
  const auto ends = [&](int signal) -> WorkerEnded {
    try {
      pieces_of(3, 2, [&](std::int64_t i) -> std::string {
        if (i == 1 && getpid() != parent && signal != 0) kill(getpid(), signal);
        if (i == 1 && getpid() != parent) _exit(0);
        return "";
      });
    } catch (const WorkerEnded& ended) {
      return ended;
    }
    ADD_FAILURE() << "nobody has noticed";
    return {};
  };
  EXPECT_EQ(ends(SIGKILL).signal, SIGKILL);
  EXPECT_EQ(ends(SIGKILL).piece, 1);
  EXPECT_EQ(ends(0).signal, 0);
  EXPECT_EQ(ends(0).piece, 1);
}

// In the moment before it waits for a worker that takes for ever.
TEST(WorkerProcessesDeathTest, AreNotWaitedForByAnInterruptedProgram) {
  const auto wait_for_one = [] {
    remember_interruptions([]() noexcept {});
    before_waiting([] { raise(SIGINT); });
    try {
      pieces_of(1, 1, [](std::int64_t) -> std::string {
        for (;;) pause();
      });
    } catch (const Failure& failure) {
      _exit(static_cast<int>(failure.code()));
    }
    _exit(0);
  };
  EXPECT_EXIT(wait_for_one(), testing::ExitedWithCode(130), "");
}

TEST(VerdictBytes, HoldEverything) {
  Verdict verdict{
      .name = "a\0b",
      .passes = true,
      .is_file_trouble = true,
      .is_lenient = true,
      .tolerance = {.channel = 5, .share = 0.5},
      .reason = "why",
      .remark = "perhaps",
      .remedy = "do",
      .comparison = Comparison{.pixels = 7, .masked = 3, .over = 2, .greatest = 200, .left = 4, .bottom = 9},
      .numbers = {std::nullopt, CheckedNumber{.expected = 1.5, .actual = 2.5, .tolerance = 0.25}},
      .drawn_by = {"renderer", "mesa", "version"},
      .duration_s = 0.1,
      .pictures = {.expected = "", .actual = std::nullopt, .difference = std::string(100'000, '\0')}};
  const Verdict read = verdict_of(bytes_of(verdict));
  EXPECT_EQ(read.name, verdict.name);
  EXPECT_TRUE(read.passes && read.is_file_trouble && read.is_lenient);
  EXPECT_EQ(read.reason + read.remark + read.remedy, "whyperhapsdo");
  EXPECT_EQ(read.tolerance.channel, 5);
  EXPECT_EQ(read.tolerance.share, 0.5);
  ASSERT_TRUE(read.comparison.has_value());
  EXPECT_EQ(read.comparison->masked, 3);
  EXPECT_EQ(read.comparison->bottom, 9);
  EXPECT_FALSE(read.numbers[0].has_value());
  ASSERT_TRUE(read.numbers[1].has_value());
  EXPECT_EQ(read.numbers[1]->actual, 2.5);
  EXPECT_EQ(read.numbers[1]->tolerance, 0.25);
  EXPECT_EQ(read.drawn_by, verdict.drawn_by);
  EXPECT_EQ(read.duration_s, 0.1);
  EXPECT_EQ(read.pictures.expected, "");
  EXPECT_EQ(read.pictures.actual, std::nullopt);
  EXPECT_EQ(read.pictures.difference, verdict.pictures.difference);
  EXPECT_FALSE(verdict_of(bytes_of(Verdict())).comparison.has_value());
}

// --- The command -----------------------------------------------------------------------------------------------------

// Times differ from run to run.
std::string without_times(const std::string& text) {
  return std::regex_replace(text, std::regex("[0-9]+\\.[0-9]+( s<|\"/?>)"), "$1");
}

std::map<std::string, std::string> contents_of(const std::string& folder) {
  std::map<std::string, std::string> contents;
  for (const std::string& name : Cases::files_in(folder)) {
    contents[name] = without_times(read_whole(folder + "/" + name));
  }
  return contents;
}

TEST(CheckJobs, ChangeNothingThatIsSaidOrWritten) {
  const std::string text(small_case);
  std::map<std::string, std::string> texts{{"changed", text},
                                           {"damaged", text},
                                           {"missing", text},
                                           {"match", text + "match = \"changed\"\n"},
                                           {"mismatch", text + "mismatch = \"changed\"\n"}};
  for (int i = 0; i < 9; ++i) texts.emplace(fmt::format("same{}", i), text);
  const Cases cases(texts);
  ASSERT_EQ(cases.check({"--update", "changed", "damaged", "same0", "same3"}).exit_code, 0);
  write_whole(cases / "changed.toml", read_whole(cases / "changed.toml") + "[tolerance]\nchannel = 2\n");
  write_whole(cases / "changed.toml", "strategy = \"full\"\n" + read_whole(cases / "changed.toml"));
  write_whole(cases / "damaged.png", "no picture");
  const std::string report = cases.beside("report");
  const Outcome alone = cases.check({"--report", report});
  const auto expected = contents_of(report);
  EXPECT_EQ(alone.exit_code, 8);
  for (const char* jobs : {"1", "2", "3", "64"}) {
    fs::remove_all(report);
    const Outcome outcome = cases.check({"--report", report, "--jobs", jobs});
    EXPECT_EQ(outcome.exit_code, alone.exit_code) << jobs;
    EXPECT_EQ(outcome.out, alone.out) << jobs;
    EXPECT_EQ(outcome.err, alone.err) << jobs;
    EXPECT_TRUE(contents_of(report) == expected) << jobs;
  }
  EXPECT_EQ(cases.check({"--only", "same3", "same0", "--jobs", "2"}).out,
            "pass same0\npass same3\n2 cases, 0 failed\n");
}

TEST(CheckJobs, AreANumberWithinLimits) {
  const Cases cases({{"wall", std::string(small_case)}});
  for (const char* jobs : {"0", "65", "-1", "1.5", "many", ""}) {
    const Outcome outcome = cases.check({"--jobs", jobs});
    EXPECT_EQ(outcome.exit_code, 2) << jobs;
    EXPECT_TRUE(contains(outcome.err, "is not a whole number from 1 to 64"));
  }
  EXPECT_EQ(cases.check({"--jobs", "2", "--update", "wall"}).exit_code, 2);
  EXPECT_EQ(cases.files().size(), 1U);
  const Outcome lesson = run_ghostforce({"check", "ghost", "--jobs", "2"});
  EXPECT_EQ(lesson.exit_code, 2);
  EXPECT_TRUE(contains(lesson.err, "--jobs, --json and --renderer are for a folder of cases"));
}

TEST(CheckJobs, SayWhatIsMissingWhereThereIsNoOpenGl) {
  const NoOpenGl no_opengl;
  const Cases cases({{"a", std::string(small_case)}, {"b", std::string(small_case)}});
  const Outcome alone = cases.check_with({no_opengl.variable()});
  const Outcome several = cases.check_with({no_opengl.variable()}, {"--jobs", "2"});
  EXPECT_EQ(several.exit_code, 6);
  EXPECT_EQ(several.err, alone.err);
}

TEST(CheckJobs, SayOnceThatAVariableIsIgnored) {
  const Cases cases({{"a", std::string(small_case)}, {"b", std::string(small_case) + "match = \"a\"\n"}});
  const Outcome outcome = cases.check_with({"GALLIUM_DRIVER=softpipe"}, {"--jobs", "2", "--only", "b"});
  EXPECT_EQ(outcome.exit_code, 0);
  const std::size_t first = outcome.err.find("GALLIUM_DRIVER");
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(outcome.err.find("GALLIUM_DRIVER", first + 1), std::string::npos) << outcome.err;
}

// Enough cases that it cannot end before it is met.
Cases many_cases() {
  std::map<std::string, std::string> texts;
  for (int i = 0; i < 60; ++i) texts.emplace(fmt::format("case{}", i), small_case);
  return Cases(texts);
}

TEST(CheckJobs, LeaveNothingBehindWhenInterrupted) {
  const Cases cases = many_cases();
  const std::string report = cases.beside("report");
  fs::create_directory(report);
  ProgramCall call;
  call.words = {"check", cases.path(), "--report", report, "--jobs", "2"};
  call.signal_when_created_in = report;
  call.signal = SIGINT;
  // It would wait for as long as a process has the other end of its output: none outlives the check.
  EXPECT_EQ(run_ghostforce(call).exit_code, 130);
  EXPECT_EQ(Cases::files_in(report), std::set<std::string>{});
}

// A check that cannot end, because its long lines go to a small pipe that nobody reads until somebody has been killed.
class HeldUpCheck {
 public:
  HeldUpCheck() {
    const std::string pipe = folder_ / "pipe";
    if (mkfifo(pipe.c_str(), 0600) != 0) throw std::runtime_error("no pipe");
    out_ = open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (fcntl(out_, F_SETPIPE_SZ, 4096) < 0) throw std::runtime_error("a pipe cannot be made small here");
    fs::create_directory(folder_ / "cases");
    for (int i = 0; i < 60; ++i) {
      write_whole(fmt::format("{}/{}-{:02}.toml", folder_ / "cases", std::string(200, 'x'), i), small_case);
    }
    ProgramCall call;
    call.words = {"-c", fmt::format("exec {} check {} --jobs 2 >{} 2>{}", ghostforce_program(), folder_ / "cases", pipe,
                                    folder_ / "err")};
    program_.emplace("/bin/sh", call);
  }
  ~HeldUpCheck() { close(out_); }
  HeldUpCheck(const HeldUpCheck&) = delete;
  HeldUpCheck& operator=(const HeldUpCheck&) = delete;

  RunningProgram& program() { return *program_; }

  // One of its processes, once there is one.
  pid_t worker() {
    while (!program_->has_ended()) {
      for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
        const std::string name = entry.path().filename();
        pid_t process = 0;
        if (std::from_chars(name.data(), name.data() + name.size(), process).ec != std::errc{}) continue;
        const std::string state = read_whole(entry.path() / "stat");  // "PID (NAME) STATE PARENT …"
        const std::size_t end = state.rfind(") ");
        if (end == std::string::npos) continue;
        if (state.substr(end + 4).starts_with(fmt::format("{} ", program_->pid()))) return process;
      }
      usleep(1000);
    }
    throw std::runtime_error("it has ended before it was met: " + read_whole(folder_ / "err"));
  }

  // Until nobody writes any more.
  void read_all() {
    fcntl(out_, F_SETFL, 0);
    std::array<char, 4096> piece;
    while (read(out_, piece.data(), piece.size()) > 0) {
    }
  }
  std::string errors() const { return read_whole(folder_ / "err"); }

 private:
  TemporaryFolder folder_;
  int out_ = -1;
  std::optional<RunningProgram> program_;
};

TEST(CheckJobs, NeverPassWhatAKilledProcessShouldHaveChecked) {
  HeldUpCheck check;
  kill(check.worker(), SIGKILL);
  check.read_all();
  EXPECT_EQ(check.program().wait_for_end(), 8);
  EXPECT_TRUE(contains(check.errors(), "a worker process was killed"));
  EXPECT_TRUE(contains(check.errors(), "choose fewer --jobs"));
}

TEST(CheckJobs, EndWithTheProgramThatStartedThem) {
  HeldUpCheck check;
  check.worker();
  check.program().send(SIGKILL);
  check.read_all();  // returns once no process has the pipe any more
  EXPECT_EQ(check.program().wait_for_end(), 128 + SIGKILL);
}

}  // namespace
}  // namespace ghostforce::check_jobs_test
