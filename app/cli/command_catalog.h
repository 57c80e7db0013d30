// Each command's one function.
#pragma once

#include <functional>

#include "app/cli/own_inputs.h"

namespace CLI {
class App;
}

namespace ghostforce {

std::function<int()> attach_run(CLI::App& command, FileOptions& files);
std::function<int()> attach_render(CLI::App& command, FileOptions& files);
std::function<int()> attach_simulate(CLI::App& command, FileOptions& files);
std::function<int()> attach_equilibrium(CLI::App& command, FileOptions& files);
std::function<int()> attach_figures(CLI::App& command, FileOptions& files);
std::function<int()> attach_sweep(CLI::App& command, FileOptions& files);
std::function<int()> attach_replay(CLI::App& command, FileOptions& files);
std::function<int()> attach_measure_user(CLI::App& command, FileOptions& files);
std::function<int()> attach_check(CLI::App& command, FileOptions& files);
std::function<int()> attach_doctor(CLI::App& command, FileOptions& files);

}  // namespace ghostforce
