#include "app/cli/command.h"

#include <array>

namespace ghostforce {
namespace {

constexpr std::array catalog{
    Command{"run", "Open the window: drag the goal, feel the wall, compare the strategies", attach_run},
    Command{"render", "Draw a picture of a scene without a display, as PNG, SVG or PDF", attach_render},
    Command{"simulate", "Simulate a scene's scripted hand and write every tick as CSV", attach_simulate},
    Command{"equilibrium", "Compute where everything comes to rest under a fixed goal", attach_equilibrium},
    Command{"figures", "Make the paper's figures and more, with their numbers", attach_figures},
    Command{"worksheet", "Make worksheets of lessons as PDF, or the same pages with the answers", attach_worksheet},
    Command{"sweep", "Compute where everything comes to rest over ranges of one or two keys, as CSV", attach_sweep},
    Command{"replay", "Run a recording again and check whether every number comes out the same", attach_replay},
    Command{"replay-session", "Do again what a person did in the window, from a recorded session",
            attach_replay_session},
    Command{"measure-user", "Compute how stiff the hand in a run was, from the proxy drift at rest",
            attach_measure_user},
    Command{"check", "Compare the pictures of a folder of cases with the stored ones", attach_check},
    Command{"doctor", "Show what a device still needs before it can push, and what to do", attach_doctor},
    Command{"help", "Print the help or the manual page of a command, or a completion script for a shell", attach_help},
};

}  // namespace

std::span<const Command> command_catalog() noexcept {
  return catalog;
}

}  // namespace ghostforce
