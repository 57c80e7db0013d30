// What a measurement of a device finds, step by step, and its part of the report. Plain values; what allocates may throw.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/tools/doctor/operator.h"
#include "core/conventions.h"

namespace ghostforce {

// What one measurement of a device has found, for the report. A plain value.
struct Finding {
  enum class State : std::uint8_t {
    as_assumed,    // the device is what the program takes every device for
    differs,       // it is not, and the calibration says so now
    measured,      // nothing was assumed
    not_measured,  // skipped, or there was no reading to trust
    contradicts,   // the readings do not go with each other
  };

  State state = State::not_measured;
  std::string title{};                  // what was to be found
  std::string sentence{};               // the result with its uncertainty, or why there is none
  std::string settles{};                // what nobody had confirmed; empty: nothing
  std::vector<std::string> readings{};  // each, as it was taken

  static constexpr State as_assumed_if(bool is_so) noexcept { return is_so ? State::as_assumed : State::differs; }
  bool is_answer() const noexcept { return state != State::not_measured && state != State::contradicts; }
};

constexpr std::string_view words_of(Finding::State state) noexcept {
  // In the order of Finding::State.
  constexpr std::array<std::string_view, 5> words{"as assumed", "differs from what was assumed", "measured",
                                                  "not measured", "the readings contradict each other"};
  return words[static_cast<std::size_t>(state)];
}

// The mean of something over a while.
template <glm::length_t D>
struct MeanOf {
  Vector<D> sum{0.0};
  int count = 0;

  void add(const Vector<D>& value) {
    sum += value;
    ++count;
  }
  Vector<D> value() const { return count > 0 ? sum / static_cast<double>(count) : Vector<D>(0.0); }
};

struct MeasuredStep {
  std::string_view title;
  std::vector<Finding> findings;
};

// Whether every finding is an answer.
bool has_all_answers(std::span<const MeasuredStep> steps);

// The report's tables and readings, in Markdown.
std::string results_of(std::span<const MeasuredStep> steps);

// Leads the person through a catalog. A step has a title and an outline for them; what it needs and gives, of an
// enumeration whose first value is nothing; and take(rig), which does it. False: the person left before the end and wants
// the report of what there is. Throws as the rig does; Failure(answer_is_no) where the person left and wants no report.
template <typename Step, typename Rig>
bool take_steps(std::span<const Step> catalog, Rig& rig, std::vector<MeasuredStep>& steps) {
  auto& person = rig.person();
  std::array<bool, 8> has{true};  // by what a step gives
  try {
    for (std::size_t i = 0; i < catalog.size(); ++i) {
      const Step& step = catalog[i];
      person.tell(fmt::format("\nStep {} of {}: {}. {}", i + 1, catalog.size(), step.title, step.outline));
      std::vector<Finding> findings{{.title = std::string(step.title)}};
      if (!has[static_cast<std::size_t>(step.needs)]) {
        findings[0].sentence = "It needs the result of an earlier step that has none.";
      } else {
        try {
          findings = step.take(rig);
        } catch (const SkipMeasurement&) {
          rig.rest(0.0);
          findings[0].sentence = "Skipped.";
        }
      }
      has[static_cast<std::size_t>(step.gives)] |= findings.front().is_answer();
      for (const Finding& finding : findings) {
        person.tell(fmt::format("  {}: {}. {}", finding.title, words_of(finding.state), finding.sentence));
      }
      steps.push_back({step.title, std::move(findings)});
    }
    return true;
  } catch (const LeaveMeasurement&) {
    if (!person.says_yes("The motors are off. Write a report of what has been measured so far? Type y or n.")) {
      throw Failure(ExitCode::answer_is_no, "The measurement was ended. Nothing was written.");
    }
    return false;
  }
}

}  // namespace ghostforce
