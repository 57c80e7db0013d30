// Many independent simulations in the plane, a lane each: the loop of tick.h (23)(24)(25) for one strategy per lane,
// advanced side by side, as many lanes per instruction as the processor allows. For sweeps and other questions over
// many settings; the servo and `simulate` run tick(). Not for the servo thread: adding lanes allocates, advancing does
// not. No state is shared, so that each thread may have its own.
//
// The recurrence is that of tick(), with all that the settings fix multiplied out beforehand. With u = dt v the
// displacement in a tick and h = max(0, n·(o − q_h)) the depth that the wall acts on, q_p,k − q_h,k = step h_k−1 − u_k,
// hence
//     u_k   = V u_k−1 + c (q_u(t_k) − q_h,k−1) + w h_k−2        (23)(25)
//     q_h,k = q_h,k−1 + u_k                                     (24)
// where
//     M = m + dt b + dt² k_u
//     V = (m I − dt² K_r)/M
//     c = dt² k_u/M
//     w = dt² K_r step/M
// This rounds differently from tick(): a loop that comes to rest ends at the same place to some 1e-12, and not to the
// last bit. A lane's result depends on nothing but the lane: not on its neighbours, nor on the instructions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/conventions.h"
#include "core/strategy.h"
#include "core/tick.h"

namespace ghostforce {

// What a batch is computed with.
enum class Instructions : std::uint8_t {
  baseline,  // what every processor has that the program was compiled for: 2 lanes per instruction on x86-64
  avx2,      // 4 lanes
};

// The widest that this processor has.
Instructions widest_instructions() noexcept;

class Batch {
 public:
  // A lane as it stands after some tick.
  struct Lane {
    Vector<2> device;    // q_h [m]
    Vector<2> velocity;  // v [m/s]
    Vector<2> proxy;     // q_p [m]
    Vector<2> force;     // f_r = K_r (q_p − q_h) [N]
  };

  // `instructions` that this processor does not have end the program.
  explicit Batch(Instructions instructions = widest_instructions()) noexcept : instructions_(instructions) {}

  // Adds a lane at the end, as it is at k = 0: q_h = q_p = q_u = `goal` [m], v = 0, f_r = 0.
  void add(const TickCoefficients<2>& coefficients, StrategyId strategy, const Vector<2>& goal);

  // Removes a lane; the last lane takes its place.
  void remove(std::size_t lane) noexcept;

  std::size_t size() const noexcept { return readings_.size(); }

  // The goal that a lane holds from now on, q_u [m].
  void set_goal(std::size_t lane, const Vector<2>& goal) noexcept;

  // A knock between two ticks: moves all devices by this much [m].
  void displace(const Vector<2>& way) noexcept;

  // Advances by this many ticks, each lane under the goal that it holds.
  void hold(std::int64_t ticks) noexcept;

  // One tick per goal, the same goal for all lanes; they hold the last one afterwards. The caller has to mind the
  // lanes' rates: at another rate, a path in time is another sequence of goals.
  void follow(std::span<const Vector<2>> goals) noexcept;

  Lane operator[](std::size_t lane) const noexcept;

 private:
  static constexpr std::size_t width = 8;  // two registers of 4, or four of 2
  using Lanes = std::array<double, width>;
  struct Pair {
    Lanes x{};
    Lanes y{};
  };

  // Eight lanes side by side. Unused lanes are 0 and stay 0.
  struct alignas(64) Block {
    Lanes v_xx{};  // V, symmetric [1]
    Lanes v_xy{};
    Lanes v_yy{};
    Lanes spring{};      // c [1]
    Pair wall{};         // w [1]
    Pair normal{};       // n [1]
    Lanes wall_depth{};  // n·o [m]
    Pair goal{};         // q_u [m]
    Pair device{};       // q_h [m]
    Pair way{};          // u [m]
    Lanes depth{};       // h, of the device of the tick before [m]
  };

  // What a lane is read with.
  struct Reading {
    Matrix<2> rendering;   // K_r [N/m]
    Vector<2> proxy_gain;  // see proxy.h [1]
    double rate;           // 1/dt [Hz]
  };

  struct Kernel;  // batch.cpp

  Instructions instructions_;
  std::vector<Block> blocks_;
  std::vector<Reading> readings_;
};

}  // namespace ghostforce
