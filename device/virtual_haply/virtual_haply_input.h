// VirtualHaplyInput: a rehearsal. The same driver as for a real Haply 2DIY, over a real serial port of the system, on a
// simulated board with arms in a simulated hand (pty_board.h); the pointer of the window guides that hand, as far as the arms reach; it holds
// the zero pose as long as the driver waits for it.
//
// Made on the UI thread; functions of PointerTarget, inject() and hold_zero_pose() stay its, the rest is the servo
// thread's.
#pragma once

#include <cstdint>
#include <memory>

#include "core/scene.h"
#include "device/haply/haply_input.h"
#include "device/input/input.h"
#include "device/virtual_haply/pty_board.h"

namespace ghostforce {

// Outlives the driver, which says goodbye to it.
struct HeldPtyBoard {
  std::unique_ptr<PtyBoard> board;
};

class VirtualHaplyInput final : private HeldPtyBoard, public HaplyInput, public PointerTarget {
 public:
  // `port` leads to the board.
  VirtualHaplyInput(std::unique_ptr<PtyBoard> board, std::unique_ptr<SerialPort> port, HaplyOptions options,
                    const Scene& scene);

  void move_to(const Vector<2>& goal, double duration_s) noexcept override;
  std::uint64_t ignored_moves() const noexcept override { return ignored_moves_; }
  void set_user_stiffness(double k_u) noexcept override;
  void inject(const InjectedHaplyFault& wrong) noexcept { board->inject(wrong); }
  void hold_zero_pose(bool holds) noexcept { board->hold_zero_pose(holds); }

  // How things really are. UI thread.
  HaplyTruth truth() noexcept { return board->truth(); }

 private:
  void lead() noexcept;

  HaplyCalibration usual_;
  HaplyPlane plane_;
  std::uint64_t ignored_moves_ = 0;
  Vector<2> goal_;  // of the hand, in the scene [m]
  double move_s_ = 0.0;
  double k_u_;
};

}  // namespace ghostforce
