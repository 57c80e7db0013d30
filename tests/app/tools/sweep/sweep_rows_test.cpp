// The rows of a `sweep`, against independent ways to know them.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/files/run.h"
#include "app/files/scene_file.h"
#include "app/tools/sweep/sweep.h"
#include "core/equilibrium.h"
#include "core/ghost_force.h"
#include "tests/app/tools/sweep/point_equilibrium.h"
#include "tests/core/linear_equilibrium.h"
#include "tests/support/program.h"

namespace ghostforce::sweep_rows_test {
namespace {

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

// A hand that changes is, at rest, the one of the scene's end; what is believed of it is what the scene says.
TEST(SweepRows, AChangingHandIsThatOfTheScenesEnd) {
  const EquilibriumKind& both = equilibrium_kinds[2];
  const Scene changing =
      load_scene("wall45", std::vector<std::string>{"user.k_u_path_N_per_m=[200, 400]", "user.k_u_times_s=[0, 6]",
                                                    "user.tremor_mm_rms=1", "device.encoder_mm=0.06"});
  const Scene constant =
      load_scene("wall45", std::vector<std::string>{"user.k_u_N_per_m=300", "user.believed_k_u_N_per_m=200"});
  const PointEquilibrium found = point_equilibrium(changing, both);
  const PointEquilibrium wanted = point_equilibrium(constant, both);
  for (std::size_t i = 0; i < strategy_count; ++i) {
    EXPECT_EQ(found.predicted[i].at.device, wanted.predicted[i].at.device);
    EXPECT_EQ(found.predicted[i].at.force, wanted.predicted[i].at.force);
    ASSERT_TRUE(found.simulated[i] && wanted.simulated[i]);
    EXPECT_EQ(found.simulated[i]->device, wanted.simulated[i]->device);
  }
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
  words.insert(words.begin(), "sweep");
  const Outcome outcome = run_ghostforce(std::move(words));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  Csv csv = parse_csv(outcome.out);
  const auto unsettled = std::ranges::count_if(csv.rows, [](const Row& row) {
    const auto settled = row.fields.find("settled");
    return settled != row.fields.end() && settled->second == "0";
  });
  const std::string told = "in " + std::to_string(unsettled) + " of the rows, settled is 0";
  EXPECT_TRUE(unsettled == 0 ? outcome.err.empty() : outcome.err.starts_with(told)) << outcome.err;
  return csv;
}

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
    const Outcome outcome = run_ghostforce({"equilibrium", "fig1", "--json",
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
      const Stiffnesses& stiffnesses = scene.settings.stiffnesses;
      const Wall<2> wall = wall_of(scene.settings);
      const Actuation<2> actuation = actuation_of(scene.settings);
      const Vector<2> goal = scene.goal.points.back();
      const auto solved = [&](StrategyId id) {
        return equilibrium_by_linear_solve(wall, make_coupling(strategy(id), stiffnesses, actuation), stiffnesses.k_u,
                                           stiffnesses.k_c, goal);
      };
      const Equilibrium<2> expected = solved(row.strategy());
      // Elimination without scaling loses as many digits as the stiffnesses lie apart, 4 or so of 16.
      const double distance = 1e-11;
      const double force = distance * (stiffnesses.k_r + stiffnesses.k_u);
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
      const Stiffnesses& stiffnesses = scene.settings.stiffnesses;
      deepest = std::max(deepest, row.number("depth_m"));
      // The forces on the device cancel to what k_u makes of 1 pm and to rounding, 16 ulp of 0.1 m here times the
      // stiffnesses over k_u, another 1 pm at most; along the wall a device can be off by up to 1 + √κ/2 times that.
      const double kappa = stiffnesses.k_r / stiffnesses.k_u;
      const double step = std::max(1.0, std::sqrt(tracking_ratio(stiffnesses)));
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
      near("force", "N", distance * (2.0 + step) * stiffnesses.k_r);
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
    for (const EquilibriumKind& kind : equilibrium_kinds) {
      std::string expected;
      for (std::int64_t point = 0; point < size_of(grid); ++point) {
        fmt::memory_buffer rows;
        Scene at = scene;
        put_point(grid, point, at);
        append_sweep_rows(rows, grid, point, point_equilibrium(at, kind), kind);
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

}  // namespace
}  // namespace ghostforce::sweep_rows_test
