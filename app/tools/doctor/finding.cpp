#include "app/tools/doctor/finding.h"

#include <algorithm>

namespace ghostforce {

bool has_all_answers(std::span<const MeasuredStep> steps) {
  return std::ranges::all_of(
      steps, [](const MeasuredStep& step) { return std::ranges::all_of(step.findings, &Finding::is_answer); });
}

std::string results_of(std::span<const MeasuredStep> steps) {
  std::string text = "## Results\n\n| What | | Result | Settles |\n|---|---|---|---|\n";
  for (const MeasuredStep& step : steps) {
    for (const Finding& finding : step.findings) {
      text += fmt::format("| {} | {} | {} | {} |\n", finding.title, words_of(finding.state), finding.sentence,
                          finding.is_answer() ? finding.settles : "nothing");
    }
  }
  text += "\n## Readings\n";
  for (const MeasuredStep& step : steps) {
    text += fmt::format("\n### {}\n\n", step.title);
    bool is_empty = true;
    for (const Finding& finding : step.findings) {
      for (const std::string& reading : finding.readings) {
        text += fmt::format("- {}\n", reading);
        is_empty = false;
      }
    }
    if (is_empty) text += "None.\n";
  }
  return text;
}

}  // namespace ghostforce
