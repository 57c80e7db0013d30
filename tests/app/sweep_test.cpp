// `sweep`: the ranges, the rows against independent ways to know them, and how it ends.
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <csignal>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/progress.h"
#include "app/run_file.h"
#include "app/scene_file.h"
#include "app/scene_key_name.h"
#include "app/sweep/rows.h"
#include "app/sweep/sweep.h"
#include "core/equilibrium.h"
#include "core/ghost_force.h"
#include "tests/support/program.h"
#include "tests/support/scene_values.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {
namespace {

Outcome run(std::vector<std::string> words) {
  words.insert(words.begin(), "sweep");
  return run_program(GHOSTFORCE_PROGRAM, std::move(words));
}

Range range(std::string_view argument) {
  auto parsed = parse_range(argument);
  if (const auto* const what = std::get_if<std::string>(&parsed)) throw std::runtime_error(*what);
  return std::get<Range>(parsed);
}

std::vector<double> values(std::string_view argument) {
  return range(argument).values;
}

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.emplace_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

struct Row {
  std::map<std::string, std::string> fields;

  const std::string& text(const std::string& column) const { return fields.at(column); }
  double number(const std::string& column) const {
    const std::string& digits = text(column);
    double value = std::nan("");
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
  }
  Vector<2> vector(const std::string& name, const std::string& unit) const {
    return {number(name + "_x_" + unit), number(name + "_y_" + unit)};
  }
  StrategyId strategy() const { return find_strategy(text("strategy")).value(); }
};

struct Csv {
  std::vector<std::string> comments;
  std::vector<std::string> columns;
  std::vector<Row> rows;
};

Csv parse_csv(const std::string& text) {
  EXPECT_TRUE(text.ends_with("\n"));
  Csv csv;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with('#')) {
      csv.comments.push_back(line);
      continue;
    }
    const std::vector<std::string> fields = split(line);
    if (csv.columns.empty()) {
      csv.columns = fields;
      continue;
    }
    EXPECT_EQ(fields.size(), csv.columns.size()) << line;
    Row row;
    for (std::size_t i = 0; i < std::min(fields.size(), csv.columns.size()); ++i) {
      row.fields[csv.columns[i]] = fields[i];
    }
    csv.rows.push_back(row);
  }
  return csv;
}

Csv swept(std::vector<std::string> words) {
  const Outcome outcome = run(std::move(words));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return parse_csv(outcome.out);
}

// --- Ranges ---

TEST(SweepRange, EndsAreHitExactlyAndValuesAreWhatAPersonWouldWrite) {
  EXPECT_EQ(values("wall.normal_deg=0:180:7"), (std::vector<double>{0, 30, 60, 90, 120, 150, 180}));
  EXPECT_EQ(values("device.mass_kg=0.1:1:10"), (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1}));
  EXPECT_EQ(values("wall.normal_deg=10:-10:5"), (std::vector<double>{10, 5, 0, -5, -10}));
  EXPECT_EQ(values(" wall.normal_deg = +1 : 2 : 2 "), (std::vector<double>{1, 2}));
  EXPECT_EQ(values("wall.normal_deg=3:4:1"), std::vector<double>{3});
  EXPECT_EQ(values("user.k_u_N_per_m=1:1000:4:log"), (std::vector<double>{1, 10, 100, 1000}));
  EXPECT_EQ(values("user.k_u_N_per_m=1000:1:4:log"), (std::vector<double>{1000, 100, 10, 1}));
  EXPECT_EQ(values("device.rate_hz=10:10000:4:log"), (std::vector<double>{10, 100, 1000, 10000}));
  for (const double value : values("wall.normal_deg=-1:1:21")) EXPECT_FALSE(value == 0.0 && std::signbit(value));
}

TEST(SweepRange, ValuesIncreaseAndStayBetweenTheEnds) {
  for (const std::string_view argument :
       {"user.k_u_N_per_m=0.1:1000000:10003", "user.k_u_N_per_m=0.1:1000000:10003:log",
        "user.k_u_N_per_m=0.30000000000000004:0.7:1001", "rendering.k_c_N_per_m=3:7:1001:log",
        "wall.normal_deg=-1e+308:1e+308:1001", "wall.normal_deg=1e+307:1.7e+308:1001"}) {
    const std::vector<double> all = values(argument);
    EXPECT_EQ(fmt::format("{}={}:{}:{}{}", argument.substr(0, argument.find('=')), all.front(), all.back(), all.size(),
                          argument.ends_with(":log") ? ":log" : ""),
              argument);
    for (std::size_t i = 1; i < all.size(); ++i) ASSERT_LT(all[i - 1], all[i]) << argument << " at " << i;
  }
}

TEST(SweepRange, LogarithmicStepsAreEqualRatios) {
  const std::vector<double> all = values("rendering.k_r_N_per_m=7:7000:11:log");
  const double ratio = std::pow(1000.0, 0.1);
  // Some ulp of pow() and of log10() times the logarithm.
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_NEAR(all[i] / all[i - 1], ratio, 1e-13 * ratio);
}

// Each number key, by --over and by --set with the text that the file shows.
TEST(SweepRange, AValueIsBitForBitThatOfSet) {
  int keys = 0;
  for (const SceneKey& key : scene_keys()) {
    double least = 0.0;
    double greatest = 0.0;
    bool whole = false;
    if (const auto* const number = std::get_if<NumberKey>(&key.value)) {
      least = number->least;
      greatest = number->greatest;
      whole = number->whole;
    } else if (const auto* const optional = std::get_if<OptionalNumberKey>(&key.value)) {
      least = optional->least;
      greatest = optional->greatest;
    } else {
      continue;
    }
    ++keys;
    const std::string name = dotted_name(key.table, key.name);
    const double from = whole ? 10.0 : std::max(least, -777.7);
    const double to = whole ? 970.0 : std::min(greatest, 999.9);
    const Scene scene = load_scene("wall45");
    const Grid grid = make_grid(std::vector{fmt::format("{}={}:{}:25", name, from, to)}, scene);
    for (std::int64_t point = 0; point < size_of(grid); ++point) {
      Scene by_sweep = scene;
      put_point(grid, point, by_sweep);
      const Scene by_set = load_scene("wall45", std::vector{fmt::format("{}={}", name, value_at(grid, 0, point))});
      ASSERT_EQ(scene_values(by_sweep), scene_values(by_set)) << name << " at " << point;
    }
  }
  EXPECT_EQ(keys, 13);
}

TEST(SweepRange, WrongOnesAreRefusedAndNothingIsWritten) {
  struct Case {
    std::vector<std::string> ranges;
    std::string_view said;
  };
  const std::vector<Case> cases{
      {{"wall.normal_deg"}, "--over wall.normal_deg: give KEY=FROM:TO:COUNT"},
      {{"=1:2:3"}, "give KEY=FROM:TO:COUNT"},
      {{"wall.normal_deg=1:2"}, "'1:2' is no range; give KEY=FROM:TO:COUNT"},
      {{"wall.normal_deg=1:2:3:log:4"}, "is no range"},
      {{"wall.normal_deg=90"}, "'90' is no range"},
      {{"wall.normaldeg=1:2:3"}, "the key wall.normaldeg is unknown; did you mean 'wall.normal_deg'?"},
      {{"k_r=1:2:3"}, "the key k_r is unknown; did you mean 'rendering.k_r_N_per_m'?"},
      {{"format=1:2:3"}, "the key format is unknown"},
      {{"goal.path_mm=1:2:3"}, "the key goal.path_mm is not one number; a sweep can go over wall.normal_deg, "},
      {{"title=1:2:3"}, "the key title is not one number"},
      {{"rendering.strategy=1:2:3"}, "the key rendering.strategy is not one number"},
      {{"wall.normal_deg=a:2:3"}, "FROM is 'a'; give a finite number"},
      {{"wall.normal_deg=1:2x:3"}, "TO is '2x'; give a finite number"},
      {{"wall.normal_deg=1::3"}, "TO is nothing; give a finite number"},
      {{"wall.normal_deg=nan:2:3"}, "FROM is 'nan'; give a finite number"},
      {{"wall.normal_deg=1:-inf:3"}, "TO is '-inf'; give a finite number"},
      {{"wall.normal_deg=1e999:2:3"}, "FROM is '1e999'; give a finite number"},
      {{"rendering.k_c_N_per_m=1:inf:3"}, "with --set rendering.k_c_N_per_m=inf"},
      {{"user.k_u_N_per_m=0:1:3"}, "FROM is 0, out of the key's range; give 0.1 to 1000000 N/m"},
      {{"user.k_u_N_per_m=1:1.1e6:1"}, "TO is 1100000, out of the key's range"},
      {{"rendering.tracking_ratio=1:1001:3"}, "TO is 1001, out of the key's range; give 0.001 to 1000"},
      {{"wall.normal_deg=1:2:0"}, "COUNT is '0'; give a whole number from 1 to 10000000"},
      {{"wall.normal_deg=1:2:-3"}, "COUNT is '-3'"},
      {{"wall.normal_deg=1:2:2.5"}, "COUNT is '2.5'"},
      {{"wall.normal_deg=1:2:"}, "COUNT is nothing"},
      {{"wall.normal_deg=1:2:10000001"}, "COUNT is '10000001'"},
      {{"wall.normal_deg=1:2:99999999999999999999"}, "COUNT is '99999999999999999999'"},
      {{"wall.normal_deg=1:2:3:lin"}, "the spacing is 'lin'; write log"},
      {{"wall.normal_deg=0:2:3:log"}, "log needs FROM and TO greater than 0, and FROM is 0"},
      {{"wall.normal_deg=1:-2:3:log"}, "log needs FROM and TO greater than 0, and TO is -2"},
      {{"device.rate_hz=100:200:4"}, "number 2 of 4 would be 133.333333333333"},
      {{"device.rate_hz=100.5:200:1"}, "number 1 of 1 would be 100.5"},
      {{"wall.normal_deg=1:2:3", "wall.normal_deg=1:2:4"}, "the key wall.normal_deg is swept already"},
      {{"wall.normal_deg=1:2:3", "user.k_u_N_per_m=1:2:3", "device.mass_kg=1:2:3"}, "one or two keys"},
      {{"wall.normal_deg=1:2:10000", "user.k_u_N_per_m=1:2:1001"}, "the sweep would have 10010000 points"},
      {{"goal.duration_s=1:1e5:4"}, "with goal.duration_s=33334 the key goal.duration_s: duration_s times rate_hz"},
      {{"goal.duration_s=1:1000:2", "device.rate_hz=1000:20000:2"},
       "with goal.duration_s=1000 and device.rate_hz=20000 the key goal.duration_s"},
  };
  const TemporaryFolder folder;
  for (const Case& wrong : cases) {
    std::vector<std::string> words{"wall45", "-o", folder / "sweep.csv"};
    for (const std::string& argument : wrong.ranges) words.push_back("--over=" + argument);
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 2) << wrong.said;
    EXPECT_NE(outcome.err.find(wrong.said), std::string::npos) << wrong.said << "\n" << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder.count(), 0) << wrong.said;
  }
  EXPECT_EQ(run({"wall45"}).exit_code, 2);
  const Outcome wrong_kind = run({"wall45", "--over=wall.normal_deg=1:2:3", "--at-rest=closed-from"});
  EXPECT_EQ(wrong_kind.exit_code, 2);
  EXPECT_NE(wrong_kind.err.find("did you mean 'closed-form'?"), std::string::npos) << wrong_kind.err;
}

// --- Rows ---

TEST(Sweep, HeaderColumnsAndOrder) {
  const std::string set = "--set=rendering.k_t_N_per_m=700";
  const Csv csv =
      swept({"fig3-normal", "--over=wall.normal_deg=90:150:3", "--over=rendering.k_r_N_per_m=10:1000:3:log", set});
  const Scene scene = load_scene("fig3-normal", std::vector<std::string>{"rendering.k_t_N_per_m=700"});
  std::string comments;
  for (const std::string& line : csv.comments) comments += line + "\n";
  EXPECT_TRUE(comments.starts_with(provenance(scene))) << comments;
  EXPECT_NE(comments.find("# over wall.normal_deg=90:150:3\n# over rendering.k_r_N_per_m=10:1000:3:log\n"),
            std::string::npos)
      << comments;
  EXPECT_EQ(csv.columns, split("wall.normal_deg,rendering.k_r_N_per_m,strategy,depth_m,device_x_m,device_y_m,"
                               "proxy_x_m,proxy_y_m,force_x_N,force_y_N,ghost_force_x_N,ghost_force_y_N,"
                               "proxy_drift_x_m,proxy_drift_y_m,simulated_device_x_m,simulated_device_y_m,"
                               "simulated_proxy_x_m,simulated_proxy_y_m,simulated_force_x_N,simulated_force_y_N,"
                               "settled"));
  std::vector<std::string> order;
  for (const Row& row : csv.rows) {
    order.push_back(row.text("wall.normal_deg") + " " + row.text("rendering.k_r_N_per_m") + " " + row.text("strategy"));
  }
  std::vector<std::string> expected;
  for (const std::string_view angle : {"90", "120", "150"}) {
    for (const std::string_view stiffness : {"10", "100", "1000"}) {
      for (const std::string_view name : {"full", "naive", "anisotropic"}) {
        expected.push_back(fmt::format("{} {} {}", angle, stiffness, name));
      }
    }
  }
  EXPECT_EQ(order, expected);
}

TEST(Sweep, ColumnsOfOneKindAloneAreThoseOfBoth) {
  const auto words = [](std::string kind) {
    return std::vector<std::string>{"fig1", "--over=wall.normal_deg=90:150:3", "--at-rest=" + kind};
  };
  const Csv both = swept(words("both"));
  const Csv predicted = swept(words("closed-form"));
  const Csv simulated = swept(words("simulated"));
  EXPECT_EQ(predicted.columns.size() + simulated.columns.size(), both.columns.size() + 3);
  for (const Csv* const part : {&predicted, &simulated}) {
    ASSERT_EQ(part->rows.size(), both.rows.size());
    for (std::size_t i = 0; i < both.rows.size(); ++i) {
      for (const auto& [column, text] : part->rows[i].fields) EXPECT_EQ(text, both.rows[i].text(column)) << column;
    }
  }
}

TEST(Sweep, OnePointIsWhatEquilibriumTells) {
  const Csv csv = swept({"fig1", "--over=user.believed_k_u_N_per_m=33.3:120:3", "--over=wall.normal_deg=95.5:140:3",
                         "--at-rest=closed-form"});
  for (const Row& row : csv.rows) {
    const Outcome outcome =
        run_program(GHOSTFORCE_PROGRAM, {"equilibrium", "fig1", "--json",
                                         "--set=user.believed_k_u_N_per_m=" + row.text("user.believed_k_u_N_per_m"),
                                         "--set=wall.normal_deg=" + row.text("wall.normal_deg")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const nlohmann::json told = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(row.number("depth_m"), told.at("depth_m").get<double>());
    const nlohmann::json& of = told.at("strategies").at(row.text("strategy"));
    for (const auto& [column, unit, name] :
         {std::array{"device", "m", "device_m"}, std::array{"proxy", "m", "proxy_m"},
          std::array{"force", "N", "force_N"}, std::array{"ghost_force", "N", "ghost_force_N"},
          std::array{"proxy_drift", "m", "proxy_drift_m"}}) {
      const Vector<2> expected(of.at(name)[0].get<double>(), of.at(name)[1].get<double>());
      EXPECT_EQ(row.vector(column, unit), expected) << column;
    }
  }
}

// The scene with the values that a row was swept with, by way of --set.
Scene scene_of(const Row& row, const std::string& name, const std::vector<std::string>& keys,
               std::vector<std::string> set = {}) {
  for (const std::string& key : keys) set.push_back(key + "=" + row.text(key));
  return load_scene(name, set);
}

TEST(Sweep, ClosedFormsSolveTheLinearSystem) {
  const std::vector<std::string> set{"user.k_u_N_per_m=150", "user.believed_k_u_N_per_m=70"};
  for (const std::vector<std::string>& keys : {std::vector<std::string>{"wall.normal_deg", "rendering.k_r_N_per_m"},
                                               {"device.actuated_deg", "rendering.k_c_N_per_m"},
                                               {"rendering.tracking_ratio", "rendering.k_t_N_per_m"}}) {
    std::vector<std::string> words{"fig1", "--at-rest=closed-form", "--set=" + set[0], "--set=" + set[1]};
    words.push_back("--over=" + keys[0] + (keys[0].ends_with("deg") ? "=95:175:9" : "=0.5:30:9"));
    words.push_back("--over=" + keys[1] + "=20:1e5:7:log");
    const Csv csv = swept(words);
    ASSERT_EQ(csv.rows.size(), 9U * 7U * 3U);
    for (const Row& row : csv.rows) {
      const Scene scene = scene_of(row, "fig1", keys, set);
      const Impedances& impedances = scene.settings.impedances;
      const Wall<2> wall = wall_of(scene.settings);
      const Actuation<2> actuation = actuation_of(scene.settings);
      const Vector<2> goal = scene.goal.points.back();
      const auto solved = [&](StrategyId id) {
        return equilibrium_by_linear_solve(wall, make_coupling(strategy(id), impedances, actuation), impedances.k_u,
                                           impedances.k_c, goal);
      };
      const Equilibrium<2> expected = solved(row.strategy());
      // Elimination without scaling loses as many digits as the stiffnesses lie apart, 4 or so of 16.
      const double distance = 1e-11;
      const double force = distance * (impedances.k_r + impedances.k_u);
      const auto near = [&](const char* column, const char* unit, const Vector<2>& value, double tolerance) {
        EXPECT_NEAR(row.number(fmt::format("{}_x_{}", column, unit)), value.x, tolerance) << column;
        EXPECT_NEAR(row.number(fmt::format("{}_y_{}", column, unit)), value.y, tolerance) << column;
      };
      EXPECT_NEAR(row.number("depth_m"), depth(wall, goal), 1e-15);
      near("device", "m", expected.device, distance);
      near("proxy", "m", expected.proxy, distance);
      near("force", "N", expected.force, force);
      near("ghost_force", "N", ghost_force(actuation, expected.force, solved(StrategyId::full).force), force);
      near("proxy_drift", "m", proxy_drift(wall, expected.proxy, goal), distance);
    }
  }
}

TEST(Sweep, SimulatedDevicesEndWhereTheClosedFormsSay) {
  for (const std::vector<std::string>& keys : {std::vector<std::string>{"wall.normal_deg", "rendering.k_r_N_per_m"},
                                               {"device.actuated_deg", "rendering.k_c_N_per_m"},
                                               {"rendering.tracking_ratio", "user.believed_k_u_N_per_m"},
                                               {"device.mass_kg", "device.damping_N_s_per_m"}}) {
    const bool turns = keys[0].ends_with("deg");
    const bool mass = keys[0].ends_with("kg");
    const Csv csv = swept({"fig1",
                           "--over=" + keys[0] +
                               (turns  ? "=-180:180:17"
                                : mass ? "=0.05:0.5:4"
                                       : "=0.5:30:5"),
                           "--over=" + keys[1] + (mass ? "=2:200:5:log" : "=20:2000:5:log")});
    double deepest = 0.0;
    for (const Row& row : csv.rows) {
      ASSERT_EQ(row.text("settled"), "1");
      const Scene scene = scene_of(row, "fig1", keys);
      const Impedances& impedances = scene.settings.impedances;
      deepest = std::max(deepest, row.number("depth_m"));
      // The forces on the device cancel to what k_u makes of 1 pm and to rounding, 16 ulp of 0.1 m here times the
      // stiffnesses over k_u, another 1 pm at most; along the wall a device can be off by up to 1 + √κ/2 times that.
      const double kappa = impedances.k_r / impedances.k_u;
      const double step = std::max(1.0, std::sqrt(tracking_ratio(impedances)));
      const double distance = 2e-12 * (1.0 + std::sqrt(kappa) / 2.0);
      const auto near = [&](const char* column, const char* unit, double tolerance) {
        for (const char* const axis : {"x", "y"}) {
          const std::string name = fmt::format("{}_{}_{}", column, axis, unit);
          EXPECT_NEAR(row.number("simulated_" + name), row.number(name), tolerance)
              << name << " " << row.text(keys[0]) << " " << row.text(keys[1]) << " " << row.text("strategy");
        }
      };
      near("device", "m", distance);
      near("proxy", "m", distance * (1.0 + step));
      near("force", "N", distance * (2.0 + step) * impedances.k_r);
    }
    EXPECT_GT(deepest, 0.01);
  }
}

TEST(Sweep, GoalOutsideTheWallIsWhereEverythingEnds) {
  const Csv csv = swept({"fig1", "--over=wall.normal_deg=-60:-30:2"});
  for (const Row& row : csv.rows) {
    EXPECT_LT(row.number("depth_m"), 0.0);
    EXPECT_EQ(row.vector("device", "m"), Vector<2>(0.03, -0.05));
    EXPECT_EQ(row.vector("proxy", "m"), Vector<2>(0.03, -0.05));
    for (const char* const name : {"force", "ghost_force"}) EXPECT_EQ(row.vector(name, "N"), Vector<2>(0.0));
    EXPECT_EQ(row.vector("proxy_drift", "m"), Vector<2>(0.0));
    EXPECT_EQ(row.text("settled"), "1");
    EXPECT_LT(glm::distance(row.vector("simulated_device", "m"), Vector<2>(0.03, -0.05)), 2e-12);
  }
}

// The hand of this scene would come to its last waypoint after the duration: it is put there.
TEST(Sweep, ThePathMayBeCutShortByTheDuration) {
  const Csv csv = swept({"fig1", "--set=goal.times_s=[0.0, 1e6]", "--over=goal.duration_s=0:0.01:2"});
  for (const Row& row : csv.rows) {
    EXPECT_EQ(row.text("settled"), "1");
    EXPECT_LT(glm::distance(row.vector("simulated_device", "m"), row.vector("device", "m")), 1e-11);
  }
}

void expect_not_settled(const Row& row) {
  EXPECT_EQ(row.text("settled"), "0");
  for (const char* const column : {"device_x_m", "device_y_m", "proxy_x_m", "proxy_y_m", "force_x_N", "force_y_N"}) {
    EXPECT_EQ(row.text(std::string("simulated_") + column), "") << column;
    EXPECT_NE(row.text(column), "") << column;
  }
}

TEST(Sweep, WhatNeverComesToRestIsLeftEmpty) {
  // k_r dt²/m is 10 and more at the far end: unstable. At the near end it is 0.01.
  for (const Row& row : swept({"fig3-normal", "--over=rendering.k_r_N_per_m=1000:1e6:2"}).rows) {
    if (row.number("rendering.k_r_N_per_m") == 1000.0) {
      EXPECT_EQ(row.text("settled"), "1");
    } else {
      expect_not_settled(row);
    }
  }
  // Stable, but the slowest of its motions decays within b/k_u = 1e5 s.
  const Csv slow = swept({"fig3-normal", "--over=user.k_u_N_per_m=0.1:0.1:1", "--set=device.damping_N_s_per_m=1e4"});
  for (const Row& row : slow.rows) expect_not_settled(row);
}

TEST(Sweep, AnUnstableLoopIsFoundOutThoughTheHandDoesNotExciteIt) {
  // The hand comes straight at the wall. Along it the fully actuated device is multiplied by (m − dt² k_r) / (m + dt b
  // + dt² k_u) per tick: by −0.9986 at 13930 N/m, by −1.0014 at 13970.
  const Csv edge = swept({"wall45", "--set=device.rate_hz=250", "--over=rendering.k_r_N_per_m=13750:14000:2"});
  for (const Row& row : edge.rows) {
    if (row.strategy() != StrategyId::full) continue;
    EXPECT_EQ(row.text("settled"), row.number("rendering.k_r_N_per_m") == 13750.0 ? "1" : "0");
  }
}

TEST(Sweep, ACreepingDeviceIsWaitedFor) {
  // b/k_u = 10 s: after 3 s it has barely begun to move.
  for (const Row& row : swept({"fig3-normal", "--over=device.damping_N_s_per_m=1000:1000:1"}).rows) {
    EXPECT_EQ(row.text("settled"), "1");
    EXPECT_LT(glm::distance(row.vector("simulated_device", "m"), row.vector("device", "m")), 1e-11);
  }
}

// Nor does a point's result depend on those that are simulated beside it, which share its path in the first grid and
// not in the second.
TEST(Sweep, AsManyThreadsAsOneLikes) {
  const Scene scene = load_scene("fig1");
  for (const std::vector<std::string>& ranges :
       {std::vector<std::string>{"wall.normal_deg=90:180:37", "rendering.k_r_N_per_m=10:1e4:29:log"},
        {"goal.duration_s=0:3:7", "device.rate_hz=500:1000:6"}}) {
    const Grid grid = make_grid(ranges, scene);
    for (const RestKind& kind : rest_kinds) {
      std::string expected;
      for (std::int64_t point = 0; point < size_of(grid); ++point) {
        fmt::memory_buffer rows;
        Scene at = scene;
        put_point(grid, point, at);
        append_sweep_rows(rows, grid, point, at_rest(at, kind), kind);
        expected.append(rows.data(), rows.size());
      }
      for (const std::size_t threads : {1U, 2U, 5U}) {
        std::string rows;
        std::int64_t points = 0;
        EXPECT_TRUE(sweep({scene, grid, kind}, threads, [&](const SweptBlock& block) {
          rows += block.rows;
          EXPECT_GT(block.points, points);
          points = block.points;
        }));
        EXPECT_EQ(points, size_of(grid));
        EXPECT_TRUE(rows == expected) << ranges[0] << " " << kind.name << " on " << threads;
      }
    }
  }
}

// --- How it ends ---

// More points than can be swept before a signal arrives, and what they would be.
const std::vector<std::string> long_ranges{"wall.normal_deg=90:180:2000", "rendering.k_r_N_per_m=10:1e4:2000:log"};
const std::vector<std::string> long_sweep{"sweep",        "fig1",   "--at-rest=closed-form", "--over",
                                          long_ranges[0], "--over", long_ranges[1]};

// The text is a sweep cut after some whole row, and says so; its rows are those of the sweep.
void expect_interrupted_rows(const std::string& text, std::int64_t least_rows) {
  ASSERT_TRUE(text.ends_with("\n# interrupted\n"))
      << text.substr(text.size() - std::min<std::size_t>(text.size(), 300));
  const Scene scene = load_scene("fig1");
  const Grid grid = make_grid(long_ranges, scene);
  const RestKind& kind = rest_kinds.front();
  const std::string header = sweep_header(scene, grid, kind);
  ASSERT_TRUE(text.starts_with(header));
  const std::string_view rows(text.data() + header.size(), text.size() - header.size() - interrupted_line.size() - 1);
  const std::int64_t row_count = std::ranges::count(rows, '\n');
  EXPECT_EQ(row_count % 3, 0);
  EXPECT_GE(row_count, least_rows);
  ASSERT_LT(row_count, 3 * size_of(grid));
  fmt::memory_buffer expected;
  for (std::int64_t point = 0; point < row_count / 3; ++point) {
    Scene at = scene;
    put_point(grid, point, at);
    append_sweep_rows(expected, grid, point, at_rest(at, kind), kind);
  }
  EXPECT_TRUE(rows == std::string_view(expected.data(), expected.size()));
}

TEST(SweepEnds, InterruptedItLeavesWholeRowsInTheFile) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const TemporaryFolder folder;
    ProgramCall call;
    call.words = long_sweep;
    call.words.insert(call.words.end(), {"-o", folder / "sweep.csv"});
    call.signal_when_created_in = folder.path();
    call.signal = signal;
    const Outcome outcome = run_program(GHOSTFORCE_PROGRAM, call);
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("interrupted"), std::string::npos);
    EXPECT_EQ(folder.count(), 1);
    expect_interrupted_rows(read_whole(folder / "sweep.csv"), 0);
  }
}

// The pipe is full and the program waits for this reader when the signal comes.
TEST(SweepEnds, InterruptedWhileAReaderIsSlowItLeavesWholeRowsInThePipe) {
  ProgramCall call;
  call.words = long_sweep;
  RunningProgram program(GHOSTFORCE_PROGRAM, call);
  std::string text;
  const auto take = [&] {
    const auto line = program.next_line(std::chrono::seconds(20));
    if (line) text += *line + "\n";
    return line.has_value();
  };
  ASSERT_TRUE(take());
  ::usleep(100'000);  // time to fill the pipe; nothing is wrong if it is too short
  program.send(SIGINT);
  while (take()) {
  }
  EXPECT_EQ(program.wait_for_end(), 130);
  expect_interrupted_rows(text, 100);  // that is what the pipe held
}

TEST(SweepEnds, AReaderWhoTakesNothingIsNotWaitedFor) {
  ProgramCall call;
  call.words = long_sweep;
  RunningProgram program(GHOSTFORCE_PROGRAM, call);
  ASSERT_TRUE(program.next_line(std::chrono::seconds(20)));
  program.send(SIGTERM);
  EXPECT_EQ(program.wait_for_end(), 130);
}

TEST(SweepEnds, AClosedPipeIsNoTrouble) {
  ProgramCall call;
  call.words = long_sweep;
  call.close_after_first_piece = true;
  const Outcome outcome = run_program(GHOSTFORCE_PROGRAM, call);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
}

TEST(SweepEnds, WhatCannotBeWrittenIsTold) {
  for (const auto& [path, said] : {std::pair("/dev/full", "/dev/full cannot be written: No space left on device"),
                                   std::pair("/none/sweep.csv", "/none/sweep.csv cannot be written: No such file")}) {
    const Outcome outcome = run({"fig1", "--over=wall.normal_deg=90:180:3", "-o", path});
    EXPECT_EQ(outcome.exit_code, 8);
    EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
  }
  ProgramCall call;
  call.words = long_sweep;
  call.out_to = "/dev/full";
  EXPECT_EQ(run_program(GHOSTFORCE_PROGRAM, call).exit_code, 8);
}

// --- On a terminal ---

TEST(SweepProgress, BarShareAndTimeLeft) {
  using Seconds = std::chrono::duration<double>;
  EXPECT_EQ(progress_words("sweeping", 0, 10, Seconds(2)), "sweeping [                    ]   0 %");
  EXPECT_EQ(progress_words("sweeping", 1, 4, Seconds(2)), "sweeping [#####               ]  25 %, 6 s left");
  EXPECT_EQ(progress_words("sweeping", 999, 1000, Seconds(9)), "sweeping [################### ]  99 %, 1 s left");
  EXPECT_EQ(progress_words("sweeping", 10, 10, Seconds(9)), "sweeping [####################] 100 %, 0 s left");
  EXPECT_EQ(progress_words("x", 1, 2, Seconds(600)), "x [##########          ]  50 %, 10 min left");
  EXPECT_EQ(progress_words("x", 1, 1001, Seconds(36)), "x [                    ]   0 %, 10 h left");
}

TEST(SweepProgress, ATerminalIsToldHowLongItTook) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_GE(terminal, 0);
  ASSERT_EQ(grantpt(terminal), 0);
  ASSERT_EQ(unlockpt(terminal), 0);
  const std::string other_end = ptsname(terminal);
  const int kept_open = open(other_end.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);  // so that what was said stays
  const Outcome outcome = run_program(
      "/bin/sh",
      {"-c", "exec \"$0\" sweep fig1 --over wall.normal_deg=90:180:3 2> \"$1\"", GHOSTFORCE_PROGRAM, other_end});
  EXPECT_EQ(outcome.exit_code, 0);
  pollfd wait{terminal, POLLIN, 0};
  ASSERT_EQ(poll(&wait, 1, 5000), 1);
  std::array<char, 4096> piece;
  const ssize_t count = read(terminal, piece.data(), piece.size());
  ASSERT_GT(count, 0);
  const std::string said(piece.data(), static_cast<std::size_t>(count));
  EXPECT_NE(said.find("s: computing "), std::string::npos) << said;
  EXPECT_NE(said.find("writing "), std::string::npos) << said;
  close(kept_open);
  close(terminal);
}

// --- The page about it ---

TEST(SweepDoc, ItsCommandsRun) {
  const std::string page = read_whole(GHOSTFORCE_SWEEP_DOC);
  // In a block of its own, and followed by the block of what it prints if that is anything.
  const std::regex call("\n```\nghostforce (sweep [^`]*)```\n");
  int calls = 0;
  const TemporaryFolder folder;
  for (std::sregex_iterator found(page.begin(), page.end(), call), end; found != end; ++found) {
    ++calls;
    ProgramCall shell;
    shell.words = {"-c", "\"$0\" " + (*found)[1].str(), GHOSTFORCE_PROGRAM};
    shell.folder = folder.path();
    const Outcome outcome = run_program("/bin/sh", shell);
    EXPECT_EQ(outcome.exit_code, 0) << (*found)[1] << "\n" << outcome.err;
    EXPECT_EQ(outcome.err, "") << (*found)[1];
    if (outcome.out.empty()) continue;
    EXPECT_TRUE(found->suffix().str().starts_with("\n```\n" + outcome.out + "```\n"))
        << "the page has other numbers than\n"
        << outcome.out;
  }
  EXPECT_EQ(calls, 5);
}

}  // namespace
}  // namespace ghostforce
