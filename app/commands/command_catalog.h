// Each command's one function.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace ghostforce {

std::function<int()> attach_run(CLI::App& subcommand);
std::function<int()> attach_render(CLI::App& subcommand);
std::function<int()> attach_simulate(CLI::App& subcommand);
std::function<int()> attach_equilibrium(CLI::App& subcommand);
std::function<int()> attach_figures(CLI::App& subcommand);
std::function<int()> attach_sweep(CLI::App& subcommand);
std::function<int()> attach_replay(CLI::App& subcommand);
std::function<int()> attach_measure_user(CLI::App& subcommand);
std::function<int()> attach_check(CLI::App& subcommand);
std::function<int()> attach_doctor(CLI::App& subcommand);

}  // namespace ghostforce
