// A case of `check`: what to draw, what the picture must equal, and what its numbers must be. One TOML file each,
// NAME.toml; strict like a scene. Not for the servo thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/read_error.h"
#include "app/picture/glossary.h"
#include "app/shell/desktop/offscreen.h"
#include "app/tools/check/comparison.h"
#include "app/tools/check/golden_origin.h"

namespace ghostforce {

enum class Expectation : std::uint8_t {
  golden,    // the picture stored beside the case
  match,     // the picture of another case
  mismatch,  // anything but the picture of another case
};

struct Case {
  std::string name;         // the file's, without .toml
  std::string path;         // of the file
  std::string source_path;  // of the scene or lesson that it shows; empty: a shipped one
  int width = 0;            // of the picture [px]
  int height = 0;
  Expectation expectation = Expectation::golden;
  std::string other;        // name of the case that `expectation` speaks of
  ReadProblem other_place;  // where it is named
  Tolerance tolerance;
  bool has_tolerance = false;  // the file states it
  std::vector<PixelBox> mask;  // within the picture
  // What the numbers of the active strategy must be, in the order and the units of quantity_catalog(); empty: anything.
  std::array<std::optional<double>, quantity_count> numbers{};
  double number_tolerance = 1e-6;
  std::optional<GoldenOrigin> origin;

  std::string golden_path() const;
};

// What can be long, and is read again each time it is needed: a folder may hold any number of cases.
struct CaseContent {
  std::string text;  // in the file
  PictureRequest request;
};

// Loads the scene too; its path is relative to the case's file. Whatever is wrong is added to `problems`. Throws
// ReadError(unreadable) where the case or its scene is there and cannot be read, and Failure(interrupted).
struct ReadCase {
  Case summary;
  CaseContent content;
};
ReadCase read_case(const std::string& path, std::vector<ReadProblem>& problems);

// As above; throws ReadError(wrong) too, where the file has been changed and is wrong now.
CaseContent content_of(const Case& described);

// "golden"; "match" or "mismatch", as in the file.
std::string_view expectation_name(Expectation expectation) noexcept;

}  // namespace ghostforce
