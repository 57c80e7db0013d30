// Vector pictures: the same marks as OpenGL draws, measured against it pixel by pixel.
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "app/paint/label_painter.h"
#include "app/paint/vector/vector_painter.h"
#include "tests/app/paint/vector/both_painters.h"
#include "tests/app/paint/vector/vector_panes.h"

namespace ghostforce::vector_picture_test {
namespace {

// Letters are smoothed in another way by ImGui, and stand on whole pixels there: they are compared for themselves.
std::vector<Pane> without_labels(std::vector<Pane> panes) {
  for (Pane& pane : panes) {
    std::erase_if(pane.marks, [](const Mark& mark) { return std::holds_alternative<Label>(mark.form); });
  }
  return panes;
}

struct Setting {
  std::string scene;
  Compare compare;
  std::string theme;
};

const std::vector<Setting> looks{
    {"wall45", Compare::overlay, "light"},          {"fig1", Compare::overlay, "dark"},
    {"fig3-normal", Compare::overlay, "projector"}, {"fig1", Compare::side_by_side, "light"},
    {"wall45", Compare::side_by_side, "dark"},      {"fig3-actuated", Compare::active_only, "projector"},
};

// Measured: 3 to 16 of 542,400 pixels, at the corners of arrows, where two ways to smooth an edge differ most.
constexpr int few_pixels = 20;

TEST(VectorPicture, LooksAsOpenGlDrawsIt) {
  OpenGl gl;
  for (const Setting& look : looks) {
    const Theme& theme = *find_theme(look.theme);
    const std::vector<Pane> panes = without_labels(panes_of(look.scene, look.compare, theme, false));
    EXPECT_LE(unlike_pixels(drawn_by_cairo(panes, theme), gl.draw(panes, theme)), few_pixels)
        << look.scene << ' ' << compare_name(look.compare) << ' ' << look.theme;
  }
}

// The test above can fail: by an arrow that is not there, and by a marker 3 points from where it should be.
TEST(VectorPicture, WouldBeSeenToDifferFromOpenGl) {
  OpenGl gl;
  const std::vector<Pane> panes = without_labels(panes_of("wall45", Compare::overlay, light, false));
  const Image expected = gl.draw(panes, light);
  int changed = 0;
  for (std::size_t i = 0; i < panes.front().marks.size(); ++i) {
    std::vector<Pane> other = panes;
    Marks& marks = other.front().marks;
    if (auto* marker = std::get_if<Marker>(&marks[i].form)) {
      // Others are thin or lie behind these.
      if (marks[i].role != Role::device && marks[i].role != Role::goal && marks[i].role != Role::legend) continue;
      marker->offset.x += 3.0;
    } else if (std::holds_alternative<Arrow>(marks[i].form)) {
      marks.erase(marks.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      continue;
    }
    ++changed;
    EXPECT_GT(unlike_pixels(drawn_by_cairo(other, light), expected), 2 * few_pixels) << i;
  }
  EXPECT_GE(changed, 10);
}

// OpenGL draws a trail piece by piece, and smoothed ends that lie over each other make it a little bolder.
TEST(VectorPicture, DrawsTrailsWithTheirDashesWhereOpenGlDoes) {
  constexpr int bolder = 200;  // measured: up to 159 pixels
  OpenGl gl;
  for (const Setting& look : looks) {
    const Theme& theme = *find_theme(look.theme);
    std::vector<Pane> panes = panes_of(look.scene, look.compare, theme);
    for (Pane& pane : panes) {
      std::erase_if(pane.marks, [](const Mark& mark) { return mark.role != Role::trail; });
    }
    const Image expected = gl.draw(panes, theme);
    EXPECT_LE(unlike_pixels(drawn_by_cairo(panes, theme), expected), bolder)
        << look.scene << ' ' << compare_name(look.compare) << ' ' << look.theme;
    for (Pane& pane : panes) {
      for (Mark& mark : pane.marks) std::get<Line>(mark.form).pattern = solid_line;
    }
    EXPECT_GT(unlike_pixels(drawn_by_cairo(panes, theme), expected), bolder) << look.scene;
  }
}

TEST(VectorPicture, DrawsEachFormAsOpenGlDoes) {
  constexpr double mm = 0.001;
  constexpr Colour fill = rgb(0x4F8DEB), rim = rgb(0x173C93);
  const auto mark = [](auto form) { return Mark{Role::device, std::nullopt, std::move(form)}; };
  const auto marker = [&](Shape shape, Colour inside, double rim_width) {
    return mark(Marker{{-10.0 * mm, 8.0 * mm}, shape, 60.0, inside, rim, rim_width, {31.5, -12.25}});
  };
  const LinePattern pattern{30.0, 12.0, 9.0, 12.0};
  const Vector<2> left{-40.0 * mm, -20.0 * mm}, middle{-5.0 * mm, 17.0 * mm}, right{38.0 * mm, 11.0 * mm};
  const Vector<2> bend = middle + Vector<2>(0.5 * mm, 0.0);
  const double length = glm::distance(left, middle);
  struct Case {
    const char* name;
    Marks marks;
  };
  const std::vector<Case> cases{
      {"half plane", {mark(HalfPlane{{3.0 * mm, 5.0 * mm}, direction_at(2.0), fill})}},
      {"half plane, everything", {mark(HalfPlane{{3000.0 * mm, 0.0}, {1.0, 0.0}, fill})}},
      {"half plane, nothing", {mark(HalfPlane{{-3000.0 * mm, 0.0}, {1.0, 0.0}, fill})}},
      {"half plane, straight", {mark(HalfPlane{{0.0, 3.0 * mm}, {0.0, 1.0}, fill})}},
      {"line", {mark(Line{left, right, 17.0, fill})}},
      {"point", {mark(Line{left, left, 40.0, fill})}},
      {"dashed line", {mark(Line{left, right, 7.0, fill, pattern})}},
      {"dashed line from within", {mark(Line{left, right, 7.0, fill, pattern, 2.0 * mm})}},
      {"dashed curve",
       {mark(Line{left, middle, 9.0, fill, pattern}), mark(Line{middle, right, 9.0, fill, pattern, length})}},
      {"dashed curve with a jump",
       {mark(Line{left, middle, 9.0, fill, pattern}), mark(Line{middle, right, 9.0, fill, pattern, 0.9 * length})}},
      {"curve of two colours", {mark(Line{left, middle, 9.0, fill}), mark(Line{middle, right, 9.0, rim})}},
      {"translucent curve",
       {mark(Line{left, middle, 60.0, rim.with_alpha(107)}), mark(Line{middle, bend, 60.0, rim.with_alpha(107)}),
        mark(Line{bend, right, 60.0, rim.with_alpha(107)})}},
      {"disc", {marker(Shape::disc, fill, 14.0)}},
      {"hollow disc", {mark(Line{left, right, 17.0, fill}), marker(Shape::disc, rim.with_alpha(0), 14.0)}},
      {"translucent disc", {mark(Line{left, right, 17.0, rim}), marker(Shape::disc, fill.with_alpha(128), 2.0)}},
      {"diamond", {marker(Shape::diamond, fill, 14.0)}},
      {"triangle", {marker(Shape::triangle, fill, 14.0)}},
      {"triangle without rim", {marker(Shape::triangle, fill, 0.0)}},
      {"arrow", {mark(Arrow{left, right, 25.0, fill, rim, 8.0, {10.0, -21.0}})}},
      {"short arrow", {mark(Arrow{left, left + Vector<2>(0.0, 4.0 * mm), 25.0, fill, rim, 2.0})}},
      {"bar", {mark(Arrow{left, right, 25.0, fill, rim, 8.0, {10.0, -21.0}, false})}},
      {"hatched arrow", {mark(Arrow{left, right, 60.0, fill, rim, 4.0, {}, true, true})}},
      {"hatched bar", {mark(Arrow{right, left, 40.0, fill, rim, 4.0, {}, false, true})}},
      {"hollow hatched bar", {mark(Arrow{right, middle, 40.0, {0, 0, 0, 0}, rim, 4.0, {}, false, true})}},
      {"box", {mark(Box{middle, {301.0, 97.5}, 24.0, fill, rim, 6.0, {-30.5, 12.25}})}},
      {"box with sharp corners", {mark(Box{middle, {301.0, 97.0}, 0.0, fill, rim, 0.0})}},
      {"box that is all corners", {mark(Box{middle, {120.0, 80.0}, 500.0, fill, rim, 3.0})}},
      {"hollow box", {mark(Line{left, right, 17.0, fill}), mark(Box{left, {90.0, 70.0}, 9.0, {0, 0, 0, 0}, rim, 5.0})}},
      {"area", {mark(Area{{left, middle, right, {0.0, -40.0 * mm}, {-3.0 * mm, 5.0 * mm}}, fill})}},
      {"translucent area that crosses itself",
       {mark(Line{left, right, 17.0, rim}),
        mark(Area{{left, right, {-30.0 * mm, 20.0 * mm}, {10.0 * mm, -26.0 * mm}, {5.0 * mm, 28.0 * mm}},
                  fill.with_alpha(90)})}},
      {"area beyond the pane", {mark(Area{{{-1.0, -0.9}, {0.0, 0.01}, {0.8, -1.0}}, fill})}},
      {"raster", {mark(Raster{middle, {300.0, 200.0}, 3, 2, {fill, rim, fill, rim, fill, fill}})}},
      {"raster between pixels", {mark(Raster{left, {150.3, 90.4}, 1, 4, {fill, rim, fill, rim}})}},
  };
  OpenGl gl;
  for (const Case& each : cases) {
    const std::vector<Pane> panes{pane_with(each.marks)};
    EXPECT_LE(unlike_pixels(drawn_by_cairo(panes, light), gl.draw(panes, light)), 6) << each.name;  // measured: 0 to 3
  }
}

// ---- Letters --------------------------------------------------------------------------------------------------------

TEST(VectorPicture, MeasuresLettersAsTheScreenDoes) {
  OpenGl gl;
  gl.window().frame(0.0, [&] {
    for (const std::string_view text : {"ghost force 1.27 N", "N  device, Naïve", "ρ κ", "A"}) {
      for (const double line : {13.0, 19.0, 57.0}) {
        const Vector<2> expected = measure_text(gl.window().fonts(), text, {line});
        const Vector<2> measured = measure_vector_text(text, {line});
        EXPECT_NEAR(measured.x, expected.x, 0.01 * line) << text;  // ImGui's are rounded to fractions of a pixel
        EXPECT_EQ(measured.y, expected.y) << text;
      }
    }
  });
}

// The box of all that is not paper [px].
struct InkBox {
  int left = width, right = 0, top = height, bottom = 0;
};

InkBox box_of_ink(const Image& image, Colour paper) {
  InkBox box;
  for (int i = 0; i < width * height; ++i) {
    if (std::abs(int{image.rgb[3 * static_cast<std::size_t>(i) + 1]} - int{paper.green}) < 64) continue;
    box.left = std::min(box.left, i % width);
    box.right = std::max(box.right, i % width);
    box.top = std::min(box.top, i / width);
    box.bottom = std::max(box.bottom, i / width);
  }
  return box;
}

bool are_close(const InkBox& a, const InkBox& b) {
  const auto near = [](int x, int y) { return std::abs(x - y) <= 1; };
  return near(a.left, b.left) && near(a.right, b.right) && near(a.top, b.top) && near(a.bottom, b.bottom);
}

TEST(VectorPicture, SetsLettersAndTheirHaloWhereTheScreenDoes) {
  OpenGl gl;
  for (const TextStyle& style : {small_text, normal_text, large_text}) {
    for (const Colour halo : {rgb(0x000000), Colour{0, 0, 0, 0}}) {
      const auto panes_with = [&](const Vector<2>& aside, const TextStyle& other_style) {
        // Letters stand on whole pixels on the screen and anywhere here, so ask for a place in between.
        const Vector<2> offset = Vector<2>(40.5, -59.5) + aside;
        return std::vector<Pane>{
            pane_with({Mark{Role::legend, std::nullopt,
                            Label{Vector<2>(0.0), offset, "Force Egj 3.39 N", other_style, rgb(0x000000), halo}}})};
      };
      const auto drawn = [&](const Vector<2>& aside, const TextStyle& other_style) {
        return box_of_ink(drawn_by_cairo(panes_with(aside, other_style), light), light.background);
      };
      const InkBox expected = box_of_ink(gl.draw(panes_with(Vector<2>(0.0), style), light), light.background);
      EXPECT_TRUE(are_close(drawn(Vector<2>(0.0), style), expected)) << style.height << ' ' << halo.alpha;
      EXPECT_FALSE(are_close(drawn({3.0, 0.0}, style), expected));
      EXPECT_FALSE(are_close(drawn({0.0, 3.0}, style), expected));
      const TextStyle& other = style == small_text ? normal_text : small_text;
      EXPECT_FALSE(are_close(drawn(Vector<2>(0.0), other), expected));
    }
  }
}

}  // namespace
}  // namespace ghostforce::vector_picture_test
