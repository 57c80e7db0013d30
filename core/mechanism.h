// The mechanisms that carry a handle: what their motors can do to it in each of its places, and how they stand there.
// Values and pure functions, never allocate or throw, any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

#include "core/actuation_matrix.h"
#include "core/conventions.h"

namespace ghostforce {

// A motor along one direction of the plane, wherever the handle is.
struct FixedAxis {
  Vector<2> direction{1.0, 0.0};  // unit [1]

  friend bool operator==(const FixedAxis&, const FixedAxis&) = default;
};

// Two links in a row, with a motor at one of the two joints; the other one is free. Joint angles are relative, so the
// motor at the base pushes the handle along the second link, and the motor at the elbow along the line from base to
// handle.
struct TwoLinkArm {
  enum class Elbow : std::uint8_t { left, right };  // of the way from the base to the handle
  enum class Motor : std::uint8_t { base, elbow };

  Vector<2> base{0.0};                      // [m]
  std::array<double, 2> links{0.16, 0.16};  // [m]
  Elbow elbow = Elbow::left;
  Motor motor = Motor::base;

  friend bool operator==(const TwoLinkArm&, const TwoLinkArm&) = default;
};

// A five-bar linkage: two arms that meet in the handle, elbows outward, with a motor at one of the two bases. It pushes
// the handle along the distal link of its own arm.
struct FiveBar {
  enum class Motor : std::uint8_t { left, right };

  std::array<Vector<2>, 2> bases{Vector<2>(-0.035, 0.0), Vector<2>(0.035, 0.0)};  // left and right [m]
  double proximal = 0.11;                                                         // [m]
  double distal = 0.14;                                                           // [m]
  Motor motor = Motor::left;

  friend bool operator==(const FiveBar&, const FiveBar&) = default;
};

// Whether the base that is called left is on the left of the other one, seen from them towards the handle.
inline bool has_elbows_outward(const FiveBar& linkage, const Vector<2>& q) noexcept {
  const Vector<2> across = linkage.bases[1] - linkage.bases[0];
  const Vector<2> way = q - linkage.bases[0];
  return across.x * way.y - across.y * way.x >= 0.0;
}

// The handle hangs on strings. Each pulls towards its anchor, and cannot push.
struct Strings {
  std::array<Vector<2>, most_motors> anchors{};  // [m]
  std::uint32_t count = 0;
  double most = no_limit;  // tension of each [N]

  friend bool operator==(const Strings&, const Strings&) = default;
};

using Mechanism = std::variant<FixedAxis, TwoLinkArm, FiveBar, Strings>;

// Poses nearer to a singular one than this are outside the workspace: |sin| of the angle between two links [1].
inline constexpr double least_link_sine = 0.05;

// Nearer to an anchor than this, a string has no direction to rely on [m].
inline constexpr double shortest_string_m = 0.001;

// With the handle at q. Empty: outside the workspace.
std::optional<ActuationMatrix<2>> actuation_at(const Mechanism& mechanism, const Vector<2>& q) noexcept;

// The same for a loop, without a copy. False: outside the workspace.
bool find_actuation(const Mechanism& mechanism, const Vector<2>& q, ActuationMatrix<2>& actuation) noexcept;

// Whether that depends on q.
inline bool turns(const Mechanism& mechanism) noexcept {
  return !std::holds_alternative<FixedAxis>(mechanism);
}

// Motors that exist, r.
std::size_t motor_count(const Mechanism& mechanism) noexcept;

// Whether efforts are torques, N·m; else N.
inline bool makes_torques(const Mechanism& mechanism) noexcept {
  return std::holds_alternative<TwoLinkArm>(mechanism) || std::holds_alternative<FiveBar>(mechanism);
}

// How the mechanism stands, for drawing: joints, and the links or strings between them. Joints with a motor come first,
// in the order of the efforts.
struct LinkagePose {
  static constexpr std::size_t most_joints = 6;
  struct Link {
    std::size_t from;
    std::size_t to;
    bool is_string;
  };
  std::array<Vector<2>, most_joints> joints{};  // the last one is the handle [m]
  std::size_t joint_count = 0;
  std::size_t motor_count = 0;
  std::array<Link, most_joints> links{};
  std::size_t link_count = 0;
};

// Of a pose that is not empty [m].
inline Vector<2> handle_of(const LinkagePose& pose) noexcept {
  return pose.joints[pose.joint_count - 1];
}

// Empty: the handle cannot be there. A singular pose is drawn like any other.
std::optional<LinkagePose> pose_at(const Mechanism& mechanism, const Vector<2>& q) noexcept;

// The same, but stretched or folded towards q where the handle cannot be there: then the last joint is elsewhere.
LinkagePose nearest_pose(const Mechanism& mechanism, const Vector<2>& q) noexcept;

}  // namespace ghostforce
