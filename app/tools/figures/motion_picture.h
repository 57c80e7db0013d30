// A motion as a picture: the hand's way, the three devices', and where they come to rest. Pure, any thread.
#pragma once

#include <string>
#include <vector>

#include "app/tools/figures/scene_pane.h"
#include "app/tools/figures/simulated_motion.h"

namespace ghostforce {

// The hand's way is dotted; the devices' proxies stand hollow on the wall. `start` and `goal` name the ends of the way.
ScenePicture picture_of(const SimulatedMotion& motion, const std::string& start, const std::string& goal);

// Its entries of the legend.
std::vector<LegendEntry> motion_legend();

// Panes of pictures at one scale, side by side; the first one has the scale bar. A full row each.
void add_scenes(Sheet& sheet, double height, std::vector<ScenePicture> pictures, std::size_t per_row);

}  // namespace ghostforce
