// A scene as a paper shows it: wall, trajectories, points with their letters, a scale bar; as a pane. Words are put
// where they cover neither each other nor points, and lines as little as can be. Pure, any thread.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/tools/figures/sheet.h"
#include "app/tools/figures/simulated_motion.h"
#include "core/settings.h"

namespace ghostforce {

struct Trail {
  std::vector<Vector<2>> points;  // [m]
  Colour colour;
  LinePattern pattern = solid_line;
  double width = 2.0;  // [points]
};

struct FigurePoint {
  Vector<2> at;  // [m]
  Shape shape = Shape::disc;
  Colour fill;
  Colour rim;
  double radius = 6.0;           // [points]
  std::string name{};            // beside it; empty: none
  std::string subscript{};       // of the name
  TextStyle style = large_text;  // of the name
  bool has_cross = false;        // the goal's
};

struct MotorForceArrow {
  Vector<2> tail;   // [m]
  Vector<2> force;  // [N]
  Colour colour;
  Colour letters;
  std::string name{};
  bool is_hollow = false;
};

struct ScenePicture {
  std::string title;  // above the pane
  Settings settings;  // of the scene: wall and motor axis
  std::vector<Trail> trails{};
  std::vector<MotorForceArrow> arrows{};
  std::vector<FigurePoint> points{};
  bool has_scale = false;  // scale bar and motor axis
};

// The part of the world that several panes of one size show, at one scale.
struct Frame {
  double points_per_metre;
  std::vector<Vector<2>> centers;  // per picture [m]
};
Frame frame_for(std::span<const ScenePicture> pictures, const Vector<2>& size);

inline constexpr double points_per_newton_on_paper = 18.0;

Pane scene_pane(const ScenePicture& picture, const Place& place, const Vector<2>& center, double points_per_metre);

// The pieces that several figures have in common.
FigurePoint goal_point(const Vector<2>& at, std::string name, std::string subscript = {});
FigurePoint device_point(StrategyId id, const Vector<2>& at, std::string name, std::string subscript = {});
Trail device_trail(StrategyId id, std::vector<Vector<2>> points);

// --- A motion as a picture: the hand's way, the three devices', and where they come to rest ---

// The hand's way is dotted; the devices' proxies stand hollow on the wall. `start` and `goal` name the ends of the way.
ScenePicture picture_of(const SimulatedMotion& motion, const std::string& start, const std::string& goal);

// Its entries of the legend.
std::vector<LegendEntry> motion_legend();

// Panes of pictures at one scale, side by side; the first one has the scale bar. A full row each.
void add_scenes(Sheet& sheet, double height, std::vector<ScenePicture> pictures, std::size_t per_row);

}  // namespace ghostforce
