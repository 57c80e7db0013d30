// VirtualFalconInput: a rehearsal. The same driver as for a real Falcon, on a simulated device in a simulated hand; the
// pointer of the window guides that hand, which homes the device when it is asked to, as a person would.
//
// The hand is the scene's: where the goal says, but for its tremor and drift, and as stiff as its path says at each
// moment of the run. It lives by the model's time, a tick at a time: as long as that stands still, so does what changes in
// the hand.
//
// Made on the UI thread; functions of PointerTarget and inject() stay its, the rest is the servo thread's.
#pragma once

#include <cstdint>
#include <optional>

#include "core/scene.h"
#include "core/tremor_and_drift.h"
#include "device/falcon/falcon_input.h"
#include "device/input/input.h"
#include "device/virtual_falcon/virtual_link.h"

namespace ghostforce {

class VirtualFalconInput final : public FalconInput, public PointerTarget {
 public:
  using Clock = VirtualLink::Clock;

  // A device without firmware takes the one of `options`, or else a practice one.
  VirtualFalconInput(FalconOptions options, const InjectedFault& injected_fault, const Scene& scene,
                     Clock clock = Clock::monotonic);

  std::optional<double> user_stiffness(std::int64_t tick, double rate) noexcept override;

  void move_to(const Vector<2>& goal, double duration_s) noexcept override;
  std::uint64_t ignored_moves() const noexcept override { return ignored_moves_; }
  void set_user_stiffness(double k_u) noexcept override;
  // A button of the grip, as in ReplyFrame; 0: none.
  void press(std::uint8_t buttons) noexcept;
  void inject(const InjectedFault& wrong) noexcept { link_.inject(wrong); }

  // See VirtualLink.
  const VirtualLink& link() const noexcept { return link_; }

 private:
  VirtualFalconInput(std::unique_ptr<VirtualLink> link, const FalconOptions& options, const Scene& scene);
  void lead() noexcept;

  VirtualLink& link_;  // the driver's
  FalconPlane plane_;
  std::uint64_t ignored_moves_ = 0;
  Vector<2> goal_;  // of the hand, in the scene [m]
  double move_s_ = 0.0;
  double k_u_;
  std::uint8_t buttons_ = 0;
  StiffnessPath stiffness_;  // empty: k_u_
  TremorAndDriftMotion tremor_and_drift_;
};

}  // namespace ghostforce
