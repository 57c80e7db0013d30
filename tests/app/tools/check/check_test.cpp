// Screenshot regression as its users have it: what `ghostforce check` says of pictures. That it notices what it is for
// (a colour, a marker 2 px off, a missing arrow, another strategy), says it so that a person can act on it, and stays
// quiet where nothing has changed.
#include <sched.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <ostream>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/png_writer.h"
#include "app/files/scene_file.h"
#include "app/paint/gl_painter.h"
#include "app/paint/label_painter.h"
#include "app/shell/desktop/glfw_window.h"
#include "app/shell/desktop/offscreen.h"
#include "app/tools/check/comparison.h"
#include "app/widgets/controls.h"
#include "tests/app/tools/check/check_cases.h"
#include "tests/support/read_png.h"

namespace ghostforce::check_test {
namespace {

namespace fs = std::filesystem;

// --- What it notices -------------------------------------------------------------------------------------------------

// The scene's marks as the screen composes them, altered, and painted as the screen paints them.
Image painted(const PictureRequest& request, const std::function<void(Marks&)>& alter) {
  const Moment moment = simulate_to_moment(request);
  GlfwWindow window(
      {.title = "", .width = request.width, .height = request.height, .offscreen = true, .takes_mouse = false});
  const auto scale = static_cast<float>(request.appearance.scale);
  apply_style(*request.appearance.theme, scale);
  GlPainter painter(window.fonts());
  for (int i = 0; i < 3; ++i) {
    window.frame(0.0, [&] {
      std::vector<Pane> panes =
          compose_moment(request, moment, {request.width, request.height}, measure_with(window.fonts()));
      for (Pane& pane : panes) alter(pane.marks);
      painter.paint(panes, *request.appearance.theme, {0.0F, 0.0F},
                    request.appearance.scale * request.appearance.theme->thickness, window.pixel_width(),
                    window.pixel_height());
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

// With the least tolerance, and with the one that docs/check.md advises for runs on several machines. The least is one
// level: where a letter stands in the texture rounds it, and the program has measured other words before.
TEST_P(Notices, WhatIsDrawnOtherwise) {
  PictureRequest request;
  request.scene = load_scene("wall45");
  apply_strategy_word("naive", request);
  request.width = 640;
  request.height = 480;
  request.part = Part::scene;
  const std::string golden = png_bytes(painted(request, GetParam().apply));
  const std::string text = "scene = \"wall45\"\nstrategy = \"naive\"\nsize = [640, 480]\npart = \"scene\"\n";
  const Cases cases({{"exact", text + "[tolerance]\nchannel = 1\n"},
                     {"tolerant", text + "[tolerance]\nchannel = 2\nshare = 0.0001\n"}});
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

// A case may show a step of a lesson; what is wrong with it is told at its key.
TEST(Check, ShowsStepsOfLessons) {
  const std::string step = "lesson = \"ghost\"\nsize = [320, 240]\n";
  const Cases cases({{"open", step + "step = 1\nmismatch = \"answered\"\n"},
                     {"answered", step + "step = 1\nanswer = 1\nmismatch = \"spanish\"\n"},
                     {"spanish", step + "step = 1\nanswer = 1\nlanguage = \"es\"\nmismatch = \"next\"\n"},
                     {"next", step + "step = 2\nmismatch = \"open\"\n"}});
  const Outcome good = cases.check();
  EXPECT_EQ(good.exit_code, 0) << good.out << good.err;
  for (const auto& [text, words] :
       {std::pair(step + "step = 99\n", "the lesson ghost has"), std::pair(step + "answer = 9\n", "has 3 answers"),
        std::pair(std::string("lesson = \"gost\"\n"), "did you mean 'ghost'"),
        std::pair(step + "language = \"ES\"\n", "'ES' is not one of en, es; did you mean 'es'?"),
        std::pair(step + "scene = \"wall45\"\n", "is what a step of a lesson says"),
        std::pair(std::string("scene = \"wall45\"\nstep = 2\n"), "belongs to a lesson")}) {
    const Outcome bad = Cases({{"bad", text + "mismatch = \"other\"\n"}, {"other", std::string(small_case)}}).check();
    EXPECT_EQ(bad.exit_code, 2) << text;
    EXPECT_NE(bad.err.find(words), std::string::npos) << bad.err;
  }
}

TEST(Check, ShowsTheStageInEachLanguage) {
  const std::string stage = "scene = \"wall45\"\nsize = [320, 240]\nview = \"stage\"\n";
  const Outcome good = Cases({{"english", stage + "match = \"plain\"\nlanguage = \"en\"\n"},
                              {"plain", stage + "mismatch = \"spanish\"\n"},
                              {"spanish", stage + "language = \"es\"\nmismatch = \"plain\"\n"}})
                           .check();
  EXPECT_EQ(good.exit_code, 0) << good.out << good.err;
  for (const auto& [text, words] :
       {std::pair(stage + "language = \"xx\"\n", "'xx' is not one of en, es"),
        std::pair(std::string(small_case) + "language = \"es\"\n", "the key language: belongs to the stage")}) {
    const Outcome bad = Cases({{"bad", text + "mismatch = \"other\"\n"}, {"other", std::string(small_case)}}).check();
    EXPECT_EQ(bad.exit_code, 2) << text;
    EXPECT_NE(bad.err.find(words), std::string::npos) << bad.err;
  }
}

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
           "theme = \"projector\"\nset = [\"wall.normal_deg=120\", \"rendering.strategy=full\"]\n"},
          {"stage", "scene = \"wall45\"\nsize = [640, 360]\nview = \"stage\"\nmode = \"why\"\nstrategy = \"naive\"\n"}};
}

TEST(Check, DrawsWhatRenderDraws) {
  const Cases cases(varied_cases());
  // One window after another in one process, against a process each.
  const std::map<std::string, std::vector<std::string>> renders{
      {"window", {"wall45", "--size", "640x480", "--theme", "dark"}},
      {"fig1", {"fig1", "--size", "320x240", "--part", "scene", "--strategy", "all", "--at", "0.8"}},
      {"panes",
       {"wall45", "--size", "600x240", "--compare", "side-by-side", "--scale", "0.75", "--theme", "projector", "--set",
        "wall.normal_deg=120", "--set", "rendering.strategy=full"}},
      {"stage", {"wall45", "--size", "640x360", "--view", "stage", "--mode", "why", "--strategy", "naive"}}};
  for (const auto& [name, words] : renders) {
    std::vector<std::string> call{"render", "-o", cases / (name + ".png")};
    call.insert(call.end(), words.begin(), words.end());
    ASSERT_EQ(run_ghostforce(call).exit_code, 0);
  }
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "pass fig1\npass panes\npass stage\npass window\n4 cases, 0 failed\n");
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
  ASSERT_EQ(cases.check({"--update", "window", "fig1", "panes", "stage"}).exit_code, 0);
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
    const Outcome outcome = run_ghostforce(call);
    EXPECT_EQ(outcome.exit_code, 0) << folder << '\n' << outcome.out << outcome.err;
  }
  if (fs::exists("/usr/bin/taskset")) {
    const std::string processor = std::to_string(an_allowed_processor());
    const Outcome outcome =
        run_program("/usr/bin/taskset", {"-c", processor, ghostforce_program(), "check", cases.path()});
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
  at_once({"--update", "window", "fig1", "panes", "stage"}, 0);
  at_once({"--report", report}, 0);
  EXPECT_EQ(cases.files().size(), 8U) << "four cases, four goldens";
  EXPECT_EQ(Cases::files_in(report), (std::set<std::string>{"report.html", "junit.xml"}));
}

// --- What it tells of a difference -----------------------------------------------------------------------------------

TEST(Check, TellsNumbersAndPlaceOfADifference) {
  const Cases cases({{"wall", std::string(small_case)}});
  cases.update("wall");
  Image golden = read_png(cases / "wall.png");
  // 3 x 2 pixels at (10, 120), one of them by 77.
  for (const int y : {120, 121}) {
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
                       "x 10, y 120"));
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
  EXPECT_TRUE(contains(outcome.out, "320x241 pixels, but the golden has 320x240"));
  EXPECT_EQ(read_png(cases.beside("report/wall.actual.png")).height, 241);
  EXPECT_FALSE(fs::exists(cases.beside("report/wall.expected.png"))) << "its size says what is wrong";
  EXPECT_FALSE(fs::exists(cases.beside("report/wall.diff.png")));
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
  EXPECT_TRUE(contains(outcome.err, "the cause may be another renderer: the golden was drawn by"));
  EXPECT_TRUE(contains(outcome.err, "Mesa 9.9.9, this picture by"));
  EXPECT_TRUE(contains(read_whole(cases.beside("report/report.html")), "the cause may be another renderer"));
  EXPECT_TRUE(contains(read_whole(cases.beside("report/junit.xml")), "the cause may be another renderer"));
}

// --- match and mismatch ----------------------------------------------------------------------------------------------

TEST(CheckMatch, ComparesWithAnotherCasesPicture) {
  const std::string text(small_case);
  const Cases cases({{"a", text + "mismatch = \"c\"\n"},
                     {"b", text + "set = [\"rendering.strategy=naive\"]\nmatch = \"a\"\n"},
                     {"c", text + "strategy = \"full\"\nmismatch = \"b\"\n"}});
  EXPECT_EQ(cases.check().out, "pass a\npass b\npass c\n3 cases, 0 failed\n") << "also when they name each other";
  EXPECT_EQ(cases.files().size(), 3U);
  EXPECT_EQ(cases.check({"--only", "b"}).out, "pass b\n1 case, 0 failed\n");

  write_whole(cases / "b.toml", text + "match = \"c\"\n");
  write_whole(cases / "a.toml", text + "mismatch = \"b\"\n");
  const Outcome outcome = cases.check({"--report", cases.beside("report")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(
      contains(outcome.out, "FAIL a  compared with the picture of b, which it must not equal: no pixel differs"));
  EXPECT_TRUE(contains(outcome.out, "FAIL b  compared with the picture of c, which it must equal: "));
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
      "[a-z-]+=\"[^\"<]*\")*/?)>|&(amp|lt|gt|quot|#39|#9|#10|#13);|[^<&]+|.");
  static const std::set<std::string> never_closed{"meta", "img", "input"};
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
  EXPECT_EQ(links, 8) << "three pictures, each shown and linked, and two of them in one place";
  EXPECT_TRUE(contains(html, "a &lt;b&gt; &amp; &quot;c&quot; #1 %41 \xC3\xBC \xEF\xBF\xBD"));
  for (const char* const words : {"type=\"range\"", "good"}) EXPECT_TRUE(contains(html, words));

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
  EXPECT_TRUE(contains(outcome.err, "this is the folder of the cases"));
  EXPECT_EQ(cases.files().size(), 1U);
}

}  // namespace
}  // namespace ghostforce::check_test
