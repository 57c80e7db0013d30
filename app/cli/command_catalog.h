// Each command's one function.
#pragma once

#include <functional>

#include "app/cli/command_options.h"

namespace ghostforce {

std::function<int()> attach_run(CommandOptions subcommand);
std::function<int()> attach_render(CommandOptions subcommand);
std::function<int()> attach_simulate(CommandOptions subcommand);
std::function<int()> attach_equilibrium(CommandOptions subcommand);
std::function<int()> attach_figures(CommandOptions subcommand);
std::function<int()> attach_sweep(CommandOptions subcommand);
std::function<int()> attach_replay(CommandOptions subcommand);
std::function<int()> attach_measure_user(CommandOptions subcommand);
std::function<int()> attach_check(CommandOptions subcommand);
std::function<int()> attach_doctor(CommandOptions subcommand);

}  // namespace ghostforce
