// Settings for tests in which motors push: the hand of the paper's experiment and a wall that no motor is too weak for.
#pragma once

#include "core/settings.h"

namespace ghostforce {

inline Settings motor_settings(StrategyId active) {
  Settings settings;
  settings.mass = 0.1;
  settings.damping = 5.0;
  settings.rate = 1000.0;
  settings.stiffnesses.k_u = 100.0;
  settings.stiffnesses.k_r = 500.0;
  settings.stiffnesses.k_t = 500.0;
  settings.stiffnesses.k_c = 1e5;
  settings.active = active;
  return settings;
}

}  // namespace ghostforce
