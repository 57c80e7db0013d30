// Figure: a picture for a paper, as a value: panes on a sheet, and the numbers that they were drawn from. Each figure
// is one file beside this one and one row in figure_catalog.cpp; its data come from a pure function apart from the
// drawing, so that the tests of the paper's claims look at the same numbers as the reader.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/csv_table.h"
#include "app/view/panes.h"
#include "core/goal_path.h"
#include "core/scene.h"

namespace ghostforce {

// Of the simulated hand's tremor.
inline constexpr std::uint64_t figure_seed = 1;

// A hand that was recorded, in place of the simulated one.
struct RecordedHand {
  std::string name;           // of the recording, for the provenance
  Scene scene;                // that it was recorded in
  GoalPath path;              // q_u over time
  bool is_estimated = false;  // inferred from a device that was measured
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

// Where a figure's numbers come from, in one line: program version, scene and seed.
std::string provenance(const std::string& scene);

}  // namespace ghostforce
