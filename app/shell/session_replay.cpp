#include "app/shell/session_replay.h"

#include <memory>
#include <utility>

#include <fmt/format.h>

#include "app/files/scene_file.h"
#include "app/shell/action_text.h"
#include "app/state/lesson_file.h"
#include "app/state/permit.h"
#include "app/state/set_up.h"
#include "app/state/set_up_of.h"
#include "device/servo/servo_driver.h"

namespace ghostforce {
namespace {

using LeftOutInReplay =
    std::variant<Quit, ToggleFullScreen, ToggleAudience, SaveScene, SavePicture, SaveClip, SavePlots, CopyPicture,
                 CopyValues, CopySetUp, ShowLink, ShowControls, StartRecording, StopRecording>;
// After which a person read words on the screen, that Esc takes away before all else.
using LeavesWords = std::variant<SaveScene, SavePicture, SavePlots, CopyPicture, CopyValues, CopySetUp>;

}  // namespace

ApplicationOptions SessionReplay::options_for(const SessionStart& start, std::vector<InputEntry> inputs) {
  ApplicationOptions options;
  options.face = start.face;
  options.mode = start.mode;
  if (!start.lesson.empty()) options.lesson = std::make_shared<const Lesson>(load_lesson(start.lesson));
  options.language = start.language;
  if (find_input(inputs, start.input) != nullptr) options.input = start.input;
  options.inputs = std::move(inputs);
  options.input_options.virtual_falcon_clock = VirtualLink::Clock::stepped;
  options.make_servo_driver = [] { return std::make_unique<FrameServoDriver>(); };
  options.is_replay = true;
  return options;
}

Scene SessionReplay::scene_of(const SessionStart& start, const std::string& shown_path) {
  return read_scene(start.scene, shown_path + ", its scene");
}

SessionReplay::SessionReplay(Application& application, const RecordedSession& session)
    : application_(application), session_(session) {
  application_.start();
}

void SessionReplay::step() {
  application_.update(frame_s);
  while (next_ < session_.actions.size() && session_.actions[next_].time_s <= application_.clock_s()) {
    repeat(session_.actions[next_++].action);
  }
  if (!is_told_that_it_is_over_) {
    is_told_that_it_is_over_ = is_over();
    application_.show_replay_place({next_, session_.actions.size(), is_over()});
  }
  application_.draw();
}

bool SessionReplay::is_over() const {
  return next_ == session_.actions.size() && application_.clock_s() >= session_.end_s;
}

void SessionReplay::repeat(const Action& action) {
  const auto is_left_out = [&]<typename A>(const A& wanted) {
    if constexpr (std::is_same_v<A, ChooseInput>) return !application_.has_input(wanted.name);
    return is_one_of<A, LeftOutInReplay>;
  };
  const auto leaves_words = []<typename A>(const A&) { return is_one_of<A, LeavesWords>; };
  if (permit(application_.session(), action)) {
    ++counts_.refused;
  } else if (std::visit(is_left_out, action)) {
    ++counts_.left_out;
    if (std::visit(leaves_words, action)) application_.show_notice("A replay saves and copies nothing.", false);
    return;
  } else {
    ++counts_.done;
  }
  // What is refused may leave words on the screen too.
  application_.act_at_once(action);
}

std::string SessionReplay::result() const {
  const ShownMoment shown = application_.shown();
  const Session& session = application_.session();
  const auto& active = shown.snapshot.strategies[index_of(session.settings.active)];
  return fmt::format("t_s={} actions={} done={} refused={} left-out={} device_m={},{} force_N={},{} set-up={}\n",
                     application_.clock_s(), next_, counts_.done, counts_.refused, counts_.left_out, active.device.x,
                     active.device.y, active.force.x, active.force.y,
                     line_value(set_up_line(set_up_of(session, shown))));
}

}  // namespace ghostforce
