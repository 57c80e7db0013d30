// Screenshot regression as its users have it: `ghostforce check` on folders of cases. That it notices what it is for (a
// colour, a marker 2 px off, a missing arrow, another strategy), says it so that a person can act on it, and stays
// quiet where nothing has changed.
#include <sched.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <optional>
#include <ostream>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/check/comparison.h"
#include "app/check/golden_origin.h"
#include "app/check/shell_word.h"
#include "app/paint/label_painter.h"
#include "app/paint/scene_painter.h"
#include "app/panels/style.h"
#include "app/picture.h"
#include "app/png_file.h"
#include "app/scene_file.h"
#include "app/window.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

// Small, so that a picture takes a twentieth of a second.
constexpr std::string_view small_case =
    "scene = \"wall45\"\n"
    "size = [320, 240]\n"
    "part = \"scene\"\n";

class Cases {
 public:
  explicit Cases(const std::map<std::string, std::string>& texts = {}) {
    fs::create_directory(path());
    for (const auto& [name, text] : texts) write_whole(*this / (name + ".toml"), text);
  }

  std::string path() const { return folder_ / "cases"; }
  std::string operator/(std::string_view name) const { return (fs::path(path()) / name).string(); }
  std::string beside(std::string_view name) const { return folder_ / name; }

  Outcome check(const std::vector<std::string>& more = {}) const { return check_with({}, more); }
  Outcome check_with(const std::vector<std::string>& environment, const std::vector<std::string>& more = {}) const {
    ProgramCall call;
    call.words = {"check", path()};
    call.words.insert(call.words.end(), more.begin(), more.end());
    call.environment = environment;
    return run_program(GHOSTFORCE_PROGRAM, call);
  }
  void update(const std::string& name) const {
    const Outcome outcome = check({"--update", name});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }

  // Names of what is in the folder, hidden files too.
  std::set<std::string> files() const { return files_in(path()); }
  static std::set<std::string> files_in(const std::string& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
    return names;
  }

 private:
  TemporaryFolder folder_;
};

testing::AssertionResult contains(const std::string& text, std::string_view piece) {
  if (text.find(piece) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "no '" << piece << "' in:\n" << text;
}

std::string replaced(std::string text, std::string_view piece, std::string_view by) {
  const std::size_t at = text.find(piece);
  EXPECT_NE(at, std::string::npos) << piece;
  return text.replace(at, piece.size(), by);
}

// --- What it notices -------------------------------------------------------------------------------------------------

// The scene's marks as the screen composes them, altered, and painted as the screen paints them.
Image painted(const PictureRequest& request, const std::function<void(Marks&)>& alter) {
  const Moment moment = play_to_moment(request);
  Window window(
      {.title = "", .width = request.width, .height = request.height, .offscreen = true, .takes_mouse = false});
  const auto scale = static_cast<float>(request.look.scale);
  apply_style(*request.look.theme, scale);
  ScenePainter painter;
  for (int i = 0; i < 3; ++i) {
    window.frame(0.0, [&] {
      std::vector<Pane> panes = compose_moment(request, moment, {request.width, request.height}, measure_text);
      for (Pane& pane : panes) alter(pane.marks);
      painter.paint(panes, *request.look.theme, {0.0F, 0.0F}, request.look.scale * request.look.theme->thickness,
                    window.pixel_width(), window.pixel_height());
    });
  }
  return window.picture();
}

template <typename Form>
Form& only_form(Marks& marks, Role role) {
  std::vector<Form*> found;
  for (Mark& mark : marks) {
    if (mark.role != role) continue;
    if (Form* const form = std::get_if<Form>(&mark.form)) found.push_back(form);
  }
  if (found.size() != 1) throw std::logic_error(fmt::format("{} marks of this role and form", found.size()));
  return *found.front();
}

struct Alteration {
  std::string name;
  std::function<void(Marks&)> apply;
  bool is_noticed;
};

void PrintTo(const Alteration& alteration, std::ostream* out) {
  *out << alteration.name;
}

const std::vector<Alteration> alterations{
    {"None", [](Marks&) {}, false},
    {"ColourOfTheDevice",
     [](Marks& marks) {
       std::uint8_t& red = only_form<Marker>(marks, Role::device).fill.red;
       red = static_cast<std::uint8_t>(red + (red < 128 ? 4 : -4));
     },
     true},
    {"DeviceTwoPixelsToTheRight",
     [](Marks& marks) { only_form<Marker>(marks, Role::device).offset += Vector<2>(2.0, 0.0); }, true},
    {"ProxyTwoPixelsDown", [](Marks& marks) { only_form<Marker>(marks, Role::proxy).offset += Vector<2>(0.0, 2.0); },
     true},
    {"NoGhostForceArrow",
     [](Marks& marks) {
       const auto is_arrow = [](const Mark& mark) {
         return mark.role == Role::ghost_force && std::holds_alternative<Arrow>(mark.form);
       };
       if (std::erase_if(marks, is_arrow) != 1) throw std::logic_error("one ghost force arrow was expected");
     },
     true},
};

class Notices : public testing::TestWithParam<Alteration> {};

// Without a tolerance, and with the one that docs/check.md advises for runs on several machines.
TEST_P(Notices, WhatIsDrawnOtherwise) {
  PictureRequest request;
  request.scene = load_scene("wall45");
  apply_strategy_word("naive", request);
  request.width = 640;
  request.height = 480;
  request.part = Part::scene;
  const std::string golden = png_bytes(painted(request, GetParam().apply));
  const std::string text = "scene = \"wall45\"\nstrategy = \"naive\"\nsize = [640, 480]\npart = \"scene\"\n";
  const Cases cases({{"exact", text}, {"tolerant", text + "[tolerance]\nchannel = 2\nshare = 0.0001\n"}});
  write_whole(cases / "exact.png", golden);
  write_whole(cases / "tolerant.png", golden);
  const Outcome outcome = cases.check();
  const std::string word = GetParam().is_noticed ? "FAIL" : "pass";
  EXPECT_EQ(outcome.exit_code, GetParam().is_noticed ? 1 : 0);
  EXPECT_TRUE(contains(outcome.out, word + " exact"));
  EXPECT_TRUE(contains(outcome.out, word + " tolerant"));
}

INSTANTIATE_TEST_SUITE_P(, Notices, testing::ValuesIn(alterations),
                         [](const auto& alteration) { return alteration.param.name; });

TEST(Check, NoticesAnotherStrategy) {
  const Cases cases({{"wall", std::string(small_case) + "strategy = \"naive\"\n"}});
  cases.update("wall");
  ASSERT_EQ(cases.check().exit_code, 0);
  for (const char* other : {"full", "anisotropic", "all"}) {
    const std::string text = read_whole(cases / "wall.toml");
    write_whole(cases / "wall.toml", replaced(text, "naive", other));
    const Outcome outcome = cases.check();
    EXPECT_EQ(outcome.exit_code, 1) << other;
    EXPECT_TRUE(contains(outcome.out, "FAIL wall"));
    write_whole(cases / "wall.toml", text);
  }
}

// --- The same every time ---------------------------------------------------------------------------------------------

std::map<std::string, std::string> varied_cases() {
  return {{"window", "scene = \"wall45\"\nsize = [640, 480]\ntheme = \"dark\"\n"},
          {"fig1", "scene = \"fig1\"\nsize = [320, 240]\npart = \"scene\"\nstrategy = \"all\"\nat_s = 0.8\n"},
          {"panes",
           "scene = \"wall45\"\nsize = [600, 240]\ncompare = \"side-by-side\"\nscale = 0.75\n"
           "theme = \"projector\"\nset = [\"wall.normal_deg=120\", \"rendering.strategy=full\"]\n"}};
}

TEST(Check, DrawsWhatRenderDraws) {
  const Cases cases(varied_cases());
  // One window after another in one process, against a process each.
  const std::map<std::string, std::vector<std::string>> renders{
      {"window", {"wall45", "--size", "640x480", "--theme", "dark"}},
      {"fig1", {"fig1", "--size", "320x240", "--part", "scene", "--strategy", "all", "--at", "0.8"}},
      {"panes",
       {"wall45", "--size", "600x240", "--compare", "side-by-side", "--scale", "0.75", "--theme", "projector", "--set",
        "wall.normal_deg=120", "--set", "rendering.strategy=full"}}};
  for (const auto& [name, words] : renders) {
    std::vector<std::string> call{"render", "-o", cases / (name + ".png")};
    call.insert(call.end(), words.begin(), words.end());
    ASSERT_EQ(run_program(GHOSTFORCE_PROGRAM, call).exit_code, 0);
  }
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "pass fig1\npass panes\npass window\n3 cases, 0 failed\n");
  EXPECT_EQ(outcome.err, "");
}

// A container may have any of a machine's processors, and number 0 not among them.
std::size_t an_allowed_processor() {
  cpu_set_t allowed;
  EXPECT_EQ(sched_getaffinity(0, sizeof allowed, &allowed), 0);
  std::size_t processor = 0;
  while (processor < CPU_SETSIZE - 1 && !CPU_ISSET(processor, &allowed)) ++processor;
  return processor;
}

TEST(Check, PassesAgainWhereverAndHoweverItRuns) {
  const Cases cases(varied_cases());
  ASSERT_EQ(cases.check({"--update", "window", "fig1", "panes"}).exit_code, 0);
  for (const std::string variable : {"TWICE=1", "LC_ALL=C", "LC_ALL=C.UTF-8", "LC_ALL=xx_BOGUS.wrong",
                                     "LP_NUM_THREADS=1", "LP_NUM_THREADS=0", "TZ=Pacific/Chatham"}) {
    const Outcome outcome = cases.check_with({variable});
    EXPECT_EQ(outcome.exit_code, 0) << variable << '\n' << outcome.out << outcome.err;
  }
  for (const auto& [from, folder] : std::vector<std::pair<std::string, std::string>>{
           {cases.beside(""), "cases"}, {cases.beside(""), "./cases/"}, {cases.path(), "."}, {"/", cases.path()}}) {
    ProgramCall call;
    call.words = {"check", folder};
    call.folder = from;
    const Outcome outcome = run_program(GHOSTFORCE_PROGRAM, call);
    EXPECT_EQ(outcome.exit_code, 0) << folder << '\n' << outcome.out << outcome.err;
  }
  if (fs::exists("/usr/bin/taskset")) {
    const std::string processor = std::to_string(an_allowed_processor());
    const Outcome outcome =
        run_program("/usr/bin/taskset", {"-c", processor, GHOSTFORCE_PROGRAM, "check", cases.path()});
    EXPECT_EQ(outcome.exit_code, 0) << "on processor " << processor << '\n' << outcome.out << outcome.err;
  }
}

TEST(Check, RunsBesideItself) {
  const Cases cases(varied_cases());
  const auto at_once = [&](const std::vector<std::string>& more, int exit_code) {
    std::vector<std::future<Outcome>> runs;
    for (int i = 0; i < 3; ++i) runs.push_back(std::async(std::launch::async, [&] { return cases.check(more); }));
    for (std::future<Outcome>& run : runs) {
      const Outcome outcome = run.get();
      EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    }
  };
  const std::string report = cases.beside("report");
  at_once({"--report", report}, 1);
  at_once({"--update", "window", "fig1", "panes"}, 0);
  at_once({"--report", report}, 0);
  EXPECT_EQ(cases.files().size(), 6U) << "three cases, three goldens";
  EXPECT_EQ(Cases::files_in(report), (std::set<std::string>{"report.html", "junit.xml"}));
}

// --- Goldens ---------------------------------------------------------------------------------------------------------

TEST(Check, SaysWithWhichCommandAGoldenComesToBe) {
  const Cases cases({{"it's new", std::string(small_case)}});
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.out, "FAIL it's new  there is no golden"));
  EXPECT_TRUE(contains(outcome.out, "1 cases, 1 failed\n"));
  const std::string command = fmt::format("check {} --update 'it'\\''s new'", cases.path());
  ASSERT_TRUE(contains(outcome.err, "ghostforce " + command));
  // By a shell, as the person does it.
  EXPECT_EQ(run_program("/bin/sh", {"-c", GHOSTFORCE_PROGRAM " " + command}).exit_code, 0);
  EXPECT_EQ(cases.check().exit_code, 0);
}

TEST(Check, TellsNumbersAndPlaceOfADifference) {
  const Cases cases({{"wall", std::string(small_case)}});
  cases.update("wall");
  Image golden = read_png(cases / "wall.png");
  // 3 x 2 pixels at (10, 20), one of them by 77.
  for (const int y : {20, 21}) {
    for (const int x : {10, 11, 12}) {
      std::uint8_t& green = golden.rgb[static_cast<std::size_t>(3 * (y * golden.width + x) + 1)];
      green = static_cast<std::uint8_t>(green - (x == 11 ? 77 : 5));
    }
  }
  write_whole(cases / "wall.png", png_bytes(golden));
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.out,
                       "6 of 76800 pixels (0.00781 %) differ by up to 77, all of them in 3x2 pixels at "
                       "x 10, y 20"));
  EXPECT_FALSE(contains(outcome.err, "renderer"));

  // 6 of 76800 is a share of 7.8125e-5, and the 2 pixels that differ by more than 5 are one of 2.604e-5.
  const std::string text = read_whole(cases / "wall.toml");
  for (const auto& [tolerance, exit_code] : std::vector<std::pair<std::string, int>>{{"share = 7.8125e-5", 0},
                                                                                     {"share = 7.8124e-5", 1},
                                                                                     {"channel = 77", 0},
                                                                                     {"channel = 76", 1},
                                                                                     {"channel = 5\nshare = 2.7e-5", 0},
                                                                                     {"channel = 5\nshare = 2.6e-5", 1},
                                                                                     {"channel = 4\nshare = 2.7e-5", 1},
                                                                                     {"share = 1", 0},
                                                                                     {"channel = 255", 0}}) {
    write_whole(cases / "wall.toml", text + "[tolerance]\n" + tolerance + "\n");
    EXPECT_EQ(cases.check().exit_code, exit_code) << tolerance;
  }
}

TEST(Check, FailsWhereTheSizeDiffers) {
  const Cases cases({{"wall", std::string(small_case) + "[tolerance]\nchannel = 255\nshare = 1.0\n"}});
  cases.update("wall");
  write_whole(cases / "wall.toml", replaced(read_whole(cases / "wall.toml"), "240", "241"));
  const Outcome outcome = cases.check({"--report", cases.beside("report")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.out, "320x241 pixels and the golden 320x240"));
  EXPECT_EQ(read_png(cases.beside("report/wall.diff.png")).height, 241);
}

TEST(Check, SaysThatAnotherRendererIsTheProbableCause) {
  const Cases cases({{"wall", std::string(small_case)}});
  cases.update("wall");
  const std::string text = read_whole(cases / "wall.toml");
  const std::string other = std::regex_replace(text, std::regex("mesa = .*"), "mesa = \"9.9.9\"");
  write_whole(cases / "wall.toml", other);
  EXPECT_EQ(cases.check().exit_code, 0) << "what is equal passes, whoever drew it";
  write_whole(cases / "wall.toml", "strategy = \"full\"\n" + other);
  const Outcome outcome = cases.check({"--report", cases.beside("report")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "another renderer is probably the cause: the golden was drawn by"));
  EXPECT_TRUE(contains(outcome.err, "Mesa 9.9.9, this picture by"));
  EXPECT_TRUE(contains(read_whole(cases.beside("report/report.html")), "another renderer is probably the cause"));
  EXPECT_TRUE(contains(read_whole(cases.beside("report/junit.xml")), "another renderer is probably the cause"));
}

TEST(Check, ReportsAGoldenThatIsNoPictureAndGoesOn) {
  const Cases cases({{"a", std::string(small_case)}, {"b", std::string(small_case)}});
  write_whole(cases / "a.png", "version https://git-lfs.github.com/spec/v1\n");
  cases.update("b");
  const Outcome outcome = cases.check({"--report", cases.beside("report")});
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_TRUE(contains(outcome.out, "FAIL a"));
  EXPECT_TRUE(contains(outcome.out, "pass b\n2 cases, 1 failed\n"));
  cases.update("a");
  EXPECT_EQ(cases.check().exit_code, 0);
}

// Each of them once held the check up, or got a remedy that failed.
TEST(Check, SaysWhatAGoldenIsThatIsNoFile) {
  const Cases cases({{"folder", std::string(small_case)},
                     {"good", std::string(small_case)},
                     {"link", std::string(small_case)},
                     {"loop", std::string(small_case)},
                     {"pipe", std::string(small_case)}});
  cases.update("good");
  fs::create_directory(cases / "folder.png");
  fs::create_symlink("nothing.png", cases / "link.png");
  fs::create_symlink("loop.png", cases / "loop.png");
  ASSERT_EQ(mkfifo((cases / "pipe.png").c_str(), 0600), 0);
  const Outcome checked = cases.check({"--report", cases.beside("report")});
  EXPECT_EQ(checked.exit_code, 8);
  EXPECT_TRUE(contains(checked.out, "pass good"));
  EXPECT_TRUE(contains(checked.out, "5 cases, 4 failed"));
  EXPECT_EQ(checked.err.find("--update"), std::string::npos) << checked.err;
  const Outcome updated = cases.check({"--update", "folder", "link", "loop", "pipe"});
  EXPECT_EQ(updated.exit_code, 8);
  EXPECT_EQ(updated.out, "");
  for (const auto& [name, words] : std::map<std::string, std::string>{{"folder", "is a folder"},
                                                                      {"link", "is a link that leads nowhere"},
                                                                      {"loop", "is a link that leads nowhere"},
                                                                      {"pipe", "is a pipe"}}) {
    EXPECT_TRUE(contains(checked.err, fmt::format("the golden {} {}", cases / (name + ".png"), words)));
    EXPECT_TRUE(contains(updated.err, fmt::format("{} cannot be written: it {}", cases / (name + ".png"), words)));
    EXPECT_EQ(read_whole(cases / (name + ".toml")), small_case);
    fs::remove(cases / (name + ".png"));
  }
  EXPECT_EQ(cases.check({"--update", "folder", "link", "loop", "pipe"}).exit_code, 0) << "as it was advised";
}

TEST(Check, TakesALinkToAFileForTheFile) {
  const Cases cases({{"wall", std::string(small_case)}});
  cases.update("wall");
  for (const char* name : {"wall.png", "wall.toml"}) {
    fs::rename(cases / name, cases.beside(name));
    fs::create_symlink(fs::path("..") / name, cases / name);
  }
  EXPECT_EQ(cases.check().exit_code, 0);
}

// --- --update --------------------------------------------------------------------------------------------------------

TEST(CheckUpdate, KeepsEveryByteOfTheRestOfTheCase) {
  struct Edit {
    std::string before;
    std::string after;  // {} stands for the table's three values
  };
  const std::string head = "# Ünlaut \xE2\x86\x92 comment\n  scene = \"wall45\" # why\nsize=[320,240]\n";
  for (const std::string newline : {"\n", "\r\n"}) {
    for (const Edit& edit : std::vector<Edit>{
             {head, head + "\n[golden]\nrenderer = R\nmesa = M\nversion = V\n"},
             {head + "part='scene'  # no newline",
              head + "part='scene'  # no newline\n\n[golden]\nrenderer = R\nmesa = M\nversion = V\n"},
             {head + "[golden] # mine\n mesa='1'#x\n# y\nrenderer = \"\\\"ü\\\"\"  # z\nversion =\"0\"\n\n# "
                     "end\n[tolerance]\nshare=0.5\n",
              head +
                  "[golden] # mine\n mesa=M#x\n# y\nrenderer = R  # z\nversion =V\n\n# end\n[tolerance]\nshare=0.5\n"},
             {head + "[golden]\nmesa = '1'\n[tolerance]\n# nothing",
              head + "[golden]\nrenderer = R\nversion = V\nmesa = M\n[tolerance]\n# nothing"},
             {head + "[golden]", head + "[golden]\nrenderer = R\nmesa = M\nversion = V\n"},
             {head + "golden.renderer='a'\ngolden.mesa = 'b'\ngolden.version='c'\n",
              head + "golden.renderer=R\ngolden.mesa = M\ngolden.version=V\n"}}) {
      const auto with_newlines = [&](const std::string& text) {
        return std::regex_replace(text, std::regex("\n"), newline);
      };
      const auto with_values = [](std::string text, const GoldenOrigin& origin) {
        text = std::regex_replace(text, std::regex("([=] ?)R"), "$1\"" + origin.renderer + "\"");
        text = std::regex_replace(text, std::regex("([=] ?)M"), "$1\"" + origin.mesa + "\"");
        return std::regex_replace(text, std::regex("([=] ?)V"), "$1\"" + origin.version + "\"");
      };
      const GoldenOrigin origin{"softpipe", "22.3.6", "7.7"};
      // A newline where the table had none is the one that the file uses elsewhere.
      EXPECT_EQ(with_origin(with_newlines(edit.before), origin, "f.toml"),
                with_newlines(with_values(edit.after, origin)));
    }
  }
}

TEST(CheckUpdate, WritesWhereTheGoldenCameFromAndNothingElse) {
  const std::string before = "# keep me\r\n" + std::string(small_case) + "# and me\n[tolerance] # too\nchannel = 1\n";
  const Cases cases({{"a", before}, {"b", before}});
  const Outcome outcome = cases.check({"--update", "a"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(contains(outcome.out, "wrote " + cases / "a.png"));
  EXPECT_TRUE(contains(outcome.out, "look at it before you commit it"));
  EXPECT_EQ(cases.files(), (std::set<std::string>{"a.toml", "a.png", "b.toml"}));
  EXPECT_EQ(read_whole(cases / "b.toml"), before);
  const std::string after = read_whole(cases / "a.toml");
  EXPECT_TRUE(after.starts_with(before));
  EXPECT_TRUE(contains(after, "renderer = \"llvmpipe"));
  EXPECT_TRUE(contains(after, "mesa = \""));
  EXPECT_TRUE(contains(after, "version = \"" GHOSTFORCE_VERSION "\""));
  EXPECT_FALSE(contains(after, "bits")) << "the width of the vectors changes no pixel";
}

TEST(CheckUpdate, LeavesWhatIsEqualUntouched) {
  const Cases cases({{"wall", std::string(small_case)}});
  cases.update("wall");
  const auto golden_time = fs::last_write_time(cases / "wall.png");
  const auto case_time = fs::last_write_time(cases / "wall.toml");
  const Outcome outcome = cases.check({"--update", "wall"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(contains(outcome.out, "stays as it is"));
  EXPECT_EQ(fs::last_write_time(cases / "wall.png"), golden_time);
  EXPECT_EQ(fs::last_write_time(cases / "wall.toml"), case_time);
}

TEST(CheckUpdate, RefusesWhatHasNoGolden) {
  const Cases cases({{"a", std::string(small_case)}, {"b", std::string(small_case) + "match = \"a\"\n"}});
  const Outcome outcome = cases.check({"--update", "a", "b"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, cases / "b.toml:4:9: b has no golden"));
  EXPECT_EQ(cases.files().size(), 2U) << "nothing was written for the other either";
}

TEST(CheckUpdate, RefusesAnInlineTableThatLacksAKey) {
  const Cases cases({{"a", std::string(small_case) + "golden = { mesa = \"1\" }\n"}});
  const Outcome outcome = cases.check({"--update", "a"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "remove it"));
  EXPECT_EQ(cases.files().size(), 1U);
}

TEST(CheckUpdate, SaysWhereItCannotWrite) {
  const Cases cases({{"wall", std::string(small_case)}});
  fs::create_directory(cases / "wall.png");
  const Outcome outcome = cases.check({"--update", "wall"});
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_TRUE(contains(outcome.err, "wall.png cannot be written"));
  EXPECT_EQ(read_whole(cases / "wall.toml"), small_case);
}

TEST(CheckUpdate, SaysWhereTheFolderMayOnlyBeRead) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  const Cases cases({{"wall", std::string(small_case)}, {"same", std::string(small_case) + "match = \"wall\"\n"}});
  fs::permissions(cases.path(), fs::perms::owner_read | fs::perms::owner_exec);
  const Outcome updated = cases.check({"--update", "wall"});
  const Outcome checked = cases.check({"--only", "same"});
  fs::permissions(cases.path(), fs::perms::owner_all);
  EXPECT_EQ(updated.exit_code, 8);
  EXPECT_TRUE(contains(updated.err, "wall.png cannot be written: Permission denied"));
  EXPECT_EQ(checked.exit_code, 0);
  EXPECT_EQ(cases.files().size(), 2U);
}

// --- match and mismatch ----------------------------------------------------------------------------------------------

TEST(CheckMatch, ComparesWithAnotherCasesPicture) {
  const std::string text(small_case);
  const Cases cases({{"a", text + "mismatch = \"c\"\n"},
                     {"b", text + "set = [\"rendering.strategy=naive\"]\nmatch = \"a\"\n"},
                     {"c", text + "strategy = \"full\"\nmismatch = \"b\"\n"}});
  EXPECT_EQ(cases.check().out, "pass a\npass b\npass c\n3 cases, 0 failed\n") << "also when they name each other";
  EXPECT_EQ(cases.files().size(), 3U);
  EXPECT_EQ(cases.check({"--only", "b"}).out, "pass b\n1 cases, 0 failed\n");

  write_whole(cases / "b.toml", text + "match = \"c\"\n");
  write_whole(cases / "a.toml", text + "mismatch = \"b\"\n");
  const Outcome outcome = cases.check({"--report", cases.beside("report")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(
      contains(outcome.out, "FAIL a  against the picture of b, which it must not be equal to: no pixel differs"));
  EXPECT_TRUE(contains(outcome.out, "FAIL b  against the picture of c, which it must be equal to: "));
  EXPECT_TRUE(contains(outcome.out, "pass c\n3 cases, 2 failed"));
  EXPECT_FALSE(contains(outcome.err, "--update")) << "there is nothing to update";
  EXPECT_TRUE(fs::exists(cases.beside("report/b.diff.png")));
}

TEST(CheckMatch, TakesTheToleranceIntoAccount) {
  const std::string text(small_case);
  const std::string tolerance = "[tolerance]\nshare = 0.9\n";
  const Cases cases({{"a", text + "strategy = \"full\"\nmatch = \"b\"\n" + tolerance},
                     {"b", text + "strategy = \"naive\"\nmismatch = \"a\"\n" + tolerance}});
  const Outcome outcome = cases.check();
  EXPECT_TRUE(contains(outcome.out, "pass a\nFAIL b"));
}

// --- Reports ---------------------------------------------------------------------------------------------------------

// Each tag is closed in its turn, each attribute quoted, each & the beginning of an entity.
testing::AssertionResult is_well_formed(const std::string& text) {
  static const std::regex piece(
      "<(\\?xml [^?<>]*\\?|!DOCTYPE html|/?[a-z][a-z0-9]*(?: "
      "[a-z]+=\"[^\"<]*\")*/?)>|&(amp|lt|gt|quot|#39|#9|#10|#13);|[^<&]+|.");
  static const std::set<std::string> never_closed{"meta", "img"};
  std::vector<std::string> open;
  for (std::sregex_iterator at(text.begin(), text.end(), piece), end; at != end; ++at) {
    const std::string whole = at->str();
    if (whole == "<" || whole == "&") return testing::AssertionFailure() << "a bare " << whole << " in:\n" << text;
    const std::string tag = (*at)[1];
    if (tag.empty() || tag[0] == '?' || tag[0] == '!' || tag.back() == '/') continue;
    const std::string name = tag.substr(tag[0] == '/' ? 1 : 0, tag.find(' ') - (tag[0] == '/' ? 1 : 0));
    if (never_closed.contains(name)) continue;
    if (tag[0] != '/') {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return testing::AssertionFailure() << whole << " closes nothing in:\n" << text;
    } else {
      open.pop_back();
    }
  }
  if (!open.empty()) return testing::AssertionFailure() << open.back() << " stays open in:\n" << text;
  return testing::AssertionSuccess();
}

std::string percent_decoded(std::string_view link) {
  std::string name;
  for (std::size_t i = 0; i < link.size(); ++i) {
    if (link[i] == '%') {
      name += static_cast<char>(std::stoi(std::string(link.substr(i + 1, 2)), nullptr, 16));
      i += 2;
    } else {
      name += link[i];
    }
  }
  return name;
}

TEST(CheckReport, ShowsFailuresAsFilesForPeopleAndMachines) {
  const std::string odd = "a <b> & \"c\" #1 %41 \xC3\xBC \xFF";  // the last is no UTF-8
  const Cases cases({{odd, std::string(small_case)}, {"good", std::string(small_case)}});
  ASSERT_EQ(cases.check({"--update", odd, "good"}).exit_code, 0);
  write_whole(cases / (odd + ".toml"), std::string(small_case) + "strategy = \"full\"\n");
  const std::string report = cases.beside("deep/report");
  const Outcome outcome = cases.check({"--report", report});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(Cases::files_in(report), (std::set<std::string>{odd + ".expected.png", odd + ".actual.png",
                                                            odd + ".diff.png", "report.html", "junit.xml"}));
  EXPECT_EQ(read_whole(report + "/" + odd + ".expected.png"), read_whole(cases / (odd + ".png")));

  const std::string html = read_whole(report + "/report.html");
  EXPECT_TRUE(is_well_formed(html));
  const std::regex link("(?:src|href)=\"([^#][^\"]*)\"");
  int links = 0;
  for (std::sregex_iterator at(html.begin(), html.end(), link), end; at != end; ++at, ++links) {
    EXPECT_TRUE(fs::exists(fs::path(report) / percent_decoded((*at)[1].str()))) << (*at)[1];
  }
  EXPECT_EQ(links, 6) << "three pictures, each shown and linked";
  EXPECT_TRUE(contains(html, "a &lt;b&gt; &amp; &quot;c&quot; #1 %41 \xC3\xBC \xEF\xBF\xBD"));
  EXPECT_TRUE(contains(html, "good"));

  const std::string junit = read_whole(report + "/junit.xml");
  EXPECT_TRUE(is_well_formed(junit));
  EXPECT_TRUE(contains(junit, "tests=\"2\" failures=\"1\""));
  EXPECT_TRUE(std::regex_search(junit, std::regex("name=\"good\" time=\"[0-9.]+\"/>")));
  EXPECT_TRUE(std::regex_search(junit, std::regex("<failure type=\"picture\" message=\"[0-9]+ of 76800 pixels")));
}

TEST(CheckReport, MarksWhatDiffersInADifferencePicture) {
  Image a{20, 10, std::vector<std::uint8_t>(600, 100)};
  Image b = a;
  b.rgb[3U * (5 * 20 + 10)] = 130;  // (10, 5), over
  b.rgb[3U * (1 * 20 + 18)] = 102;  // (18, 1), within
  const Image picture = difference_picture(a, b, {.channel = 2});
  const auto pixel = [&](int x, int y) {
    const auto at = picture.rgb.begin() + 3 * (y * 20 + x);
    return std::vector<int>(at, at + 3);
  };
  EXPECT_EQ(pixel(10, 5), (std::vector<int>{255, 0, 190}));
  EXPECT_EQ(pixel(18, 1), (std::vector<int>{255, 165, 0}));
  EXPECT_EQ(pixel(0, 0), (std::vector<int>{224, 224, 224}));
  EXPECT_EQ(pixel(5, 5), (std::vector<int>{0, 90, 255})) << "the frame, five pixels away";
}

TEST(CheckReport, IsWrittenWhenAllPassesAndDeletesNothing) {
  const Cases cases({{"wall", std::string(small_case)}});
  cases.update("wall");
  const std::string report = cases.beside("report");
  fs::create_directory(report);
  write_whole(report + "/notes.txt", "mine");
  EXPECT_EQ(cases.check({"--report", report}).exit_code, 0);
  EXPECT_EQ(Cases::files_in(report), (std::set<std::string>{"notes.txt", "report.html", "junit.xml"}));
  EXPECT_TRUE(is_well_formed(read_whole(report + "/report.html")));
  EXPECT_TRUE(contains(read_whole(report + "/junit.xml"), "failures=\"0\""));
}

TEST(CheckReport, KeepsNoPicturesOfAFailureThatIsOver) {
  const Cases cases({{"other", std::string(small_case)}, {"wall", std::string(small_case)}});
  ASSERT_EQ(cases.check({"--update", "other", "wall"}).exit_code, 0);
  for (const char* name : {"other.toml", "wall.toml"}) {
    write_whole(cases / name, "strategy = \"full\"\n" + read_whole(cases / name));
  }
  const std::string report = cases.beside("report");
  ASSERT_EQ(cases.check({"--report", report}).exit_code, 1);
  ASSERT_EQ(Cases::files_in(report).size(), 8U);
  write_whole(report + "/wall.notes.png", "mine");
  write_whole(report + "/wal.diff.png", "mine");
  cases.update("wall");
  EXPECT_EQ(cases.check({"--only", "wall", "--report", report}).exit_code, 0);
  EXPECT_EQ(Cases::files_in(report),
            (std::set<std::string>{"other.expected.png", "other.actual.png", "other.diff.png", "wall.notes.png",
                                   "wal.diff.png", "report.html", "junit.xml"}))
      << "nothing is known of the other case now";
}

TEST(CheckReport, IsRefusedWhereItCannotBe) {
  const Cases cases({{"wall", std::string(small_case)}});
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--report", ""}, {"--report="}}) {
    const Outcome nowhere = cases.check(words);
    EXPECT_EQ(nowhere.exit_code, 2) << words[0];
    EXPECT_TRUE(contains(nowhere.err, "--report"));
    EXPECT_EQ(nowhere.out, "");
  }
  EXPECT_EQ(cases.check({"--report", "/proc/nothing/report"}).exit_code, 8);
  EXPECT_EQ(cases.check({"--report", cases / "wall.toml"}).exit_code, 8);
  const Outcome outcome = cases.check({"--report", cases.path()});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "the cases are there"));
  EXPECT_EQ(cases.files().size(), 1U);
}

// --- Wrong calls -----------------------------------------------------------------------------------------------------

TEST(Check, TellsAllThatIsWrongWithAllCasesBeforeItDraws) {
  const Cases cases({
      {"a", "scene = \"wal45\"\n"},
      {"b", "scene = \"wall45\"\nstratgy = \"naive\"\n[tolerance]\nshares = 0.5\n"},
      {"c",
       "scene = 5\nat_s = \"3\"\nsize = [1280, 63]\npart = \"windw\"\nstrategy = \"naiv\"\ntheme = \"drak\"\n"
       "compare = \"overlai\"\nscale = 5\nset = [\"wall.normal_de=120\", \"wall.normal_deg=x\"]\n"},
      {"d", "scene = \"wall45\"\nmatch = \"aa\"\nmismatch = \"b\"\n[tolerance]\nchannel = 256\nshare = nan\n"},
      {"e", "scene = \"wall45\"\nmatch = \"e\"\n"},
      {"f", "scene = \"wall45\"\nsize = 5\nset = \"x\"\n[golden]\nmesa = 22\n"},
      {"g", "scene = \"wall45\"\nat_s = 20000\nset = [\"wall.normal_de=120\"]\n[tolerance]\ntheme = \"dark\"\n"},
      {"h", ""},
      {"i", "scene = \n"},
      {"j", "scene = \"wall45\"\nmatch = \"b\"\nsize = [100, 100]\n[golden]\n"},
      {"k", "scene = \"wall45\"\nat_s = 20000\nchannel = 3\nsize = [1.5, 100]\n"},
      {"l", "scene = \"broken.scene\"\n"},
  });
  write_whole(cases / "broken.scene", "format = 1\n");
  const Outcome outcome = cases.check({"--report", cases.beside("report")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  for (const std::string words : {"a.toml:1:9: the key scene: no scene named",
                                  "did you mean 'wall45'?",
                                  "b.toml:2:1: the key stratgy is unknown; did you mean 'strategy'?",
                                  "b.toml:4:1: the key tolerance.shares is unknown; did you mean 'share'?",
                                  "c.toml:1:9: the key scene: is a number; give a text in quotes",
                                  "c.toml:2:8: the key at_s: is a text; give 0 to",
                                  "c.toml:3:15: the key size: 63 is out of range; give a whole number, 64 to 4096",
                                  "c.toml:4:8: the key part: 'windw' is none of window, scene; did you mean 'window'?",
                                  "c.toml:5:12: the key strategy: 'naiv' is none of",
                                  "c.toml:6:9: the key theme: 'drak' is none of",
                                  "c.toml:7:11: the key compare: 'overlai'",
                                  "c.toml:8:9: the key scale: 5 is out of range; give 0.75 to 3",
                                  "d.toml:2:9: the key match: there is no case 'aa'",
                                  "d.toml:3:12: the key mismatch: there is the key match too",
                                  "d.toml:5:11: the key tolerance.channel: 256 is out of range",
                                  "d.toml:6:9: the key tolerance.share: nan",
                                  "e.toml:2:9: the key match: names this case itself",
                                  "f.toml:2:8: the key size: is a number; give [width",
                                  "f.toml:3:7: the key set: is a text; give texts",
                                  "f.toml:5:8: the key golden.mesa: is a number",
                                  "g.toml:3:8: the key set: wall.normal_de=120: ",
                                  "did you mean 'theme'? It stands before the first [table]",
                                  "h.toml:1:1: the key scene is missing",
                                  "i.toml:1:",
                                  "j.toml:4:1: the table [golden]: with the key match",
                                  "j.toml:2:9: the key match: this picture has 100x100 pixels and that of 'b' 1280x800",
                                  "k.toml:2:8: the key at_s: 20000 s is out of range",
                                  "k.toml:3:1: the key channel is unknown; did you mean "
                                  "'tolerance.channel'?",
                                  "k.toml:4:9: the key size: has a decimal point",
                                  "l.toml:1:9: the key scene: "}) {
    EXPECT_TRUE(contains(outcome.err, words));
  }
  EXPECT_FALSE(fs::exists(cases.beside("report")));
}

TEST(Check, TellsASceneFromACase) {
  const Cases cases({{"good", std::string(small_case)},
                     {"half", "[wall]\nnormal_deg = 90\n"},
                     {"mine", read_whole(GHOSTFORCE_SCENES "/wall45.toml")},
                     {"mixed", "format = 1\n" + std::string(small_case)}});
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 2);
  for (const char* name : {"half", "mine"}) {
    EXPECT_TRUE(contains(outcome.err, fmt::format("{}.toml:1:1: this is a scene, not a case; put scenes into a "
                                                  "subfolder, and name them as in scene = \"scenes/{}.toml\"\n",
                                                  name, name)));
  }
  EXPECT_TRUE(contains(outcome.err, "mixed.toml:1:1: the key format is unknown")) << "it names a scene: a case";
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 3) << outcome.err;
}

TEST(Check, SaysWhatACaseIsThatIsNoFile) {
  const Cases cases({{"good", std::string(small_case)}});
  fs::create_directory(cases / "folder.toml");
  fs::create_symlink("nothing.toml", cases / "link.toml");
  ASSERT_EQ(mkfifo((cases / "pipe.toml").c_str(), 0600), 0);
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "folder.toml: is a folder, and a case is a file; rename it, or remove it"));
  EXPECT_TRUE(contains(outcome.err, "link.toml: is a link that leads nowhere"));
  EXPECT_TRUE(contains(outcome.err, "pipe.toml: is a pipe"));
}

TEST(Check, NamesASceneAsThePersonWroteIt) {
  const Cases cases({{"a", "scene = \"wall46\"\n"},
                     {"b", "scene = \"scenes/mien.toml\"\n"},
                     {"c", "scene = \"scenes/wall46.toml\"\n"},
                     {"d", "scene = \"something else\"\n"},
                     {"wall46x", std::string(small_case)}});
  fs::create_directory(cases / "scenes");
  write_whole(cases / "scenes/mine.toml", "");
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 2);
  for (const char* words : {"a.toml:1:9: the key scene: no scene named 'wall46'; did you mean 'wall45'?\n",
                            "b.toml:1:9: the key scene: no scene named 'scenes/mien.toml'; did you mean "
                            "'scenes/mine.toml'?\n",
                            "c.toml:1:9: the key scene: no scene named 'scenes/wall46.toml'; did you mean 'wall45'?\n",
                            "d.toml:1:9: the key scene: no scene named 'something else'; give a path relative to this "
                            "file, or one of fig1, "}) {
    EXPECT_TRUE(contains(outcome.err, words));
  }
}

TEST(Check, NamesTheCaseWhoseLoopIsUnstable) {
  const Cases cases(
      {{"good", std::string(small_case)},
       {"wild", std::string(small_case) + "set = [\"rendering.k_r_N_per_m=1e6\", \"device.mass_kg=0.001\"]\n"}});
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "wild.toml: "));
  EXPECT_TRUE(contains(outcome.err, "unstable"));
  EXPECT_EQ(outcome.out, "");
}

TEST(Check, FindsASceneBesideItsCase) {
  const Cases cases({{"mine", replaced(std::string(small_case), "wall45", "../scenes/mine.toml")},
                     {"shipped", std::string(small_case) + "match = \"mine\"\n"}});
  fs::create_directory(cases.beside("scenes"));
  fs::copy_file(GHOSTFORCE_SCENES "/wall45.toml", cases.beside("scenes/mine.toml"));
  EXPECT_EQ(cases.check({"--only", "shipped"}).exit_code, 0);
}

TEST(Check, RefusesFoldersAndNamesThatAreNot) {
  const Cases cases({{"wall45-naive", std::string(small_case)}});
  fs::create_directory(cases.beside("pictures"));
  const auto refusal = [](std::vector<std::string> words) {
    words.insert(words.begin(), "check");
    const Outcome outcome = run_program(GHOSTFORCE_PROGRAM, words);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  EXPECT_TRUE(contains(refusal({cases.beside("picture")}), "did you mean '" + cases.beside("pictures") + "'?"));
  EXPECT_TRUE(contains(refusal({cases.beside("pictures")}), "there is no case in"));
  EXPECT_TRUE(contains(refusal({cases / "wall45-naive.toml"}), "is no folder"));
  for (const char* option : {"--only", "--update"}) {
    EXPECT_TRUE(contains(refusal({cases.path(), option, "wall45-naiv"}),
                         fmt::format("{} wall45-naiv: there is no such case; did you mean 'wall45-naive'?", option)));
    refusal({cases.path(), option});
  }
  refusal({cases.path(), "--only", "wall45-naive", "--update", "wall45-naive"});
  refusal({cases.path(), "--report", cases.beside("report"), "--update", "wall45-naive"});
  refusal({});
  EXPECT_EQ(cases.files().size(), 1U);
}

TEST(Check, ChecksOnlyWhatItIsAskedFor) {
  const Cases cases({{"a", std::string(small_case)}, {"b", std::string(small_case)}, {"c", std::string(small_case)}});
  ASSERT_EQ(cases.check({"--update", "a", "c"}).exit_code, 0);
  EXPECT_EQ(cases.check({"--only", "c", "a"}).out, "pass a\npass c\n2 cases, 0 failed\n");
  write_whole(cases / ".hidden.toml", "an editor's");
  EXPECT_EQ(cases.check({"--only", "b"}).exit_code, 1);
}

TEST(Check, KeepsItsExitCodeWhenNobodyReadsOn) {
  std::map<std::string, std::string> texts;
  for (int i = 0; i < 8; ++i) texts.emplace(fmt::format("case{}", i), small_case);
  const Cases cases(texts);
  ProgramCall call;
  call.words = {"check", cases.path()};
  call.close_after_first_piece = true;
  EXPECT_EQ(run_program(GHOSTFORCE_PROGRAM, call).exit_code, 1);
}

TEST(Check, LeavesNothingBehindWhenInterrupted) {
  std::map<std::string, std::string> texts;
  for (int i = 0; i < 60; ++i) texts.emplace(fmt::format("case{}", i), small_case);
  const Cases cases(texts);
  const std::string report = cases.beside("report");
  fs::create_directory(report);
  ProgramCall call;
  call.words = {"check", cases.path(), "--report", report};
  call.signal_when_created_in = report;
  call.signal = SIGINT;
  EXPECT_EQ(run_program(GHOSTFORCE_PROGRAM, call).exit_code, 130);
  EXPECT_EQ(Cases::files_in(report), std::set<std::string>{});
  EXPECT_EQ(cases.files().size(), 60U);
}

TEST(CheckUpdate, LeavesNothingBehindWhenInterrupted) {
  // Ten million ticks: long enough to be met in the middle.
  const std::string endless = std::string(small_case) + "set = [\"goal.duration_s=10000\"]\n";
  const Cases cases({{"a", std::string(small_case)}, {"b", endless}, {"c", endless}, {"d", endless}});
  const Outcome outcome = run_program("/usr/bin/timeout", {"--preserve-status", "-s", "INT", "0.3", GHOSTFORCE_PROGRAM,
                                                           "check", cases.path(), "--update", "a", "b", "c", "d"});
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(cases.files(), (std::set<std::string>{"a.toml", "b.toml", "c.toml", "d.toml"}));
  EXPECT_EQ(read_whole(cases / "b.toml"), endless);
}

TEST(Check, SaysWhichOpenGlThereIsWhenItIsTooOld) {
  const Cases cases({{"a", std::string(small_case)}});
  const Outcome outcome = cases.check_with({"MESA_GL_VERSION_OVERRIDE=2.1"});
  EXPECT_EQ(outcome.exit_code, 6);
  EXPECT_TRUE(contains(outcome.err, "OpenGL 2.1"));
}

TEST(ShellWord, IsTakenByAShellAsItIs) {
  for (const std::string word :
       {"plain-name_1.2", "two words", "it's", "$HOME", "`x`", "a\\b", "", "~", "*", "a;b", "ü"}) {
    EXPECT_EQ(run_program("/bin/sh", {"-c", "printf %s " + shell_word(word)}).out, word);
  }
  EXPECT_EQ(update_command("-d", "-n"), "ghostforce check ./-d --update=-n");
}

TEST(GoldenOrigin, IsReadFromWhatOpenGlSaysOfItself) {
  const GoldenOrigin origin = present_origin("llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 3.3 (Core Profile) Mesa 22.3.6");
  EXPECT_EQ(origin.renderer, "llvmpipe (LLVM 15.0.6)");
  EXPECT_EQ(origin.mesa, "22.3.6");
  EXPECT_EQ(present_origin("softpipe, OpenGL 3.3 (Core Profile) Mesa 24.0.0-devel (git-1)").mesa, "24.0.0-devel");
  EXPECT_EQ(present_origin("Other GPU, 2 bits, OpenGL 4.6").renderer, "Other GPU, 2 bits");
  EXPECT_EQ(present_origin("Other GPU, OpenGL 4.6").mesa, "");
  EXPECT_EQ(other_renderer_words(origin, {"llvmpipe (LLVM 15.0.6)", "22.3.6", "9.9"}), "")
      << "another program draws alike";
  EXPECT_EQ(other_renderer_words({}, origin), "") << "nothing is known";
  EXPECT_NE(other_renderer_words(origin, {"softpipe", "22.3.6", "0.1"}), "");
}

}  // namespace
}  // namespace ghostforce
