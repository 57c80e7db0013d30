#include "app/files/run_remarks.h"

#include <string_view>

#include <fmt/format.h>

namespace ghostforce {
namespace {

struct FaultWords {
  std::string_view one;
  std::string_view many;
};
constexpr std::array<FaultWords, static_cast<std::size_t>(RunFault::count)> fault_words{{
    {"line is damaged and left out", "lines are damaged and left out"},
    {"row has a number that is none (NaN or infinite) and is left out",
     "rows have numbers that are none (NaN or infinite) and are left out"},
    {"change of a setting cannot be read: the settings are not known from there on",
     "changes of settings cannot be read: the settings are not known from there on"},
    {"line about a jump cannot be read", "lines about jumps cannot be read"},
    {"comment is not understood and left out", "comments are not understood and left out"},
}};

}  // namespace

void RunRemarks::complain(RunFault fault, std::size_t line_number) {
  Complaint& complaint = complaints_[static_cast<std::size_t>(fault)];
  if (complaint.count++ == 0) complaint.first_line = line_number;
}

void RunRemarks::add(const std::string& words) {
  lines_.push_back(fmt::format("{}: {}", shown_path_, words));
}

void RunRemarks::add_faults() {
  for (std::size_t i = 0; i < complaints_.size(); ++i) {
    const auto& [count, first_line] = complaints_[i];
    if (count == 1) add(fmt::format("1 {}: line {}", fault_words[i].one, first_line));
    if (count > 1) add(fmt::format("{} {}, the first is line {}", count, fault_words[i].many, first_line));
  }
}

}  // namespace ghostforce
