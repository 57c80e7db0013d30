// The hand on a SpaceMouse that is plugged into this computer. A thread of the input's own looks for a device about twice
// a second (in /sys/class/hidraw), opens it and reads it (hidapi; all of which may wait and allocate); the servo thread
// only takes the newest reading.
//
// The constructor belongs to the UI thread. The destructor waits for the reading thread: some 20 ms, or until that has
// seen what is plugged in.
#pragma once

#include <stop_token>
#include <thread>

#include "device/spacemouse/spacemouse_input.h"

namespace ghostforce {

class HidSpaceMouseInput final : public SpaceMouseInput {
 public:
  explicit HidSpaceMouseInput(const SpaceMouseSettings& settings = {});
  ~HidSpaceMouseInput() override = default;  // the thread is asked to stop and waited for

 private:
  void read(const std::stop_token& stop);

  std::jthread reader_;  // last: it uses what stands above
};

}  // namespace ghostforce
