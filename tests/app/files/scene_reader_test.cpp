#include "app/files/scene_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "app/base/quoted.h"
#include "tests/app/files/scene_with.h"
#include "tests/support/scene_values.h"

namespace ghostforce::scene_reader_test {
namespace {

Scene with_overrides(const std::vector<std::string>& overrides) {
  return read_scene(good_scene, "f.toml", overrides);
}

TEST(SceneReader, ReadsEveryKeyIntoSi) {
  const Scene scene = read_scene(good_scene, "f.toml");
  constexpr double degree = std::numbers::pi / 180.0;
  EXPECT_EQ(scene.title, "A title");
  EXPECT_EQ(scene.about, "What to see.");
  EXPECT_EQ(scene.settings.wall_point, Vector<2>(0.001, -0.002));
  EXPECT_DOUBLE_EQ(scene.settings.wall_normal_angle, 135.0 * degree);
  EXPECT_EQ(scene.settings.actuated_angle, 0.0);
  EXPECT_EQ(scene.settings.mass, 0.1);
  EXPECT_EQ(scene.settings.damping, 5.0);
  EXPECT_EQ(scene.settings.rate, 1000.0);
  EXPECT_EQ(scene.settings.stiffnesses.k_u, 100.0);
  EXPECT_EQ(scene.settings.stiffnesses.believed_k_u, 50.0);
  EXPECT_EQ(scene.settings.active, StrategyId::naive);
  EXPECT_EQ(scene.settings.stiffnesses.k_r, 900.0);
  EXPECT_EQ(scene.settings.stiffnesses.k_t, 800.0);
  EXPECT_EQ(scene.settings.stiffnesses.k_c, 1e5);
  EXPECT_EQ(scene.settings.stiffnesses.chosen_tracking_ratio, 11.5);
  EXPECT_EQ(scene.goal.points, (std::vector{Vector<2>(-0.04, 0.04), Vector<2>(0.04, -0.04)}));
  EXPECT_EQ(scene.goal.times, (std::vector{0.0, 1.0}));
  EXPECT_EQ(scene.goal.motion, Motion::minimum_jerk);
  EXPECT_EQ(scene.duration, 3.0);
  EXPECT_EQ(scene.view.center, Vector<2>(0.005, 0.006));
  EXPECT_EQ(scene.view.width, 0.15);
}

TEST(SceneReader, FillsWhatIsOptional) {
  std::string text = scene_with("believed_k_u_N_per_m = 50.0\n", "");
  for (const std::string_view piece : {"tracking_ratio = 11.5\n", "motion = \"minimum-jerk\"\n"}) {
    text.erase(text.find(piece), piece.size());
  }
  text.erase(text.find("[view]"));
  const Scene scene = read_scene(text, "f.toml");
  EXPECT_EQ(scene.settings.stiffnesses.believed_k_u, std::nullopt);
  EXPECT_EQ(scene.settings.stiffnesses.chosen_tracking_ratio, std::nullopt);
  EXPECT_EQ(scene.goal.motion, Motion::linear);
  EXPECT_EQ(scene.view.width, SceneView{}.width);
  EXPECT_EQ(scene.settings.encoder_step, 0.0);
  EXPECT_TRUE(scene.stiffness_path.is_empty());
  EXPECT_EQ(scene.tremor_and_drift, TremorAndDrift{});
  EXPECT_EQ(read_scene(scene_with("11.5", "\"optimal\""), "f.toml").settings.stiffnesses.chosen_tracking_ratio,
            std::nullopt);
}

TEST(SceneReader, TakesWhatEditorsAndPeopleWrite) {
  const std::vector<std::string> expected = scene_values(read_scene(good_scene, "f.toml"));
  std::string crlf(good_scene);
  for (std::size_t at = 0; (at = crlf.find('\n', at)) != std::string::npos; at += 2) crlf.replace(at, 1, "\r\n");
  EXPECT_EQ(scene_values(read_scene(crlf, "f.toml")), expected);
  EXPECT_EQ(scene_values(read_scene("\xEF\xBB\xBF" + std::string(good_scene), "f.toml")), expected);
  EXPECT_EQ(scene_values(read_scene("# " + std::string(500, '.') + "\n" + std::string(good_scene), "f.toml")),
            expected);
  EXPECT_EQ(scene_values(read_scene(scene_with("[wall]\npoint_mm   = [1.0, -2]\nnormal_deg = 135.0\n",
                                               "wall.point_mm = [1.0, -2]\nwall.normal_deg = 135\n"),
                                    "f.toml")),
            expected);
  EXPECT_EQ(scene_values(read_scene(scene_with("k_c_N_per_m = 1e5", "k_c_N_per_m = 100_000 # hard"), "f.toml")),
            expected);
}

class SceneReaderRefuses : public testing::TestWithParam<BadFile> {};

TEST_P(SceneReaderRefuses, WithPlaceAndWords) {
  expect_refused(GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Table, SceneReaderRefuses,
    testing::Values(
        // not TOML
        BadFile{"NoValue", "mass_kg = 0.1", "mass_kg =", "9:10", {}},
        BadFile{"OpenText", "\"A title\"", "\"A title", "2:18", {}},
        BadFile{"KeyTwice", "mass_kg = 0.1", "mass_kg = 0.1\nmass_kg = 0.2", "10:11", {"redefine", "mass_kg"}},
        BadFile{"TableTwice", "[view]", "[wall]", "26:1", {"wall"}},
        BadFile{"ControlCharacter", "A title", "A \x01 title", "2:13", {}},
        BadFile{"NoUtf8", "A title", "A \xFF title", "2:12", {"utf-8"}},
        // unknown and missing
        BadFile{"UnknownKey",
                "point_mm   = [1.0, -2]",
                "point_mm = [1.0, -2]\npiont_mm = 1",
                "6:1",
                {"the key wall.piont_mm is unknown", "did you mean 'wall.point_mm'?"}},
        BadFile{"KeyOfAnotherTable",
                "mass_kg = 0.1",
                "mass_kg = 0.1\nk_u_N_per_m = 1.0",
                "10:1",
                {"the key device.k_u_N_per_m is unknown", "did you mean 'user.k_u_N_per_m'?"}},
        BadFile{
            "KeyWithoutUnit", "mass_kg = 0.1", "mass_kg = 0.1\nmass = 1.0", "10:1", {"did you mean 'device.mass_kg'?"}},
        BadFile{"KeyLikeNone",
                "mass_kg = 0.1",
                "mass_kg = 0.1\nbanana = 1.0",
                "10:1",
                {"the key device.banana is unknown", "[device] has kind, actuated_deg, mass_kg"}},
        BadFile{"KeyAtTheTop", "[wall]", "mass_kg = 1\n[wall]", "4:1", {"did you mean 'device.mass_kg'?"}},
        BadFile{"TableInTable", "[view]", "[wall.extra]\n[view]", "26:7", {"the key wall.extra is unknown"}},
        BadFile{"UnknownTable",
                "[view]",
                "[veiw]\n[view]",
                "26:2",
                {"the table [veiw] is unknown", "did you mean 'view'?"}},
        BadFile{"TableList", "[view]", "[[view]]", "26:3", {"view is an array", "write [view]"}},
        BadFile{"MissingKey", "mass_kg = 0.1\n", "", "7:1", {"the key device.mass_kg is missing"}},
        BadFile{"MissingTitle", "title  = \"A title\"\n", "", "1:1", {"the key title is missing"}},
        BadFile{"MissingTable",
                "[user]\nk_u_N_per_m = 100.0\nbelieved_k_u_N_per_m = 50.0\n",
                "",
                "1:1",
                {"the table [user] is missing; write it with k_u_N_per_m"}},
        BadFile{"MissingTableOfMany",
                "[wall]\npoint_mm   = [1.0, -2]\nnormal_deg = 135.0\n",
                "",
                "1:1",
                {"the table [wall] is missing; write it with point_mm, normal_deg"}},
        BadFile{"NoQuoteAtTheEnd", "A title\"", "A title", "2:18", {"does not end on its line; add the closing quote"}},
        BadFile{"NoBracketAtTheEnd", "[1.0, -2]", "[1.0, -2", "6:1", {"has no end; add a comma or a ]"}},
        BadFile{"NoQuotes", "\"naive\"", "naive", "16:14", {"naive stands without quotes; write \"naive\""}},
        BadFile{"NoQuotesAroundMany",
                "\"naive\"",
                "fully actuated  # the best",
                "16:13",
                {"fully actuated stands without quotes; write \"fully actuated\""}},
        BadFile{"NoQuotesAndABracket", "\"naive\"", "naive]", "16:14", {"Error while parsing"}},
        BadFile{"InfinityInWords", "= 135.0", "= Infinity", "6:14", {"TOML has no Infinity; write inf"}},
        BadFile{"InfTwice", "= 135.0", "= 135.0\nnormal_deg = inf", "7:14", {"cannot redefine"}},
        BadFile{"BlankInAKey", "strategy = \"naive\"", "stra tegy = naive", "16:6", {"expected"}},
        BadFile{"CommaAtTheEnd", "= 135.0", "= 135.0,", "6:19", {"a comma stands at the end; leave it out"}},
        BadFile{"TrueAndMore", "= 135.0", "= true x", "6:19", {"expected a comment or whitespace"}},
        BadFile{"DecimalComma", "= 135.0", "= 135,0", "6:17", {"a number has a comma in it; write a decimal point"}},
        BadFile{"NoFormat", "format = 1\n", "", "1:1", {"the key format is missing", "format = 1"}},
        BadFile{"LaterFormat",
                "format = 1",
                "format = 3\nnovelty = 1",
                "1:10",
                {"the key format", "is 3", "only knows formats 1 to 2"}},
        BadFile{"FormatText", "format = 1", "format = \"1\"", "1:10", {"the key format: is a string", "format = 1"}},
        // wrong type
        BadFile{"TextForNumber",
                "mass_kg = 0.1",
                "mass_kg = \"0.1\"",
                "9:11",
                {"the key device.mass_kg: is a string", "give 0.001 to 100 kg"}},
        BadFile{"BoolForNumber", "mass_kg = 0.1", "mass_kg = true", "9:11", {"is true or false"}},
        BadFile{"DateForNumber", "mass_kg = 0.1", "mass_kg = 2020-01-01", "9:11", {"is a date"}},
        BadFile{"NumberForText", "\"A title\"", "42", "2:10", {"the key title: is a number", "a string in quotes"}},
        BadFile{"NumberForChoice", "\"naive\"", "1", "16:12", {"is a number", "one of full, naive, anisotropic"}},
        BadFile{"NumberForPoint", "[1.0, -2]", "1.0", "5:14", {"is a number", "[x, y]"}},
        BadFile{"TableForNumber", "mass_kg = 0.1", "mass_kg = { kg = 1 }", "9:11", {"is a table"}},
        BadFile{"NumberForTable",
                "[view]\ncenter_mm = [5.0, 6.0]\nwidth_mm = 150.0\n",
                "[view_]\n",
                "26:2",
                {"did you mean 'view'?"}},
        BadFile{"RateWithPoint",
                "rate_hz = 1000",
                "rate_hz = 1000.0",
                "11:11",
                {"the key device.rate_hz", "decimal point", "whole number, 10 to 20000 Hz"}},
        // wrong value
        BadFile{
            "Nan", "k_u_N_per_m = 100.0", "k_u_N_per_m = nan", "13:15", {"nan is out of range", "0.1 to 1000000 N/m"}},
        BadFile{"Inf", "k_u_N_per_m = 100.0", "k_u_N_per_m = inf", "13:15", {"inf is out of range"}},
        BadFile{"InfAngle",
                "normal_deg = 135.0",
                "normal_deg = inf",
                "6:14",
                {"inf is out of range", "finite number of degrees"}},
        BadFile{"NanWall", "k_c_N_per_m = 1e5", "k_c_N_per_m = nan", "19:15", {"nan is out of range", "N/m, or inf"}},
        BadFile{"MinusInf", "k_c_N_per_m = 1e5", "k_c_N_per_m = -inf", "19:15", {"-inf is out of range"}},
        BadFile{
            "UnknownWord", "\"naive\"", "\"naïve\"", "16:12", {"'naïve' is not one of full", "did you mean 'naive'?"}},
        BadFile{"RatioWord", "11.5", "\"optimum\"", "20:18", {"'optimum'", "give 'optimal' or 0.001 to 1000"}},
        BadFile{"ThreeNumbers", "[1.0, -2]", "[1.0, -2, 3]", "5:14", {"is an array of 3", "[x, y]"}},
        BadFile{"FarPoint", "[1.0, -2]", "[1.0, -1000.5]", "5:20", {"-1000.5 is out of range", "-1000 to 1000 mm"}},
        BadFile{"NoWaypoints", "[[-40.0, 40.0], [40.0, -40.0]]", "[]", "22:12", {"the key goal.path_mm: is empty"}},
        BadFile{
            "FlatPath", "[[-40.0, 40.0], [40.0, -40.0]]", "[-40.0, [40.0, 40.0]]", "22:13", {"is a number", "[x, y]"}},
        BadFile{"LateStart", "[0.0, 1.0]", "[0.5, 1.0]", "23:13", {"the first time is 0.5 s; it must be 0"}},
        BadFile{"TimesEqual", "[0.0, 1.0]", "[0.0, 0.0]", "23:18", {"0 s comes after 0 s", "must increase"}},
        BadFile{"TimesBack", "[0.0, 1.0]", "[0.0, -1.0]", "23:18", {"-1 s comes after 0 s"}},
        BadFile{"TimesInf", "[0.0, 1.0]", "[0.0, inf]", "23:18", {"inf is out of range"}},
        BadFile{"TimesTooMany",
                "[0.0, 1.0]",
                "[0.0, 1.0, 2.0]",
                "23:12",
                {"the key goal.times_s", "3 times for 2 waypoints"}},
        BadFile{"TooManyTicks",
                "duration_s = 3.0",
                "duration_s = 10001.0",
                "24:14",
                {"the key goal.duration_s", "1e7 ticks"}},
        BadFile{"Backwards", "duration_s = 3.0", "duration_s = -1", "24:14", {"-1 is out of range"}}),
    [](const testing::TestParamInfo<BadFile>& tested) { return std::string(tested.param.name); });

TEST(SceneReader, HoldsEveryRangeOfTheDesign) {
  struct Range {
    std::string_view key;
    double least;
    double greatest;
  };
  for (const auto& [key, least, greatest] :
       {Range{"device.mass_kg", 0.001, 100.0}, Range{"device.damping_N_s_per_m", 0.0, 1e4},
        Range{"user.k_u_N_per_m", 0.1, 1e6}, Range{"user.believed_k_u_N_per_m", 0.1, 1e6},
        Range{"rendering.k_r_N_per_m", 0.0, 1e6}, Range{"rendering.k_t_N_per_m", 0.1, 1e6},
        Range{"rendering.k_c_N_per_m", 1.0, 1e9}, Range{"rendering.tracking_ratio", 1e-3, 1e3},
        Range{"view.width_mm", 1.0, 1e4}, Range{"device.encoder_mm", 0.0, 10.0}, Range{"user.tremor_mm_rms", 0.0, 10.0},
        Range{"user.drift_mm_per_s", 0.0, 100.0}}) {
    const auto set = [name = std::string(key)](double value) {
      std::string digits(64, '\0');
      digits.resize(static_cast<std::size_t>(std::snprintf(digits.data(), digits.size(), "%.17g", value)));
      return std::vector<std::string>{name + "=" + digits};
    };
    EXPECT_EQ(refusal(good_scene, set(least)), "") << key;
    EXPECT_EQ(refusal(good_scene, set(greatest)), "") << key;
    EXPECT_NE(refusal(good_scene, set(std::nextafter(least, -1.0))), "") << key;
    EXPECT_NE(refusal(good_scene, set(std::nextafter(greatest, 1e300))), "") << key;
  }
  for (const std::string rate : {"10", "20000"})
    EXPECT_EQ(refusal(good_scene, {"device.rate_hz=" + rate, "goal.duration_s=1"}), "");
  for (const std::string rate : {"9", "20001"}) EXPECT_NE(refusal(good_scene, {"device.rate_hz=" + rate}), "");
  EXPECT_EQ(refusal(good_scene, {"goal.path_mm=[[-1000, 1000.0], [0, 0]]"}), "");
  EXPECT_EQ(refusal(good_scene, {"wall.normal_deg=-123456.5"}), "");
  EXPECT_EQ(refusal(good_scene, {"goal.duration_s=10000"}), "");  // 1e7 ticks
}

TEST(SceneReader, TellsAllProblemsInTheOrderOfTheFile) {
  std::string text = scene_with("mass_kg = 0.1", "mass_kg = 0");
  text.replace(text.find("point_mm "), 9, "piont_mm ");
  const std::string said = refusal(text, {"rendering.k_r_N_per_m=-1"});
  EXPECT_EQ(said,
            "f.toml:4:1: the key wall.point_mm is missing\n"
            "f.toml:5:1: the key wall.piont_mm is unknown; did you mean 'wall.point_mm'?\n"
            "f.toml:9:11: the key device.mass_kg: 0 is out of range; give 0.001 to 100 kg\n"
            "--set rendering.k_r_N_per_m=-1: the key rendering.k_r_N_per_m: -1 is out of range; give 0 to 1000000 N/m");
}

TEST(SceneReader, StopsTellingSomewhere) {
  std::string text(good_scene);
  for (int i = 0; i < 1000; ++i) text.append("zz").append(std::to_string(i)).append(" = 1\n");
  const std::string said = refusal(text);
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 20);
  EXPECT_TRUE(said.ends_with("… and 980 more")) << said;
}

TEST(SceneReader, WantsSomethingInTheFile) {
  for (const std::string_view nothing : {"", "\n\n", "# a comment\n", "\xEF\xBB\xBF"}) {
    EXPECT_TRUE(refusal(nothing).starts_with("f.toml:1:1: the file is empty")) << nothing;
  }
}

TEST(SceneReader, KeepsTerminalsSafe) {
  // An escape in a key, in a value and in the path.
  std::string said = refusal(scene_with("[view]", "\"\\u001b[31m\" = 1\n[view]"));
  EXPECT_EQ(said.find('\x1b'), std::string::npos);
  EXPECT_NE(said.find("\\x1B"), std::string::npos) << said;
  said = refusal(scene_with("\"naive\"", "\"\\u001b[31m" + std::string(1000, 'x') + "\""));
  EXPECT_EQ(said.find('\x1b'), std::string::npos);
  EXPECT_LT(said.size(), 400U);
  try {
    read_scene("", "\x1b[31m.toml");
    ADD_FAILURE();
  } catch (const ReadError& error) {
    EXPECT_STREQ(
        error.what(),
        "\\x1B[31m.toml:1:1: the file is empty; start it with format = 1, or start from a copy of a shipped scene");
  }
}

// --set

TEST(SceneReaderSet, ReplacesValuesOfEveryKind) {
  const Scene scene =
      with_overrides({"title=My wall, \"mine\"", "about=\"a \\u03c1\"", "wall.point_mm=[3, 4.5]", "device.rate_hz=500",
                      "user.believed_k_u_N_per_m=70", "rendering.strategy=full", "rendering.k_c_N_per_m=inf",
                      "rendering.tracking_ratio=optimal", " goal.path_mm = [[1, 2]] ", "goal.times_s=[0]",
                      "goal.motion='linear'", "view.width_mm=1e2"});
  EXPECT_EQ(scene.title, "My wall, \"mine\"");
  EXPECT_EQ(scene.about, "a ρ");
  EXPECT_EQ(scene.settings.wall_point, Vector<2>(0.003, 0.0045));
  EXPECT_EQ(scene.settings.rate, 500.0);
  EXPECT_EQ(scene.settings.stiffnesses.believed_k_u, 70.0);
  EXPECT_EQ(scene.settings.active, StrategyId::full);
  EXPECT_TRUE(std::isinf(scene.settings.stiffnesses.k_c));
  EXPECT_EQ(scene.settings.stiffnesses.chosen_tracking_ratio, std::nullopt);
  EXPECT_EQ(scene.goal.points, std::vector{Vector<2>(0.001, 0.002)});
  EXPECT_EQ(scene.goal.times, std::vector{0.0});
  EXPECT_EQ(scene.goal.motion, Motion::linear);
  EXPECT_EQ(scene.view.width, 0.1);
  EXPECT_EQ(with_overrides({"title=42"}).title, "42");
  EXPECT_EQ(with_overrides({"title="}).title, "");
  EXPECT_EQ(with_overrides({"rendering.tracking_ratio=\"optimal\""}).settings.stiffnesses.chosen_tracking_ratio,
            std::nullopt);
  EXPECT_EQ(with_overrides({"rendering.tracking_ratio=7"}).settings.stiffnesses.chosen_tracking_ratio, 7.0);
}

TEST(SceneReaderSet, TheLastOneHoldsAndAllHoldBeforeTheFile) {
  EXPECT_EQ(with_overrides({"device.mass_kg=2", "device.mass_kg=3"}).settings.mass, 3.0);
  // A key that the file lacks or has wrong can come from the command line.
  EXPECT_EQ(refusal(scene_with("mass_kg = 0.1\n", ""), {"device.mass_kg=1"}), "");
  EXPECT_EQ(refusal(scene_with("mass_kg = 0.1", "mass_kg = 0"), {"device.mass_kg=1"}), "");
  EXPECT_EQ(refusal(scene_with("mass_kg = 0.1", "mass_kg = 0"), {"device.mass_kg=1", "format=1"}), "");
}

struct BadSet {
  const char* name;
  std::string_view argument;
  std::vector<std::string_view> words;
};

std::ostream& operator<<(std::ostream& out, const BadSet& bad) {
  return out << bad.name;
}

class SceneReaderSetRefuses : public testing::TestWithParam<BadSet> {};

TEST_P(SceneReaderSetRefuses, WithTheArgumentAndWords) {
  const BadSet& bad = GetParam();
  const std::string said = refusal(good_scene, {std::string(bad.argument)});
  EXPECT_TRUE(said.starts_with("--set " + quoted_text(bad.argument) + ": ")) << said;
  for (const std::string_view words : bad.words) EXPECT_NE(said.find(words), std::string::npos) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos) << said;
}

INSTANTIATE_TEST_SUITE_P(
    Table, SceneReaderSetRefuses,
    testing::Values(
        BadSet{"NoEquals", "device.mass_kg", {"give KEY=VALUE"}}, BadSet{"NoKey", "=3", {"give KEY=VALUE"}},
        BadSet{"NoValue", "device.mass_kg=", {"the key device.mass_kg: it has no value"}},
        BadSet{"NoTable", "k_r_N_per_m=3", {"the key k_r_N_per_m is unknown", "did you mean 'rendering.k_r_N_per_m'?"}},
        BadSet{"NoUnit", "rendering.k_r=3", {"did you mean 'rendering.k_r_N_per_m'?"}},
        BadSet{"OtherTable", "wall.mass_kg=3", {"did you mean 'device.mass_kg'?"}},
        BadSet{"NearHereButExactThere", "user.k_r_N_per_m=3", {"did you mean 'rendering.k_r_N_per_m'?"}},
        BadSet{"TableSlip", "rendring.k_r_N_per_m=3", {"did you mean 'rendering.k_r_N_per_m'?"}},
        BadSet{"Nonsense", "banana=3", {"the key banana is unknown"}},
        BadSet{"WordForNumber", "device.mass_kg=heavy", {"the key device.mass_kg: is a string", "0.001 to 100 kg"}},
        BadSet{"NoToml", "device.mass_kg=1,5", {"the key device.mass_kg: 1,5 is not a value"}},
        BadSet{"OpenQuote", "title=\"x", {"the key title: \"x is not a value"}},
        BadSet{"NoUtf8", "title=\xFF", {"a string in UTF-8"}},
        BadSet{"OutOfRange", "device.mass_kg=1000", {"1000 is out of range", "0.001 to 100 kg"}},
        BadSet{"Word", "rendering.strategy=naiv", {"'naiv' is not one of", "did you mean 'naive'?"}},
        BadSet{"RatioWord", "rendering.tracking_ratio=best", {"'best'", "give 'optimal'"}},
        BadSet{"Shape", "wall.point_mm=[1]", {"is an array of 1", "[x, y]"}},
        BadSet{"Entry", "goal.times_s=[0, -1]", {"-1 s comes after 0 s"}},
        BadSet{"Count", "goal.times_s=[0]", {"1 times for 2 waypoints"}},
        BadSet{"Ticks", "goal.duration_s=1e6", {"1e7 ticks"}},
        BadSet{"Format", "format=3", {"the key format", "is 3"}}),
    [](const testing::TestParamInfo<BadSet>& tested) { return std::string(tested.param.name); });

TEST(SceneReaderSet, OneArgumentIsOneValue) {
  const std::string said = refusal(good_scene, {"device.mass_kg=1\nvalue2 = 3"});
  EXPECT_NE(said.find("is not a value"), std::string::npos) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos) << said;
}

// Whatever the bytes: a scene, or a refusal with words; never a crash, never any other exception.

TEST(SceneReader, SurvivesWhatIsNoText) {
  for (const std::string& text :
       {std::string(1, '\0'), std::string("\xFF\xFE[\0w\0", 6), std::string(100'000, '\0'), std::string(200'000, '['),
        "a = " + std::string(200'000, '['), "a = " + std::string(200'000, '{'), std::string(300'000, 'a'),
        std::string(300'000, '"'), std::string("[goal\n"), std::string("\x7F\x45LF\x02\x01")}) {
    EXPECT_NE(refusal(text), "");
  }
}

TEST(SceneReader, SurvivesNamesOfManyParts) {
  std::string name = "a";
  for (int i = 0; i < 1'000'000; ++i) name += ".a";
  std::string quoted = "\"=\"";
  for (int i = 0; i < 300'000; ++i) quoted += ".\"#,='\\\"\"";
  for (const std::string& text : {name + " = 1\n", "[" + name + "]\n", "[[" + name + "]]\n",
                                  "x = { " + name + " = 1 }\n", quoted + " = 1\n", "[" + quoted + "]\n"}) {
    EXPECT_NE(refusal(text).find("too many dots"), std::string::npos);
  }
}

TEST(SceneReader, SurvivesDamagedFiles) {
  std::mt19937 random(20200401);  // NOLINT: the same in every run
  std::uniform_int_distribution<std::size_t> place(0, good_scene.size() - 1);
  std::uniform_int_distribution<int> byte(0, 255);
  std::uniform_int_distribution<int> how(0, 3);
  int refused = 0;
  constexpr int rounds = 4000;
  for (int i = 0; i < rounds; ++i) {
    std::string text(good_scene);
    for (int change = how(random); change >= 0; --change) {
      const std::size_t at = std::min(place(random), text.size() - 1);
      switch (how(random)) {
        case 0:
          text[at] = static_cast<char>(byte(random));
          break;
        case 1:
          text.erase(at, 1 + place(random) % 20);
          break;
        case 2:
          text.insert(at, text.substr(place(random) % text.size(), 20));
          break;
        default:
          text[at] = "[]{}=.\"'#,\n-+e0_"[byte(random) % 16];
      }
      if (text.empty()) text.push_back('x');
    }
    refused += refusal(text).empty() ? 0 : 1;
  }
  EXPECT_GT(refused, rounds / 2);
  EXPECT_LT(refused, rounds);
}

}  // namespace
}  // namespace ghostforce::scene_reader_test
