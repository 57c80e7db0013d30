#include "core/mechanism.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace ghostforce {
namespace {

// A quarter of a turn counter-clockwise: how a point goes when the link to it turns, per rad.
Vector<2> turned(const Vector<2>& link) noexcept {
  return {-link.y, link.x};
}

// The sine of the angle from one link to the other.
double sine_between(const Vector<2>& one, const Vector<2>& other) noexcept {
  return glm::dot(turned(one), other) / (glm::length(one) * glm::length(other));
}

bool is_singular(double sine) noexcept {
  return !(std::abs(sine) >= least_link_sine);
}

// The joint between two links from `base` to `q`; `side` is 1 for left of that way, −1 for right. Empty: q is out of
// reach.
std::optional<Vector<2>> joint_between(const Vector<2>& base, const Vector<2>& q, double first, double second,
                                       double side) noexcept {
  const Vector<2> way = q - base;
  const double square = glm::dot(way, way);
  if (!(square > 0.0)) return std::nullopt;
  const double along = 0.5 * (1.0 + (first * first - second * second) / square);  // of the way
  const double across = first * first / square - along * along;
  if (!(across >= 0.0)) return std::nullopt;
  return base + along * way + (side * std::sqrt(across)) * turned(way);
}

std::optional<Vector<2>> elbow_of(const TwoLinkArm& arm, const Vector<2>& q) noexcept {
  return joint_between(arm.base, q, arm.links[0], arm.links[1], arm.elbow == TwoLinkArm::Elbow::left ? 1.0 : -1.0);
}

struct Elbows {
  Vector<2> left;
  Vector<2> right;
};

std::optional<Elbows> elbows_of(const FiveBar& linkage, const Vector<2>& q) noexcept {
  const auto left = joint_between(linkage.bases[0], q, linkage.proximal, linkage.distal, 1.0);
  const auto right = joint_between(linkage.bases[1], q, linkage.proximal, linkage.distal, -1.0);
  return left && right ? std::optional(Elbows{*left, *right}) : std::nullopt;
}

// Each writes to an empty matrix. False: outside the workspace.
struct ActuationAt {
  const Vector<2>& q;
  ActuationMatrix<2>& actuation;

  bool operator()(const FixedAxis& axis) const noexcept {
    add_motor(actuation, axis.direction, axis.direction);
    return true;
  }

  // J = [∂q/∂θ_base, ∂q/∂θ_elbow]; a column of J⁻ᵀ is across the other joint's column of J.
  bool operator()(const TwoLinkArm& arm) const noexcept {
    const auto elbow = elbow_of(arm, q);
    if (!elbow || is_singular(sine_between(*elbow - arm.base, q - *elbow))) return false;
    const bool is_at_base = arm.motor == TwoLinkArm::Motor::base;
    const Vector<2> moves = turned(q - (is_at_base ? arm.base : *elbow));
    const Vector<2> pushes = q - (is_at_base ? *elbow : arm.base);  // across the other column
    add_motor(actuation, pushes / glm::dot(pushes, moves), moves);
    return true;
  }

  // The distal links d and proximal links p of both arms tie the velocity of the handle to those of the motors:
  // dᵀq̇ = (d·turned(p)) θ̇ for each, so the columns of J⁻ᵀ are d/(d·turned(p)).
  bool operator()(const FiveBar& linkage) const noexcept {
    const auto elbows = elbows_of(linkage, q);
    if (!elbows) return false;
    std::array<Vector<2>, 2> proximal{elbows->left - linkage.bases[0], elbows->right - linkage.bases[1]};
    std::array<Vector<2>, 2> distal{q - elbows->left, q - elbows->right};
    if (is_singular(sine_between(proximal[0], distal[0])) || is_singular(sine_between(proximal[1], distal[1])) ||
        is_singular(sine_between(distal[0], distal[1]))) {
      return false;
    }
    const std::size_t own = linkage.motor == FiveBar::Motor::left ? 0 : 1;
    const double lever = glm::dot(distal[own], turned(proximal[own]));
    const Vector<2> across = turned(distal[1 - own]);  // where the other motor lets the handle go
    add_motor(actuation, distal[own] / lever, across * (lever / glm::dot(distal[own], across)));
    return true;
  }

  bool operator()(const Strings& strings) const noexcept {
    Matrix<2> square(0.0);  // A Aᵀ
    for (std::size_t i = 0; i < strings.count; ++i) {
      const Vector<2> way = strings.anchors[i] - q;
      const double length = glm::length(way);
      if (!(length >= shortest_string_m)) return false;
      const Vector<2> pull = way / length;
      add_motor(actuation, pull, pull);
      actuation.least[i] = 0.0;
      actuation.greatest[i] = strings.most;
      square += glm::outerProduct(pull, pull);
    }
    // B = A⁺: Aᵀ(A Aᵀ)⁻¹ where the strings reach every direction, and Aᵀ/r where they are all in one line.
    if (std::abs(glm::determinant(square)) > 1e-12) {
      const Matrix<2> inverse = glm::inverse(square);
      for (std::size_t i = 0; i < strings.count; ++i) actuation.commands[i] = inverse * actuation.columns[i];
    } else {
      for (std::size_t i = 0; i < strings.count; ++i) actuation.commands[i] /= static_cast<double>(strings.count);
    }
    return true;
  }
};

void add_joint(const Vector<2>& joint, LinkagePose& pose) noexcept {
  pose.joints[pose.joint_count++] = joint;
}

void add_link(std::size_t from, std::size_t to, LinkagePose& pose, bool is_string = false) noexcept {
  pose.links[pose.link_count++] = {from, to, is_string};
}

struct PoseAt {
  const Vector<2>& q;

  std::optional<LinkagePose> operator()(const FixedAxis&) const noexcept {
    LinkagePose pose;
    add_joint(q, pose);
    return pose;
  }

  std::optional<LinkagePose> operator()(const TwoLinkArm& arm) const noexcept {
    const auto elbow = elbow_of(arm, q);
    if (!elbow) return std::nullopt;
    const bool is_at_base = arm.motor == TwoLinkArm::Motor::base;
    LinkagePose pose;
    pose.motor_count = 1;
    add_joint(is_at_base ? arm.base : *elbow, pose);
    add_joint(is_at_base ? *elbow : arm.base, pose);
    add_joint(q, pose);
    add_link(0, 1, pose);
    add_link(is_at_base ? 1 : 0, 2, pose);
    return pose;
  }

  std::optional<LinkagePose> operator()(const FiveBar& linkage) const noexcept {
    const auto elbows = elbows_of(linkage, q);
    if (!elbows) return std::nullopt;
    const bool is_left = linkage.motor == FiveBar::Motor::left;
    LinkagePose pose;
    pose.motor_count = 1;
    add_joint(linkage.bases[is_left ? 0 : 1], pose);
    add_joint(linkage.bases[is_left ? 1 : 0], pose);
    add_joint(is_left ? elbows->left : elbows->right, pose);
    add_joint(is_left ? elbows->right : elbows->left, pose);
    add_joint(q, pose);
    for (std::size_t i = 0; i < 2; ++i) {
      add_link(i, i + 2, pose);
      add_link(i + 2, 4, pose);
    }
    return pose;
  }

  std::optional<LinkagePose> operator()(const Strings& strings) const noexcept {
    LinkagePose pose;
    pose.motor_count = strings.count;
    for (std::size_t i = 0; i < strings.count; ++i) {
      add_joint(strings.anchors[i], pose);
      add_link(i, strings.count, pose, true);
    }
    add_joint(q, pose);
    return pose;
  }
};

// Where the elbows are bent at right angles, and so surely within reach; of an arm on the way to q.
struct MiddleOf {
  const Vector<2>& q;

  Vector<2> operator()(const FixedAxis&) const noexcept { return q; }
  Vector<2> operator()(const Strings&) const noexcept { return q; }

  Vector<2> operator()(const TwoLinkArm& arm) const noexcept {
    const Vector<2> way = q - arm.base;
    const double length = glm::length(way);
    const Vector<2> direction = length > 0.0 ? way / length : Vector<2>(1.0, 0.0);
    return arm.base + std::hypot(arm.links[0], arm.links[1]) * direction;
  }

  Vector<2> operator()(const FiveBar& linkage) const noexcept {
    const Vector<2> half = 0.5 * (linkage.bases[1] - linkage.bases[0]);
    const double gap = glm::length(half);
    const double reach = std::hypot(linkage.proximal, linkage.distal);
    const double ahead = std::sqrt(std::max(0.0, reach * reach - gap * gap));
    return linkage.bases[0] + half + (gap > 0.0 ? turned(half) * (ahead / gap) : Vector<2>(0.0, ahead));
  }
};

}  // namespace

std::optional<ActuationMatrix<2>> actuation_at(const Mechanism& mechanism, const Vector<2>& q) noexcept {
  std::optional<ActuationMatrix<2>> actuation(std::in_place);
  if (!find_actuation(mechanism, q, *actuation)) actuation.reset();
  return actuation;
}

bool find_actuation(const Mechanism& mechanism, const Vector<2>& q, ActuationMatrix<2>& actuation) noexcept {
  actuation.count = 0;
  return std::visit(ActuationAt{q, actuation}, mechanism);
}

std::size_t motor_count(const Mechanism& mechanism) noexcept {
  const auto* const strings = std::get_if<Strings>(&mechanism);
  return strings == nullptr ? 1 : strings->count;
}

std::optional<LinkagePose> pose_at(const Mechanism& mechanism, const Vector<2>& q) noexcept {
  return std::visit(PoseAt{q}, mechanism);
}

LinkagePose nearest_pose(const Mechanism& mechanism, const Vector<2>& q) noexcept {
  std::optional<LinkagePose> pose = pose_at(mechanism, q);
  if (pose) return *pose;
  const Vector<2> middle = std::visit(MiddleOf{q}, mechanism);
  pose = pose_at(mechanism, middle);
  double reached = 0.0;  // of the way from there to q
  constexpr int halvings = 40;
  double step = 0.5;
  for (int i = 0; i < halvings; ++i, step *= 0.5) {
    const auto further = pose_at(mechanism, middle + (reached + step) * (q - middle));
    if (!further) continue;
    pose = further;
    reached += step;
  }
  return pose.value_or(LinkagePose{});
}

}  // namespace ghostforce
