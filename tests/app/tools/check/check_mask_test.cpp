// Masks: the parts of a picture that `ghostforce check` does not compare.
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/png_writer.h"
#include "app/tools/check/comparison.h"
#include "tests/app/tools/check/check_cases.h"
#include "tests/support/read_png.h"

namespace ghostforce::check_mask_test {
namespace {

// Black, but for these white pixels.
Image picture_with(int width, int height, const std::vector<std::pair<int, int>>& white) {
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height))};
  for (const auto& [x, y] : white) image.rgb[static_cast<std::size_t>(3 * (y * width + x))] = 255;
  return image;
}

std::string with_mask(std::string_view mask) {
  return fmt::format("{}mask = {}\n", small_case, mask);
}

TEST(Mask, CoversEachPixelOfItsBoxesOnce) {
  const std::vector<PixelBox> boxes{{0, 0, 2, 3}, {1, 2, 4, 1}};
  const Mask mask(5, 4, boxes);
  EXPECT_EQ(mask.count(), 9) << "they overlap in one pixel";
  EXPECT_TRUE(mask.covers(0, 0));
  EXPECT_TRUE(mask.covers(4, 2));
  EXPECT_FALSE(mask.covers(2, 0));
  EXPECT_FALSE(mask.covers(4, 3));
  EXPECT_FALSE(mask.covers(5, 2)) << "beyond the picture";
  EXPECT_FALSE(Mask().covers(0, 0));
  EXPECT_EQ(Mask(5, 4, {}).count(), 0);
}

TEST(Mask, LeavesItsPixelsOutOfEveryNumber) {
  const std::vector<PixelBox> boxes{{0, 0, 5, 10}};
  const Mask mask(10, 10, boxes);
  const Image black = picture_with(10, 10, {});
  const Comparison inside = compare_pictures(black, picture_with(10, 10, {{0, 0}, {4, 9}}), {}, mask);
  EXPECT_EQ(inside.over, 0);
  EXPECT_EQ(inside.greatest, 0);
  EXPECT_EQ(difference_words(inside, {}), "no pixel differs; 50 % of the picture is masked");
  const Comparison both = compare_pictures(black, picture_with(10, 10, {{0, 0}, {7, 3}}), {}, mask);
  EXPECT_EQ(both.over, 1);
  EXPECT_EQ(both.pixels, 50);
  EXPECT_EQ(both.masked, 50);
  EXPECT_EQ(both.share(), 0.02) << "of those that are compared";
  EXPECT_EQ(difference_words(both, {}),
            "1 of 50 pixels (2 %) differ by up to 255, all of them in 1x1 pixels at x 7, y 3; 50 % of the picture is "
            "masked");
  EXPECT_EQ(compare_pictures(black, black, {}, mask).pixels, 50) << "of equal pictures too";
}

TEST(Mask, IsHatchedInADifferencePicture) {
  const std::vector<PixelBox> boxes{{0, 0, 10, 20}};
  const Mask mask(20, 20, boxes);
  const Image black = picture_with(20, 20, {});
  const Image picture = difference_picture(black, picture_with(20, 20, {{3, 3}, {15, 10}}), {}, mask);
  const auto pixel = [&](int x, int y) {
    const auto at = picture.rgb.begin() + 3 * (y * 20 + x);
    return std::vector<int>(at, at + 3);
  };
  EXPECT_EQ(pixel(15, 10), (std::vector<int>{255, 0, 190}));
  EXPECT_NE(pixel(3, 3), pixel(15, 10)) << "it is not compared";
  EXPECT_EQ(pixel(0, 0), (std::vector<int>{150, 150, 150})) << "a line of the hatch";
  EXPECT_EQ(pixel(1, 0), (std::vector<int>{204, 204, 204})) << "the picture between the lines";
  EXPECT_EQ(pixel(12, 12), (std::vector<int>{204, 204, 204})) << "no hatch beside the mask";
}

TEST(CheckMask, HidesWhatDiffersWithinIt) {
  const Cases cases({{"wall", std::string(small_case)}});
  cases.update("wall");
  Image golden = read_png(cases / "wall.png");
  golden.rgb[3U * (20 * 320 + 10)] ^= 0x80U;  // (10, 20)
  write_whole(cases / "wall.png", png_bytes(golden));
  ASSERT_EQ(cases.check().exit_code, 1);
  const std::string text = read_whole(cases / "wall.toml");
  write_whole(cases / "wall.toml", "mask = [[0, 0, 5, 5], [10, 20, 1, 1]]\n" + text);
  EXPECT_EQ(cases.check().out, "pass wall\n1 case, 0 failed\n");
  write_whole(cases / "wall.toml", "mask = [[0, 0, 5, 5], [11, 20, 1, 1]]\n" + text);
  const std::string report = cases.beside("report");
  const Outcome beside = cases.check({"--report", report});
  EXPECT_EQ(beside.exit_code, 1);
  for (const std::string& words :
       {beside.out, read_whole(report + "/report.html"), read_whole(report + "/junit.xml")}) {
    EXPECT_TRUE(contains(words, "1 of 76774 pixels"));
    EXPECT_TRUE(contains(words, "0.0339 % of the picture is masked"));
  }
  EXPECT_TRUE(contains(read_whole(report + "/report.html"), "hatched where masked"));
  cases.update("wall");
  EXPECT_TRUE(read_png(cases / "wall.png") == read_png(report + "/wall.actual.png")) << "the whole picture";
}

// The case's own counts, like its tolerance.
TEST(CheckMask, WorksWithMatchAndMismatch) {
  const std::string left = "mask = [[0, 0, 319, 240]]\n";  // all but a column without a mark in it
  const std::string text(small_case);
  const Cases cases({{"a", text + "strategy = \"full\"\nmatch = \"b\"\n" + left},
                     {"b", text + "strategy = \"naive\"\nmismatch = \"a\"\n"},
                     {"c", text + "strategy = \"naive\"\nmismatch = \"a\"\n" + left}});
  const Outcome outcome = cases.check();
  EXPECT_TRUE(contains(outcome.out, "pass a\npass b\nFAIL c  compared with the picture of a"));
  EXPECT_TRUE(contains(outcome.out, "no pixel differs; 99.7 % of the picture is masked"));
}

TEST(CheckMask, DoesNotHideAnotherSize) {
  const Cases cases({{"wall", with_mask("[[300, 200, 20, 40]]")}});
  write_whole(cases / "wall.png", png_bytes(picture_with(100, 100, {})));
  const Outcome outcome = cases.check({"--report", cases.beside("report")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.out, "FAIL wall  the picture has 320x240 pixels, but the golden has 100x100"));
}

TEST(CheckMask, IsRefusedWhereItIsWrong) {
  std::string many = "[";
  for (int i = 0; i < 101; ++i) many += "[0, 0, 1, 1], ";
  const Cases cases({{"a", with_mask("[[0, 0, 321, 10]]")},
                     {"b", with_mask("[[0, 0, 10, 10], [310, 230, 10, 11]]")},
                     {"c", with_mask("[[0, 0, 0, 10]]")},
                     {"d", with_mask("[[-1, 0, 10, 10]]")},
                     {"e", with_mask("[[0, 0, 10]]")},
                     {"f", with_mask("[0, 0, 10, 10]")},
                     {"g", with_mask("[[0, 0, 10.5, 10]]")},
                     {"h", with_mask("5")},
                     {"i", with_mask("[[0, 0, 160, 240], [100, 0, 220, 240]]")},
                     {"j", with_mask(many + "]")},
                     {"k", "mask = [[0, 0, 1281, 10]]\nscene = \"wall45\"\n"},
                     {"none", with_mask("[]")}});
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  for (const std::string words :
       {"a.toml:4:9: the key mask: the rectangle [0, 0, 321, 10] reaches beyond the picture, which has 320x240 pixels; "
        "give "
        "one within it",
        "b.toml:4:25: the key mask: the rectangle [310, 230, 10, 11] reaches beyond the picture",
        "c.toml:4:9: the key mask: a rectangle has no pixels; give a width and a height of 1 or more",
        "d.toml:4:10: the key mask: -1 is out of range", "e.toml:4:9: the key mask: is an array of 3; give rectangles",
        "f.toml:4:9: the key mask: is a number; give rectangles", "g.toml:4:16: the key mask: has a decimal point",
        "h.toml:4:8: the key mask: is a number; give rectangles [x, y, width, height] in pixels",
        "i.toml:4:8: the key mask: covers the whole picture", "j.toml:4:8: the key mask: has 101 rectangles; give 100",
        "k.toml:1:9: the key mask: the rectangle [0, 0, 1281, 10] reaches beyond the picture, which has 1280x800"}) {
    EXPECT_TRUE(contains(outcome.err, words));
  }
  EXPECT_FALSE(contains(outcome.err, "none.toml"));
}

TEST(CheckMask, IsRefusedInOneLine) {
  for (const std::string mask : {R"([["a", "b", "c", "d"]])", "[[-1, -1, -1, -1]]", "[[0, 0, 0, 0], [0, 0, 0, 0]]"}) {
    const Cases cases({{"a", with_mask(mask)}});
    const Outcome outcome = cases.check();
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  }
}

}  // namespace
}  // namespace ghostforce::check_mask_test
