// The program on a real display server, through real key presses and a real pointer: what a visitor does first.
#include <gtest/gtest.h>

#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iterator>
#include <numeric>
#include <string>
#include <thread>

#include "app/picture/theme.h"
#include "tests/support/display.h"
#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/x_client.h"

namespace ghostforce::real_window_test {
namespace {

Colour at(const Image& image, int x, int y) {
  const std::size_t i =
      3U * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

struct Spot {
  int pixels = 0;
  double x = 0.0;  // of their middle
  double y = 0.0;
};

// Pixels of exactly that colour in the scene, right of its legend.
Spot find_in_scene(const Image& image, Colour colour) {
  constexpr int legend = 240;
  constexpr int scene_right = 850;
  Spot spot;
  for (int y = 60; y < 760; ++y) {
    for (int x = y < 180 ? legend : 0; x < scene_right; ++x) {
      if (at(image, x, y) == colour) {
        ++spot.pixels;
        spot.x += x;
        spot.y += y;
      }
    }
  }
  if (spot.pixels > 0) {
    spot.x /= spot.pixels;
    spot.y /= spot.pixels;
  }
  return spot;
}

// As near as can be told where something stands before a part of it.
bool is_near(const Spot& spot, double x, double y) {
  return spot.pixels > 0 && std::abs(spot.x - x) < 3.0 && std::abs(spot.y - y) < 3.0;
}

std::string describe(const Spot& spot) {
  return "the goal shows in " + std::to_string(spot.pixels) + " pixels round " + std::to_string(spot.x) + ", " +
         std::to_string(spot.y);
}

// A button is framed in its strategy's colour while that strategy is the active one.
bool bar_shows(const Image& image, StrategyId id) {
  const Colour frame = find_theme("light")->strategy[index_of(id)];
  int framed = 0;
  for (int x = 0; x < 600; ++x) framed += at(image, x, 9) == frame || at(image, x, 8) == frame ? 1 : 0;
  return framed > 60;
}

TEST(RealWindow, KeysAndADragChangeThePictureAsTheyShould) {
  const Display display(1280, 800);
  BackgroundProgram program({ghostforce_program(), "run", "--view", "workbench", "--no-hints"}, display.environment());
  const Colour goal = find_theme("light")->goal;

  ASSERT_TRUE(display.becomes([](const Image& image) { return bar_shows(image, StrategyId::naive); }))
      << "the default scene starts naïve";
  const Spot start = find_in_scene(display.picture(), goal);
  ASSERT_GT(start.pixels, 50);
  const Colour naive = find_theme("light")->strategy[index_of(StrategyId::naive)];
  const int naive_pixels = find_in_scene(display.picture(), naive).pixels;

  display.act({"key", "3"});
  EXPECT_TRUE(display.becomes([](const Image& image) { return bar_shows(image, StrategyId::anisotropic); }));
  EXPECT_LT(find_in_scene(display.picture(), naive).pixels, naive_pixels) << "naïve steps back";
  display.act({"key", "1"});
  EXPECT_TRUE(display.becomes([](const Image& image) { return bar_shows(image, StrategyId::full); }));
  display.act({"key", "2"});
  EXPECT_TRUE(display.becomes([](const Image& image) { return bar_shows(image, StrategyId::naive); }));

  // In small steps, as a hand moves: each is another chance for a loaded machine to see where the pointer is.
  display.act({"mousemove", "560", "420", "mousedown", "1"});
  const auto goal_is_at = [&](double x, double y) {
    return [&goal, x, y](const Image& image) { return is_near(find_in_scene(image, goal), x, y); };
  };
  EXPECT_TRUE(display.becomes(goal_is_at(560.0, 420.0))) << describe(find_in_scene(display.picture(), goal));
  for (int step = 1; step <= 13; ++step) {
    display.act({"mousemove", std::to_string(560 - 20 * step), std::to_string(420 - 10 * step)});
  }
  EXPECT_TRUE(display.becomes(goal_is_at(300.0, 290.0))) << describe(find_in_scene(display.picture(), goal));
  display.act({"mouseup", "1"});

  EXPECT_TRUE(program.is_running());
  EXPECT_EQ(program.end(SIGINT), 130);
}

TEST(RealWindow, RemembersTheThemeThatWasChosen) {
  const Display display(1280, 800);
  const auto shows = [](std::string_view theme) {
    return [theme](const Image& image) { return at(image, 300, 650) == find_theme(theme)->wall; };
  };
  {
    BackgroundProgram program({ghostforce_program(), "run", "--view", "workbench", "--no-hints"},
                              display.environment());
    ASSERT_TRUE(display.becomes(shows("light")));
    display.act({"key", "ctrl+t"});
    EXPECT_TRUE(display.becomes(shows("dark")));
    display.act({"key", "ctrl+q"});
    EXPECT_TRUE(display.becomes([&](const Image&) { return !program.is_running(); }));
    EXPECT_EQ(program.end(0), 0);
  }
  EXPECT_NE(read_whole(display.preferences_file()).find("theme = \"dark\""), std::string::npos);
  BackgroundProgram again({ghostforce_program(), "run", "--view", "workbench", "--no-hints"}, display.environment());
  EXPECT_TRUE(display.becomes(shows("dark")));
  EXPECT_EQ(again.end(SIGINT), 130);
}

// Where the workbench has its lowest panels, the stage has the wall.
// Wall down to the last row, between the lines of its hatching.
bool shows_stage(const Image& image) {
  int of_wall = 0;
  for (int x = 1100; x < 1280; ++x) of_wall += at(image, x, 796) == find_theme("light")->wall ? 1 : 0;
  return of_wall > 90;
}

bool shows_workbench(const Image& image) {
  return bar_shows(image, StrategyId::naive);
}

TEST(RealWindow, OpensWithTheStageAndThenWithWhatWasLeftLast) {
  const Display display(1280, 800);
  const auto quit = [&](BackgroundProgram& program) {
    display.act({"key", "ctrl+q"});
    EXPECT_TRUE(display.becomes([&](const Image&) { return !program.is_running(); }));
    EXPECT_EQ(program.end(SIGTERM), 0);
  };
  {
    BackgroundProgram program({ghostforce_program(), "run", "--no-hints"}, display.environment());
    ASSERT_TRUE(display.becomes(shows_stage));
    display.act({"key", "F4"});
    EXPECT_TRUE(display.becomes(shows_workbench));
    quit(program);
  }
  const auto is_kept = [&] {
    return read_whole(display.preferences_file()).find("view = \"workbench\"") != std::string::npos;
  };
  EXPECT_TRUE(is_kept());
  {
    BackgroundProgram program({ghostforce_program(), "run", "--view", "stage"}, display.environment());
    EXPECT_TRUE(display.becomes(shows_stage));
    quit(program);
  }
  EXPECT_TRUE(is_kept()) << "what is asked for holds for one run";
  BackgroundProgram program({ghostforce_program()}, display.environment());
  EXPECT_TRUE(display.becomes(shows_workbench));
  quit(program);
}

TEST(RealWindow, VisitorsStayInItAndLeaveNothingBehind) {
  const Display display(1280, 800);
  BackgroundProgram program({ghostforce_program(), "run", "--kiosk"}, display.environment());
  ASSERT_TRUE(display.becomes(shows_stage)) << "on the whole screen";
  display.act({"key", "ctrl+q", "F1", "F4", "F5", "F11", "ctrl+o", "ctrl+t", "Escape"});
  const Image first = display.picture();
  // What came before it has been taken by then.
  display.act({"key", "Next"});
  EXPECT_TRUE(display.becomes([&](const Image& image) { return image != first && shows_stage(image); }));
  EXPECT_TRUE(program.is_running());
  display.act({"key", "ctrl+alt+shift+q"});
  EXPECT_TRUE(display.becomes([&](const Image&) { return !program.is_running(); }));
  EXPECT_EQ(program.end(SIGTERM), 0);
  for (const std::string& file : {display.layout_file(), display.preferences_file()}) {
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::path(file).parent_path())) << file;
  }
}

TEST(RealWindow, IsTwiceAsLargeOnADenseScreenAndStaysSo) {
  const Display display(2560, 1600, 192);
  // The frame of the active strategy's button, at twice its height above the screen's edge.
  const auto is_twice_as_large = [](const Image& image) {
    const Colour frame = find_theme("light")->strategy[index_of(StrategyId::naive)];
    int framed = 0;
    for (int x = 0; x < 1200; ++x) framed += at(image, x, 17) == frame ? 1 : 0;
    return framed > 120 && at(image, 2556, 1596) == find_theme("light")->panel;
  };
  for (int start = 0; start < 2; ++start) {
    BackgroundProgram program({ghostforce_program(), "run", "--view", "workbench", "--no-hints"},
                              display.environment());
    EXPECT_TRUE(display.becomes(is_twice_as_large)) << "start " << start;
    display.act({"key", "ctrl+q"});
    EXPECT_TRUE(display.becomes([&](const Image&) { return !program.is_running(); }));
    EXPECT_EQ(program.end(SIGTERM), 0);
  }
  const std::string layout = read_whole(display.layout_file());
  EXPECT_NE(layout.find("width = 1280\nheight = 800"), std::string::npos) << layout;
}

TEST(RealWindow, SaysWhichOpenGlThereIsWhenItIsTooOld) {
  const Display display(1280, 800);
  ProgramCall call;
  call.words = {"run"};
  call.environment = display.environment();
  call.environment.push_back("MESA_GL_VERSION_OVERRIDE=2.1");
  const Outcome outcome = run_ghostforce(call);
  EXPECT_EQ(outcome.exit_code, 6);
  EXPECT_NE(outcome.err.find("OpenGL 2.1"), std::string::npos) << outcome.err;
}

TEST(RealWindow, ClosesByItselfWhenAsked) {
  const Display display(1280, 800);
  BackgroundProgram program(
      {ghostforce_program(), "run", "--view", "workbench", "--exit-after", "0.5", "--theme", "dark"},
      display.environment());
  const Colour background = find_theme("dark")->background;
  EXPECT_TRUE(
      display.becomes([&](const Image& image) { return at(image, 200, 300) == background || !program.is_running(); }));
  EXPECT_EQ(program.end(0), 0);
}

std::ptrdiff_t different_bytes(const Image& one, const Image& other) {
  if (one.rgb.size() != other.rgb.size()) return std::ssize(one.rgb);
  return std::inner_product(one.rgb.begin(), one.rgb.end(), other.rgb.begin(), std::ptrdiff_t{0}, std::plus<>(),
                            std::not_equal_to<>());
}

// Another program that owns the clipboard, until the window does.
class Copied {
 public:
  Copied(const Display& display, const std::string& text)
      : name_(display.environment().front().substr(std::string("DISPLAY=").size())) {
    client_.own("CLIPBOARD");
    answers_ = std::thread([this, text] { client_.answer_until_another_owns_it(text); });
  }
  ~Copied() {
    XClient(name_).own("CLIPBOARD");
    answers_.join();
  }
  Copied(const Copied&) = delete;
  Copied& operator=(const Copied&) = delete;

 private:
  std::string name_;
  XClient client_{name_};
  std::thread answers_;
};

// Again where a busy machine has let the owner answer too late.
bool pastes_until_bar_shows(const Display& display, StrategyId id) {
  return display.becomes([&](const Image& image) {
    const bool is_pasted = bar_shows(image, id);
    if (!is_pasted) display.act({"key", "ctrl+v"});
    return is_pasted;
  });
}

TEST(RealWindow, PastesASetUpThatAnotherProgramHasCopied) {
  const Display display(1280, 800);
  const Copied copied(display, "ghostforce run wall45 --strategy anisotropic --view workbench");
  BackgroundProgram program({ghostforce_program(), "run", "--view", "workbench", "--no-hints"}, display.environment());
  ASSERT_TRUE(display.becomes([](const Image& image) { return bar_shows(image, StrategyId::naive); }));
  EXPECT_TRUE(pastes_until_bar_shows(display, StrategyId::anisotropic));
  EXPECT_EQ(program.end(SIGTERM), 130);
}

TEST(RealWindow, PastesTheSetUpThatItHasCopied) {
  const Display display(1280, 800);
  BackgroundProgram program({ghostforce_program(), "run", "--view", "workbench", "--no-hints"}, display.environment());
  ASSERT_TRUE(display.becomes([](const Image& image) { return bar_shows(image, StrategyId::naive); }));
  display.act({"key", "ctrl+c"});
  display.act({"key", "1"});
  ASSERT_TRUE(display.becomes([](const Image& image) { return bar_shows(image, StrategyId::full); }));
  EXPECT_TRUE(pastes_until_bar_shows(display, StrategyId::naive));
  EXPECT_EQ(program.end(SIGTERM), 130);
}

// The text comes while V is still held down.
TEST(RealWindow, PastesIntoAField) {
  const Display display(1280, 800);
  BackgroundProgram program({ghostforce_program(), "run", "--view", "workbench", "--no-hints"}, display.environment());
  ASSERT_TRUE(display.becomes([](const Image& image) { return bar_shows(image, StrategyId::naive); }));
  const Copied copied(display, "anisotropic");
  Image palette = display.picture();
  display.act({"key", "ctrl+p"});
  constexpr std::ptrdiff_t rows_of_the_palette = 30'000;
  ASSERT_TRUE(
      display.becomes([&](const Image& image) { return different_bytes(image, palette) > rows_of_the_palette; }));
  palette = display.picture();
  EXPECT_TRUE(display.becomes([&](const Image& image) {
    const bool is_pasted = different_bytes(image, palette) > rows_of_the_palette / 2;
    if (!is_pasted) {
      display.act({"keydown", "ctrl", "keydown", "v"});
      display.act({"keyup", "v", "keyup", "ctrl"});
    }
    return is_pasted;
  })) << "it has fewer rows once something stands in its field";
  EXPECT_EQ(program.end(SIGTERM), 130);
}

// Whoever owns the clipboard, and whoever would keep it, is frozen.
TEST(RealWindow, EndsWhereTheClipboardAnswersNobody) {
  const Display display(1280, 800);
  XClient frozen(display.environment().front().substr(std::string("DISPLAY=").size()));
  frozen.own("CLIPBOARD");
  frozen.own("CLIPBOARD_MANAGER");
  BackgroundProgram program({ghostforce_program(), "run", "--view", "workbench", "--no-hints"}, display.environment());
  ASSERT_TRUE(display.becomes([](const Image& image) { return bar_shows(image, StrategyId::naive); }));
  display.act({"key", "ctrl+v"});
  display.act({"key", "3"});
  EXPECT_TRUE(display.becomes([](const Image& image) { return bar_shows(image, StrategyId::anisotropic); }));
  display.act({"key", "ctrl+c"});
  display.act({"key", "1"});
  EXPECT_TRUE(display.becomes([](const Image& image) { return bar_shows(image, StrategyId::full); }));
  EXPECT_EQ(program.end(SIGTERM), 130);
}

}  // namespace
}  // namespace ghostforce::real_window_test
