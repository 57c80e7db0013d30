#include "app/picture/label_placer.h"

#include <algorithm>
#include <utility>

namespace ghostforce {
namespace {

constexpr double fade_s = 0.25;
// So long do words wait that had no place, those that could have a better one, and all until they are arranged anew.
constexpr double comes_back_s = 0.3;
constexpr double moves_on_s = 0.7;
constexpr double moves_on_in_motion_s = 2.0;
constexpr double rests_s = 0.5;

// In points of the design.
constexpr double worth_moving = 30.0;     // a new place must be better by this,
constexpr double worth_arranging = 60.0;  // and a new arrangement of all labels by this
constexpr double overlap_cost = 25.0;     // of the place where less important words stand
constexpr double narrow_cost = 20.0;      // of one that what moves may soon take away,
constexpr double roomy_air = 30.0;        // with less air than this
constexpr double very_roomy_air = 80.0;   // for what is large, and pushed away slowly
constexpr double most_in_motion = 70.0;   // what is dearer, such as a line to far words, waits until nothing moves
constexpr double far_block = 36.0;        // words farther from what they name need a line to it,
constexpr double beside_named = 17.0;     // which begins at this distance from it
constexpr double row_height = 8.0;        // from one try to place a block to the next

bool is_within(const ScreenBox& region, const ScreenBox& box) {
  return contains(region, box.least) && contains(region, box.most);
}

}  // namespace

bool LabelMemory::is_moving() const noexcept {
  return rested_s > 0.0 || std::ranges::any_of(places, [](const Place& place) {
           return place.waited_s > 0.0 || (place.is_taken && place.strength < 1.0);
         });
}

LabelPlacer::LabelPlacer(const Vector<2>& size, double unit, const MeasureText& measure, LabelMemory& memory,
                         double interval_s)
    : size_(size), unit_(unit), measure_(measure), memory_(memory), interval_s_(interval_s) {
  // Another window: all is somewhere else anyway.
  if (memory.size != size || memory.unit != unit) {
    memory = {};
    memory.size = size;
    memory.unit = unit;
  }
}

LabelPlacer::~LabelPlacer() {
  for (std::size_t i = 0; i < most_labels; ++i) {
    if (!is_asked_for_[i]) memory_.places[i] = {};
  }
  memory_.has_begun = true;
  memory_.picture = picture_;
}

LabelPlacer::Place& LabelPlacer::remembered(LabelId id) {
  Place& place = memory_.places[id];
  is_asked_for_[id] = true;
  return place;
}

void LabelPlacer::move_to(Place& place, const LabelPlace& beside, const Vector<2>& corner) {
  place = {.is_taken = true,
           .beside = beside,
           .corner = corner,
           .strength = memory_.has_begun ? 0.0 : 1.0,
           .settled = place.settled};
}

bool LabelPlacer::has_waited(Place& place, double at_least_s) const {
  // So that something is on its way, however short the first interval is.
  place.waited_s += std::max(interval_s_, 1e-6);
  return place.waited_s >= at_least_s;
}

std::vector<std::optional<PlacedLabel>> LabelPlacer::place(const std::vector<LabelRequest>& requests) {
  const LabelRoom room{size_, unit_, measure_, obstacles_};
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (!requests[i].block) order.push_back(i);
  }
  std::ranges::sort(order, {}, [&](std::size_t i) { return requests[i].id; });
  std::vector<LabelSearch> searches;
  for (const std::size_t i : order) searches.emplace_back(requests[i], room);
  for (std::size_t i = 0; i < searches.size(); ++i) {
    std::vector<ScreenPiece> others;
    for (std::size_t j = 0; j < searches.size(); ++j) {
      const auto thing = i == j ? std::nullopt : searches[j].thing();
      if (thing) others.push_back(*thing);
    }
    searches[i].keep_apart_from(std::move(others));
  }

  picture_ = obstacles_.signature();
  Options options(searches.size());
  if (!memory_.has_begun) {
    arrange_anew(searches, options);
  } else {
    keep_or_find(searches, options);
    arrange_at_rest(searches, options);
  }

  std::vector<std::optional<PlacedLabel>> found(requests.size());
  for (std::size_t i = 0; i < searches.size(); ++i) {
    if (!options[i]) continue;
    PlacedLabel& label = options[i]->label;
    label.strength = remembered(searches[i].request().id).strength;
    obstacles_.add(label.box);
    if (label.leader) obstacles_.add(label.leader->from, label.leader->to, points(1.0), Clearance::always);
    found[order[i]] = std::move(label);
  }
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (!requests[i].block) continue;
    const auto placed = place_block(*requests[i].block);
    if (!placed) continue;
    found[i] = {.lines = requests[i].lines, .box = placed->box, .strength = placed->strength};
    if (const auto& named = requests[i].block->named) found[i]->leader = leader_to(*named, placed->box);
    if (const auto& leader = found[i]->leader) obstacles_.add(leader->from, leader->to, points(1.0), Clearance::always);
  }
  return found;
}

std::optional<ScreenPiece> LabelPlacer::leader_to(const Vector<2>& named, const ScreenBox& box) const {
  const Vector<2> nearest = glm::clamp(named, box.least, box.most);
  const double gap = glm::distance(named, nearest);
  if (gap < points(far_block)) return std::nullopt;
  const Vector<2> from = named + (nearest - named) * (points(beside_named) / gap);
  const Vector<2> to =
      nearest - (nearest - named) * (points(least_label_air) / gap);  // the words' own box is an obstacle
  return obstacles_.can_pass(from, to) ? std::optional(ScreenPiece{from, to, 0.0}) : std::nullopt;
}

void LabelPlacer::arrange_anew(std::vector<LabelSearch>& searches, Options& options) {
  options = best_label_plan(searches, unit_).options;
  for (std::size_t i = 0; i < searches.size(); ++i) {
    Place& place = remembered(searches[i].request().id);
    if (options[i]) move_to(place, options[i]->place, Vector<2>(0.0));
  }
  memory_.arranged = picture_;
}

void LabelPlacer::keep_or_find(std::vector<LabelSearch>& searches, Options& options) {
  // Where all stand, if marks let them.
  Options held(searches.size());
  for (std::size_t i = 0; i < searches.size(); ++i) {
    Place& place = remembered(searches[i].request().id);
    place.strength = std::min(1.0, place.strength + interval_s_ / fade_s);
    if (!searches[i].is_seen()) place = {};
    if (place.is_taken) held[i] = searches[i].at(place.beside, least_label_air);
  }
  for (std::size_t i = 0; i < searches.size(); ++i) {
    if (!searches[i].is_seen()) continue;
    std::vector<ScreenBox> less_important;
    for (std::size_t j = i + 1; j < searches.size(); ++j) {
      if (held[j]) less_important.push_back(held[j]->label.box);
    }
    take_or_wait(searches[i], remembered(searches[i].request().id), options, less_important, held[i]);
    options[i] = held[i];
  }
}

// `option`: where it stands, then where it is to stand. `options`: of the more important ones.
void LabelPlacer::take_or_wait(LabelSearch& search, Place& place, const Options& options,
                               const std::vector<ScreenBox>& others, std::optional<LabelOption>& option) {
  const auto is_free = [&](const PlacedLabel& label, double air) {
    return std::ranges::all_of(options, [&](const std::optional<LabelOption>& other) {
      return !other || can_stand_together(label, other->label, points(air));
    });
  };
  const auto best_below = [&](double limit) {
    const LabelOption* best = nullptr;
    double least = limit;
    for (const LabelOption& candidate : search.options()) {
      if (candidate.cost >= least) break;
      if (!is_free(candidate.label, new_label_air)) continue;
      double cost = candidate.cost;
      for (const ScreenBox& other : others) {
        if (overlap(candidate.label.box.grown(points(new_label_air)), other) > 0.0) cost += overlap_cost;
      }
      if (!obstacles_.is_free(candidate.label.box, points(roomy_air), Clearance::always)) cost += narrow_cost;
      if (cost >= least) continue;
      least = cost;
      best = &candidate;
    }
    return best;
  };
  const auto move_there = [&](const LabelOption* best) {
    if (best != nullptr) {
      move_to(place, best->place, Vector<2>(0.0));
      option = *best;
    } else {
      place.waited_s = 0.0;
      place.settled = picture_;
    }
  };

  const bool is_still = memory_.picture == picture_;
  const double most = is_still ? 1e9 : most_in_motion;
  if (option && !is_free(option->label, least_label_air)) option.reset();
  if (option) {
    if (option->cost <= worth_moving || place.settled == picture_) {
      place.waited_s = 0.0;
    } else if (has_waited(place, is_still ? moves_on_s : moves_on_in_motion_s)) {
      move_there(best_below(option->cost - worth_moving));
    }
  } else {
    if (place.is_taken) place = {};
    if (place.settled != picture_ && has_waited(place, comes_back_s)) move_there(best_below(most));
  }
}

// Better places for all together, where some stand badly or not at all, once nothing moves any more.
void LabelPlacer::arrange_at_rest(std::vector<LabelSearch>& searches, Options& options) {
  const bool could_be_better = std::ranges::any_of(searches, [&](const LabelSearch& search) {
    const std::optional<LabelOption>& option = options[static_cast<std::size_t>(&search - searches.data())];
    return search.is_seen() && (!option || option->cost > worth_arranging);
  });
  if (!could_be_better || memory_.arranged == picture_) {
    memory_.rested_s = 0.0;
    return;
  }
  const bool is_still = memory_.picture == picture_;
  memory_.rested_s = std::max(is_still ? memory_.rested_s + interval_s_ : 0.0, 1e-6);
  if (memory_.rested_s < rests_s) return;
  memory_.rested_s = 0.0;
  memory_.arranged = picture_;
  const LabelPlan plan = best_label_plan(searches, unit_);
  if (plan.cost + worth_arranging > cost_of_plan(options)) return;
  for (std::size_t i = 0; i < searches.size(); ++i) {
    Place& place = remembered(searches[i].request().id);
    const bool stays = options[i] && plan.options[i] && options[i]->place == plan.options[i]->place;
    if (stays) continue;
    options[i] = plan.options[i];
    place = {};
    if (options[i]) move_to(place, options[i]->place, Vector<2>(0.0));
  }
}

std::optional<LabelPlacer::PlacedBlock> LabelPlacer::place_block(const LabelBlock& block) {
  Place& place = remembered(block.id);
  place.strength = std::min(1.0, place.strength + interval_s_ / fade_s);
  const auto box_at = [&](const Vector<2>& corner) { return ScreenBox{corner, corner + block.extent}; };
  const auto cost_of = [&](const Vector<2>& corner) {
    const Vector<2> apart = glm::abs(corner - block.wanted);
    return apart.x + apart.y;
  };
  const auto can_stay = [&](Clearance clearance) {
    const ScreenBox box = box_at(place.corner);
    return place.is_taken && is_within(block.region, box) &&
           (!block.edge || lies_right_of(*block.edge, box, points(least_label_air))) &&
           obstacles_.is_free(box, points(least_label_air), clearance);
  };
  const auto find = [&](Clearance clearance) {
    const auto with_air = [&](double air) {
      return obstacles_.find_block({.extent = block.extent,
                                    .region = block.region,
                                    .wanted = block.wanted,
                                    .edge = block.edge,
                                    .air = points(air),
                                    .air_to_boxes = points(new_label_air),
                                    .clearance = clearance},
                                   points(row_height));
    };
    // What moves shall not soon take it away again.
    if (memory_.has_begun) {
      for (const double air : {very_roomy_air, roomy_air}) {
        if (const auto found = with_air(air)) return found;
      }
    }
    return with_air(new_label_air);
  };

  const std::uint64_t now = obstacles_.signature();
  const bool is_still = std::exchange(place.settled, now) == now;
  const bool is_clear = can_stay(Clearance::always);
  const bool can_be_kept = is_clear || (block.may_cover && can_stay(Clearance::if_possible));
  const double cost = cost_of(place.corner);
  if (is_clear && cost <= points(worth_moving)) {
    place.waited_s = 0.0;
  } else {
    std::optional<Vector<2>> best = find(Clearance::always);
    if (can_be_kept) {
      const bool is_better = best && (!is_clear || cost_of(*best) + points(worth_moving) < cost);
      if (!is_better) place.waited_s = 0.0;
      if (is_better && has_waited(place, is_still ? moves_on_s : moves_on_in_motion_s)) move_to(place, {}, *best);
    } else {
      if (!best && block.may_cover) best = find(Clearance::if_possible);
      place.is_taken = false;
      if (!best) place.waited_s = 0.0;
      if (best && (!memory_.has_begun || has_waited(place, comes_back_s))) move_to(place, {}, *best);
    }
  }
  if (!place.is_taken) return std::nullopt;
  obstacles_.add(box_at(place.corner));
  return PlacedBlock{box_at(place.corner), place.strength};
}

Vector<2> LabelPlacer::extent_of(const std::vector<std::string>& lines, const TextStyle& style) const {
  Vector<2> extent(0.0, static_cast<double>(lines.size()) * style.height);
  for (const std::string& line : lines) extent.x = std::max(extent.x, measure_(line, style).x);
  return extent;
}

namespace {

constexpr double corner_fade_s = 0.25;
// How long what stands in a corner waits until it comes back, and at rest until it goes to a better place.
constexpr double corner_comes_back_s = 0.3;
constexpr double corner_moves_on_s = 0.7;

// In points of the design.
constexpr double corner_roomy_air = 30.0;  // words beside marks have room, too
constexpr double corner_air = 6.0;
constexpr double corner_least_air = 3.0;  // as long as it stands there

}  // namespace

std::optional<CornerPlace> place_in_corner(const std::vector<ScreenBox>& places, std::size_t places_of_form,
                                           LabelPlacer& labels, CornerMemory& memory) {
  const LabelObstacles& obstacles = labels.obstacles();
  const auto points = [&](double of_design) { return of_design * labels.unit(); };
  const auto fits = [&](const ScreenBox& box) {
    return box.least.x >= 0.0 && box.least.y >= 0.0 && box.most.x <= labels.size().x && box.most.y <= labels.size().y;
  };
  const auto first_of = [&](std::size_t form, double air, Clearance clearance) -> std::optional<std::size_t> {
    for (std::size_t i = form; i < form + places_of_form; ++i) {
      if (fits(places[i]) && obstacles.is_free(places[i], points(air), clearance)) return i;
    }
    return std::nullopt;
  };
  const auto best = [&]() -> std::optional<std::size_t> {
    for (const Clearance clearance : {Clearance::always, Clearance::if_possible}) {
      for (std::size_t form = 0; form < places.size(); form += places_of_form) {
        for (const double air : {corner_roomy_air, corner_air}) {
          if (const auto found = first_of(form, air, clearance)) return found;
        }
      }
    }
    return std::nullopt;
  };
  const auto move_to = [&](std::size_t place) {
    memory = {.place = place, .strength = labels.is_first() ? 1.0 : 0.0, .picture = memory.picture};
  };

  if (labels.is_first()) memory = {};
  const std::uint64_t now = obstacles.signature();
  const bool is_still = std::exchange(memory.picture, now) == now;
  memory.strength = std::min(1.0, memory.strength + labels.interval_s() / corner_fade_s);
  const bool can_stay = memory.place && *memory.place < places.size() && fits(places[*memory.place]) &&
                        obstacles.is_free(places[*memory.place], points(corner_least_air), Clearance::if_possible);
  const bool may_move = labels.is_first() || !can_stay || is_still;
  const std::optional<std::size_t> found = may_move ? best() : std::nullopt;
  memory.is_best = may_move;
  if (!can_stay) memory.place.reset();
  if (!found || found == memory.place) {
    memory.waited_s = 0.0;
  } else {
    // So that something is on its way, however short the first interval is.
    memory.waited_s += std::max(labels.interval_s(), 1e-6);
    const double wait_s = labels.is_first() ? 0.0 : can_stay ? corner_moves_on_s : corner_comes_back_s;
    if (memory.waited_s >= wait_s) move_to(*found);
  }
  if (!memory.place) return std::nullopt;
  labels.keep_clear(places[*memory.place]);
  return CornerPlace{*memory.place, memory.strength};
}

ScreenBox box_in_corner(Corner corner, const Vector<2>& extent, const Vector<2>& size, double margin) {
  const bool is_right = corner == Corner::upper_right || corner == Corner::lower_right;
  const bool is_low = corner == Corner::lower_left || corner == Corner::lower_right;
  const Vector<2> least{is_right ? size.x - margin - extent.x : margin, is_low ? size.y - margin - extent.y : margin};
  return {least, least + extent};
}

}  // namespace ghostforce
