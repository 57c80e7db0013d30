#include "app/cli/command.h"

#include <array>

namespace ghostforce {
namespace {

constexpr std::array catalog{
    Command{"run", "Open the window: drag the goal, feel the wall, compare the strategies", attach_run},
    Command{"render", "Draw the picture of a scene offscreen, as PNG, SVG or PDF", attach_render},
    Command{"simulate", "Play a scene's scripted hand and write every tick as CSV", attach_simulate},
    Command{"equilibrium", "Tell where everything comes to rest under a goal that is held still", attach_equilibrium},
    Command{"figures", "Make the paper's figures and further ones, with their numbers", attach_figures},
    Command{"sweep", "Tell where everything comes to rest, over ranges of one or two keys, as CSV", attach_sweep},
    Command{"replay", "Drive a recorded run once more, and tell whether every number repeats itself", attach_replay},
    Command{"measure-user", "Tell how stiff the hand of a run was, from the proxy drift at rest", attach_measure_user},
    Command{"check", "Compare the pictures of a folder of cases with those stored there", attach_check},
    Command{"doctor", "Tell what lies between a Falcon and its use, and what to do about it", attach_doctor},
};

}  // namespace

std::span<const Command> command_catalog() noexcept {
  return catalog;
}

}  // namespace ghostforce
