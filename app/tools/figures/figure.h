// Figure: a picture for a paper, as a value: panes on a sheet, and the numbers that they were drawn from. Each figure
// is one file beside this one, a line or two in figures.h and one row in figure_catalog.cpp; its data come from a pure
// function apart from the drawing, so that the tests of the paper's claims look at the same numbers as the reader.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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

// --- The one list of figures: the paper's, and some that it does not have ---

struct FigureEntry {
  std::string_view name;      // of its files, and on the command line
  std::string_view sentence;  // what it shows, for --help
  Figure (*make)(const FigureRequest& request);
  bool takes_hand = false;  // a recorded one
};

std::span<const FigureEntry> figure_catalog() noexcept;

// A figure as files: the picture as PNG in two densities, as SVG and as PDF, and the numbers that it was drawn from as
// CSV. The same figure gives the same bytes. One thread at a time.
//
// What a figure's name is followed by, in the names of its files.
inline constexpr std::array<std::string_view, 5> figure_file_endings{".png", "@2x.png", ".svg", ".pdf", ".csv"};

struct NamedFile {
  std::string name;
  std::string content;
};

// Throws Failure: file_trouble where the font cannot be read; interrupted.
std::vector<NamedFile> figure_files(std::string_view name, const Figure& figure);

}  // namespace ghostforce
