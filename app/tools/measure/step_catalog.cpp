#include <array>

#include "app/tools/measure/steps.h"

namespace ghostforce {
namespace {

using Needs = MeasureStep::Needs;

constexpr std::array steps{
    MeasureStep{"Encoders", "You move the handle in three directions. The motors stay off.", measure_encoders,
                Needs::nothing, Needs::encoders},
    MeasureStep{"Lengths", "You move the handle along a ruler, five times. The motors stay off.", measure_lengths,
                Needs::encoders},
    MeasureStep{"Motors' directions", "Each motor pushes gently for a second while you hold down a button of the grip.",
                measure_motor_signs, Needs::encoders, Needs::motors},
    MeasureStep{
        "Motors' strength",
        "The motors carry the handle, with and without a weight on it, while one fingertip holds down a button.",
        measure_motor_constant, Needs::motors},
    MeasureStep{"Force without commands",
                "The motors push gently, and the program is silent for up to a second: does the device drop the force?",
                measure_silence, Needs::motors},
    MeasureStep{"Exchanges", "You hold the handle still. The motors stay off.", measure_exchanges},
    MeasureStep{"Lights", "You say what colour the device's light is. The motors stay off.", check_lights},
    MeasureStep{"Buttons", "You press the four buttons of the grip. The motors stay off.", check_buttons},
};

}  // namespace

std::span<const MeasureStep> measure_step_catalog() noexcept {
  return steps;
}

}  // namespace ghostforce
