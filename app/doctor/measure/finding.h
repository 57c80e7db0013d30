// Finding: what one measurement of a Falcon has found, for the report. A plain value.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ghostforce {

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

  bool is_answer() const noexcept { return state != State::not_measured && state != State::contradicts; }
};

constexpr std::string_view words_of(Finding::State state) noexcept {
  switch (state) {
    case Finding::State::as_assumed:
      return "as assumed";
    case Finding::State::differs:
      return "differs from what was assumed";
    case Finding::State::measured:
      return "measured";
    case Finding::State::not_measured:
      return "not measured";
    case Finding::State::contradicts:
      return "the readings contradict each other";
  }
  return {};
}

}  // namespace ghostforce
