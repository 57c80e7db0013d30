// ViewFollower: the view of the stage follows what happens, so that what must be seen is in sight. It stands still while
// somebody holds something, and then glides, once, where something is covered. A view that somebody has moved stays until
// something else is moved. What undoes the reason gives the former view back: Undo, the end of the last minute. UI thread.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/stage/stage.h"
#include "app/state/session.h"

namespace ghostforce {

class ViewFollower {
 public:
  struct Moment {
    const StageFrame& frame;
    const StagePicture& picture;  // of the frame before
    bool is_held = false;         // somebody holds something
    bool is_busy = false;         // the picture moves by itself
    bool has_rest = true;         // else the handle runs away
  };
  // Once a frame; may change the session's view.
  void follow(Session& session, const Moment& moment, double interval_s);

  // On its way to the session's.
  const SceneView& view() const noexcept { return view_; }
  bool is_moving() const noexcept { return is_moving_; }

 private:
  // What a view is for.
  struct Subject {
    Settings settings{};
    Vector<2> goal{0.0};
    std::optional<Vector<2>> guess{};
    Vector<2> room{0.0};   // the scene ends there, at the right and above what is below it [points]
    bool is_past = false;  // somebody looks back at a moment

    friend bool operator==(const Subject&, const Subject&) = default;
  };
  struct Left {
    Subject subject;
    SceneView view;
  };
  void follow_measured(Session& session, const Moment& moment);
  void follow_subject(Session& session, const Moment& moment);
  void glide_to(const SceneView& wanted, double share);

  SceneView view_{};
  SceneView wanted_{};                    // of the frame before
  std::shared_ptr<const Scene> scene_{};  // of the frame before
  bool is_moving_ = false;
  bool is_chosen_ = false;             // a person has moved it, and nothing else since
  std::optional<Vector<2>> target_{};  // of a hand at a device, that has been looked for
  Subject subject_{};                  // of the view, or found in sight with it
  std::vector<Left> left_{};  // views that were left because something was covered or past, the last at the end
};

}  // namespace ghostforce
