// Input: something that knows where the hand wants the device to be.
//
// The window makes an input (input_catalog.h) and hands it to the servo, which owns it from then on. The functions
// below belong to the servo thread: they never allocate, lock, wait, throw or open files. What a kind of input takes in
// from other threads, it takes in as whole values (see MouseInput). SI units.
#pragma once

#include <cstdint>
#include <optional>

#include "core/conventions.h"
#include "device/input/haptic_device.h"

namespace ghostforce {

class Input {
 public:
  Input() = default;
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;
  virtual ~Input() = default;

  // The run starts, or starts again, at rest with this goal [m].
  virtual void restart(const Vector<2>& goal) noexcept = 0;

  // q_u(t_k) [m], where t_k = k / rate; asked once per tick. `rate` in ticks per second of model time [Hz].
  virtual Vector<2> goal(std::int64_t tick, double rate) noexcept = 0;

  // k_u of the hand in tick k [N/m], where a hand that changes moves the simulated devices, whoever says where to; asked
  // once per tick. Empty: the settings say it.
  virtual std::optional<double> user_stiffness(std::int64_t /*tick*/, double /*rate*/) noexcept { return {}; }

  // The motors of this input; null: it has none. Then nothing that it does can be felt.
  virtual HapticDevice* haptic_device() noexcept { return nullptr; }
};

}  // namespace ghostforce
