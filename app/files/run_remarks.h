// What had to be left out of a run while it was read, as lines for people: what it was, how often, and where first. Not
// for the servo thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ghostforce {

// Why a line is left out.
enum class RunFault : std::uint8_t { damaged, not_finite, bad_set, bad_state, not_understood, count };

class RunRemarks {
 public:
  // `shown_path` is what the remarks call the file.
  explicit RunRemarks(std::string shown_path) : shown_path_(std::move(shown_path)) {}

  // Lines are counted from 1.
  void complain(RunFault fault, std::size_t line_number);
  void add(const std::string& words);
  // A line for each kind of fault that there was.
  void add_faults();

  std::vector<std::string> take() { return std::move(lines_); }

 private:
  struct Complaint {
    std::size_t count = 0;
    std::size_t first_line = 0;
  };

  std::string shown_path_;
  std::array<Complaint, static_cast<std::size_t>(RunFault::count)> complaints_{};
  std::vector<std::string> lines_;
};

}  // namespace ghostforce
