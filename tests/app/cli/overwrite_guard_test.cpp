// What a command reads it does not write over, whatever the file is called and wherever links lead.
#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/scene_file.h"
#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::overwrite_guard_test {
namespace {

namespace fs = std::filesystem;

// A folder with a scene and a run, and an output that leads to one of them by another name.
class OwnInputs : public testing::Test {
 protected:
  OwnInputs() {
    write_whole(folder_ / "scene.toml", scene_text(load_scene("wall45")));
    EXPECT_EQ(run_ghostforce({"simulate", "fig1", "-o", folder_ / "run.csv"}).exit_code, 0);
  }

  // Words are divided by spaces; they run in the folder.
  Outcome in_folder(const std::string& words) {
    ProgramCall call;
    call.words = {"-c", fmt::format("exec {} {}", ghostforce_program(), words)};
    call.folder = folder_.path();
    return run_program("/bin/sh", call);
  }

  void expect_done(const std::string& words) {
    const Outcome outcome = in_folder(words);
    EXPECT_EQ(outcome.exit_code, 0) << words << "\n" << outcome.out << outcome.err;
  }

  void expect_refused(const std::string& words, const std::string& input) {
    SCOPED_TRACE(words);
    const std::string before = read_whole(folder_ / input);
    const std::ptrdiff_t files = folder_.count();
    const Outcome outcome = in_folder(words);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find(input), std::string::npos) << outcome.err;
    EXPECT_TRUE(read_whole(folder_ / input) == before);
    EXPECT_EQ(folder_.count(), files);
  }

  TemporaryFolder folder_;
};

TEST_F(OwnInputs, AreRefusedAsOutputsOfEveryCommand) {
  fs::create_hard_link(folder_ / "run.csv", folder_ / "figure-6.csv");
  fs::create_hard_link(folder_ / "scene.toml", folder_ / "visit.csv");
  for (const std::string_view words :
       {"simulate scene.toml -o scene.toml", "sweep scene.toml --over wall.normal_deg=90:180:3 -o scene.toml",
        "render scene.toml -o scene.toml", "render scene.toml -o picture.png --json scene.toml",
        "replay run.csv scene.toml -o scene.toml", "run scene.toml --record visit.csv", "scene.toml --record visit.csv",
        "equilibrium scene.toml >> scene.toml", "simulate scene.toml >> scene.toml"}) {
    expect_refused(std::string(words), "scene.toml");
  }
  for (const std::string_view words :
       {"replay run.csv -o run.csv", "replay run.csv --set rendering.tracking_ratio=2 -o run.csv",
        "figures --only figure-6 --hand run.csv -o .", "run --input replay:run.csv --record run.csv",
        "measure-user run.csv >> run.csv", "replay run.csv >> run.csv"}) {
    expect_refused(std::string(words), "run.csv");
  }
}

TEST_F(OwnInputs, AreKnownByEveryName) {
  fs::create_symlink("run.csv", folder_ / "link.csv");
  fs::create_symlink(folder_ / "link.csv", folder_ / "long.csv");
  fs::create_hard_link(folder_ / "run.csv", folder_ / "hard.csv");
  fs::create_directory_symlink(".", folder_ / "here");
  for (const std::string_view output : {"./run.csv", "link.csv", "long.csv", "hard.csv", "here/run.csv"}) {
    expect_refused(fmt::format("replay run.csv -o {}", output), "run.csv");
    expect_refused(fmt::format("replay {} -o run.csv", output), "run.csv");
  }
  expect_refused("replay /dev/stdin -o run.csv < run.csv", "run.csv");
  const Outcome outcome = in_folder("replay run.csv -o link.csv");
  EXPECT_EQ(outcome.err,
            "--output link.csv: would overwrite run.csv, which this command reads as RUN; name another file\n");
}

TEST_F(OwnInputs, AreRefusedWhereAReportWouldBe) {
  fs::create_directory(folder_ / "report");
  write_whole(folder_ / "a.toml", "scene = \"wall45\"\n");
  write_whole(folder_ / "a.png", "precious");
  fs::create_symlink("../a.png", folder_ / "report/a.actual.png");
  expect_refused("check . --report report", "a.png");
  fs::remove(folder_ / "report/a.actual.png");
  fs::create_hard_link(folder_ / "a.toml", folder_ / "report/report.html");
  expect_refused("check . --report report", "a.toml");
}

// A scene may be called anything, as what a command writes is.
TEST_F(OwnInputs, AreTheScenesThatACheckShows) {
  fs::create_directory(folder_ / "cases");
  fs::create_directory(folder_ / "report");
  for (const std::string_view scene : {"cases/a.png", "report/a.actual.png", "report/junit.xml"}) {
    SCOPED_TRACE(scene);
    fs::copy_file(folder_ / "scene.toml", folder_ / scene);
    write_whole(folder_ / "cases/a.toml", fmt::format("scene = \"../{}\"\nsize = [320, 240]\n", scene));
    const bool is_golden = scene == "cases/a.png";
    const Outcome outcome = in_folder(is_golden ? "check cases --update a" : "check cases --report report");
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("would be overwritten, but it is what the case a shows"), std::string::npos)
        << outcome.err;
    EXPECT_EQ(read_whole(folder_ / scene), read_whole(folder_ / "scene.toml"));
    fs::remove(folder_ / scene);
  }
}

// What a case shows is read, too; and a link that leads nowhere yet leads two outputs to one file.
TEST_F(OwnInputs, AreNotReachedByLinksInAFolderForOutputs) {
  fs::create_directory(folder_ / "cases");
  fs::create_directory(folder_ / "report");
  write_whole(folder_ / "cases/a.toml", "scene = \"../scene.toml\"\nsize = [320, 240]\n");
  for (const std::string_view name : {"report.html", "junit.xml", "a.actual.png"}) {
    fs::create_symlink("../scene.toml", folder_ / fmt::format("report/{}", name));
    const std::string before = read_whole(folder_ / "scene.toml");
    const Outcome outcome = in_folder("check cases --report report");
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find(" is a link"), std::string::npos) << outcome.err;
    EXPECT_EQ(read_whole(folder_ / "scene.toml"), before);
    fs::remove(folder_ / fmt::format("report/{}", name));
  }
  fs::create_symlink("figure-1.csv", folder_ / "figure-1.pdf");
  const Outcome outcome = in_folder("figures --only figure-1 -o .");
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_FALSE(fs::exists(folder_ / "figure-1.csv"));
}

// Not the scenes that its cases show: what a shell adds to one of those is the shell's doing.
TEST_F(OwnInputs, OfACheckAreItsCasesAndGoldens) {
  fs::create_directory(folder_ / "cases");
  write_whole(folder_ / "cases/a.toml", "scene = \"wall45\"\nsize = [320, 240]\n");
  expect_done("check cases --update a");
  for (const char* const log : {"log.txt", "other.png"}) expect_done(fmt::format("check cases > cases/{}", log));
  expect_refused("check cases >> cases/a.toml", "cases/a.toml");
  expect_refused("check cases >> cases/a.png", "cases/a.png");
}

TEST_F(OwnInputs, AreRefusedToAMeasurement) {
  for (const std::string_view option : {"-o", "--calibration"}) {
    write_whole(folder_ / "firmware.bin", "precious");
    const std::string words = fmt::format(
        "doctor --measure --input virtual-falcon --firmware firmware.bin {} firmware.bin < /dev/null", option);
    expect_refused(words, "firmware.bin");
    const Outcome outcome = in_folder(words);
    EXPECT_NE(outcome.err.find("would overwrite firmware.bin, which this command reads as --firmware"),
              std::string::npos)
        << outcome.err;
  }
}

TEST_F(OwnInputs, TwoOutputsAreTwoFiles) {
  fs::create_directory_symlink(".", folder_ / "here");
  const auto expect_both_refused = [&](const std::string& words) {
    const std::ptrdiff_t files = folder_.count();
    const Outcome outcome = in_folder(words);
    EXPECT_EQ(outcome.exit_code, 2) << words << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find("--output already writes to this file; name another"), std::string::npos) << outcome.err;
    EXPECT_EQ(folder_.count(), files) << words;
  };
  for (const std::string_view other : {"both.png", "./both.png", "here/both.png"}) {
    expect_both_refused(fmt::format("render wall45 -o both.png --json {}", other));
    expect_both_refused(
        fmt::format("doctor --measure --input virtual-falcon -o both.png --calibration {} < /dev/null", other));
  }
  write_whole(folder_ / "both.png", "old");
  expect_both_refused("render wall45 -o both.png --json here/both.png");
  EXPECT_EQ(read_whole(folder_ / "both.png"), "old");
}

TEST_F(OwnInputs, TwoGoldensAreTwoFiles) {
  fs::create_directory(folder_ / "cases");
  write_whole(folder_ / "cases/a.toml", "scene = \"wall45\"\nsize = [320, 240]\n");
  write_whole(folder_ / "cases/b.toml", "scene = \"fig1\"\nsize = [320, 240]\n");
  expect_done("check cases --update a");
  fs::create_symlink("a.png", folder_ / "cases/b.png");
  const std::string before = read_whole(folder_ / "cases/a.png");
  const Outcome outcome = in_folder("check cases --update a b");
  EXPECT_EQ(outcome.exit_code, 8) << outcome.err;
  EXPECT_NE(outcome.err.find("b.png cannot be written: it is a link to the same file as"), std::string::npos)
      << outcome.err;
  EXPECT_TRUE(read_whole(folder_ / "cases/a.png") == before);
}

// What is no file, or another one, is no input.
TEST_F(OwnInputs, NothingElseIsRefused) {
  fs::create_symlink("run.csv", folder_ / "link.csv");
  expect_done("replay link.csv -o again.csv");
  expect_done("replay run.csv -o again.csv");
  expect_done("replay run.csv -o /dev/null");
  expect_done("replay run.csv > other.csv");
  expect_done("simulate wall45 -o wall45");
  expect_done("simulate wall45 -o wall45");  // the shipped scene is no file
  expect_done("figures --only figure-6 --hand run.csv -o .");
  fs::rename(folder_ / "run.csv", folder_ / "figure-1.csv");
  expect_done("figures --only figure-6 --hand figure-1.csv -o .");  // figure 1 is not made
}

}  // namespace
}  // namespace ghostforce::overwrite_guard_test
