#include "core/batch.h"

#include <cstring>

#include <glm/geometric.hpp>

// On other processors there are no such instructions, and widest_instructions() never names them.
#if defined(__x86_64__)
#define GHOSTFORCE_WITH_AVX2 [[gnu::target("avx2")]]
#else
#define GHOSTFORCE_WITH_AVX2
#endif

namespace ghostforce {

Instructions widest_instructions() noexcept {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return Instructions::avx2;
#endif
  return Instructions::baseline;
}

namespace {

// Registers, as g++ and clang++ know them; each operation is done number by number.
typedef double TwoDoubles __attribute__((vector_size(16)));
typedef double FourDoubles __attribute__((vector_size(32)));

}  // namespace

struct Batch::Kernel {
  // All that makes a lane, each number's eight.
  template <typename Do>
  static void for_each_number(Block& block, const Do& what) noexcept {
    for (Lanes* lanes : {&block.v_xx, &block.v_xy, &block.v_yy, &block.spring, &block.wall_depth, &block.depth}) {
      what(*lanes);
    }
    for (Pair* pair : {&block.wall, &block.normal, &block.goal, &block.device, &block.way}) {
      what(pair->x);
      what(pair->y);
    }
  }

  // Two registers at a time: the sums of one are made while those of the other are waited for, and the state of more
  // would not stay in the 16 registers that there are. Inlined into the functions that say with which instructions.
  template <bool is_held, typename Register>
  [[gnu::always_inline]] static void advance(std::span<Block> blocks, std::span<const Vector<2>> goals,
                                             std::int64_t ticks) noexcept {
    constexpr std::size_t pair = 2;
    constexpr std::size_t in_register = sizeof(Register) / sizeof(double);
    static_assert(width % (pair * in_register) == 0);
    using Registers = Register[pair];
    for (Block& block : blocks) {
      for (std::size_t first = 0; first < width; first += pair * in_register) {
        const auto load = [first](const Lanes& from, Registers& to) { std::memcpy(&to, &from[first], sizeof to); };
        const auto store = [first](const Registers& from, Lanes& to) { std::memcpy(&to[first], &from, sizeof from); };
        Registers v_xx, v_xy, v_yy, spring, wall_x, wall_y, normal_x, normal_y, wall_depth, goal_x, goal_y;
        load(block.v_xx, v_xx);
        load(block.v_xy, v_xy);
        load(block.v_yy, v_yy);
        load(block.spring, spring);
        load(block.wall.x, wall_x);
        load(block.wall.y, wall_y);
        load(block.normal.x, normal_x);
        load(block.normal.y, normal_y);
        load(block.wall_depth, wall_depth);
        load(block.goal.x, goal_x);
        load(block.goal.y, goal_y);
        Registers device_x, device_y, way_x, way_y, depth;
        load(block.device.x, device_x);
        load(block.device.y, device_y);
        load(block.way.x, way_x);
        load(block.way.y, way_y);
        load(block.depth, depth);
        for (std::int64_t k = 0; k < ticks; ++k) {
          for (std::size_t i = 0; i < pair; ++i) {
            Register to_goal_x;
            Register to_goal_y;
            if constexpr (is_held) {
              to_goal_x = goal_x[i] - device_x[i];
              to_goal_y = goal_y[i] - device_y[i];
            } else {
              to_goal_x = goals[static_cast<std::size_t>(k)].x - device_x[i];
              to_goal_y = goals[static_cast<std::size_t>(k)].y - device_y[i];
            }
            const Register x = v_xx[i] * way_x[i] + v_xy[i] * way_y[i] + spring[i] * to_goal_x + wall_x[i] * depth[i];
            const Register y = v_xy[i] * way_x[i] + v_yy[i] * way_y[i] + spring[i] * to_goal_y + wall_y[i] * depth[i];
            const Register inside = wall_depth[i] - (normal_x[i] * device_x[i] + normal_y[i] * device_y[i]);
            depth[i] = inside > 0.0 ? inside : Register{};
            way_x[i] = x;
            way_y[i] = y;
            device_x[i] += x;
            device_y[i] += y;
          }
        }
        store(device_x, block.device.x);
        store(device_y, block.device.y);
        store(way_x, block.way.x);
        store(way_y, block.way.y);
        store(depth, block.depth);
      }
    }
  }

  template <bool is_held>
  static void advance_baseline(std::span<Block> blocks, std::span<const Vector<2>> goals, std::int64_t ticks) noexcept {
    advance<is_held, TwoDoubles>(blocks, goals, ticks);
  }

  template <bool is_held>
  GHOSTFORCE_WITH_AVX2 static void advance_avx2(std::span<Block> blocks, std::span<const Vector<2>> goals,
                                                std::int64_t ticks) noexcept {
    advance<is_held, FourDoubles>(blocks, goals, ticks);
  }
};
#undef GHOSTFORCE_WITH_AVX2

void Batch::add(const TickCoefficients<2>& coefficients, StrategyId strategy, const Vector<2>& goal) {
  const std::size_t i = size() % width;
  if (i == 0) blocks_.emplace_back();
  const auto& [rendering, proxy_gain] = coefficients.strategies[index_of(strategy)];
  readings_.push_back({rendering, proxy_gain, coefficients.rate});

  const SampledDevice& device = coefficients.device;
  const double dt = device.period;
  const double effective_mass = device.mass + dt * device.damping + dt * dt * device.user_stiffness;
  const Matrix<2> v = (Matrix<2>(device.mass) - dt * dt * rendering) / effective_mass;
  const Vector<2> w = dt * dt * (rendering * proxy_gain) / effective_mass;

  Block& block = blocks_.back();
  block.v_xx[i] = v[0][0];
  block.v_xy[i] = v[0][1];
  block.v_yy[i] = v[1][1];
  block.spring[i] = dt * dt * device.user_stiffness / effective_mass;
  block.wall.x[i] = w.x;
  block.wall.y[i] = w.y;
  block.normal.x[i] = coefficients.wall.normal.x;
  block.normal.y[i] = coefficients.wall.normal.y;
  block.wall_depth[i] = glm::dot(coefficients.wall.normal, coefficients.wall.point);
  block.device.x[i] = goal.x;
  block.device.y[i] = goal.y;
  set_goal(size() - 1, goal);
}

void Batch::remove(std::size_t lane) noexcept {
  const std::size_t last = size() - 1;
  std::array<double, sizeof(Block) / sizeof(Lanes)> moved;
  double* out = moved.data();
  Kernel::for_each_number(blocks_.back(), [&](Lanes& numbers) {
    *out++ = numbers[last % width];
    numbers[last % width] = 0.0;
  });
  if (lane != last) {
    const double* in = moved.data();
    Kernel::for_each_number(blocks_[lane / width], [&](Lanes& numbers) { numbers[lane % width] = *in++; });
    readings_[lane] = readings_[last];
  }
  readings_.pop_back();
  if (last % width == 0) blocks_.pop_back();
}

void Batch::set_goal(std::size_t lane, const Vector<2>& goal) noexcept {
  blocks_[lane / width].goal.x[lane % width] = goal.x;
  blocks_[lane / width].goal.y[lane % width] = goal.y;
}

Batch::Lane Batch::operator[](std::size_t lane) const noexcept {
  const Block& block = blocks_[lane / width];
  const std::size_t i = lane % width;
  const Reading& reading = readings_[lane];
  const Vector<2> device(block.device.x[i], block.device.y[i]);
  const Vector<2> way(block.way.x[i], block.way.y[i]);
  const Vector<2> from_device = reading.proxy_gain * block.depth[i] - way;  // q_p − q_h
  return {device, reading.rate * way, device + from_device, reading.rendering * from_device};
}

void Batch::displace(const Vector<2>& way) noexcept {
  for (std::size_t lane = 0; lane < size(); ++lane) {
    Pair& device = blocks_[lane / width].device;
    device.x[lane % width] += way.x;
    device.y[lane % width] += way.y;
  }
}

void Batch::hold(std::int64_t ticks) noexcept {
  (instructions_ == Instructions::avx2 ? Kernel::advance_avx2<true> : Kernel::advance_baseline<true>)(blocks_, {},
                                                                                                      ticks);
}

void Batch::follow(std::span<const Vector<2>> goals) noexcept {
  if (goals.empty()) return;
  const auto ticks = static_cast<std::int64_t>(goals.size());
  (instructions_ == Instructions::avx2 ? Kernel::advance_avx2<false> : Kernel::advance_baseline<false>)(blocks_, goals,
                                                                                                        ticks);
  for (std::size_t lane = 0; lane < size(); ++lane) set_goal(lane, goals.back());
}

}  // namespace ghostforce
