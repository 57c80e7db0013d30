// The keys of a hand that is not still, and of the encoder that it is seen through.
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/scene_file.h"
#include "tests/app/files/scene_with.h"

namespace ghostforce::scene_hand_keys_test {
namespace {

TEST(SceneHandKeys, ReadsTheHandThatIsNotStill) {
  const Scene scene = read_scene(scene_with("k_u_N_per_m = 100.0\n",
                                            "k_u_N_per_m = 100.0\n"
                                            "k_u_path_N_per_m = [100, 400.5]\n"
                                            "k_u_times_s = [0, 2.5]\n"
                                            "tremor_mm_rms = 0.3\n"
                                            "tremor_hz = [7, 11.5]\n"
                                            "drift_mm_per_s = 5\n"
                                            "seed = 12\n"),
                                 "f.toml", std::vector<std::string>{"device.encoder_mm=0.06"});
  EXPECT_EQ(scene.stiffness_path, (StiffnessPath{{100.0, 400.5}, {0.0, 2.5}}));
  EXPECT_EQ(scene.tremor_and_drift.tremor_rms, 0.0003);
  EXPECT_EQ(scene.tremor_and_drift.tremor_hz, (NumberRange{7.0, 11.5}));
  EXPECT_EQ(scene.tremor_and_drift.drift_speed, 0.005);
  EXPECT_EQ(scene.tremor_and_drift.seed, 12.0);
  EXPECT_EQ(scene.settings.encoder_step, 0.06 / 1000.0);
}

TEST(SceneHandKeys, ATremorMayHaveOneFrequency) {
  const Scene scene =
      read_scene(scene_with("k_u_N_per_m = 100.0\n", "k_u_N_per_m = 100.0\ntremor_hz = [8, 8]\n"), "f.toml");
  EXPECT_EQ(scene.tremor_and_drift.tremor_hz, (NumberRange{8.0, 8.0}));
}

class SceneHandKeysRefuse : public testing::TestWithParam<BadFile> {};

TEST_P(SceneHandKeysRefuse, WithPlaceAndWords) {
  expect_refused(GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Table, SceneHandKeysRefuse,
    testing::Values(
        BadFile{"PathWithoutTimes",
                "believed_k_u_N_per_m = 50.0",
                "k_u_path_N_per_m = [100, 200]",
                "14:20",
                {"the key user.k_u_path_N_per_m: k_u_times_s is missing", "give both"}},
        BadFile{"TimesWithoutPath",
                "believed_k_u_N_per_m = 50.0",
                "k_u_times_s = [0, 2]",
                "14:15",
                {"the key user.k_u_times_s: k_u_path_N_per_m is missing", "give both"}},
        BadFile{"TooFewStiffnesses",
                "believed_k_u_N_per_m = 50.0",
                "k_u_path_N_per_m = [100, 200]\nk_u_times_s = [0, 2, 3]",
                "15:15",
                {"the key user.k_u_times_s: there are 3 times for 2 stiffnesses in k_u_path_N_per_m"}},
        BadFile{"StiffnessTimesBack",
                "believed_k_u_N_per_m = 50.0",
                "k_u_path_N_per_m = [100, 200]\nk_u_times_s = [0, 0.0]",
                "15:19",
                {"0 s comes after 0 s", "must increase"}},
        BadFile{"StiffnessTimesLate",
                "believed_k_u_N_per_m = 50.0",
                "k_u_path_N_per_m = [100, 200]\nk_u_times_s = [1, 2]",
                "15:16",
                {"the first time is 1 s; it must be 0"}},
        BadFile{"StiffnessOut",
                "believed_k_u_N_per_m = 50.0",
                "k_u_path_N_per_m = [100, 0]\nk_u_times_s = [0, 2]",
                "14:26",
                {"0 is out of range", "0.1 to 1000000 N/m"}},
        BadFile{"StiffnessNan",
                "believed_k_u_N_per_m = 50.0",
                "k_u_path_N_per_m = [nan]\nk_u_times_s = [0]",
                "14:21",
                {"nan is out of range"}},
        BadFile{"NoStiffness",
                "believed_k_u_N_per_m = 50.0",
                "k_u_path_N_per_m = []\nk_u_times_s = [0]",
                "14:20",
                {"the key user.k_u_path_N_per_m: is empty", "one or more numbers"}},
        BadFile{"OneStiffness",
                "believed_k_u_N_per_m = 50.0",
                "k_u_path_N_per_m = 100\nk_u_times_s = [0]",
                "14:20",
                {"the key user.k_u_path_N_per_m", "give an array"}},
        BadFile{"BandBackwards",
                "believed_k_u_N_per_m = 50.0",
                "tremor_hz = [12, 8]",
                "14:13",
                {"the key user.tremor_hz: 12 Hz comes before 8 Hz", "the smaller number first"}},
        BadFile{"BandOfOne", "believed_k_u_N_per_m = 50.0", "tremor_hz = [8]", "14:13", {"[least, greatest]"}},
        BadFile{"BandOut",
                "believed_k_u_N_per_m = 50.0",
                "tremor_hz = [0, 8]",
                "14:14",
                {"0 is out of range", "0.1 to 100 Hz"}},
        BadFile{"TremorOut",
                "believed_k_u_N_per_m = 50.0",
                "tremor_mm_rms = 10.5",
                "14:17",
                {"10.5 is out of range", "0 to 10 mm"}},
        BadFile{"DriftOut",
                "believed_k_u_N_per_m = 50.0",
                "drift_mm_per_s = -1",
                "14:18",
                {"-1 is out of range", "0 to 100 mm/s"}},
        BadFile{
            "HalfASeed", "believed_k_u_N_per_m = 50.0", "seed = 1.5", "14:8", {"the key user.seed", "whole number"}},
        BadFile{"EncoderOut", "rate_hz = 1000", "rate_hz = 1000\nencoder_mm = 11", "12:14", {"0 to 10 mm"}},
        BadFile{"EncoderMistyped",
                "rate_hz = 1000",
                "rate_hz = 1000\nencodr_mm = 0.1",
                "12:1",
                {"did you mean 'device.encoder_mm'?"}}),
    [](const testing::TestParamInfo<BadFile>& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ghostforce::scene_hand_keys_test
