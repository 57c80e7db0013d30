// The landscape as a picture: that words can be read wherever the ring is, that it says what the formula says, and that
// no settings break it.
#include "app/stage/landscape_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/files/scene_file.h"
#include "app/paint/vector/vector_painter.h"
#include "app/picture/share_colour.h"
#include "app/stage/landscape_map.h"
#include "core/conventions.h"
#include "tests/app/stage/random_settings.h"

namespace ghostforce::landscape_layer_test {
namespace {

const MeasureText measure = measure_vector_text;

struct Picture {
  Settings settings;
  double dial = 0.0;
  Vector<2> size{1280.0, 720.0};
  double scale = 1.0;
  std::string theme = "light";
  const StageLanguage* language = &english_stage;
  Camera camera{{0.0, 0.0}, 4000.0, {1280.0, 720.0}};
  LandscapeLayout layout{};
  Marks marks{};

  explicit Picture(const Settings& shown, double turned = 0.0) : settings(shown), dial(turned) { compose(); }

  void compose() {
    camera.size = size;
    const LandscapeView view{settings, dial, false, *language, *find_theme(theme), camera, scale, measure, room()};
    layout = landscape_layout(view);
    marks.clear();
    add_landscape(view, marks);
  }

  // As the stage has it.
  LandscapeRoom room() const { return {{{size.x - 0.66 * size.y, 0.0}, {size.x, 0.0889 * size.y}}, 0.858 * size.y}; }

  struct Words {
    std::string text;
    TextStyle drawn;
    ScreenBox box;
  };
  std::vector<Words> words() const {
    std::vector<Words> found;
    for (const Mark& mark : marks) {
      const auto* const label = std::get_if<Label>(&mark.form);
      if (label == nullptr) continue;
      const TextStyle& drawn = label->style;
      const Vector<2> corner = to_screen(camera, label->anchor) + label->offset;
      found.push_back({label->text, drawn, {corner, corner + measure(label->text, drawn)}});
    }
    return found;
  }
  bool says(const std::string& text) const {
    return std::ranges::any_of(words(), [&](const Words& label) { return label.text == text; });
  }
  std::string all_words() const {
    std::string all;
    for (const Words& label : words()) all += label.text + ' ';
    return all;
  }
  bool mentions(const std::string& text) const { return all_words().find(text) != std::string::npos; }

  std::vector<ScreenBox> discs(Role role) const {
    std::vector<ScreenBox> found;
    for (const Mark& mark : marks) {
      const auto* const marker = std::get_if<Marker>(&mark.form);
      if (marker == nullptr || mark.role != role) continue;
      const Vector<2> at = to_screen(camera, marker->center) + marker->offset;
      const double reach = marker->radius + 0.5 * marker->rim_width;
      found.push_back({at - Vector<2>(reach), at + Vector<2>(reach)});
    }
    return found;
  }
};

const Settings& wall45() {
  static const Settings settings = load_scene("wall45").settings;
  return settings;
}

// ---- That it can be read ----------------------------------------------------------------------------------------------

// More than what rounding makes of two words that touch [points²].
bool cover_each_other(const ScreenBox& a, const ScreenBox& b) {
  return overlap(a, b) > 1e-6;
}

void expect_readable(const Picture& picture, const std::string& where) {
  const Vector<2> size = picture.size;
  const ScreenBox header = picture.room().header;
  const ScreenBox buttons{{0.0, picture.room().bottom}, size};
  std::vector<ScreenBox> marks = picture.discs(Role::handle);
  ASSERT_EQ(marks.size(), 2U) << "the ring and what sets it off";
  std::ranges::copy(picture.discs(Role::button), std::back_inserter(marks));
  ASSERT_EQ(marks.size(), 3U) << "and the knob";
  const std::vector<Picture::Words> words = picture.words();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Picture::Words& label = words[i];
    EXPECT_TRUE(label.box.least.x >= 0.0 && label.box.least.y >= 0.0 && label.box.most.x <= size.x)
        << where << ": '" << label.text << "' is cut off";
    EXPECT_FALSE(cover_each_other(label.box, buttons)) << where << ": '" << label.text << "' is where the buttons are";
    EXPECT_FALSE(cover_each_other(label.box, header)) << where << ": '" << label.text << "' is where the header is";
    for (const ScreenBox& mark : marks) {
      EXPECT_FALSE(cover_each_other(label.box, mark)) << where << ": '" << label.text << "' covers ring or knob";
    }
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(cover_each_other(label.box, words[j].box))
          << where << ": '" << label.text << "' over '" << words[j].text << "'";
    }
  }
}

class LandscapeInWords : public testing::TestWithParam<const StageLanguage*> {};
INSTANTIATE_TEST_SUITE_P(InEachLanguage, LandscapeInWords, testing::ValuesIn(stage_languages),
                         [](const auto& each) { return std::string(each.param->code); });

TEST_P(LandscapeInWords, NoWordsOverlapAndNoneIsCutOff) {
  RandomSettings random(1);
  for (int i = 0; i < 300; ++i) {
    Picture picture(wall45());
    picture.language = GetParam();
    picture.settings = random.next();
    picture.dial = random.coin() ? 0.0 : random.between(0.0, 1.0);
    picture.size = i % 4 == 0 ? Vector<2>(1024.0, random.coin() ? 640.0 : 768.0)
                              : Vector<2>(random.between(1024.0, 3840.0), random.between(640.0, 2160.0));
    picture.scale = i % 3 == 0 ? 1.0 : random.between(0.75, 3.0);
    picture.theme = i % 5 == 0 ? "projector" : i % 5 == 1 ? "dark" : "light";
    picture.camera.center = {random.between(-0.1, 0.1), random.between(-0.1, 0.1)};
    picture.camera.points_per_metre = random.between(100.0, 50000.0);
    if (random.coin()) {
      // To the map's edges and corners too, where there is least room.
      picture.settings = with_landscape_point(
          picture.settings,
          {random.between(-0.2, 1.8), std::pow(10.0, std::clamp(random.between(-0.3, 2.3), 0.0, 2.0))});
    }
    picture.compose();
    expect_readable(picture, std::to_string(i));
    if (HasFailure()) return;
  }
}

TEST_P(LandscapeInWords, ItsLettersAreLargeEnoughForTheLastRow) {
  for (const Vector<2>& size : {Vector<2>(1024.0, 640.0), Vector<2>(1024.0, 768.0), Vector<2>(1280.0, 720.0),
                                Vector<2>(1280.0, 800.0), Vector<2>(1920.0, 1080.0), Vector<2>(3840.0, 2160.0)}) {
    for (const std::string theme : {"light", "dark", "projector"}) {
      for (const double kappa : {3.0, 3000.0}) {
        Picture picture(wall45());
        picture.settings.stiffnesses.k_r = kappa * picture.settings.stiffnesses.k_u;
        picture.settings.wall_normal_angle = 85.0 * radians_per_degree;
        picture.language = GetParam();
        picture.size = size;
        picture.theme = theme;
        picture.compose();
        for (const Picture::Words& label : picture.words()) {
          // A line's height is 1.17 em.
          EXPECT_GE(label.drawn.height, (1.0 - 1e-9) * 1.17 * size.y / 30.0) << size.x << ' ' << label.text;
        }
      }
    }
  }
}

// ---- That it is true --------------------------------------------------------------------------------------------------

TEST(LandscapeLayer, SaysWhatTheFormulaSays) {
  const Picture naive(wall45());
  EXPECT_TRUE(naive.says("+42 %"));
  EXPECT_TRUE(naive.says("you are here: +42 %"));
  EXPECT_TRUE(naive.mentions("too much"));
  EXPECT_TRUE(naive.mentions("+200 %"));

  const Picture optimal(wall45(), 1.0);
  EXPECT_TRUE(optimal.says("no ghost force here"));
  EXPECT_TRUE(optimal.says("you are here: 0 %"));

  Settings settings = wall45();
  settings.stiffnesses.believed_k_u = 0.2 * settings.stiffnesses.k_u;
  const Picture soft(settings, 1.0);
  EXPECT_TRUE(soft.mentions("too little"));
  EXPECT_TRUE(
      soft.says("you are here: " + share_words(ghost_share(landscape_of(settings, 1.0), landscape_point(settings)))));

  settings.stiffnesses.k_r = 1000.0 * settings.stiffnesses.k_u;
  EXPECT_TRUE(Picture(settings).mentions("off the map")) << "the ring stands at the edge, and is not there";
}

TEST(LandscapeLayer, WritesSharesAsPeopleReadThem) {
  EXPECT_EQ(share_words(0.4242), "+42 %");
  EXPECT_EQ(share_words(-0.07), "−7 %");
  EXPECT_EQ(share_words(0.004), "0 %");
  EXPECT_EQ(share_words(-0.004), "0 %");
  EXPECT_EQ(share_words(0.006), "+1 %");
  EXPECT_EQ(share_words(9.99), "+999 %");
  EXPECT_EQ(share_words(1e12), "> +999 %");
}

TEST(LandscapeLayer, PromisesThatTheRedDrainsAwayOnlyWhileItDoes) {
  const auto promises = [](const Settings& settings, double dial) {
    return Picture(settings, dial).mentions("drains away");
  };
  EXPECT_TRUE(promises(wall45(), 0.0));
  EXPECT_TRUE(promises(wall45(), 0.7));
  EXPECT_FALSE(promises(wall45(), 1.0)) << "it has drained away";
  Settings settings = wall45();
  settings.stiffnesses.believed_k_u = 3.0 * settings.stiffnesses.k_u;
  EXPECT_FALSE(promises(settings, 0.0)) << "some of it stays";
  EXPECT_TRUE(Picture(settings, 0.0).mentions("less red"));
  EXPECT_FALSE(Picture(settings, 1.0).mentions("turn me"));
  settings.stiffnesses.chosen_tracking_ratio = 0.5;
  EXPECT_FALSE(Picture(settings, 0.0).mentions("turn me")) << "it becomes worse";
}

TEST(LandscapeLayer, TheMapsCellsAreColouredByTheFormula) {
  const Picture picture(wall45(), 0.3);
  const auto is_map = [](const Mark& mark) {
    return mark.role == Role::map && std::holds_alternative<Raster>(mark.form);
  };
  const auto found = std::ranges::find_if(picture.marks, is_map);
  ASSERT_NE(found, picture.marks.end());
  const auto& raster = std::get<Raster>(found->form);
  ASSERT_EQ(raster.cells.size(), static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
  const Vector<2> corner = to_screen(picture.camera, raster.corner);
  for (int row = 0; row < raster.rows; row += 7) {
    for (int column = 0; column < raster.columns; column += 7) {
      const Vector<2> middle =
          corner + raster.size * Vector<2>((column + 0.5) / raster.columns, (row + 0.5) / raster.rows);
      const double share =
          ghost_share(landscape_of(picture.settings, 0.3), landscape_point_under(picture.layout, middle));
      const Colour cell = raster.cells[static_cast<std::size_t>(row * raster.columns + column)];
      const Colour expected = colour_of_share(*find_theme("light"), share);
      EXPECT_NEAR(cell.red, expected.red, 1) << row << ' ' << column;
      EXPECT_NEAR(cell.green, expected.green, 1) << row << ' ' << column;
      EXPECT_NEAR(cell.blue, expected.blue, 1) << row << ' ' << column;
    }
  }
}

TEST(LandscapeLayer, ColoursDeepenWithTheShare) {
  for (const Theme& theme : theme_catalog()) {
    EXPECT_EQ(colour_of_share(theme, 0.0), theme.background);
    EXPECT_EQ(colour_of_share(theme, 1e9), theme.excess);
    double before = 0.0;
    for (double share = 0.02; share < 3.0; share += 0.02) {
      EXPECT_GT(depth_of_colour(share), before);
      before = depth_of_colour(share);
      EXPECT_EQ(depth_of_colour(-share), before) << "as much of too little is as deep";
      EXPECT_NE(colour_of_share(theme, share), colour_of_share(theme, -share));
    }
  }
}

TEST(LandscapeLayer, TheRingIsWhereTheSetUpIs) {
  const Picture picture(wall45());
  const Vector<2> ring = ring_at(picture.layout, landscape_point(picture.settings));
  for (const ScreenBox& disc : picture.discs(Role::handle)) {
    EXPECT_NEAR(glm::distance(0.5 * (disc.least + disc.most), ring), 0.0, 1e-6);
  }
  const double middle = 0.5 * (picture.layout.map.least.x + picture.layout.map.most.x);
  EXPECT_NEAR(ring.x, middle, 1e-6) << "45° of 90°";
}

TEST(LandscapeLayer, ContoursAsTheyAreDrawnHaveFewPiecesAndKeepToTheirLevel) {
  const Picture picture(wall45());
  const Landscape landscape = landscape_of(picture.settings, 0.0);
  std::size_t pieces = 0;
  for (const DrawnContour& contour : drawn_contours(landscape, picture.layout)) {
    for (std::size_t i = 1; i < contour.corners.size(); ++i, ++pieces) {
      // Half a point to each side of a piece's middle the map lies on both sides of the level.
      const Vector<2> way = contour.corners[i] - contour.corners[i - 1];
      const Vector<2> middle = 0.5 * (contour.corners[i] + contour.corners[i - 1]);
      const Vector<2> aside = 0.5 * glm::normalize(Vector<2>(-way.y, way.x));
      const double left = ghost_share(landscape, landscape_point_under(picture.layout, middle + aside));
      const double right = ghost_share(landscape, landscape_point_under(picture.layout, middle - aside));
      EXPECT_LE((left - contour.level) * (right - contour.level), 0.0) << contour.level << ' ' << i;
    }
  }
  EXPECT_GT(pieces, 40U);
  EXPECT_LT(pieces, 400U);
}

// There all levels lie side by side, and would be a thick bar.
TEST(LandscapeLayer, NoContourRunsAlongTheFrame) {
  for (const double kappa : {1.0, 3.0, 100.0}) {
    Settings settings = wall45();
    settings.stiffnesses.k_r = kappa * settings.stiffnesses.k_u;
    const Picture picture(settings);
    const double frame = picture.layout.map.most.x;
    for (const DrawnContour& contour : drawn_contours(landscape_of(settings, 0.0), picture.layout)) {
      for (const Vector<2>& corner : contour.corners) EXPECT_GE(frame - corner.x, 0.2 * picture.layout.em);
    }
  }
}

// ---- That nothing breaks it -------------------------------------------------------------------------------------------

bool is_finite(const Vector<2>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}

struct IsFinite {
  bool operator()(const HalfPlane& form) const { return is_finite(form.point) && is_finite(form.normal); }
  bool operator()(const Line& form) const {
    return is_finite(form.from) && is_finite(form.to) && std::isfinite(form.width) && std::isfinite(form.pattern_start);
  }
  bool operator()(const Marker& form) const { return is_finite(form.center) && std::isfinite(form.radius); }
  bool operator()(const Arrow& form) const { return is_finite(form.tail) && is_finite(form.tip); }
  bool operator()(const Box& form) const { return is_finite(form.corner) && is_finite(form.size); }
  bool operator()(const Area& form) const { return std::ranges::all_of(form.corners, is_finite); }
  bool operator()(const Raster& form) const { return is_finite(form.corner) && is_finite(form.size); }
  bool operator()(const Label& form) const {
    return is_finite(form.anchor) && is_finite(form.offset) && std::isfinite(form.style.height);
  }
};

TEST(LandscapeLayer, IsFiniteAndReadableWhateverTheSettingsHold) {
  RandomSettings random(7);
  for (int i = 0; i < 300; ++i) {
    Picture picture(wall45());
    picture.settings = random.hostile();
    picture.dial = random.coin() ? random.hostile_number() : random.between(0.0, 1.0);
    picture.compose();
    for (const Mark& mark : picture.marks) {
      EXPECT_TRUE(std::visit(IsFinite{}, mark.form)) << i << ' ' << role_name(mark.role);
    }
    expect_readable(picture, std::to_string(i));
    EXPECT_FALSE(picture.mentions("nan") || picture.mentions("inf ")) << i;
    EXPECT_LT(picture.marks.size(), 2000U) << i;
    if (HasFailure()) return;
  }
}

TEST(LandscapeLayer, IsFiniteInAPictureOfNoSize) {
  for (const Vector<2>& size : {Vector<2>(0.0), Vector<2>(1.0), Vector<2>(3.0, 2000.0), Vector<2>(20000.0, 10.0)}) {
    Picture picture(wall45());
    picture.size = size;
    picture.compose();
    for (const Mark& mark : picture.marks) EXPECT_TRUE(std::visit(IsFinite{}, mark.form)) << role_name(mark.role);
  }
}

}  // namespace
}  // namespace ghostforce::landscape_layer_test
