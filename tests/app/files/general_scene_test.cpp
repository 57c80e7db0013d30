// Scenes of format 2: read, refused with words, and written so that they read back.
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/scene_file.h"
#include "tests/app/files/scene_with.h"
#include "tests/core/general_scenes.h"
#include "tests/core/random_setting.h"
#include "tests/support/scene_values.h"

namespace ghostforce::general_scene_test {
namespace {

// The good scene as a general one: its wall and its device are these tables' keys.
std::string general_scene(std::string_view wall, std::string_view device, std::string_view user = "") {
  return fmt::format(
      "format = 2\ntitle = \"t\"\nabout = \"a\"\n[wall]\n{}\n[device]\n{}\nmass_kg = 0.1\ndamping_N_s_per_m = 5.0\n"
      "rate_hz = 1000\n[user]\nk_u_N_per_m = 200.0\n{}\n[rendering]\nstrategy = \"naive\"\nk_r_N_per_m = 600.0\n"
      "k_t_N_per_m = 600.0\nk_c_N_per_m = 1e5\n[goal]\npath_mm = [[-10.0, 10.0], [5.0, -5.0]]\ntimes_s = [0.0, 1.0]\n"
      "duration_s = 3.0\n",
      wall, device, user);
}

constexpr std::string_view plane = "point_mm = [0, 0]\nnormal_deg = 135";
constexpr std::string_view axes = "actuated_deg = 0.0";
constexpr std::string_view arm =
    "kind = \"arm\"\nbase_mm = [-150, -150]\nlinks_mm = [160, 160]\nelbow = \"left\"\nmotor = \"base\"";
constexpr std::string_view strings = "kind = \"strings\"\nanchors_mm = [[-200, 60], [-60, -200]]";
constexpr std::string_view corner = "kind = \"corner\"\npoint_mm = [0, 0]\nnormals_deg = [130, 40]";

struct Bad {
  std::string text;
  std::vector<std::string_view> words;
};

TEST(GeneralScene, ShippedOnesAreWhatTheModelIsTestedWith) {
  const auto settings_of = [](std::string name) {
    Settings settings = load_scene(name).settings;
    settings.active = StrategyId::anisotropic;
    return settings;
  };
  EXPECT_EQ(settings_of("arm"), arm_settings());
  EXPECT_EQ(settings_of("pantograph"), pantograph_settings());
  EXPECT_EQ(settings_of("string"), string_settings());
  EXPECT_EQ(settings_of("corner"), corner_settings());
  EXPECT_EQ(settings_of("curve"), curve_settings());
}

TEST(GeneralScene, WhatIsWrongIsSaidInOneLineWithItsPlace) {
  const Bad all[]{
      {general_scene("kind = \"polyline\"", axes), {"f.toml:5:8:", "polyline", "follows in a later version"}},
      {general_scene(plane, "kind = \"stylus\"\ntip_mm = 120"), {"stylus", "follows in a later version"}},
      {general_scene(fmt::format("{}\nfriction = 0.3", plane), axes),
       {"f.toml:7:", "wall.friction", "follows in a later version"}},
      {general_scene(plane, fmt::format("{}\nlinks_mm = [1, 2]", axes)),
       {"device.links_mm", "belongs to kind 'arm', and this device is of kind 'axes'", "kind = \"arm\""}},
      {general_scene(fmt::format("{}\nnormal_deg = 3", corner), axes),
       {"wall.normal_deg", "belongs to kind 'plane', and this wall is of kind 'corner'"}},
      {general_scene(plane, "kind = \"arm\"\nbase_mm = [-150, -150]\nlinks_mm = [160, 160]\nelbow = \"left\""),
       {"device.motor is missing"}},
      {general_scene(plane, "kind = \"arms\"\nactuated_deg = 0.0"), {"device.kind", "arms", "arm"}},
      {general_scene(plane, fmt::format("{}", arm).replace(arm.find("base\""), 4, "left")),
       {"device.motor", "left", "base"}},
      {general_scene(plane, fmt::format("{}", arm).replace(arm.find("[160, 160]"), 10, "[160, 0.5]")),
       {"device.links_mm", "0.5"}},
      {general_scene(plane, fmt::format("{}", arm).replace(arm.find("[160, 160]"), 10, "[160]")), {"device.links_mm"}},
      {general_scene(plane, fmt::format("{}", arm).replace(arm.find("[160, 160]"), 10, "[60, 60]")),
       {"goal.path_mm", "the arm reaches 120 mm from its base; the goal at (-10, 10) mm is 213 mm away"}},
      {general_scene(plane, fmt::format("{}", arm).replace(arm.find("[160, 160]"), 10, "[400, 20]")),
       {"the arm comes no nearer to its base than 380 mm"}},
      {general_scene(plane, "kind = \"strings\"\nanchors_mm = []"), {"device.anchors_mm", "one to four"}},
      {general_scene(plane, "kind = \"strings\"\nanchors_mm = [[1, 2], [3, 4], [5, 6], [7, 8], [9, 9]]"),
       {"device.anchors_mm", "has 5 elements"}},
      {general_scene(plane, "kind = \"strings\"\nanchors_mm = [[100, 2], [100, 2]]"), {"the same anchor, (100, 2) mm"}},
      {general_scene(plane, "kind = \"strings\"\nanchors_mm = [[100, 2], [5, 5]]"),
       {"16 mm from the anchor (5, 5) mm"}},
      {general_scene("kind = \"corner\"\npoint_mm = [0, 0]\nnormals_deg = [130, 132]", axes),
       {"wall.normals_deg", "2 degrees apart", "5 to 175"}},
      {general_scene("kind = \"circle\"\ncenter_mm = [0, 0]\nradius_mm = 0.5\nfree = \"inside\"", axes),
       {"wall.radius_mm", "0.5"}},
      {general_scene("kind = \"circle\"\ncenter_mm = [0, 0]\nradius_mm = 30\nfree = \"in\"", axes),
       {"wall.free", "inside"}},
      {general_scene("kind = \"corner\"\npoint_mm = [0, 0]\nnormal_degs = [130, 40]", axes),
       {"wall.normal_degs is unknown; did you mean 'wall.normals_deg'?"}},
      {general_scene(plane,
                     "kind = \"pantograph\"\nbases_mm = [[35, -170], [-35, -170]]\nproximal_mm = 110\n"
                     "distal_mm = 140\nmotor = \"left\""),
       {"device.bases_mm", "the first is the right one", "give the left base first"}},
      {general_scene(plane, arm, "k_u_first_deg = 30"),
       {"user.k_u_first_deg", "give k_u_second_N_per_m too, or leave it out"}},
      {general_scene(plane, axes, "k_u_second_N_per_m = 100\nk_u_path_N_per_m = [1, 2]\nk_u_times_s = [0, 1]"),
       {"user.k_u_path_N_per_m", "stiffer in one direction"}},
  };
  for (const Bad& bad : all) {
    const std::string said = refusal(bad.text);
    EXPECT_TRUE(said.starts_with("f.toml:")) << said << bad.text;
    for (const std::string_view words : bad.words)
      EXPECT_NE(said.find(words), std::string::npos) << said << "\n" << words;
  }
  EXPECT_EQ(refusal(general_scene(plane, arm)), "");
  EXPECT_EQ(refusal(general_scene(corner, strings, "k_u_second_N_per_m = 100\nk_u_first_deg = 30")), "");
}

// A second stiffness that is there, but wrong, is not asked for.
TEST(GeneralScene, WhoGivesASecondStiffnessIsNotToldToGiveOne) {
  for (const char* const second : {"k_u_secnd_N_per_m = 50", "k_u_second_N_per_m = nan"}) {
    const std::string said = refusal(general_scene(plane, arm, fmt::format("{}\nk_u_first_deg = 30", second)));
    EXPECT_NE(said.find("k_u_sec"), std::string::npos) << said;
    EXPECT_EQ(said.find("too, or leave it out"), std::string::npos) << said;
  }
  const std::string older = refusal(scene_with("[user]\n", "[user]\nk_u_second_N_per_m = 50\nk_u_first_deg = 30\n"));
  EXPECT_EQ(older.find("too, or leave it out"), std::string::npos) << older;
}

TEST(GeneralScene, AFileOfFormat1HasNoneOfIt) {
  const std::string said = refusal(scene_with("[user]\n", "[user]\nk_u_second_N_per_m = 50\n"));
  EXPECT_TRUE(said.starts_with("f.toml:13:")) << said;
  EXPECT_NE(said.find("the key user.k_u_second_N_per_m: is of format 2; write format = 2"), std::string::npos) << said;
  EXPECT_NE(refusal(scene_with("format = 1", "format = 3")).find("is 3, but this program only knows formats 1 to 2"),
            std::string::npos);
  const std::string ratio = refusal(scene_with("format = 1\n", "format = 2\n"), {"user.k_u_second_N_per_m=50"});
  EXPECT_NE(ratio.find("the key rendering.tracking_ratio: belongs to scenes of format 1"), std::string::npos) << ratio;
  // By the command line alone, whatever the file.
  EXPECT_EQ(refusal(good_scene, {"user.k_u_second_N_per_m=50"}), "");
  EXPECT_EQ(refusal(good_scene, {"device.kind=strings", "device.anchors_mm=[[100, 100], [-100, 0]]"}), "");
  EXPECT_NE(refusal(good_scene, {"wall.friction=0.3"}).find("follows in a later version"), std::string::npos);
  EXPECT_NE(refusal(good_scene, {"device.kind=arm"}).find("device.base_mm is missing"), std::string::npos);
}

TEST(GeneralScene, AFileWithoutAFormatIsToldTheOneThatItIsOf) {
  const std::string said = refusal(general_scene(plane, arm).substr(std::string_view("format = 2\n").size()));
  EXPECT_EQ(said, "f.toml:1:1: the key format is missing; start the file with format = 2");
}

TEST(GeneralScene, WhatFormat1CanSayIsWrittenInFormat1) {
  const std::string text = scene_text(read_scene(scene_with("format = 1\n", "format = 2\n"), "f.toml"));
  EXPECT_TRUE(text.starts_with("format = 1\n")) << text;
  EXPECT_EQ(text.find("kind"), std::string::npos) << text;
}

// A general scene as a file may hold it, on which nothing else but the device's reach depends.
Scene random_general(Random& random) {
  Scene scene = load_scene("wall45");
  GeneralSettings& general = scene.settings.general;
  const auto mm = [&](double reach) { return std::round(random.uniform(-reach, reach)) / mm_per_m; };
  general.constraint = static_cast<ConstraintKind>(random.below(3));
  if (general.constraint != ConstraintKind::plane) scene.settings.wall_normal_angle = 0.0;  // which no file tells then
  if (general.constraint == ConstraintKind::corner) {
    general.corner_normal_angles[0] = random.uniform(0.0, 6.0);
    general.corner_normal_angles[1] = general.corner_normal_angles[0] + random.uniform(0.2, 2.8);
  }
  if (general.constraint == ConstraintKind::circle) {
    general.circle_center = {mm(10.0), mm(10.0)};
    general.circle_radius = random.uniform(0.001, 1.0);
    general.circle_is_free_inside = random.once_in(2);
  }
  general.mechanism = static_cast<MechanismKind>(random.below(4));
  if (general.mechanism == MechanismKind::arm) {
    general.arm = {{mm(20.0) - 0.2, mm(20.0)}, {random.uniform(0.15, 0.3), 0.16}, {}, {}};
    general.arm.elbow = random.once_in(2) ? TwoLinkArm::Elbow::left : TwoLinkArm::Elbow::right;
    general.arm.motor = random.once_in(2) ? TwoLinkArm::Motor::base : TwoLinkArm::Motor::elbow;
  }
  if (general.mechanism == MechanismKind::pantograph) {
    general.pantograph = {{Vector<2>(mm(20.0) - 0.03, -0.17), Vector<2>(0.03, mm(10.0) - 0.17)},
                          0.12,
                          random.uniform(0.14, 0.2),
                          random.once_in(2) ? FiveBar::Motor::left : FiveBar::Motor::right};
  }
  if (general.mechanism == MechanismKind::strings) {
    general.strings.count = static_cast<std::uint32_t>(1 + random.below(4));
    for (std::size_t i = 0; i < general.strings.count; ++i) {
      general.strings.anchors[i] = 0.3 * direction_at(static_cast<double>(i) + random.uniform(0.0, 0.9));
    }
    if (random.once_in(2)) general.strings.most = random.uniform(0.5, 20.0);
  }
  if (random.once_in(2)) {
    general.k_u_second = random.uniform(10.0, 1000.0);
    if (random.once_in(2)) general.k_u_first_angle = random.uniform(-3.0, 3.0);
  }
  if (random.once_in(2)) general.compliance_share = random.uniform(0.0, 2.0);
  return rounded_to_file(scene);
}

TEST(GeneralScene, ReadsBackBitForBit) {
  int general = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(seed);
    const Scene scene = random_general(random);
    const std::string text = scene_text(scene);
    EXPECT_EQ(text.starts_with("format = 2\n"), is_general(scene.settings)) << text;
    general += is_general(scene.settings) ? 1 : 0;
    if (find_workspace_problem(scene)) continue;
    const Scene again = read_scene(text, "f.toml");
    ASSERT_EQ(scene_values(again), scene_values(scene)) << text;
    EXPECT_EQ(scene_text(again), text);
  }
  EXPECT_GT(general, 400);
}

}  // namespace
}  // namespace ghostforce::general_scene_test
