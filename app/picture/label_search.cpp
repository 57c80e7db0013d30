#include "app/picture/label_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "app/picture/text.h"

namespace ghostforce {
namespace {

// In points of the design: from the rim of what is named to the words.
constexpr std::array reaches{6.0, 10.0, 15.0, 22.0, 30.0, 42.0, 58.0, 80.0, 110.0};
constexpr double far_reach = 36.0;  // words beyond need a line to what they name

// What else makes a place worse, in the same measure.
constexpr double turn_cost = 15.0;       // for a place at right angles to the wanted direction
constexpr double shift_cost = 24.0;      // for one at the end of a thing instead of at its middle, twice that
constexpr double break_cost = 14.0;      // for two lines,
constexpr double split_cost = 30.0;      // and of words that are short enough for one
constexpr double leader_cost = 45.0;     // for a line to what it names
constexpr double ambiguity_cost = 40.0;  // for one that is nearer to something else,
constexpr double cover_cost = 60.0;      // for one on a long thin thing
constexpr double full_ambiguity = 20.0;  // by so much

// A choice that is large enough; places that are nearly the same count once.
constexpr std::size_t most_options = 64;
constexpr double same_place = 7.0;

constexpr double long_thing = 80.0;
constexpr std::size_t short_words = 16;  // [letters]

// Of the box, going round it.
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

// So much does it cost to leave words out, and so much does a bad place of theirs count: the more, the more important
// they are.
double missing_cost(std::size_t less_important) {
  return 250.0 * std::pow(1.7, static_cast<double>(less_important));
}
double weight_of(std::size_t less_important) {
  return 1.0 + 0.15 * static_cast<double>(less_important);
}

}  // namespace

LabelSearch::LabelSearch(const LabelRequest& request, const LabelRoom& room) : request_(request), room_(room) {
  const double length = glm::length(request.direction);
  wanted_ = length > 0.0 ? request.direction / length : Vector<2>(0.0, -1.0);
  ScreenPiece seen{request.from, request.to, 0.0};
  is_seen_ = clip({Vector<2>(0.0), room.size}, seen);
  from_ = seen.from;
  to_ = seen.to;
}

std::optional<ScreenPiece> LabelSearch::thing() const {
  const bool has_none = request_.is_of_long_thing || request_.block || !is_seen_;
  return has_none ? std::nullopt : std::optional(ScreenPiece{from_, to_, 0.0});
}

const LabelSearch::Form& LabelSearch::form_of(bool is_broken) {
  const auto add = [&](std::vector<std::string> lines) {
    Vector<2> extent(0.0, static_cast<double>(lines.size()) * request_.style.height);
    for (const std::string& line : lines) extent.x = std::max(extent.x, room_.measure(line, request_.style).x);
    forms_.push_back({std::move(lines), extent});
  };
  if (forms_.empty()) add(request_.lines);
  if (is_broken && forms_.size() == 1) add(broken_in_two(request_.lines.front(), request_.style, room_.measure));
  return forms_[is_broken ? 1 : 0];
}

std::vector<double> LabelSearch::shares() const {
  std::vector<double> all{request_.best_share};
  if (glm::distance(from_, to_) < points(long_thing)) return all;
  for (const double share : {0.5, 0.25, 0.75, 0.05, 0.95}) {
    if (share != request_.best_share) all.push_back(share);
  }
  return all;
}

double LabelSearch::cost_of(const LabelPlace& place) const {
  double cost = place.reach + turn_cost * (1.0 - glm::dot(glm::normalize(place.side), wanted_)) +
                shift_cost * std::abs(place.share - request_.best_share);
  if (place.is_broken) cost += request_.lines.front().size() < short_words ? split_cost : break_cost;
  if (place.reach > far_reach) cost += leader_cost;
  return cost;
}

double LabelSearch::cost_of_doubt(const ScreenBox& box) const {
  const Vector<2> middle = 0.5 * (box.least + box.most);
  const double own = distance_to_line(middle, from_, to_);
  double least = own;
  for (const ScreenPiece& other : others_) least = std::min(least, distance_to_line(middle, other.from, other.to));
  return request_.ambiguity_weight * ambiguity_cost * std::min(1.0, (own - least) / points(full_ambiguity));
}

std::optional<LabelOption> LabelSearch::at(const LabelPlace& place, double air) {
  const Form& form = form_of(place.is_broken);
  const Vector<2> anchor = from_ + place.share * (to_ - from_);
  const Vector<2> middle =
      anchor + way_to(place.side) * (request_.clearance + points(place.reach)) + 0.5 * place.side * form.extent;
  const ScreenBox box{middle - 0.5 * form.extent, middle + 0.5 * form.extent};
  const Vector<2> edge(points(edge_of_labels));
  if (!lies_within({edge, room_.size - edge}, box)) return std::nullopt;
  const bool is_clear = room_.obstacles.is_free(box, points(air), Clearance::always);
  const bool may_stand = request_.may_cover && room_.obstacles.is_free(box, points(air), Clearance::if_possible);
  if (!is_clear && !may_stand) return std::nullopt;
  const double aligned = place.side.x < -0.5 ? 1.0 : place.side.x > 0.5 ? 0.0 : 0.5;
  LabelOption option{place, {form.lines, box, aligned}, cost_of(place) + cost_of_doubt(box)};
  if (!is_clear) option.cost += cover_cost;
  if (place.reach > far_reach) {
    const Vector<2> nearest = glm::clamp(anchor, box.least, box.most);
    const Vector<2> gap = nearest - anchor;
    const ScreenPiece leader{anchor + gap * (request_.clearance / glm::length(gap)), nearest, 0.0};
    if (!room_.obstacles.can_pass(leader.from, leader.to)) return std::nullopt;
    option.label.leader = leader;
  }
  return option;
}

std::vector<LabelSearch::Candidate> LabelSearch::candidates(const std::vector<double>& shares) const {
  const bool can_break = request_.lines.size() == 1 && request_.lines.front().find(' ') != std::string::npos;
  std::vector<Candidate> all;
  LabelPlace place;
  for (const bool is_broken : {false, true}) {
    if (is_broken && !can_break) break;
    place.is_broken = is_broken;
    for (std::size_t share = 0; share < shares.size(); ++share) {
      place.share = shares[share];
      for (std::size_t side = 0; side < sides.size(); ++side) {
        place.side = sides[side];
        for (std::size_t reach = 0; reach < reaches.size(); ++reach) {
          place.reach = reaches[reach];
          all.push_back({cost_of(place), static_cast<std::uint8_t>(share), static_cast<std::uint8_t>(side),
                         static_cast<std::uint8_t>(reach), is_broken});
        }
      }
    }
  }
  return all;
}

bool LabelSearch::is_like_another(const LabelOption& option) const {
  return std::ranges::any_of(*options_, [&](const LabelOption& other) {
    const Vector<2> apart = glm::abs(option.label.box.least - other.label.box.least);
    return option.place.is_broken == other.place.is_broken && std::max(apart.x, apart.y) < points(same_place);
  });
}

const std::vector<LabelOption>& LabelSearch::options() {
  if (options_) return *options_;
  options_.emplace();
  if (!is_seen_ || request_.block) return *options_;
  const std::vector<double> all_shares = shares();
  std::vector<Candidate> heap = candidates(all_shares);
  const auto dearer = [](const Candidate& a, const Candidate& b) { return a.cost > b.cost; };
  std::ranges::make_heap(heap, dearer);
  while (!heap.empty() && options_->size() < most_options) {
    std::ranges::pop_heap(heap, dearer);
    const Candidate& candidate = heap.back();
    const auto option =
        at({all_shares[candidate.share], sides[candidate.side], reaches[candidate.reach], candidate.is_broken},
           new_label_air);
    heap.pop_back();
    if (option && !is_like_another(*option)) options_->push_back(*option);
  }
  std::ranges::stable_sort(*options_, {}, &LabelOption::cost);
  return *options_;
}

bool can_stand_together(const PlacedLabel& a, const PlacedLabel& b, double air) noexcept {
  // Beside each other they would be read as one line.
  if (overlap(a.box.grown(Vector<2>(3.0 * air, air)), b.box) > 0.0) return false;
  const auto crosses = [air](const std::optional<ScreenPiece>& leader, const ScreenBox& box) {
    if (!leader) return false;
    ScreenPiece piece = *leader;
    return clip(box.grown(air), piece);
  };
  if (crosses(a.leader, b.box) || crosses(b.leader, a.box)) return false;
  return !a.leader || !b.leader || distance_between_lines(*a.leader, *b.leader) > air;
}

// ---- Several ----------------------------------------------------------------------------------------------------------

namespace {

// Each in turn is given the best that is left.
LabelPlan plan_in_order(std::vector<LabelSearch>& searches, const std::vector<std::size_t>& order, double air) {
  LabelPlan plan{std::vector<std::optional<LabelOption>>(searches.size()), 0.0};
  for (const std::size_t i : order) {
    for (const LabelOption& option : searches[i].options()) {
      const bool is_free = std::ranges::all_of(plan.options, [&](const std::optional<LabelOption>& other) {
        return !other || can_stand_together(option.label, other->label, air);
      });
      if (!is_free) continue;
      plan.options[i] = option;
      break;
    }
  }
  plan.cost = cost_of_plan(plan.options);
  return plan;
}

}  // namespace

double cost_of_plan(const std::vector<std::optional<LabelOption>>& options) noexcept {
  double cost = 0.0;
  for (std::size_t i = 0; i < options.size(); ++i) {
    const std::size_t less_important = options.size() - 1 - i;
    cost += options[i] ? weight_of(less_important) * options[i]->cost : missing_cost(less_important);
  }
  return cost;
}

LabelPlan best_label_plan(std::vector<LabelSearch>& searches, double unit) {
  const double air = new_label_air * unit;
  std::vector<std::size_t> order(searches.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  LabelPlan best = plan_in_order(searches, order, air);
  // Who is off badly is let choose earlier, as long as that helps.
  for (bool has_improved = true; has_improved;) {
    has_improved = false;
    for (std::size_t i = 0; i < searches.size(); ++i) {
      const std::vector<LabelOption>& options = searches[i].options();
      if (options.empty() || (best.options[i] && best.options[i]->cost <= options.front().cost)) continue;
      const auto at = std::ranges::find(order, i);
      for (auto to = order.begin(); to != at; ++to) {
        std::vector<std::size_t> other = order;
        const auto own = other.begin() + (at - order.begin());
        std::rotate(other.begin() + (to - order.begin()), own, own + 1);
        LabelPlan plan = plan_in_order(searches, other, air);
        if (plan.cost >= best.cost - 0.5) continue;
        best = std::move(plan);
        order = std::move(other);
        has_improved = true;
        break;
      }
    }
  }
  return best;
}

}  // namespace ghostforce
