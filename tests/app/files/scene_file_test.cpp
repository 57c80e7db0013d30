#include "app/files/scene_file.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <locale>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "app/cli/command.h"
#include "app/files/input_file.h"
#include "embedded_scenes.h"
#include "tests/support/long_run.h"
#include "tests/support/places.h"
#include "tests/support/scene_values.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::scene_file_test {
namespace {

Scene read_back(const Scene& scene) {
  return read_scene(scene_text(scene), "written");
}

std::pair<ExitCode, std::string> refusal(const std::string& name_or_path) {
  try {
    load_scene(name_or_path);
  } catch (const ReadError& error) {
    return {exit_code_of(error.kind()), error.what()};
  }
  return {ExitCode::done, ""};
}

// A scene as a file may hold it: each number drawn in the file's unit.
class RandomScene {
 public:
  explicit RandomScene(unsigned seed) : random_(seed) {}

  Scene next() {
    Scene scene;
    for (const SceneKey& key : scene_keys()) {
      if (key.format > 1) continue;  // general scenes have a test of their own
      std::visit([&](const auto& value) { fill(value, scene); }, key.value);
    }
    scene.goal.points.resize(scene.goal.times.size(), Vector<2>(0.0));
    for (Vector<2>& point : scene.goal.points) point = position();
    if (coin()) {
      scene.stiffness_path.values.resize(scene.stiffness_path.times.size());
      for (double& value : scene.stiffness_path.values) value = number(0.1, 1e6);
    } else {
      scene.stiffness_path = {};
    }
    return scene;
  }

 private:
  // Every second one is as short as people write them.
  double number(double least, double greatest) {
    double value = std::uniform_real_distribution<>(std::max(least, -1e6), std::min(greatest, 1e6))(random_);
    if (coin()) value = std::round(value * 10.0) / 10.0;
    return std::clamp(value, least, greatest);
  }
  bool coin() { return std::uniform_int_distribution<int>(0, 1)(random_) == 1; }
  Vector<2> position() { return {number(-1000.0, 1000.0) / 1000.0, number(-1000.0, 1000.0) / 1000.0}; }

  void fill(const NumberKey& key, Scene& scene) {
    if (key.may_be_infinite && coin()) {
      key.in(scene) = std::numeric_limits<double>::infinity();
    } else if (key.whole) {
      key.in(scene) = std::round(number(key.least, key.greatest));
    } else {
      key.in(scene) = number(key.least, std::min(key.greatest, 500.0)) / key.per_si;
    }
  }
  void fill(const OptionalNumberKey& key, Scene& scene) {
    if (coin()) key.in(scene) = number(key.least, key.greatest);
  }
  void fill(const TextKey& key, Scene& scene) {
    const std::string_view letters = key.may_have_lines ? "aZ \"\\\n\t#='" : "aZ \"\\#='";
    for (int i = 0; i < 12; ++i) {
      key.in(scene) += letters[std::uniform_int_distribution<std::size_t>(0, letters.size() - 1)(random_)];
    }
    key.in(scene) += "ρ → …";
  }
  void fill(const ChoiceKey& key, Scene& scene) {
    key.set(scene, std::uniform_int_distribution<std::size_t>(0, key.words.size() - 1)(random_));
  }
  void fill(const PointKey& key, Scene& scene) { key.in(scene) = position(); }
  void fill(const PointsKey&, Scene&) {}
  void fill(const TimesKey& key, Scene& scene) {
    key.in(scene) = {0.0};
    while (coin()) key.in(scene).push_back(key.in(scene).back() + number(0.001, 3.0));
  }
  void fill(const NumbersKey&, Scene&) {}
  void fill(const PairKey&, Scene&) {}
  void fill(const PointPairKey&, Scene&) {}
  void fill(const AnchorsKey&, Scene&) {}
  void fill(const RangeKey& key, Scene& scene) {
    if (coin()) return;  // the usual one
    const double one = number(key.range.least, key.range.greatest);
    const double other = number(key.range.least, key.range.greatest);
    key.in(scene) = {std::min(one, other), std::max(one, other)};
  }

  std::mt19937 random_;
};

TEST(SceneFile, ShippedScenesAreThereAndGood) {
  const std::vector<std::string_view> names = shipped_scene_names();
  std::set<std::string> files;
  for (const auto& file : std::filesystem::directory_iterator(source_path("/assets/scenes"))) {
    files.insert(file.path().stem().string());
  }
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()), files) << "app/files/CMakeLists.txt lists them";
  for (const std::string_view name : names) {
    const Scene scene = load_scene(std::string(name));
    EXPECT_FALSE(scene.title.empty()) << name;
    EXPECT_EQ(scene_values(read_back(scene)), scene_values(scene)) << name;
  }
}

TEST(SceneFile, WritesWhatReadsBackBitForBit) {
  RandomScene random(1);
  for (int i = 0; i < trials(1000); ++i) {
    const Scene scene = random.next();
    ASSERT_EQ(scene_values(read_back(scene)), scene_values(scene)) << scene_text(scene);
    ASSERT_EQ(scene_values(rounded_to_file(scene)), scene_values(scene)) << "a scene of a file stays as it is";
  }
}

// Files of a scene without the rare keys are those that they were before there were such keys, byte for byte.
TEST(SceneFile, WritesWhatIsRareOnlyWhereItIs) {
  constexpr std::string_view rare[]{"encoder_mm", "k_u_path_N_per_m", "k_u_times_s", "tremor_mm_rms",
                                    "tremor_hz",  "drift_mm_per_s",   "seed"};
  const Scene scene = load_scene("wall45");
  const std::string text = scene_text(scene);
  for (const std::string_view key : rare) EXPECT_EQ(text.find(key), std::string::npos) << key << text;
  EXPECT_NE(text.find("rate_hz = 1000\n\n[user]\nk_u_N_per_m = 200.0\n\n[rendering]\n"), std::string::npos) << text;

  const std::vector<std::string> all{"device.encoder_mm=0.06",
                                     "user.k_u_path_N_per_m=[200, 500]",
                                     "user.k_u_times_s=[0, 5]",
                                     "user.tremor_mm_rms=0.2",
                                     "user.tremor_hz=[8, 13]",
                                     "user.drift_mm_per_s=3",
                                     "user.seed=2"};
  const Scene restless = load_scene("wall45", all);
  const std::string said = scene_text(restless);
  EXPECT_NE(said.find("rate_hz = 1000\nencoder_mm = 0.06\n\n[user]\nk_u_N_per_m = 200.0\n"
                      "k_u_path_N_per_m = [200.0, 500.0]\nk_u_times_s = [0.0, 5.0]\ntremor_mm_rms = 0.2\n"
                      "tremor_hz = [8.0, 13.0]\ndrift_mm_per_s = 3.0\nseed = 2\n\n[rendering]\n"),
            std::string::npos)
      << said;
  EXPECT_EQ(read_back(restless), restless);
}

TEST(SceneFile, WritesNumbersAsShortAsTheyWere) {
  // Every mm and degree with one decimal comes out as it went in.
  const int step = 10'000 / trials(10'000);
  for (int tenth = -10'000; tenth <= 10'000; tenth += step) {
    Scene scene = load_scene("fig1");
    const double value = tenth / 10.0;
    scene.settings.wall_point.x = value / 1000.0;
    const std::string text = scene_text(scene);
    const std::size_t at = text.find("point_mm = [") + 12;
    const std::string written = text.substr(at, text.find(',', at) - at);
    ASSERT_EQ(std::stod(written), value);
    ASSERT_LE(written.size(), 7U) << written;
  }
  const std::string text = scene_text(load_scene("fig1", std::vector<std::string>{"view.width_mm=120"}));
  for (const std::string_view line :
       {"normal_deg = 135.0\n", "width_mm = 120.0\n", "rate_hz = 1000\n", "mass_kg = 0.1\n", "k_c_N_per_m = 100000.0\n",
        "tracking_ratio = \"optimal\"\n", "times_s = [0.0, 1.0]\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  }
  EXPECT_EQ(text.find("believed"), std::string::npos) << text;
}

TEST(SceneFile, KeepsInfinityAndTheSignOfZero) {
  Scene scene = load_scene("wall45");
  scene.settings.stiffnesses.k_c = std::numeric_limits<double>::infinity();
  scene.settings.wall_point.x = -0.0;
  scene.settings.actuated_angle = -0.0;
  scene.settings.stiffnesses.k_r = -0.0;
  EXPECT_EQ(scene_values(read_back(scene)), scene_values(scene)) << scene_text(scene);
}

TEST(SceneFile, RoundsWhatNoFileHoldsByTheLastBitOnly) {
  std::mt19937 random(2);
  std::uniform_real_distribution<> metres(-1.0, 1.0);
  int moved = 0;
  for (int i = 0; i < trials(2000); ++i) {
    Scene scene = load_scene("fig1");
    scene.settings.wall_point.x = metres(random);
    scene.settings.wall_normal_angle = 3.0 * metres(random);
    const Scene rounded = rounded_to_file(scene);
    const auto is_near = [&](double a, double b) {
      moved += a != b ? 1 : 0;
      return std::nextafter(a, b) == b;
    };
    ASSERT_TRUE(is_near(scene.settings.wall_point.x, rounded.settings.wall_point.x));
    ASSERT_TRUE(is_near(scene.settings.wall_normal_angle, rounded.settings.wall_normal_angle));
    ASSERT_EQ(scene_values(read_back(rounded)), scene_values(rounded));
    ASSERT_EQ(scene_values(read_back(scene)), scene_values(rounded)) << "what is written is what was promised";
  }
  EXPECT_GT(moved, 0) << "or this test has not met the case that it is for";
}

// A decimal comma, as half of the world writes it.
struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(SceneFile, KnowsNoLocale) {
  const std::string expected = scene_text(load_scene("wall45"));
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const std::string with_comma = scene_text(load_scene("wall45", std::vector<std::string>{"device.mass_kg=0.1"}));
  std::locale::global(before);
  EXPECT_EQ(with_comma, expected);
}

TEST(SceneFile, LoadsFilesAndPrefersShippedNames) {
  const TemporaryFolder folder;
  const std::string path = folder / "mine.toml";
  Scene scene = load_scene("fig1");
  scene.title = "mine";
  write_whole(path, scene_text(scene));
  EXPECT_EQ(load_scene(path).title, "mine");
  EXPECT_EQ(load_scene(path, std::vector<std::string>{"title=yours"}).title, "yours");
  EXPECT_TRUE(may_be_scene(path));
  EXPECT_TRUE(may_be_scene("fig1"));
  EXPECT_TRUE(may_be_scene("no/such"));
  EXPECT_TRUE(may_be_scene("nosuch.toml"));
  EXPECT_FALSE(may_be_scene("simulat"));
}

TEST(SceneFile, NamesTheNearestOfWhatIsNotThere) {
  const TemporaryFolder folder;
  write_whole(folder / "steep.toml", "");
  write_whole(folder / "notes.txt", "");
  const auto expect = [](const std::string& asked, ExitCode code, std::string_view words) {
    const auto [got, said] = refusal(asked);
    EXPECT_EQ(got, code) << asked;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  expect("wal45", ExitCode::wrong_call, "no scene named 'wal45'; did you mean 'wall45'?");
  expect("wall45.toml", ExitCode::wrong_call, "did you mean 'wall45'?");
  expect("./wall46", ExitCode::wrong_call, "did you mean 'wall45'?");
  expect("banana", ExitCode::wrong_call, "one of arm, changing-hand, corner, curve, fig1, fig3-actuated");
  expect("", ExitCode::wrong_call, "no scene named ''");
  expect(folder / "stepe.toml", ExitCode::wrong_call, "did you mean '" + (folder / "steep.toml") + "'?");
  expect(folder / "steep", ExitCode::wrong_call, "did you mean '" + (folder / "steep.toml") + "'?");
  expect((folder / "notes.txt") + "/x.toml", ExitCode::wrong_call, "there is no file '");
  expect("nosuch.toml", ExitCode::wrong_call,
         "there is no file 'nosuch.toml'; give the path of a file, or one of arm,");
  expect(std::string(100'000, 'x'), ExitCode::wrong_call, "no scene named");
}

TEST(SceneFile, TellsWhatIsNoReadableFile) {
  const TemporaryFolder folder;
  const auto expect = [](const std::string& asked, ExitCode code, const std::string& words) {
    const auto [got, said] = refusal(asked);
    EXPECT_EQ(got, code) << asked;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  expect(folder.path(), ExitCode::wrong_call, folder.path() + ": is a folder");
  expect("/dev/zero", ExitCode::wrong_call, "/dev/zero: is larger than 16 MiB");
  expect("/dev/null", ExitCode::wrong_call, "/dev/null:1:1: the file is empty");
  // A file that opens but does not read, whoever asks.
  expect("/proc/self/mem", ExitCode::file_trouble,
         "/proc/self/mem: cannot be read: Input/output error; check the disk");
}

TEST(SceneFile, ShippedTextsAreWhatTheFolderHolds) {
  for (const EmbeddedText& scene : embedded_scenes) {
    EXPECT_EQ(read_whole(source_path("/assets/scenes") + "/" + std::string(scene.name)), scene.contents) << scene.name;
  }
  EXPECT_EQ(
      static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(source_path("/assets/scenes")), {})),
      embedded_scenes.size())
      << "a scene in assets/scenes is not listed in app/CMakeLists.txt";
}

// It is sound: nobody removes it, nor looks for another.
TEST(UnreadableWords, AdviseAHigherLimitWhereTooManyFilesAreOpen) {
  for (const int error : {EMFILE, ENFILE}) {
    const std::string words = unreadable_words(error);
    EXPECT_NE(words.find("ulimit -n"), std::string::npos) << words;
    EXPECT_EQ(words.find("another"), std::string::npos) << words;
    EXPECT_EQ(words.find("remove"), std::string::npos) << words;
  }
}

}  // namespace
}  // namespace ghostforce::scene_file_test
