#include "app/stage/view_follower.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "app/state/lesson_guide.h"
#include "app/state/stage_view.h"
#include "app/state/target.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

// Whether the numbers, the small picture or what is round the scene lie over anything that must be seen.
bool is_covered(const StagePicture& picture, std::span<const StageStroke> strokes, double view_width) {
  const Camera& camera = picture.pane.camera;
  const double unit = camera.points_per_metre * view_width / stage_view_width;
  return std::ranges::any_of(strokes, [&](const StageStroke& stroke) {
    const double radius = stroke.radius * unit;
    const auto at = [&](const FitPoint& point) { return to_screen(camera, point.world) + point.offset * unit; };
    ScreenPiece piece{at(stroke.from), at(stroke.to), 0.0};
    const ScreenBox room = picture.scene.grown(-radius);
    if (!contains(room, piece.from) || !contains(room, piece.to)) return true;
    const auto lies_over = [&](const std::optional<ScreenBox>& box) {
      ScreenPiece below = piece;
      return box && clip(box->grown(radius), below);
    };
    return lies_over(picture.numbers) || lies_over(picture.inset);
  });
}

// A handle there is whole, and below nothing; or what reaches so far [points of the design].
bool is_in_sight(const StagePicture& picture, const Vector<2>& place, double reach = 16.0) {
  const double radius = reach * picture.unit;
  const Vector<2> handle = to_screen(picture.pane.camera, place);
  const auto lies_over = [&](const std::optional<ScreenBox>& box) {
    return box && contains(box->grown(radius), handle);
  };
  return contains(picture.scene.grown(-radius), handle) && !lies_over(picture.numbers) && !lies_over(picture.inset) &&
         !lies_over(picture.tools) && !lies_over(picture.motors);
}

Vector<2> active_handle(const Session& session, const StageFrame& frame) {
  return frame.shown.snapshot.strategies[index_of(session.settings.active)].device;
}

std::vector<StageStroke> strokes_of(const Session& session, const ShownMoment& shown) {
  const double reference_force = reference_force_of(session);
  if (shown.is_past) return stage_strokes(shown.settings, shown.snapshot.goal, reference_force);
  auto strokes = stage_strokes(settings_now(session), session.goal, reference_force);
  if (session.stage.guess) strokes.push_back(guess_stroke(*session.stage.guess));
  return strokes;
}

// What must be seen of a hand at a device: it, the handle, and the target if there is one.
std::vector<Vector<2>> measured_places(const Session& session, const StageFrame& frame) {
  const Snapshot& snapshot = frame.shown.snapshot;
  std::vector<Vector<2>> places{snapshot.strategies[index_of(*snapshot.measured)].device, snapshot.goal};
  if (const auto target = target_of(session, frame.loop.motors)) places.push_back(*target);
  return places;
}

SceneView fitting_view(const Session& session, const ViewFollower::Moment& moment) {
  const ShownMoment& shown = moment.frame.shown;
  if (shown.snapshot.measured && !shown.is_past) {
    return stage_view_of(session.settings, measured_places(session, moment.frame), reference_force_of(session));
  }
  if (shown.is_past) {
    return stage_view_of(shown.settings, std::array{shown.snapshot.goal}, reference_force_of(session));
  }
  if (moment.has_rest || session.stage.mode == StageMode::landscape) return stage_view_of(session);
  const std::array places{session.goal, active_handle(session, moment.frame)};
  return stage_view_of(session.settings, places, reference_force_of(session));
}

}  // namespace

// A handle that somebody moves away takes the view along. A hand and a new target do so unless a person has moved it.
void ViewFollower::follow_measured(Session& session, const Moment& moment) {
  const std::vector<Vector<2>> places = measured_places(session, moment.frame);
  const std::optional<Vector<2>> target = target_of(session, moment.frame.loop.motors);
  const bool is_new_target = std::exchange(target_, target) != target && target;
  const std::size_t must_be_seen = is_new_target ? places.size() : is_chosen_ ? 1 : 2;
  constexpr double hand_reach = 60.0;
  const auto is_seen = [&](const Vector<2>& place) {
    return &place == &places[1] ? is_in_sight(moment.picture, place, hand_reach) : is_in_sight(moment.picture, place);
  };
  if (std::ranges::all_of(std::span(places).first(must_be_seen), is_seen)) return;
  session.stage_shown = fitting_view(session, moment);
  is_chosen_ = false;
}

void ViewFollower::follow_subject(Session& session, const Moment& moment) {
  const ShownMoment& shown = moment.frame.shown;
  const Vector<2> room = moment.picture.scene.most;
  const Subject before = std::exchange(
      subject_, shown.is_past ? Subject{shown.settings, shown.snapshot.goal, std::nullopt, room, true}
                              : Subject{session.settings, session.goal, session.stage.guess, room, false});
  if (subject_ == before || !(session.pointer_moves_goal || subject_.is_past || before.is_past)) {
    const bool runs_away =
        !subject_.is_past && !moment.has_rest && !is_in_sight(moment.picture, active_handle(session, moment.frame));
    if (runs_away) session.stage_shown = fitting_view(session, moment);
    return;
  }
  const bool has_only_other_room = subject_.settings == before.settings && subject_.goal == before.goal &&
                                   subject_.guess == before.guess && subject_.is_past == before.is_past;
  if (is_chosen_ && has_only_other_room) return;
  is_chosen_ = false;
  const auto same = std::ranges::find(left_ | std::views::reverse, subject_, &Left::subject);
  if (same != left_.rend()) {
    session.stage_shown = same->view;
    left_.erase(std::prev(same.base()), left_.end());
    return;
  }
  const bool must_leave = is_covered(moment.picture, strokes_of(session, shown), session.stage_shown.width);
  // Whoever has looked back finds the present as it was.
  if (!before.is_past && (must_leave || subject_.is_past)) {
    constexpr std::size_t most_left = 64;
    if (left_.size() == most_left) left_.erase(left_.begin());
    left_.push_back({before, session.stage_shown});
  }
  if (must_leave) session.stage_shown = fitting_view(session, moment);
}

void ViewFollower::glide_to(const SceneView& wanted, double share) {
  view_.center = glm::mix(view_.center, wanted.center, share);
  view_.width = glm::mix(view_.width, wanted.width, share);
  const double apart = glm::distance(view_.center, wanted.center) + std::abs(view_.width - wanted.width);
  is_moving_ = apart > 2e-3 * view_.width;
  if (!is_moving_) view_ = wanted;
}

void ViewFollower::follow(Session& session, const Moment& moment, double interval_s) {
  constexpr double glides_s = 0.12;  // until two thirds of the way
  const StageFrame& frame = moment.frame;
  const bool is_other_scene = std::exchange(scene_, session.scene) != session.scene;
  const bool is_map = session.stage.mode == StageMode::landscape;
  const bool is_moved = session.stage_shown != wanted_;
  if (std::exchange(session.fits_view, false)) {
    session.stage_shown = fitting_view(session, moment);
    is_chosen_ = false;
    left_.clear();
  } else if (is_moved || is_other_scene || is_map) {
    // A workspace that a device was given by a drag is shown once that is over.
    const bool is_other_device = !moment.is_held && subject_.settings.general != session.settings.general;
    if (is_map && has_joints(session.settings) && is_other_device) {
      session.stage_shown = stage_view_of(session);
      subject_.settings = session.settings;
    }
    view_ = session.stage_shown;
    is_chosen_ = is_moved && !is_other_scene;
    if (is_moved || is_other_scene) {
      subject_.settings = session.settings;
      left_.clear();
    }
  } else if ((frame.shown.is_past || !moment.is_held) && !moment.is_busy && !is_moving_) {
    frame.shown.snapshot.measured ? follow_measured(session, moment) : follow_subject(session, moment);
  }
  wanted_ = session.stage_shown;
  glide_to(session.stage_shown, reduces_motion(session) ? 1.0 : 1.0 - std::exp(-interval_s / glides_s));
}

}  // namespace ghostforce
