#include "app/view/stage/stage_labels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ghostforce {
namespace {

constexpr double fade_s = 0.25;
constexpr double edge = 6.0;                           // to the window's edge [points of the design]
constexpr double label_breath = 5.0;                   // to marks and other labels
constexpr std::array reaches{6.0, 26.0, 60.0, 110.0};  // from the anchor's rim to the label
constexpr std::size_t near_reaches = 2;                // the nearest of these need no line to their anchor
constexpr std::size_t directions = 16;

// 0, 1, −1, 2, −2, …: from the wanted direction to both sides.
double turn_of(std::size_t i) {
  const double steps = static_cast<double>((i + 1) / 2) * (i % 2 == 1 ? 1.0 : -1.0);
  return steps * 2.0 * std::numbers::pi / static_cast<double>(directions);
}

Vector<2> turned(const Vector<2>& direction, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * direction.x - s * direction.y, s * direction.x + c * direction.y};
}

}  // namespace

bool StageLabelMemory::is_moving() const noexcept {
  return std::ranges::any_of(places, [](const Place& place) { return place.candidate && place.strength < 1.0; });
}

StageLabels::~StageLabels() {
  for (std::size_t i = 0; i < stage_label_count; ++i) {
    if (!is_asked_for_[i]) memory_.places[i] = {};
  }
  memory_.has_begun = true;
}

void StageLabels::keep_clear(const Vector<2>& from, const Vector<2>& to, double radius) {
  obstacles_.push_back({from, to, radius + label_breath * unit_});
}

void StageLabels::keep_clear(const ScreenBox& box) {
  boxes_.push_back(box.grown(label_breath * unit_));
}

bool StageLabels::is_free(const ScreenBox& box) const {
  const ScreenBox window{Vector<2>(edge * unit_), size_ - Vector<2>(edge * unit_)};
  if (!contains(window, box.least) || !contains(window, box.most)) return false;
  const auto covers = [&](const ScreenBox& other) { return overlap(box, other) > 0.0; };
  const auto touches = [&](const Obstacle& obstacle) {
    ScreenPiece piece{obstacle.from, obstacle.to, 0.0};
    return clip(box.grown(obstacle.radius), piece);
  };
  return std::ranges::none_of(boxes_, covers) && std::ranges::none_of(obstacles_, touches);
}

template <typename BoxOf>
std::optional<StageLabels::Found> StageLabels::choose(StageLabel id, std::size_t count, const BoxOf& box_of,
                                                      std::size_t first_far) {
  StageLabelMemory::Place& place = memory_.places[static_cast<std::size_t>(id)];
  is_asked_for_[static_cast<std::size_t>(id)] = true;
  const auto is_good = [&](std::size_t candidate) { return is_free(box_of(candidate)); };
  if (!place.candidate || *place.candidate >= count || !is_good(*place.candidate)) {
    place.strength = 0.0;
    place.candidate.reset();
    for (std::size_t i = 0; i < count && !place.candidate; ++i) {
      if (is_good(i)) place.candidate = i;
    }
  }
  if (!place.candidate) return std::nullopt;
  place.strength = memory_.has_begun ? std::min(1.0, place.strength + interval_s_ / fade_s) : 1.0;
  const ScreenBox box = box_of(*place.candidate);
  boxes_.push_back(box.grown(label_breath * unit_));
  return Found{box, place.strength, *place.candidate >= first_far};
}

std::optional<StageLabels::Found> StageLabels::place(const Request& request) {
  const Vector<2> extent = extent_of(request.lines, request.style);
  const double length = glm::length(request.direction);
  const Vector<2> wanted = length > 0.0 ? request.direction / length : Vector<2>(0.0, -1.0);
  const auto box_of = [&](std::size_t candidate) {
    const Vector<2> direction = turned(wanted, turn_of(candidate % directions));
    const double reach = request.clearance + reaches[candidate / directions] * unit_;
    // The box touches a circle round the anchor: its middle is moved on by half of itself.
    const Vector<2> middle = request.anchor + direction * reach + 0.5 * direction * extent;
    return ScreenBox{middle - 0.5 * extent, middle + 0.5 * extent};
  };
  return choose(request.id, directions * reaches.size(), box_of, directions * near_reaches);
}

std::optional<StageLabels::Found> StageLabels::place_block(StageLabel id, const Vector<2>& extent,
                                                           const std::vector<Vector<2>>& corners) {
  const auto box_of = [&](std::size_t candidate) { return ScreenBox{corners[candidate], corners[candidate] + extent}; };
  return choose(id, corners.size(), box_of, corners.size());
}

Vector<2> StageLabels::extent_of(const std::vector<std::string>& lines, const TextStyle& style) const {
  Vector<2> extent(0.0, static_cast<double>(lines.size()) * style.height);
  for (const std::string& line : lines) extent.x = std::max(extent.x, measure_(line, style).x);
  return extent;
}

}  // namespace ghostforce
