// What `ghostforce check` does with files that are damaged, too large, unreadable or somewhere else, and how much
// memory it takes for many cases.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/png_writer.h"
#include "tests/app/files/png_pieces.h"
#include "tests/app/tools/check/check_cases.h"
#include "tests/support/places.h"
#include "tests/support/read_png.h"
#include "tests/support/sanitized.h"

namespace ghostforce::check_limits_test {
namespace {

namespace fs = std::filesystem;

// --- Goldens ---------------------------------------------------------------------------------------------------------

TEST(CheckGolden, AlphaCounts) {
  const Cases cases({{"wall", std::string(small_case)}});
  cases.update("wall");
  Image golden = read_png(cases / "wall.png");
  golden.alpha.assign(golden.rgb.size() / 3, 255);
  golden.alpha[20 * 320 + 10] = 100;
  write_whole(cases / "wall.png", png_bytes(golden));
  const std::string report = cases.beside("report");
  const Outcome outcome = cases.check({"--report", report});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.out,
                       "1 of 76800 pixels (0.0013 %) differ by up to 155, all of them in 1x1 pixels at x 10, y 20"));
  EXPECT_TRUE(read_png(report + "/wall.expected.png") == golden) << "as it is stored";
  write_whole(cases / "wall.toml", read_whole(cases / "wall.toml") + "[tolerance]\nchannel = 155\n");
  EXPECT_EQ(cases.check().exit_code, 0);
  cases.update("wall");
  EXPECT_TRUE(read_png(cases / "wall.png").alpha.empty()) << "an update makes it opaque";
}

TEST(CheckGolden, WithAWrongChecksumIsDamaged) {
  const Cases cases({{"wall", std::string(small_case)}});
  cases.update("wall");
  const std::string good = read_whole(cases / "wall.png");
  for (const char* chunk : {"IDAT", "IEND"}) {
    write_whole(cases / "wall.png", with_wrong_crc(good, chunk));
    const Outcome outcome = cases.check();
    EXPECT_EQ(outcome.exit_code, 8) << chunk;
    EXPECT_TRUE(
        contains(outcome.out, "wall.png: cannot be read as a PNG picture: " + std::string(chunk) + ": CRC error"));
    EXPECT_TRUE(contains(outcome.err, "--update wall"));
  }
  cases.update("wall");
  EXPECT_TRUE(read_whole(cases / "wall.png") == good);
}

// Its pixels would take 2.7 GB.
TEST(CheckGolden, OfAnotherSizeIsNotDecoded) {
  const Cases cases({{"wall", std::string(small_case)}});
  write_whole(cases / "wall.png", png_of(30000, 30000, 8, 2, ""));
  const Outcome outcome = cases.check({"--report", cases.beside("report")});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "FAIL wall  the picture has 320x240 pixels, but the golden has 30000x30000"));
  EXPECT_FALSE(fs::exists(cases.beside("report/wall.expected.png")));
  EXPECT_TRUE(fs::exists(cases.beside("report/wall.actual.png")));
  cases.update("wall");
  EXPECT_EQ(cases.check().exit_code, 0);
}

// Whether or not there is a report.
TEST(CheckGolden, OfAnotherSizeMayBeDamagedToo) {
  const Cases cases({{"wall", std::string(small_case)}});
  write_whole(cases / "wall.png", png_of(300, 200, 8, 2, "damaged"));
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--report", cases.beside("report")}}) {
    const Outcome outcome = cases.check(more);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "FAIL wall  the picture has 320x240 pixels, but the golden has 300x200"));
  }
}

TEST(CheckGolden, OfAnotherRendererIsSaidBesideTheDifference) {
  const Cases cases({{"wall", std::string(small_case) + "strategy = \"full\"\n"}});
  cases.update("wall");
  const std::string text = read_whole(cases / "wall.toml");
  const std::size_t mesa = text.find("mesa = ");
  const std::string other = text.substr(0, mesa) + "mesa = \"9.9.9\"" + text.substr(text.find('\n', mesa));
  write_whole(cases / "wall.toml", replaced(other, "full", "naive"));
  const std::string report = cases.beside("report");
  const Outcome outcome = cases.check({"--report", report});
  EXPECT_EQ(outcome.exit_code, 1);
  for (const std::string& words :
       {outcome.err, read_whole(report + "/report.html"), read_whole(report + "/junit.xml")}) {
    EXPECT_TRUE(contains(words, "of 76800 pixels"));
    EXPECT_TRUE(contains(words, "the cause may be another renderer"));
  }
  write_whole(cases / "wall.toml", replaced(other, "240", "241"));
  const Outcome larger = cases.check();
  EXPECT_EQ(larger.exit_code, 1);
  EXPECT_FALSE(contains(larger.err, "renderer")) << "no renderer changes a size";
}

// --- --update and links ----------------------------------------------------------------------------------------------

TEST(CheckUpdate, WritesThroughNoLinkThatLeadsOut) {
  for (const std::string name : {"wall.png", "wall.toml"}) {
    const Cases cases({{"wall", std::string(small_case)}});
    cases.update("wall");
    write_whole(cases / "wall.toml", std::string(small_case) + "strategy = \"full\"\n");
    fs::rename(cases / name, cases.beside(name));
    fs::create_symlink(fs::path("..") / name, cases / name);
    const std::string before = read_whole(cases.beside(name));
    const Outcome outcome = cases.check({"--update", "wall"});
    EXPECT_EQ(outcome.exit_code, 8);
    EXPECT_TRUE(contains(outcome.err, cases / name + " cannot be written: it is a link that leads out of its folder"));
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(read_whole(cases.beside(name)) == before);
    EXPECT_TRUE(fs::is_symlink(cases / name));
  }
}

TEST(CheckUpdate, WritesThroughALinkThatStaysInside) {
  const Cases cases({{"wall", std::string(small_case)}});
  cases.update("wall");
  fs::create_directory(cases / "pictures");
  fs::rename(cases / "wall.png", cases / "pictures/wall.png");
  fs::create_symlink("pictures/wall.png", cases / "wall.png");
  write_whole(cases / "wall.toml", std::string(small_case) + "strategy = \"full\"\n");
  // Wherever the folder itself is reached from.
  fs::create_directory_symlink("cases", cases.beside("link"));
  const Outcome outcome = run_ghostforce({"check", cases.beside("link"), "--update", "wall"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(fs::is_symlink(cases / "wall.png"));
  EXPECT_EQ(cases.check().exit_code, 0);
}

// --- Cases -----------------------------------------------------------------------------------------------------------

TEST(Check, TellsACaseThatCannotBeRead) {
  const Cases cases({{"good", std::string(small_case)}});
  // Nothing lies at the beginning of a process's memory: a true error of reading, EIO.
  fs::create_symlink("/proc/self/mem", cases / "bad.toml");
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_TRUE(contains(outcome.err, cases / "bad.toml cannot be read: Input/output error; check the disk"));
  fs::remove(cases / "bad.toml");
  fs::create_directory(cases / "scenes");
  fs::create_symlink("/proc/self/mem", cases / "scenes/bad.toml");
  write_whole(cases / "good.toml", "scene = \"scenes/bad.toml\"\n");
  const Outcome bad_scene = cases.check();
  EXPECT_EQ(bad_scene.exit_code, 8);
  EXPECT_TRUE(contains(bad_scene.err, "bad.toml: cannot be read: Input/output error; check the disk"));
}

TEST(Check, RefusesACaseThatIsTooLarge) {
  const Cases cases({{"large", std::string(small_case) + std::string((std::size_t{16} << 20) + 1, '#')}});
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "large.toml: is larger than 16 MiB, too large for a case"));
}

TEST(Check, TellsTheFirstOfManyMistakes) {
  std::string many;
  for (int i = 0; i < 1000; ++i) many += fmt::format("key{}=1\n", 9999 - i);
  std::string set = "set = [";
  for (int i = 0; i < 1001; ++i) set += "\"wall.normal_deg=1\", ";
  const Cases cases({{"keys", std::string(small_case) + many}, {"set", std::string(small_case) + set + "]\n"}});
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "keys.toml:4:1: the key key9999 is unknown"));
  EXPECT_TRUE(contains(outcome.err, "… and 980 more"));
  EXPECT_TRUE(contains(outcome.err, "set.toml:4:7: the key set: has 1001 strings; give 1000 at most"));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 22) << outcome.err;
}

// --- Memory ----------------------------------------------------------------------------------------------------------

// The most memory that the program had while it checked these cases [MB].
double peak_memory_mb(const Cases& cases, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{ghostforce_program(), "check", cases.path()};
  words.insert(words.end(), more.begin(), more.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  EXPECT_EQ(wait4(child, &status, 0, &usage), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1) << "there are no goldens";
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

bool can_measure_memory() {
#ifdef GHOSTFORCE_SANITIZED
  return false;
#else
  return true;
#endif
}

// What a case's scene leaves behind takes 3 MB here; fifty more would be 150.
TEST(CheckMemory, DoesNotGrowWithTheNumberOfCases) {
  if (!can_measure_memory()) GTEST_SKIP() << "sanitizers keep what is freed";
  const auto peak = [](int count) {
    std::map<std::string, std::string> texts;
    for (int i = 0; i < count; ++i) {
      texts.emplace(fmt::format("case{:02}", i), fmt::format("{}set = [\"goal.duration_s=10\"]\n", small_case));
    }
    const Cases cases(texts);
    return peak_memory_mb(cases, {"--report", cases.beside("report")});
  };
  const double few = peak(10);
  EXPECT_LT(peak(60), few + 50.0) << few;
}

// A picture takes 9 MB here, and each is wanted again at the very end: twelve more would be 113.
TEST(CheckMemory, DoesNotGrowWithThePicturesThatAreComparedWithEachOther) {
  if (!can_measure_memory()) GTEST_SKIP() << "sanitizers keep what is freed";
  const auto peak = [](int pairs) {
    const std::string text = "scene = \"wall45\"\nsize = [2048, 1536]\npart = \"scene\"\n";
    std::map<std::string, std::string> texts;
    for (int i = 0; i < pairs; ++i) {
      texts.emplace(fmt::format("a{:02}", i), text + fmt::format("match = \"z{:02}\"\n", i));
      texts.emplace(fmt::format("z{:02}", i), text);
    }
    return peak_memory_mb(Cases(texts));
  };
  const double few = peak(4);
  EXPECT_LT(peak(16), few + 70.0) << few;
}

TEST(CheckReport, HoldsThePicturesOfAnyNumberOfCases) {
  std::map<std::string, std::string> texts;
  for (int i = 0; i < 110; ++i) texts.emplace(fmt::format("case{:03}", i), "scene = \"wall45\"\nsize = [64, 64]\n");
  const Cases cases(texts);
  const Outcome outcome = cases.check({"--report", cases.beside("report")});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_EQ(Cases::files_in(cases.beside("report")).size(), 112U);
}

}  // namespace
}  // namespace ghostforce::check_limits_test
