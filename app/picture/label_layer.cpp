// Words and numbers beside the marks of the active strategy, and of what belongs to all.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/picture/glossary.h"
#include "app/picture/layers.h"
#include "app/picture/text.h"
#include "core/conventions.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

// In the order of their importance.
struct SceneLabel {
  enum Id : LabelId { ghost, force, drift, device, goal, target, proxy };
};

constexpr double air_round_lines = 2.0;  // [points]

class SceneWords {
 public:
  explicit SceneWords(const View& view) : view_(view), now_(view.snapshot.strategies[index_of(view.settings.active)]) {}

  void add_all() {
    const Vector<2> normal = to_screen_direction(wall_near(view_.settings, now_.contact).normal);
    add_force();
    if (const auto ruler = drift_ruler(view_)) {
      add({.id = SceneLabel::drift,
           .lines = {fmt::format("{}proxy drift {} mm", against_target(),
                                 decimal_text(glm::length(now_.proxy_drift) * mm_per_m, 1))},
           .style = {},
           .from = at(ruler->from),
           .to = at(ruler->to),
           .clearance = view_.points(3.0),
           .direction = normal},
          Role::proxy_drift, active());
    }
    add_point(SceneLabel::device, Role::device, "device", now_.device, 15.0, -normal, active());
    add_point(SceneLabel::goal, Role::goal, view_.snapshot.measured ? "goal, estimated" : "goal", view_.snapshot.goal,
              16.0, {1.0, 0.4}, view_.theme.text);
    if (view_.target) {
      add_point(SceneLabel::target, Role::target, "aim here", *view_.target, 14.0, normal, view_.theme.text);
    }
    if (now_.in_contact) add_point(SceneLabel::proxy, Role::proxy, "proxy", now_.proxy, 13.0, normal, active());
  }

  void place(LabelPlacer& labels, Marks& marks) const {
    const auto found = labels.place(requests_);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i] && found[i]->strength > 0.0) draw(*found[i], i, marks);
    }
  }

 private:
  Vector<2> at(const Vector<2>& world) const { return to_screen(view_.camera, world); }
  Colour active() const { return view_.theme.strategy_text[index_of(view_.settings.active)]; }

  void add(LabelRequest request, Role role, Colour colour) {
    request.style = view_.drawn(style_);
    requests_.push_back(std::move(request));
    roles_.push_back(role);
    colours_.push_back(colour);
  }
  void add_point(LabelId id, Role role, std::string words, const Vector<2>& place, double reach,
                 const Vector<2>& direction, Colour colour) {
    add({.id = id,
         .lines = {std::move(words)},
         .style = {},
         .from = at(place),
         .to = at(place),
         .clearance = view_.points(reach),
         .direction = direction},
        role, colour);
  }
  void add_force() {
    const auto force = drawn_force(view_);
    if (!force) return;
    const double half_width = 0.5 * view_.points(force_arrow_width);
    const auto add_part = [&](LabelId id, Role role, std::string words, const Vector<2>& from, const Vector<2>& to,
                              double best_share, double ambiguity_weight) {
      const Vector<2> across{-force->direction.y, force->direction.x};
      add({.id = id,
           .lines = {std::move(words)},
           .style = {},
           .from = from,
           .to = to,
           .clearance = 2.0 * half_width,
           .direction = across.y < 0.0 ? across : -across,
           .best_share = best_share,
           .ambiguity_weight = ambiguity_weight},
          role, active());
    };
    if (force->ghost != 0.0) {
      const double newton = glm::length(now_.ghost_force);
      add_part(SceneLabel::ghost, Role::ghost_force,
               fmt::format("{}ghost force {} N", against_target(), decimal_text(newton, 2)), force->share_end(),
               force->tip(), 0.5, 3.0);
    }
    // Beside what is not hatched, if possible.
    const double whole = force->share + force->ghost;
    const double best_share = force->ghost > 0.0 ? std::clamp(0.5 * force->share / whole, 0.0, 1.0) : 0.5;
    add_part(SceneLabel::force, Role::force, fmt::format("force {} N", decimal_text(glm::length(now_.force), 2)),
             force->start, force->tip(), best_share, 1.0);
  }

  void draw(const PlacedLabel& label, std::size_t i, Marks& marks) const {
    const StrategyId id = view_.settings.active;
    const bool is_of_all = roles_[i] == Role::goal || roles_[i] == Role::target;
    const std::optional<StrategyId> owner = is_of_all ? std::nullopt : std::optional(id);
    const Colour colour = faded(colours_[i], label.strength);
    const Colour halo = view_.theme.background.with_alpha(label.strength < 1.0 ? 0 : 255);
    if (label.leader) {
      marks.push_back({roles_[i], owner,
                       Line{to_world(view_.camera, label.leader->from), to_world(view_.camera, label.leader->to),
                            view_.points(1.2), faded(view_.theme.faint_text, label.strength)}});
    }
    Vector<2> corner = label.box.least;
    for (const std::string& words : label.lines) {
      const double width = view_.measure(words, view_.drawn(style_)).x;
      corner.x = label.box.least.x + label.aligned * (label.box.extent().x - width);
      marks.push_back(
          {roles_[i], owner, Label{to_world(view_.camera, corner), Vector<2>(0.0), words, style_, colour, halo}});
      corner.y += view_.drawn(style_).height;
    }
  }

  // Before numbers that are not against a given goal.
  std::string against_target() const {
    return view_.snapshot.has_target ? fmt::format("{} ", target_sign) : std::string();
  }

  const View& view_;
  const StrategySnapshot<2>& now_;
  TextStyle style_ = view_.is_pane ? small_text : normal_text;
  std::vector<LabelRequest> requests_;
  std::vector<Role> roles_;
  std::vector<Colour> colours_;
};

void keep_line_clear(const View& view, Role role, const Line& line, LabelPlacer& labels) {
  const bool is_thin = role == Role::wall || role == Role::hand_spring || role == Role::linkage;
  const bool matters = is_thin || role == Role::proxy_drift || role == Role::tracking_link || role == Role::contact ||
                       role == Role::target || role == Role::goal;
  if (!matters) return;
  labels.keep_clear(to_screen(view.camera, line.from), to_screen(view.camera, line.to),
                    0.5 * line.width + (is_thin ? 0.0 : view.points(air_round_lines)),
                    is_thin ? Clearance::if_possible : Clearance::always);
}

}  // namespace

void keep_marks_clear(const View& view, const Marks& marks, LabelPlacer& labels) {
  for (const Mark& mark : marks) {
    if (const auto* marker = std::get_if<Marker>(&mark.form)) {
      const Vector<2> middle = to_screen(view.camera, marker->center) + marker->offset;
      labels.keep_clear(middle, middle, reach_of(marker->shape) * marker->radius + 0.5 * marker->rim_width);
    } else if (const auto* arrow = std::get_if<Arrow>(&mark.form); arrow != nullptr && mark.role != Role::motor_axis) {
      const Vector<2> tail = to_screen(view.camera, arrow->tail);
      const Vector<2> tip = to_screen(view.camera, arrow->tip);
      labels.keep_clear(tail, tip, 0.5 * arrow->width + arrow->rim_width);
      const double length = glm::distance(tail, tip);
      if (!arrow->has_head || length == 0.0) continue;
      const Vector<2> neck = tip - (tip - tail) * std::min(1.0, 2.185 * arrow->width / length);
      labels.keep_clear(neck, tip, 1.15 * arrow->width + arrow->rim_width);
    } else if (const auto* line = std::get_if<Line>(&mark.form)) {
      keep_line_clear(view, mark.role, *line, labels);
    }
  }
}

void add_labels(const View& view, LabelPlacer& labels, Marks& marks) {
  SceneWords words(view);
  words.add_all();
  words.place(labels, marks);
}

}  // namespace ghostforce
