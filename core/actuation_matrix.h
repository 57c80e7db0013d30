// What the motors of a device can do to its handle in one configuration. A value; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include <glm/geometric.hpp>

#include "core/conventions.h"

namespace ghostforce {

inline constexpr std::size_t most_motors = 4;

// One number per motor; those past the count of motors mean nothing.
using Efforts = std::array<double, most_motors>;

inline constexpr double no_limit = std::numeric_limits<double>::infinity();

// A, B and U. A linkage has an entry for each motor that exists, and none for a joint without one. Efforts are N for
// axes and strings, N·m for motors that turn.
template <glm::length_t D>
struct ActuationMatrix {
  std::array<Vector<D>, most_motors> columns;   // of A: the force on the handle per unit effort of that motor alone
  std::array<Vector<D>, most_motors> commands;  // rows of B: the effort that a renderer with all motors asks it for
  Efforts least;                                // U: what the motor can make
  Efforts greatest;
  std::size_t count = 0;  // r

  bool is_limited() const noexcept {
    for (std::size_t i = 0; i < count; ++i) {
      if (least[i] > -no_limit || greatest[i] < no_limit) return true;
    }
    return false;
  }
};

// Adds a motor that can push and pull without a limit.
template <glm::length_t D>
void add_motor(ActuationMatrix<D>& actuation, const Vector<D>& column, const Vector<D>& command) noexcept {
  const std::size_t i = actuation.count++;
  actuation.columns[i] = column;
  actuation.commands[i] = command;
  actuation.least[i] = -no_limit;
  actuation.greatest[i] = no_limit;
}

// A u [N]
template <glm::length_t D>
Vector<D> force_of_efforts(const ActuationMatrix<D>& actuation, const Efforts& efforts) noexcept {
  Vector<D> force(0.0);
  for (std::size_t i = 0; i < actuation.count; ++i) force += actuation.columns[i] * efforts[i];
  return force;
}

// The nearest effort that the motor can make.
template <glm::length_t D>
double within_limits(const ActuationMatrix<D>& actuation, std::size_t motor, double effort) noexcept {
  if (effort < actuation.least[motor]) return actuation.least[motor];
  return effort > actuation.greatest[motor] ? actuation.greatest[motor] : effort;
}

// B f, each effort as near as its motor comes: what is sent to the motors that exist for a force that was meant for all.
template <glm::length_t D>
Efforts commanded_efforts(const ActuationMatrix<D>& actuation, const Vector<D>& force) noexcept {
  Efforts efforts{};
  for (std::size_t i = 0; i < actuation.count; ++i) {
    efforts[i] = within_limits(actuation, i, glm::dot(actuation.commands[i], force));
  }
  return efforts;
}

}  // namespace ghostforce
