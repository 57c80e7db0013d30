// Letters as the painter draws them, offscreen: nothing of a letter, or of its neighbours in the texture, shows beside it.
#include <gtest/gtest.h>

#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "app/paint/label_painter.h"
#include "app/shell/desktop/glfw_window.h"

namespace ghostforce::letters_test {
namespace {

constexpr int width = 640;
constexpr int height = 120;
constexpr std::string_view all_letters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZ abcdefghijklmnopqrstuvwxyz 0123456789 .,:;!?()[]/+=%&| −·×ρκ°ï";

struct Written {
  std::string_view words;
  Vector<2> corner;
  TextStyle style;
  Colour colour{0, 0, 0};
};

Image picture_of(Window& window, const std::vector<Written>& all) {
  const Camera camera = camera_on({0.0, 0.0}, 0.1, {width, height});
  Marks marks;
  for (const Written& each : all) {
    marks.push_back({Role::legend, std::nullopt,
                     Label{to_world(camera, each.corner), Vector<2>(0.0), std::string(each.words), each.style,
                           each.colour, Colour{255, 255, 255}}});
  }
  window.frame(0.02, [&] {
    ImDrawList& drawing = *ImGui::GetBackgroundDrawList();
    drawing.AddRectFilled({0.0F, 0.0F}, {width, height}, IM_COL32_WHITE);
    paint_labels(marks, camera, window.fonts(), {0.0F, 0.0F}, 1.0, drawing);
  });
  return window.picture();
}

GlfwWindow offscreen_window() {
  return GlfwWindow({.title = "letters", .width = width, .height = height, .offscreen = true});
}

std::size_t coloured_channels(const Image& image) {
  return static_cast<std::size_t>(
      std::ranges::count_if(image.rgb, [](unsigned char channel) { return channel != 255; }));
}

int greatest_difference(const Image& a, const Image& b) {
  int greatest = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) greatest = std::max(greatest, std::abs(a.rgb[i] - b.rgb[i]));
  return greatest;
}

TEST(Letters, InTheColourOfThePaperLeaveNoTrace) {
  GlfwWindow window = offscreen_window();
  for (const double size : {11.0, 13.0, 13.4, 15.0, 18.5, 24.0, 37.0}) {
    for (const bool is_bold : {false, true}) {
      for (const double fraction : {0.0, 0.3, 0.5, 0.99}) {
        const Vector<2> corner{5.0 + fraction, 20.0 + fraction};
        const Written white{all_letters, corner, {size, is_bold}, Colour{255, 255, 255}};
        EXPECT_EQ(coloured_channels(picture_of(window, {white})), 0U) << size << (is_bold ? " bold " : " ") << fraction;
      }
    }
  }
  // What the test looks at is where letters are.
  EXPECT_GT(coloured_channels(picture_of(window, {{all_letters, {5.0, 20.0}, {13.0}}})), 1000U);
}

TEST(Letters, LookTheSameAloneAndBesideOthers) {
  constexpr std::string_view letters = "hN1l:gi";
  // Where a letter stands in the texture is rounded to a fraction of a texel.
  constexpr int rounding = 1;
  const auto alone = [](const char& letter) { return Written{{&letter, 1}, {20.3, 20.6}, {13.4}}; };
  std::vector<Image> from_a_full_texture;
  {
    GlfwWindow window = offscreen_window();
    picture_of(window, {{all_letters, {5.0, 60.0}, {13.4}}, {all_letters, {5.0, 90.0}, {13.4, true}}});
    for (const char& letter : letters) from_a_full_texture.push_back(picture_of(window, {alone(letter)}));
  }
  for (std::size_t i = 0; i < letters.size(); ++i) {
    GlfwWindow window = offscreen_window();
    EXPECT_LE(greatest_difference(picture_of(window, {alone(letters[i])}), from_a_full_texture[i]), rounding)
        << letters[i];
  }
}

}  // namespace
}  // namespace ghostforce::letters_test
