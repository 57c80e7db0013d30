// Words and numbers beside the marks. Each label tries a few places round its anchor and takes the first that is free,
// so that labels neither cover each other nor the markers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "app/view/layers.h"
#include "app/view/screen_box.h"
#include "core/units.h"

namespace ghostforce {
namespace {

class WordPlacer {
 public:
  WordPlacer(const View& view, Marks& marks) : view_(view), marks_(marks) {}

  void keep_clear(const Vector<2>& screen, double radius) {
    taken_.push_back({{screen - Vector<2>(radius), screen + Vector<2>(radius)}, mark_weight});
  }
  void keep_clear_of_text(const Vector<2>& upper_left, const Vector<2>& extent) {
    taken_.push_back({{upper_left, upper_left + extent}, text_weight});
  }
  // A thin box per piece: a slanted line's bounding box would keep half the picture clear.
  void keep_clear(const Vector<2>& from, const Vector<2>& to, double radius) {
    const int pieces = static_cast<int>(std::clamp(glm::distance(from, to) / (2.0 * radius), 1.0, 256.0));
    for (int i = 0; i <= pieces; ++i) keep_clear(from + (to - from) * (static_cast<double>(i) / pieces), radius);
  }

  // `gap` is the distance between anchor and text [points].
  void place(Role role, std::optional<StrategyId> id, const Vector<2>& anchor, double gap, std::string text,
             const TextStyle& style, Colour colour) {
    const Vector<2> extent = view_.measure(text, view_.drawn(style));
    const Vector<2> at = to_screen(view_.camera, anchor);
    // What is far outside the picture is not there to be named.
    const Vector<2> nearest = glm::clamp(at, Vector<2>(0.0), view_.camera.size);
    if (glm::distance(at, nearest) > view_.points(farthest_outside)) return;
    // Most of what is taken lies farther away than any place that is tried.
    const Vector<2> farthest = Vector<2>(gap * reaches.back()) + 0.5 * extent;
    const ScreenBox tried{inside(at - farthest - 0.5 * extent, extent) - breath,
                          inside(at + farthest - 0.5 * extent, extent) + extent + breath};
    near_.clear();
    std::ranges::copy_if(taken_, std::back_inserter(near_),
                         [&](const Obstacle& other) { return overlap(tried, other.box) > 0.0; });
    Vector<2> best = at;
    double least = -1.0;
    for (const double reach : reaches) {
      for (const Vector<2>& side : sides) {
        const Vector<2> corner = inside(at + side * (Vector<2>(gap * reach) + 0.5 * extent) - 0.5 * extent, extent);
        const double cost = crowding({corner - breath, corner + extent + breath}, least);
        if (least < 0.0 || cost < least) {
          least = cost;
          best = corner;
        }
      }
      if (least == 0.0) break;
    }
    keep_clear_of_text(best, extent);
    marks_.push_back({role, id, Label{anchor, best - at, std::move(text), style, colour, view_.theme.background}});
  }

 private:
  // Words over a line can still be read, words over words cannot.
  static constexpr double farthest_outside = 60.0;  // [points]
  static constexpr double mark_weight = 1.0;
  static constexpr double text_weight = 100.0;
  struct Obstacle {
    ScreenBox box;
    double weight;
  };

  static constexpr std::array reaches{1.0, 1.8, 3.0, 5.0, 8.0};  // distances that are tried, in those asked for
  static constexpr Vector<2> margin{4.0, 4.0};                   // to the picture's edge [points]
  // Between two labels, or a word ends where the next begins [points].
  static constexpr Vector<2> breath{3.0, 1.0};
  // Right first, as one reads; then above and below, then left.
  static constexpr std::array<Vector<2>, 8> sides{
      {{1.0, 0.0}, {0.7, -0.9}, {0.7, 0.9}, {0.0, -1.0}, {0.0, 1.0}, {-1.0, 0.0}, {-0.7, -0.9}, {-0.7, 0.9}}};

  // The corner of a text that would leave the picture, moved so that it stays.
  Vector<2> inside(const Vector<2>& corner, const Vector<2>& extent) const {
    return glm::max(glm::min(corner, view_.camera.size - extent - margin), margin);
  }

  // Counts no further than `enough`, where that is not negative: a place as crowded as that is not taken anyway.
  double crowding(const ScreenBox& box, double enough) const {
    double cost = 0.0;
    for (const Obstacle& other : near_) {
      cost += other.weight * overlap(box, other.box);
      if (enough >= 0.0 && cost >= enough) break;
    }
    return cost;
  }

  const View& view_;
  Marks& marks_;
  std::vector<Obstacle> taken_;
  std::vector<Obstacle> near_;  // of these, what the label that is being placed may meet
};

// Marks at the edge and on the scene that no label may cover.
void keep_marks_clear(const View& view, const Marks& marks, WordPlacer& placer) {
  for (const Mark& mark : marks) {
    if (mark.role == Role::prediction) continue;  // thin, and round a marker that is kept clear
    if (const auto* marker = std::get_if<Marker>(&mark.form)) {
      placer.keep_clear(to_screen(view.camera, marker->center) + marker->offset, marker->radius + 2.0);
    } else if (const auto* arrow = std::get_if<Arrow>(&mark.form)) {
      placer.keep_clear(to_screen(view.camera, arrow->tail) + arrow->offset,
                        to_screen(view.camera, arrow->tip) + arrow->offset, arrow->width + 2.0);
    } else if (const auto* label = std::get_if<Label>(&mark.form)) {
      const Vector<2> at = to_screen(view.camera, label->anchor) + label->offset;
      const Vector<2> extent = view.measure(label->text, view.drawn(label->style));
      placer.keep_clear_of_text(at, extent);
    } else if (const auto* line = std::get_if<Line>(&mark.form);
               line != nullptr &&
               (mark.role == Role::proxy_drift || mark.role == Role::scale || mark.role == Role::wall)) {
      placer.keep_clear(to_screen(view.camera, line->from), to_screen(view.camera, line->to), 4.0);
    }
  }
}

// One letter per device; devices in the same place share a label ("F N A" in free space).
void add_letters(const View& view, WordPlacer& placer) {
  std::vector<StrategyId> open;
  for_each_shown(view, [&](StrategyId id) { open.push_back(id); });
  std::reverse(open.begin(), open.end());  // the active one leads its group
  while (!open.empty()) {
    const StrategyId first = open.front();
    const Vector<2> at = view.snapshot.strategies[index_of(first)].device;
    std::string letters;
    std::erase_if(open, [&](StrategyId id) {
      const double apart = glm::distance(at, view.snapshot.strategies[index_of(id)].device);
      if (id != first && apart > view.metres(12.0)) return false;
      letters += letters.empty() ? "" : " ";
      letters += strategy(id).letter;
      return true;
    });
    placer.place(Role::device, first, at, view.points(11.0), letters, view.in_front(first) ? large_text : normal_text,
                 view.theme.strategy_text[index_of(first)]);
  }
}

// Whether a device stands where the active one does: its numbers would be said twice.
bool is_behind_active(const View& view, StrategyId id) {
  const auto device = [&](StrategyId which) { return view.snapshot.strategies[index_of(which)].device; };
  return !view.in_front(id) && glm::distance(device(id), device(view.settings.active)) < view.metres(4.0);
}

void add_measures(const View& view, StrategyId id, WordPlacer& placer) {
  if (is_behind_active(view, id)) return;
  const std::size_t i = index_of(id);
  // Where there are several, each says whose it is.
  const std::string whose =
      view.options.compare == Compare::overlay ? fmt::format("{}: ", strategy(id).letter) : std::string();
  const StrategySnapshot<2>& now = view.snapshot.strategies[i];
  const Colour colour = view.theme.strategy_text[i];
  if (has_ghost_arrow(view, id)) {
    const Vector<2> offset = ghost_arrow_offset(view);
    const Vector<2> tip =
        arrow_tip(view, now.device, now.ghost_force) + to_screen_direction(offset) / view.camera.points_per_metre;
    placer.place(Role::ghost_force, id, tip, view.points(9.0),
                 fmt::format("{}ghost force {:.2f} N", whose, glm::length(now.ghost_force)), normal_text, colour);
  }
  if (view.in_front(id) && is_drawn(view, now.force)) {
    placer.place(Role::force, id, arrow_tip(view, now.device, now.force), view.points(9.0),
                 fmt::format("{}force {:.2f} N", whose, glm::length(now.force)), normal_text, colour);
  }
  if (has_drift_ruler(view, id)) {
    const DriftRuler ruler = drift_ruler(view, id);
    placer.place(Role::proxy_drift, id, 0.5 * (ruler.from + ruler.to), view.points(8.0),
                 fmt::format("{}drift {:.1f} mm", whose, glm::length(now.proxy_drift) * mm_per_m), normal_text, colour);
  }
}

}  // namespace

void add_labels(const View& view, Marks& marks) {
  WordPlacer placer(view, marks);
  keep_marks_clear(view, marks, placer);
  add_letters(view, placer);
  placer.place(Role::goal, std::nullopt, view.snapshot.goal, view.points(15.0),
               view.snapshot.measured ? "goal, estimated" : "goal", normal_text, view.theme.text);
  if (view.target) {
    placer.place(Role::target, std::nullopt, *view.target, view.points(15.0), "aim here", normal_text, view.theme.text);
  }
  for_each_shown(view, [&](StrategyId id) { add_measures(view, id, placer); });
}

}  // namespace ghostforce
