// What the JSON of a picture tells of each form.
#include "app/paint/file_painter.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ghostforce::json_painter_test {
namespace {

std::string json_of(Role role, decltype(Mark::form) form) {
  return marks_as_json({{role, std::nullopt, std::move(form), {}}}).at(0).dump();
}

TEST(JsonPainter, TellsBoxesAreasAndRasters) {
  EXPECT_EQ(
      json_of(Role::button, Box{{0.002, 0.001}, {90.0, 30.0}, 8.0, rgb(0xFFFFFF), rgb(0xB03407), 2.0, {1.0, -4.0}}),
      R"({"role":"button","form":"box","corner_mm":[2.0,1.0],"offset":[1.0,-4.0],"size":[90.0,30.0],)"
      R"("radius":8.0,"fill":"#FFFFFFFF","rim":"#B03407FF"})");
  EXPECT_EQ(json_of(Role::area, Area{{{0.0, 0.0}, {0.001, 0.0}, {0.0, 0.003}}, rgb(0x4F8DEB).with_alpha(80)}),
            R"({"role":"area","form":"area","corners_mm":[[0.0,0.0],[1.0,0.0],[0.0,3.0]],"fill":"#4F8DEB50"})");
  EXPECT_EQ(json_of(Role::map, Raster{{0.0, 0.005}, {700.0, 480.0}, 2, 1, {rgb(0x000000), rgb(0xFFFFFF)}}),
            R"({"role":"map","form":"raster","corner_mm":[0.0,5.0],"size":[700.0,480.0],"columns":2,"rows":1})");
}

TEST(JsonPainter, SaysOfArrowsAndLabelsOnlyWhatIsUnusual) {
  const Arrow arrow{{0.0, 0.0}, {0.01, 0.0}, 4.0, rgb(0x000000), rgb(0x000000), 0.0};
  Arrow bar = arrow;
  bar.has_head = false;
  Arrow hatched = arrow;
  hatched.is_hatched = true;
  const std::string plain = json_of(Role::force, arrow);
  EXPECT_EQ(plain,
            R"({"role":"force","form":"arrow","tail_mm":[0.0,0.0],"tip_mm":[10.0,0.0],"offset":[0.0,0.0],"width":4.0,)"
            R"("fill":"#000000FF","rim":"#000000FF"})");
  const std::string start = plain.substr(0, plain.size() - 1);
  EXPECT_EQ(json_of(Role::force, bar), start + R"(,"head":false})");
  EXPECT_EQ(json_of(Role::force, hatched), start + R"(,"hatched":true})");

  const auto label = [](const TextStyle& style) {
    return json_of(Role::number, Label{{0.0, 0.0}, {0.0, 0.0}, "1.27", style, rgb(0x000000), rgb(0xFFFFFF)});
  };
  const std::string usual = label(normal_text);
  EXPECT_EQ(usual, R"({"role":"number","form":"label","text":"1.27","anchor_mm":[0.0,0.0],"offset":[0.0,0.0],)"
                   R"("colour":"#000000FF"})");
  EXPECT_EQ(label(small_text), usual);
  EXPECT_EQ(label(large_text), usual);
  EXPECT_EQ(label({74.0}), usual.substr(0, usual.size() - 1) + R"(,"height":74.0})");
  EXPECT_EQ(label({19.0, true}), usual.substr(0, usual.size() - 1) + R"(,"height":19.0,"bold":true})");
}

TEST(JsonPainter, NamesEveryRoleByAnotherName) {
  std::vector<std::string> names;
  for (int i = 0; i <= static_cast<int>(Role::hint); ++i) {
    const std::string name(role_name(static_cast<Role>(i)));
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos) << name;
    EXPECT_EQ(std::ranges::count(names, name), 0) << name;
    names.push_back(name);
  }
  EXPECT_EQ(names.back(), "hint");
}

}  // namespace
}  // namespace ghostforce::json_painter_test
