#include "app/view/stage/stage_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "app/view/stage/stage_lines.h"

namespace ghostforce {
namespace {

constexpr double fade_s = 0.25;
// So long must there have been a place for words that had none, and a better one for words that have one.
constexpr double comes_back_s = 0.2;
constexpr double moves_on_s = 0.7;

// In points of the design.
constexpr double edge = 6.0;       // to the window's edge
constexpr double new_air = 5.0;    // to marks and other labels, where words come to stand,
constexpr double least_air = 2.0;  // and as long as they stand there
constexpr std::array reaches{6.0, 10.0, 15.0, 22.0, 30.0, 42.0, 58.0, 80.0, 110.0};
constexpr double far_reach = 36.0;     // words beyond need a line to what they name
constexpr double worth_moving = 30.0;  // so much nearer must a place be
constexpr double row_height = 8.0;     // from one try to place a block to the next

// What else makes a place worse, in the same measure.
constexpr double cost_of_turn = 20.0;      // for a place at right angles to the wanted direction
constexpr double cost_of_shift = 24.0;     // for one at the end of a thing instead of at its middle, twice that
constexpr double cost_of_break = 14.0;     // for two lines
constexpr double cost_of_leader = 30.0;    // for a line to what it names
constexpr double cost_of_crowding = 25.0;  // for the place that less important words would have

// The sides of the words' box that can be towards what they name, going round it.
constexpr std::array sides{Vector<2>(-1.0, -1.0), Vector<2>(-0.75, -1.0), Vector<2>(-0.5, -1.0), Vector<2>(-0.25, -1.0),
                           Vector<2>(0.0, -1.0),  Vector<2>(0.25, -1.0),  Vector<2>(0.5, -1.0),  Vector<2>(0.75, -1.0),
                           Vector<2>(1.0, -1.0),  Vector<2>(1.0, -0.5),   Vector<2>(1.0, 0.0),   Vector<2>(1.0, 0.5),
                           Vector<2>(1.0, 1.0),   Vector<2>(0.75, 1.0),   Vector<2>(0.5, 1.0),   Vector<2>(0.25, 1.0),
                           Vector<2>(0.0, 1.0),   Vector<2>(-0.25, 1.0),  Vector<2>(-0.5, 1.0),  Vector<2>(-0.75, 1.0),
                           Vector<2>(-1.0, 1.0),  Vector<2>(-1.0, 0.5),   Vector<2>(-1.0, 0.0),  Vector<2>(-1.0, -0.5)};

// From what is named to the words.
Vector<2> way_to(const Vector<2>& side) {
  if (std::abs(side.x) < 1.0) return {0.0, side.y};
  if (std::abs(side.y) < 1.0) return {side.x, 0.0};
  return side * std::numbers::sqrt2 * 0.5;
}

bool lies_within(const ScreenBox& region, const ScreenBox& box) {
  return contains(region, box.least) && contains(region, box.most);
}

}  // namespace

struct StageLabels::Form {
  std::vector<std::string> lines;
  Vector<2> extent;
};

struct StageLabels::Candidate {
  double cost;
  std::uint8_t share;
  std::uint8_t side;
  std::uint8_t reach;
  bool is_broken;
};

// One request: what it may look like, and where it may stand.
class StageLabels::Search {
 public:
  Search(const StageLabels& labels, const LabelRequest& request) : labels_(labels), request_(request) {
    forms_.push_back({request.lines, labels.extent_of(request.lines, request.style)});
    const double length = glm::length(request.direction);
    wanted_ = length > 0.0 ? request.direction / length : Vector<2>(0.0, -1.0);
    const ScreenBox window{Vector<2>(0.0), labels.size_};
    ScreenPiece seen{request.from, request.to, 0.0};
    is_seen_ = clip(window, seen);
    from_ = seen.from;
    to_ = seen.to;
  }

  bool is_seen() const { return is_seen_; }
  const LabelRequest& request() const { return request_; }

  // Empty where it is not free.
  std::optional<PlacedLabel> at(const Place& place, double air) {
    const Form& form = form_of(place.is_broken);
    const Vector<2> anchor = from_ + place.share * (to_ - from_);
    const Vector<2> way = way_to(place.side);
    const Vector<2> middle =
        anchor + way * (request_.clearance + labels_.points(place.reach)) + 0.5 * place.side * form.extent;
    const ScreenBox box{middle - 0.5 * form.extent, middle + 0.5 * form.extent};
    const ScreenBox window{Vector<2>(labels_.points(edge)), labels_.size_ - Vector<2>(labels_.points(edge))};
    if (!lies_within(window, box)) return std::nullopt;
    if (!labels_.obstacles_.is_free(box, labels_.points(air), Clearance::always)) return std::nullopt;
    PlacedLabel placed{form.lines, box, 0.5 - 0.5 * place.side.x};
    if (place.reach > far_reach) {
      const Vector<2> nearest = glm::clamp(anchor, box.least, box.most);
      const Vector<2> gap = nearest - anchor;
      const ScreenPiece leader{anchor + gap * (request_.clearance / glm::length(gap)), nearest, 0.0};
      if (!labels_.obstacles_.can_pass(anchor, leader.from, leader.to)) return std::nullopt;
      placed.leader = leader;
    }
    return placed;
  }

  double cost_of(const Place& place) const {
    double cost = place.reach + cost_of_turn * (1.0 - glm::dot(glm::normalize(place.side), wanted_)) +
                  cost_of_shift * std::abs(place.share - request_.best_share);
    if (place.is_broken) cost += cost_of_break;
    if (place.reach > far_reach) cost += cost_of_leader;
    return cost;
  }

  // The best free place that is better than `limit`, if less important words, which stand there, are left in peace.
  std::optional<Place> best(double limit, const std::vector<ScreenBox>& others) {
    const std::vector<double> shares = shares_of();
    fill(shares, limit);
    std::optional<Place> found;
    double least = limit;
    const auto dearer = [](const Candidate& a, const Candidate& b) { return a.cost > b.cost; };
    std::ranges::make_heap(candidates_, dearer);
    while (!candidates_.empty() && candidates_.front().cost < least) {
      const Candidate& candidate = candidates_.front();
      Place place;
      place.share = shares[candidate.share];
      place.side = sides[candidate.side];
      place.reach = reaches[candidate.reach];
      place.is_broken = candidate.is_broken;
      if (const auto placed = at(place, new_air)) {
        double cost = candidate.cost;
        for (const ScreenBox& other : others) {
          if (overlap(placed->box.grown(labels_.points(new_air)), other) > 0.0) cost += cost_of_crowding;
        }
        if (cost < least) {
          least = cost;
          found = place;
        }
      }
      std::ranges::pop_heap(candidates_, dearer);
      candidates_.pop_back();
    }
    return found;
  }

 private:
  const Form& form_of(bool is_broken) {
    if (is_broken && forms_.size() == 1) {
      const std::vector<std::string> lines = broken_in_two(request_.lines.front(), request_.style, labels_.measure_);
      forms_.push_back({lines, labels_.extent_of(lines, request_.style)});
    }
    return forms_[is_broken ? 1 : 0];
  }

  std::vector<double> shares_of() const {
    std::vector<double> shares{request_.best_share};
    if (glm::distance(from_, to_) < labels_.points(80.0)) return shares;
    for (const double share : {0.5, 0.25, 0.75, 0.05, 0.95}) {
      if (share != request_.best_share) shares.push_back(share);
    }
    return shares;
  }

  void fill(const std::vector<double>& shares, double limit) {
    candidates_.clear();
    const bool can_break = request_.lines.size() == 1 && request_.lines.front().find(' ') != std::string::npos;
    Place place;
    for (const bool is_broken : {false, true}) {
      if (is_broken && !can_break) break;
      place.is_broken = is_broken;
      for (std::size_t share = 0; share < shares.size(); ++share) {
        place.share = shares[share];
        for (std::size_t side = 0; side < sides.size(); ++side) {
          place.side = sides[side];
          for (std::size_t reach = 0; reach < reaches.size(); ++reach) {
            place.reach = reaches[reach];
            const double cost = cost_of(place);
            if (cost >= limit) break;
            candidates_.push_back({cost, static_cast<std::uint8_t>(share), static_cast<std::uint8_t>(side),
                                   static_cast<std::uint8_t>(reach), is_broken});
          }
        }
      }
    }
  }

  const StageLabels& labels_;
  const LabelRequest& request_;
  std::vector<Form> forms_;
  Vector<2> wanted_{0.0};
  Vector<2> from_{0.0};  // what is seen of the thing
  Vector<2> to_{0.0};
  bool is_seen_ = false;
  std::vector<Candidate> candidates_;
};

bool StageLabelMemory::is_moving() const noexcept {
  return std::ranges::any_of(
      places, [](const Place& place) { return place.waited_s > 0.0 || (place.is_taken && place.strength < 1.0); });
}

StageLabels::StageLabels(const Vector<2>& size, double unit, const MeasureText& measure, StageLabelMemory& memory,
                         double interval_s)
    : size_(size), unit_(unit), measure_(measure), memory_(memory), interval_s_(interval_s) {
  // Another window: all is somewhere else anyway.
  if (memory.size != size || memory.unit != unit) memory = {.size = size, .unit = unit};
}

StageLabels::~StageLabels() {
  for (std::size_t i = 0; i < stage_label_count; ++i) {
    if (!is_asked_for_[i]) memory_.places[i] = {};
  }
  memory_.has_begun = true;
}

StageLabels::Place& StageLabels::remembered(StageLabel id) {
  is_asked_for_[static_cast<std::size_t>(id)] = true;
  return memory_.places[static_cast<std::size_t>(id)];
}

void StageLabels::move_to(Place& place, const Place& other) {
  place = other;
  place.is_taken = true;
  place.strength = memory_.has_begun ? 0.0 : 1.0;
  place.waited_s = 0.0;
}

bool StageLabels::has_waited(Place& place, double at_least_s) {
  if (!memory_.has_begun) return true;
  // So that something is on its way, however short the first interval is.
  place.waited_s += std::max(interval_s_, 1e-6);
  return place.waited_s >= at_least_s;
}

std::vector<std::optional<PlacedLabel>> StageLabels::place(const std::vector<LabelRequest>& requests) {
  std::vector<Search> searches;
  for (const LabelRequest& request : requests) searches.emplace_back(*this, request);
  std::vector<std::size_t> order(requests.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return requests[i].id; });

  // Where each would stand if there were no others.
  std::vector<std::optional<ScreenBox>> expected(requests.size());
  for (const std::size_t i : order) {
    Search& search = searches[i];
    Place place = remembered(requests[i].id);
    if (!search.is_seen() || requests[i].block) continue;
    if (!memory_.has_begun) {
      const auto best = search.best(std::numeric_limits<double>::infinity(), {});
      if (!best) continue;
      place = *best;
      place.is_taken = true;
    }
    if (!place.is_taken) continue;
    if (const auto placed = search.at(place, least_air)) expected[i] = placed->box;
  }

  std::vector<std::optional<PlacedLabel>> found(requests.size());
  for (const std::size_t i : order) {
    expected[i].reset();
    std::vector<ScreenBox> others;
    for (const std::optional<ScreenBox>& other : expected) {
      if (other) others.push_back(*other);
    }
    found[i] = place_one(searches[i], others);
    if (!found[i]) continue;
    if (!requests[i].block) obstacles_.add(found[i]->box);
    if (const auto& leader = found[i]->leader) obstacles_.add(leader->from, leader->to, points(1.0), Clearance::always);
  }
  return found;
}

std::optional<PlacedLabel> StageLabels::place_one(Search& search, const std::vector<ScreenBox>& others) {
  if (const auto& block = search.request().block) {
    const auto placed = place_block(*block);
    if (!placed) return std::nullopt;
    return PlacedLabel{.lines = search.request().lines, .box = placed->box, .strength = placed->strength};
  }
  Place& place = remembered(search.request().id);
  if (!search.is_seen()) {
    place = {};
    return std::nullopt;
  }
  place.strength = std::min(1.0, place.strength + interval_s_ / fade_s);
  std::optional<PlacedLabel> now = place.is_taken ? search.at(place, least_air) : std::nullopt;
  if (now) {
    const double limit = search.cost_of(place) - worth_moving;
    const auto better = limit > 0.0 ? search.best(limit, others) : std::nullopt;
    if (!better) place.waited_s = 0.0;
    if (better && has_waited(place, moves_on_s)) {
      move_to(place, *better);
      now = search.at(place, least_air);
    }
  } else {
    const auto best = search.best(std::numeric_limits<double>::infinity(), others);
    if (best && (place.is_taken || has_waited(place, comes_back_s))) {
      move_to(place, *best);
      now = search.at(place, least_air);
    } else {
      place.is_taken = false;
      place.strength = 0.0;
      if (!best) place.waited_s = 0.0;
    }
  }
  if (now) now->strength = place.strength;
  return now;
}

std::optional<StageLabels::PlacedBlock> StageLabels::place_block(const LabelBlock& block) {
  Place& place = remembered(block.id);
  place.strength = std::min(1.0, place.strength + interval_s_ / fade_s);
  const auto box_at = [&](const Vector<2>& corner) { return ScreenBox{corner, corner + block.extent}; };
  const auto cost_of = [&](const Vector<2>& corner) {
    return glm::dot(block.dearness, glm::abs(corner - block.wanted));
  };
  const auto can_stay = [&](Clearance clearance) {
    const ScreenBox box = box_at(place.corner);
    return place.is_taken && lies_within(block.region, box) &&
           (!block.edge || lies_right_of(*block.edge, box, points(least_air))) &&
           obstacles_.is_free(box, points(least_air), clearance);
  };
  const auto find = [&](Clearance clearance) {
    return obstacles_.find_block(
        {block.extent, block.region, block.wanted, block.dearness, block.edge, points(new_air), clearance},
        points(row_height));
  };
  const auto move_on_to = [&](const Vector<2>& corner) {
    Place other;
    other.corner = corner;
    move_to(place, other);
  };

  const bool is_clear = can_stay(Clearance::always);
  const bool is_half_clear = is_clear || (block.may_cover && can_stay(Clearance::if_possible));
  const double cost = cost_of(place.corner);
  if (is_clear && cost <= points(worth_moving)) {
    place.waited_s = 0.0;
  } else {
    std::optional<Vector<2>> best = find(Clearance::always);
    const bool is_better = best && (!is_clear || cost_of(*best) + points(worth_moving) < cost);
    if (!best && block.may_cover && !is_half_clear) best = find(Clearance::if_possible);
    if (is_half_clear) {
      if (!is_better) place.waited_s = 0.0;
      if (is_better && has_waited(place, moves_on_s)) move_on_to(*best);
    } else if (best && (place.is_taken || has_waited(place, comes_back_s))) {
      move_on_to(*best);
    } else {
      place.is_taken = false;
      place.strength = 0.0;
      if (!best) place.waited_s = 0.0;
    }
  }
  if (!place.is_taken) return std::nullopt;
  obstacles_.add(box_at(place.corner));
  return PlacedBlock{box_at(place.corner), place.strength};
}

Vector<2> StageLabels::extent_of(const std::vector<std::string>& lines, const TextStyle& style) const {
  Vector<2> extent(0.0, static_cast<double>(lines.size()) * style.height);
  for (const std::string& line : lines) extent.x = std::max(extent.x, measure_(line, style).x);
  return extent;
}

}  // namespace ghostforce
