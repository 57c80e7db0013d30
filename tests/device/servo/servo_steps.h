// A servo on a scene's own path, stepped by hand. For tests.
#pragma once

#include <cstdint>
#include <memory>

#include "core/scene.h"
#include "device/input/input.h"
#include "device/input/scripted_input.h"
#include "device/servo/servo.h"

namespace ghostforce {

inline std::unique_ptr<Input> script_of(const Scene& scene) {
  return std::make_unique<ScriptedInput>(scene.goal);
}

inline void step(Servo& servo, std::int64_t times) {
  for (std::int64_t i = 0; i < times; ++i) servo.step();
}

}  // namespace ghostforce
