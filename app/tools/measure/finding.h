// Finding: what one measurement of a Falcon has found, for the report. A plain value.
#pragma once

#include <array>
#include <cstddef>
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

  static constexpr State as_assumed_if(bool is_so) noexcept { return is_so ? State::as_assumed : State::differs; }
  bool is_answer() const noexcept { return state != State::not_measured && state != State::contradicts; }
};

constexpr std::string_view words_of(Finding::State state) noexcept {
  // In the order of Finding::State.
  constexpr std::array<std::string_view, 5> words{"as assumed", "differs from what was assumed", "measured",
                                                  "not measured", "the readings contradict each other"};
  return words[static_cast<std::size_t>(state)];
}

}  // namespace ghostforce
