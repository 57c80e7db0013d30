// Figure: a picture for a paper, as a value: panes on a sheet, and the numbers that they were drawn from. Each figure
// is one file beside this one, a line or two in figures.h and one row in figure_catalog.cpp; its data come from a pure
// function apart from the drawing, so that the tests of the paper's claims look at the same numbers as the reader.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/files/csv_table.h"
#include "app/picture/panes.h"
#include "core/scene.h"
#include "core/tick.h"

namespace ghostforce {

// Of the simulated hand's tremor.
inline constexpr std::uint64_t figure_seed = 1;

// From this time on other settings hold.
struct SettingsChange {
  double time_s;
  Settings settings;
};

// A hand that was recorded, in place of the simulated one.
struct RecordedHand {
  std::string name;                       // of the recording
  Scene scene;                            // that it was recorded in; its path is the hand's q_u over time
  TickState<2> start;                     // where it begins
  std::vector<SettingsChange> changes{};  // while it was recorded
  bool is_estimated = false;              // inferred from a device that was measured
  std::vector<std::string> left_out{};    // of the recording, for people: whole sentences
};

struct FigureRequest {
  std::optional<RecordedHand> hand{};
};

struct Figure {
  std::string title;
  CsvTable data;
  std::vector<Pane> panes;
  Vector<2> size{0.0};  // of the sheet [points]
};

// Where a figure's numbers come from, in one line: program version, scene and seed, or the hand's recording.
std::string provenance_of_scene(const std::string& scene);
std::string provenance_of_hand(const std::string& recording);

}  // namespace ghostforce
