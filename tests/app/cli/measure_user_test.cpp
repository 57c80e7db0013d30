// measure-user over runs, as people call it.
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/files/run.h"
#include "app/files/scene_file.h"
#include "core/measuring_tones.h"
#include "core/simulate.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::measure_user_test {
namespace {

class MeasureUser : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path() + "/" + name; }

  std::string simulated(const std::vector<std::string>& settings) {
    std::vector<std::string> words{"simulate", "wall45", "--strategy", "all", "-o", path("run.csv")};
    for (const std::string& setting : settings) {
      words.emplace_back("--set");
      words.push_back(setting);
    }
    const Outcome outcome = run_ghostforce(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return path("run.csv");
  }
  nlohmann::json measured(const std::string& file, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"measure-user", file, "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run_ghostforce(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }

  static double median_of(const nlohmann::json& json) {
    EXPECT_EQ(json["hands"].size(), 1U) << json;
    return json["hands"][0]["k_u_N_per_m"]["median"].get<double>();
  }

  // What a recording of a real device looks like, made from the model: the goal is inferred with a belief that is
  // wrong, and the hand trembles by 0.2 mm. `limited_by` makes of the force and its time what the motors got.
  using Limit = std::function<Vector<2>(const Vector<2>& force, double time_s)>;
  static Vector<2> all_of_it(const Vector<2>& force, double /*time_s*/) { return force; }
  std::string of_a_device(const Vector<2>& aim, double k_u, const Limit& limited_by = all_of_it,
                          bool says_saturated = false) {
    Scene scene = load_scene("wall45");
    scene.settings.stiffnesses.k_u = k_u;
    scene.settings.stiffnesses.believed_k_u = 500.0;
    scene.settings.active = StrategyId::anisotropic;
    scene.goal = {{aim}, {0.0}, Motion::linear};
    scene.duration = 2.0;
    fmt::memory_buffer rows;
    simulate(scene, last_tick(scene), [&](Snapshot snapshot) {
      auto& now = snapshot.strategies[index_of(StrategyId::anisotropic)];
      const double phase = 50.0 * snapshot.time_s;
      const Vector<2> tremor = 0.0002 * Vector<2>(std::cos(phase), std::sin(1.3 * phase));
      snapshot.goal = now.device - now.force / 500.0;
      now.device += tremor;
      now.proxy += tremor;
      append_run_row(rows, snapshot, StrategyId::anisotropic);
      const Vector<2> sent = limited_by(now.force, snapshot.time_s);
      fmt::format_to(std::back_inserter(rows), ",1,estimated,measured,{},{},{},0.001\n", sent.x, sent.y,
                     says_saturated && sent != now.force ? 1 : 0);
    });
    std::ofstream(path("device.csv")) << run_header(scene,
                                                    ",active,goal_kind,device_kind,sent_x_N,sent_y_N,saturated,loop_s")
                                      << std::string_view(rows.data(), rows.size());
    return path("device.csv");
  }

  // A recording of a hand that holds still in the wall for 4 s, at a real device or a simulated one. From 1 s on tones
  // measure it.
  std::string with_tones(double k_u, bool at_device, bool is_saturated = false) {
    Scene scene = load_scene("wall45");
    scene.settings.stiffnesses.k_u = k_u;
    scene.settings.stiffnesses.believed_k_u = 500.0;
    scene.settings.active = StrategyId::anisotropic;
    const std::size_t active = index_of(scene.settings.active);
    const TickCoefficients<2> coefficients = coefficients_of(scene.settings);
    const double dt = 1.0 / scene.settings.rate;
    const Vector<2> goal = scene.goal.points.back();
    TickState<2> state = equilibrium_state(scene.settings, goal);
    MeasuringTones tones;
    fmt::memory_buffer rows;
    while (state.tick < 4000) {
      tick(coefficients, goal, state);
      const Vector<2> tone(tones.step(state.tick > 1000, true, usual_tone_force, dt), 0.0);
      state.strategies[active].tone = tone;
      const Snapshot snapshot = snapshot_of(coefficients, state);
      append_run_row(rows, snapshot, StrategyId::anisotropic);
      const Vector<2> sent = at_device ? snapshot.strategies[active].force + tone : Vector<2>(0.0);
      fmt::format_to(std::back_inserter(rows), ",1,{},{},{},{},{},0.001,{},{}\n", at_device ? "estimated" : "given",
                     at_device ? "measured" : "simulated", sent.x, sent.y, is_saturated ? 1 : 0, tone.x, tone.y);
    }
    std::ofstream(path("tones.csv")) << run_header(scene, recording_columns)
                                     << std::string_view(rows.data(), rows.size());
    return path("tones.csv");
  }

  TemporaryFolder folder_;
};

TEST_F(MeasureUser, TonesTellTheHandWithoutAnyTarget) {
  for (const bool at_device : {true, false}) {
    SCOPED_TRACE(at_device);
    const nlohmann::json json = measured(with_tones(310.0, at_device));
    ASSERT_EQ(json["live"].size(), 20U) << "every 0.1 s of 4 s, from the first window on";
    const nlohmann::json& early = json["live"][0];
    EXPECT_DOUBLE_EQ(early["t_s"].get<double>(), 2.1) << "the first row is that of 0.001 s";
    EXPECT_FALSE(early["known"].get<bool>());
    EXPECT_NE(early["reason"], "");
    for (const char* const number : {"k_u_N_per_m", "sigma_N_per_m", "mass_kg", "damping_N_s_per_m"}) {
      EXPECT_TRUE(early[number].is_null()) << number;
    }
    const nlohmann::json& last = json["live"].back();
    EXPECT_TRUE(last["known"].get<bool>()) << last;
    EXPECT_EQ(last["reason"], "");
    EXPECT_NEAR(last["k_u_N_per_m"].get<double>(), 310.0, 0.005 * 310.0);
    EXPECT_NEAR(last["mass_kg"].get<double>(), 0.1, 0.002);
    // The tick's delay adds up to 0.7 N·s/m (docs/theory.md).
    EXPECT_NEAR(last["damping_N_s_per_m"].get<double>(), 5.0, 0.8);
    EXPECT_GT(last["sigma_N_per_m"].get<double>(), 0.0);
    // Until the tones begin, the hand is at rest; a real one's goal is known by nobody.
    EXPECT_EQ(json["hands"].size(), at_device ? 0U : 1U);
  }
  const Outcome outcome = run_ghostforce({"measure-user", with_tones(310.0, true)});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("measured live, at 3 Hz along the motor: median 3"), std::string::npos) << outcome.out;
}

// What was sent is the model's force and the tones: nothing has shortened it.
TEST_F(MeasureUser, TonesAreNoLimit) {
  const nlohmann::json json = measured(with_tones(310.0, true), {"--target-mm=0,0"});
  ASSERT_EQ(json["readings"].size(), 1U) << json;
  EXPECT_FALSE(json["readings"][0].contains("why_not")) << json["readings"][0];
  // The mean over seconds of tones.
  EXPECT_NEAR(median_of(json), 310.0, 0.02 * 310.0);
}

TEST_F(MeasureUser, AForceAtItsLimitTellsNoHand) {
  const Outcome outcome = run_ghostforce({"measure-user", with_tones(310.0, true, true), "--json"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("at its limit"), std::string::npos) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  ASSERT_FALSE(json["live"].empty());
  for (const nlohmann::json& reading : json["live"]) {
    EXPECT_FALSE(reading["known"].get<bool>());
    EXPECT_TRUE(reading["k_u_N_per_m"].is_null());
  }
}

TEST_F(MeasureUser, ARunWithoutTonesHasOneLiveEntryThatSaysSo) {
  const nlohmann::json json = measured(simulated({}));
  ASSERT_EQ(json["live"].size(), 1U);
  EXPECT_FALSE(json["live"][0]["known"].get<bool>());
  EXPECT_NE(json["live"][0]["reason"].get<std::string>().find("tones did not sound"), std::string::npos);
}

TEST_F(MeasureUser, GivesBackTheStiffnessOfASimulatedHandWhateverWasBelieved) {
  for (const std::string k_c : {"2000", "1e5", "inf"}) {
    for (const std::string believed : {"40", "1500"}) {
      for (const double k_u : {90.0, 350.0}) {
        for (const std::string angle : {"120", "60"}) {
          SCOPED_TRACE(testing::Message() << k_c << ' ' << believed << ' ' << k_u << ' ' << angle);
          // The goal of wall45 is inside for either angle.
          const nlohmann::json json =
              measured(simulated({"rendering.k_c_N_per_m=" + k_c, "user.believed_k_u_N_per_m=" + believed,
                                  fmt::format("user.k_u_N_per_m={}", k_u), "wall.normal_deg=" + angle,
                                  "goal.path_mm=[[0, 0], [-5, -20]]"}));
          ASSERT_EQ(json["readings"].size(), 2U) << json;
          for (const nlohmann::json& reading : json["readings"]) {
            // The second half of a rest of two seconds is some ten time constants from its beginning, which was within
            // 0.02 mm: a share of 1e-6 of a drift of millimetres.
            EXPECT_NEAR(reading["k_u_N_per_m"].get<double>(), k_u, 1e-5 * k_u) << reading;
            EXPECT_EQ(reading["given_k_u_N_per_m"], k_u);
          }
          ASSERT_EQ(json["hands"].size(), 1U);
          EXPECT_EQ(json["hands"][0]["given_k_u_N_per_m"], k_u);
          EXPECT_EQ(json["hands"][0]["count"], 2) << "one for each strategy that drifts";
          EXPECT_NEAR(json["hands"][0]["k_u_N_per_m"]["median"].get<double>(), k_u, 1e-5 * k_u);
        }
      }
    }
  }
}

TEST_F(MeasureUser, AHandThatChangesIsOneForEachStiffness) {
  const nlohmann::json json =
      measured(simulated({"user.k_u_path_N_per_m=[100, 100, 400]", "user.k_u_times_s=[0, 2, 2.1]",
                          "user.believed_k_u_N_per_m=50", "goal.duration_s=5"}));
  ASSERT_EQ(json["hands"].size(), 2U) << json;
  for (const nlohmann::json& hand : json["hands"]) {
    const double given = hand["given_k_u_N_per_m"].get<double>();
    EXPECT_NEAR(hand["k_u_N_per_m"]["median"].get<double>(), given, 1e-3 * given) << hand;
  }
  EXPECT_EQ(json["hands"][0]["given_k_u_N_per_m"], 100.0);
  EXPECT_EQ(json["hands"][1]["given_k_u_N_per_m"], 400.0);
}

TEST_F(MeasureUser, TellsPeopleTheMedianAndTheGivenValue) {
  const Outcome outcome = run_ghostforce({"measure-user", simulated({"user.believed_k_u_N_per_m=50"})});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("median 200.00 N/m of 2 readings"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("given to the simulated hand: 200.00 N/m"), std::string::npos) << outcome.out;
}

TEST_F(MeasureUser, ADeviceNeedsTheTargetThatWasAimedAt) {
  const Vector<2> aim{0.012, -0.016};
  const std::string file = of_a_device(aim, 150.0);
  const Outcome without = run_ghostforce({"measure-user", file});
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_NE(without.err.find("--target-mm"), std::string::npos) << without.err;
  EXPECT_EQ(without.out, "");

  // Any point on the normal through the aim: its foot on the wall.
  const nlohmann::json json = measured(file, {"--target-mm=-2,-2"});
  EXPECT_EQ(json["device_kind"], "measured");
  ASSERT_EQ(json["readings"].size(), 1U);
  EXPECT_FALSE(json["readings"][0].contains("given_k_u_N_per_m"));
  // The aim is 0 along the wall from the target; of the tremor of 0.2 mm the mean over half a second or more leaves a
  // hundredth.
  EXPECT_NEAR(median_of(json), 150.0, 1.5);
  // Somewhere else it is another hand: the target matters. Aside by 2√2 mm, the drift is off by as much.
  const nlohmann::json elsewhere = measured(file, {"--target-mm=0,0"});
  EXPECT_NEAR(
      std::abs(elsewhere["readings"][0]["drift_m"].get<double>() - json["readings"][0]["drift_m"].get<double>()),
      std::sqrt(8.0) * 1e-3, 1e-9);
  EXPECT_GT(std::abs(median_of(elsewhere) - 150.0), 15.0) << elsewhere;
}

// The drift of a force that was shortened on its way is that of another hand.
TEST_F(MeasureUser, ForcesThatWereLimitedAreNoReading) {
  const Vector<2> aim{0.012, -0.016};
  const std::string words = "gave less than was asked";
  const auto expect_limited = [&](const std::string& file) {
    const Outcome outcome = run_ghostforce({"measure-user", file, "--target-mm=-2,-2"});
    EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  };
  const auto at_most = [](double limit) {
    return [limit](const Vector<2>& force, double) {
      const double length = glm::length(force);
      return length > limit ? force * (limit / length) : force;
    };
  };
  // The force is some newtons.
  expect_limited(of_a_device(aim, 150.0, at_most(0.5), true));
  expect_limited(of_a_device(aim, 150.0, [](const Vector<2>&, double) { return Vector<2>(0.0); }));
  expect_limited(of_a_device(aim, 150.0, [](const Vector<2>& force, double time_s) { return force * (time_s / 2.0); }));

  // A ramp that is over before the second half of the hold, of which the mean is taken.
  const auto ramped = [](const Vector<2>& force, double time_s) { return force * std::min(1.0, time_s / 0.5); };
  EXPECT_NEAR(median_of(measured(of_a_device(aim, 150.0, ramped), {"--target-mm=-2,-2"})), 150.0, 1.5);
  // A handle whose way is shown 1.5 times as large: a share that is always the same.
  const auto scaled = [](const Vector<2>& force, double) { return force / 1.5; };
  EXPECT_NEAR(median_of(measured(of_a_device(aim, 150.0, scaled), {"--target-mm=-2,-2"})), 150.0, 1.5);
}

// As recorded while k_u, then what is believed of it, was changed: three stretches of rest, of two hands.
TEST_F(MeasureUser, EachHandHasItsOwnMedian) {
  Scene scene = load_scene("wall45");
  scene.settings.stiffnesses.believed_k_u = 200.0;
  scene.goal = {{{0.012, -0.016}}, {0.0}, Motion::linear};
  scene.duration = 2.0;
  const Settings first = scene.settings;
  fmt::memory_buffer rows;
  Settings known = first;
  // Where it rests with these settings, for a second.
  const auto rest_for_a_second = [&](const Settings& settings, int from_s) {
    append_set_lines(rows, from_s, known, settings);
    Scene part = scene;
    part.settings = settings;
    Snapshot rest;
    simulate(part, last_tick(part), [&](const Snapshot& snapshot) { rest = snapshot; });
    for (int k = 1000 * from_s; k < 1000 * (from_s + 1); ++k) {
      rest.time_s = k / 1000.0;
      for (const Strategy& strategy : strategy_catalog()) {
        append_run_row(rows, rest, strategy.id);
        rows.push_back('\n');
      }
    }
  };
  Settings settings = first;
  rest_for_a_second(settings, 0);
  settings.stiffnesses.k_u = 900.0;
  rest_for_a_second(settings, 1);
  settings.stiffnesses.believed_k_u = 300.0;
  rest_for_a_second(settings, 2);
  std::ofstream(path("hands.csv")) << run_header(scene) << std::string_view(rows.data(), rows.size());

  const nlohmann::json json = measured(path("hands.csv"));
  // N does not know what is believed: its second rest goes on. A has a ratio of its own in each.
  ASSERT_EQ(json["readings"].size(), 5U) << json;
  ASSERT_EQ(json["hands"].size(), 2U) << json;
  EXPECT_EQ(json["hands"][0]["given_k_u_N_per_m"], 200.0);
  EXPECT_EQ(json["hands"][0]["count"], 2);
  EXPECT_NEAR(json["hands"][0]["k_u_N_per_m"]["median"].get<double>(), 200.0, 0.2);
  EXPECT_EQ(json["hands"][1]["given_k_u_N_per_m"], 900.0);
  EXPECT_EQ(json["hands"][1]["count"], 3);
  EXPECT_NEAR(json["hands"][1]["k_u_N_per_m"]["median"].get<double>(), 900.0, 0.9);
  const std::string table = run_ghostforce({"measure-user", path("hands.csv")}).out;
  EXPECT_NE(table.find("given to the simulated hand: 200.00 N/m"), std::string::npos) << table;
  EXPECT_NE(table.find("given to the simulated hand: 900.00 N/m"), std::string::npos) << table;
}

TEST_F(MeasureUser, SaysThatATargetIsOfNoUseWhereTheGoalIsGiven) {
  const std::string file = simulated({});
  const Outcome outcome = run_ghostforce({"measure-user", file, "--target-mm=0,0"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("--target-mm, which is for a real device, is not used"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, run_ghostforce({"measure-user", file}).out);
}

TEST_F(MeasureUser, SaysWhyThereIsNoReading) {
  const auto expect_none = [&](const std::string& file, std::string_view why) {
    for (const bool json : {false, true}) {
      std::vector<std::string> words{"measure-user", file};
      if (json) words.emplace_back("--json");
      const Outcome outcome = run_ghostforce(words);
      EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
      EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
      EXPECT_EQ(outcome.out.empty(), !json);
      if (json) {
        EXPECT_TRUE(nlohmann::json::parse(outcome.out)["hands"].empty());
      }
    }
  };
  expect_none(simulated({"wall.normal_deg=180"}), "turn one of them");
  expect_none(simulated({"rendering.k_r_N_per_m=0"}), "raise k_r");
  expect_none(simulated({"goal.path_mm=[[-20, 20], [-5, 5]]"}), "press into the wall");
  expect_none(simulated({"goal.duration_s=1.1"}), "hold still for at least 0.25 s");
}

TEST_F(MeasureUser, RefusesWhatItCannotRead) {
  const Outcome absent = run_ghostforce({"measure-user", path("absent.csv")});
  EXPECT_EQ(absent.exit_code, 2);
  EXPECT_NE(absent.err.find("no such file"), std::string::npos);
  const Outcome nothing = run_ghostforce({"measure-user"});
  EXPECT_EQ(nothing.exit_code, 2);
  const Outcome nowhere = run_ghostforce({"measure-user", simulated({}), "--target-mm=here"});
  EXPECT_EQ(nowhere.exit_code, 2);
  EXPECT_NE(nowhere.err.find("--target-mm"), std::string::npos);
  std::ofstream(path("text.csv")) << "once upon a time\n";
  EXPECT_EQ(run_ghostforce({"measure-user", path("text.csv")}).exit_code, 2);
}

}  // namespace
}  // namespace ghostforce::measure_user_test
