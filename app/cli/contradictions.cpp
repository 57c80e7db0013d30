#include "app/cli/contradictions.h"

#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/failure.h"

namespace ghostforce {

void refuse_contradictions(const CLI::App& command, std::string_view given,
                           std::span<const Contradiction> contradictions) {
  for (const Contradiction& each : contradictions) {
    const CLI::Option* const option = command.get_option_no_throw(std::string(each.option));
    if (option == nullptr || option->count() == 0) continue;
    if (!each.value.empty() && !option->as<std::string>().starts_with(each.value)) continue;
    throw Failure(ExitCode::wrong_call,
                  fmt::format("{} and {}{}{} contradict each other: {}; leave out one of them", given, each.option,
                              each.value.empty() ? "" : " ", each.value, each.reason));
  }
}

}  // namespace ghostforce
