// Where the program may not have the memory or the threads it needs it says so or does without, and neither crashes,
// hangs nor takes that for a bug.
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::memory_limit_test {
namespace {

class MemoryLimit : public testing::Test {
 protected:
  void SetUp() override {
#ifdef GHOSTFORCE_ADDRESS_SANITIZED
    GTEST_SKIP() << "the sanitizer itself needs terabytes of address space";
#endif
  }

  Outcome run_under(int limit_kb, const std::vector<std::string>& words) {
    ProgramCall call;
    call.words = {"-c", "ulimit -c 0; ulimit -v " + std::to_string(limit_kb) + "; exec \"$@\"", "sh",
                  ghostforce_program()};
    call.words.insert(call.words.end(), words.begin(), words.end());
    call.environment = {"DISPLAY=", "WAYLAND_DISPLAY="};
    call.folder = folder.path();
    return run_program("/bin/sh", call);
  }

  TemporaryFolder folder;
};

TEST_F(MemoryLimit, ASmallPictureIsMadeOrRefusedAndALargeOneRefused) {
  // Between too little for anything and enough for threads of the renderer.
  for (int limit_kb = 100'000; limit_kb <= 1'200'000; limit_kb += 100'000) {
    const Outcome outcome = run_under(limit_kb, {"render", "wall45", "--size", "640x400", "-o", "picture.png"});
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 8)
        << limit_kb << ": " << outcome.exit_code << ' ' << outcome.err;
    EXPECT_EQ(outcome.exit_code == 8, outcome.err.find("ulimit -v") != std::string::npos) << outcome.err;
  }
  const Outcome large = run_under(300'000, {"render", "wall45", "--size", "4096x4096", "-o", "large.png"});
  EXPECT_EQ(large.exit_code, 8);
  EXPECT_NE(large.err.find("drawing needs about 768 MB more memory"), std::string::npos) << large.err;
}

TEST_F(MemoryLimit, AdvisesNoSmallerPictureWhereThereIsNone) {
  const Outcome outcome = run_under(150'000, {"run", "--exit-after", "0.1"});
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_NE(outcome.err.find("ulimit -v"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("picture"), std::string::npos) << outcome.err;
}

TEST_F(MemoryLimit, NoCommandCrashesUnderIt) {
  ASSERT_EQ(run_ghostforce({"simulate", "wall45", "-o", folder / "run.csv"}).exit_code, 0);
  write_whole(folder / "case.toml", "scene = \"wall45\"\nsize = [4096, 4096]\n");
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"simulate", "wall45", "-o", "again.csv"},
           {"equilibrium", "wall45"},
           {"figures", "-o", "figures"},
           {"check", "."},
           {"sweep", "fig3-normal", "--over", "wall.normal_deg=90:180:91", "-o", "sweep.csv"},
           {"replay", "run.csv"},
           {"measure-user", "run.csv"},
           {"render", "wall45", "-o", "picture.svg"},
           {"run", "--exit-after", "0.1"}}) {
    for (const int limit_kb : {100'000, 300'000}) {
      const Outcome outcome = run_under(limit_kb, words);
      EXPECT_LE(outcome.exit_code, 8) << words[0] << " under " << limit_kb << '\n' << outcome.err;
      EXPECT_EQ(outcome.err.find("bug"), std::string::npos) << outcome.err;
    }
  }
}

// Of root's processes nobody counts how many there are.
TEST_F(MemoryLimit, APictureIsDrawnWhereNoThreadMayBeStarted) {
  const auto run_as_another = [&](const std::string& limit, std::vector<std::string> words) {
    const std::string as_another = geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
    words.insert(words.begin(), {"-c", "exec " + as_another + limit + " \"$@\"", "sh", ghostforce_program()});
    return run_program("/bin/sh", words);
  };
  if (run_as_another("", {"--version"}).exit_code != 0) GTEST_SKIP() << "only this user may start the program";
  const std::string no_thread = "prlimit --nproc=1";
  for (const std::string& limit : {no_thread, std::string("prlimit --nproc=2")}) {
    const Outcome outcome = run_as_another(limit, {"render", "wall45", "-o", "-"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("\x89PNG")) << outcome.err;
  }

  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  write_whole(folder / "case.toml", "scene = \"wall45\"\nsize = [320, 240]\n");
  const Outcome checked = run_as_another(no_thread, {"check", folder.path()});
  EXPECT_EQ(checked.exit_code, 1) << checked.err;
  EXPECT_NE(checked.out.find("FAIL case  there is no golden"), std::string::npos) << checked.out;
  const Outcome of_two = run_as_another(no_thread, {"check", folder.path(), "--jobs", "2"});
  EXPECT_EQ(of_two.exit_code, 8) << of_two.err;
  EXPECT_EQ(of_two.err, "another process cannot be started: Resource temporarily unavailable; choose fewer --jobs\n");
}

}  // namespace
}  // namespace ghostforce::memory_limit_test
