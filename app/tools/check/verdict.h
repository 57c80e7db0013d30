// Verdict: whether a case passes, and what a person needs to know where it does not. Main thread only (it draws).
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "app/picture/glossary.h"
#include "app/tools/check/case_file.h"
#include "app/tools/check/comparison.h"
#include "app/tools/check/golden_origin.h"
#include "app/tools/check/rendered_cases.h"

namespace ghostforce {

// By --renderer gpu, for a golden that another renderer drew and a case without a tolerance of its own: graphics cards
// round differently from Mesa's software renderer, most of all along edges. Ten times as many pixels as differ
// by more with softpipe, Mesa's other software renderer.
inline constexpr Tolerance graphics_card_tolerance{.channel = 16, .share = 0.0005};

// Whether that applies; `present` drew the picture.
bool is_for_graphics_card(const Case& checked, std::optional<Renderer> renderer, const GoldenOrigin& present);

// Of a case that fails, as PNG files; no value where there is none.
struct VerdictPictures {
  std::optional<std::string> expected;
  std::optional<std::string> actual;
  std::optional<std::string> difference;
};

// A number that the case states.
struct CheckedNumber {
  double expected = 0.0;
  double actual = 0.0;
  double tolerance = 0.0;

  // Written so that NaN does not.
  bool passes() const noexcept { return std::abs(actual - expected) <= tolerance; }
};

// In the order of quantity_catalog(); none: the case does not state it.
using CheckedNumbers = std::array<std::optional<CheckedNumber>, quantity_count>;

CheckedNumbers check_numbers(const Case& checked, const StrategySnapshot<2>& actual);

// In words, which of these numbers are not what their case states; empty: all are.
std::string wrong_numbers(const CheckedNumbers& numbers);

struct Verdict {
  std::string name;
  bool passes = false;
  bool is_file_trouble = false;          // the golden is there and cannot be read
  bool is_lenient = false;               // graphics_card_tolerance was applied
  Tolerance tolerance;                   // that was applied
  std::string reason;                    // one line; of a case that passes too: what was found
  std::string remark;                    // a probable cause; may be empty
  std::string remedy;                    // the command that updates the golden; empty where none does or none is needed
  std::optional<Comparison> comparison;  // none: there was nothing to compare with
  CheckedNumbers numbers{};
  GoldenOrigin drawn_by;
  double duration_s = 0.0;
  VerdictPictures pictures;
};

// `folder` as the person named it, for the remedy. Pictures are made where `wants_pictures`. Throws what drawing does.
Verdict evaluate(const Case& checked, RenderedCases& rendered, std::string_view folder, bool wants_pictures);

// On its way from one process of this program to another.
std::string bytes_of(const Verdict& verdict);

// Of the same build, by the function above.
Verdict verdict_of(std::string_view bytes);

}  // namespace ghostforce
