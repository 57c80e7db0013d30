#include "app/shell/web/page.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/failure.h"
#include "app/base/language.h"
#include "app/base/quoted.h"
#include "app/files/read_error.h"
#include "app/files/scene_file.h"
#include "app/picture/camera.h"
#include "app/picture/screen_box.h"
#include "app/shell/action_text.h"
#include "app/shell/page_address.h"
#include "app/shell/preferences.h"
#include "app/shell/web/browser.h"
#include "app/shell/web/page_inputs.h"
#include "app/shell/web/page_lesson.h"
#include "app/state/apply.h"
#include "app/state/lesson_file.h"
#include "app/state/set_up.h"
#include "app/state/set_up_of.h"
#include "app/state/stage_language.h"
#include "device/servo/servo_driver.h"
#include "device/virtual_falcon/virtual_link.h"

namespace ghostforce {
namespace {

constexpr const char* first_scene = "wall45";
// For what the page tells beside the picture.
constexpr double look_every_s = 0.5;
// In less room its panels leave nothing of the scene, and their words do not fit [CSS pixels].
constexpr int least_workbench_width = 640;
constexpr int least_workbench_height = 432;

// The servo's ticks of a frame, and how long they took.
class MeasuredServoDriver final : public ServoDriver {
 public:
  explicit MeasuredServoDriver(FrameTimes& times) : times_(times) {}

  void start(Servo& servo) override { driver_.start(servo); }
  void stop() noexcept override { driver_.stop(); }
  void step(std::int64_t now_ns) noexcept override {
    const double began_s = browser::clock_s();
    driver_.step(now_ns);
    times_.add(browser::clock_s() - began_s);
  }

 private:
  FrameServoDriver driver_;
  FrameTimes& times_;
};

// To the page around this one. What is on the clipboard, and how files are called, is the person's business alone.
void tell_action(Action action) {
  std::visit(
      [](auto& one) {
        if constexpr (requires { one.line.clear(); }) one.line.clear();
        if constexpr (requires { one.path.clear(); }) one.path.clear();
        if constexpr (requires { one.paths.clear(); }) one.paths.clear();
        if constexpr (requires { one.name_or_path.clear(); }) one.name_or_path.clear();
      },
      action);
  browser::tell_action(action_text(action));
}

}  // namespace

struct Page::Start {
  PageAddress address = read_page_address(browser::query(), browser::is_origin);
  bool is_kiosk = address.is_kiosk;
  bool keeps = !is_kiosk && !address.is_for_new_person;
  StoredPreferences stored = preferences_for(address);
  LessonProgress progress = keeps ? load_lesson_progress(stored.remarks) : LessonProgress{};
  std::shared_ptr<const Lesson> lesson;
  std::optional<SetUp> set_up;
  Scene scene = load_scene(first_scene);

  // A mistake in the address is told, and the page opens without it.
  Start() {
    std::ranges::copy(address.problems, std::back_inserter(stored.remarks));
    const auto attempt = [this](const char* what, const auto& act) {
      try {
        act();
      } catch (const std::exception& error) {
        stored.remarks.push_back(fmt::format("{} in the address of this page cannot be used: {}", what, error.what()));
      }
    };
    if (!address.lesson.empty()) {
      attempt("The lesson", [&] { lesson = std::make_shared<const Lesson>(load_lesson(address.lesson)); });
    }
    if (lesson && address.lesson_step > lesson->steps.size()) {
      stored.remarks.push_back(
          fmt::format("Step {} in the address of this page cannot be used: the lesson has {} steps.",
                      *address.lesson_step, lesson->steps.size()));
      address.lesson_step.reset();
    }
    const std::string fragment = browser::fragment();
    if (!fragment.empty() && (lesson || is_kiosk)) {
      stored.remarks.push_back(fmt::format("The set-up in the address of this page is not used: {}",
                                           is_kiosk ? "a kiosk takes none." : "the lesson comes before it."));
    } else if (!fragment.empty()) {
      attempt("The set-up", [&] { set_up = read_set_up_line(without_percent_signs(fragment)); });
    }
    if (set_up) {
      scene = set_up->scene;
      stored.preferences.face = set_up->face;
    }
    Preferences& preferences = stored.preferences;
    preferences.language =
        wanted_language(address.language.empty() ? preferences.language : address.language, locale_variables());
  }

  static StoredPreferences preferences_for(const PageAddress& address) {
    if (address.is_for_new_person) return {};
    return address.is_kiosk ? for_visitors(load_preferences()) : load_preferences();
  }
};

ApplicationOptions Page::options_for(const Start& start, Times& times) {
  const Preferences& preferences = start.stored.preferences;
  ApplicationOptions options{
      .appearance = preferences.appearance,
      .face = preferences.face,
      .mode = start.set_up ? start.set_up->mode : StageMode::none,
      .lesson = start.lesson,
      .lesson_step = start.address.lesson_step.value_or(1) - 1,
      .language = preferences.language,
      .lesson_progress = start.progress,
      .inputs = page_inputs(),
      .why_no_falcon = why_no_falcon_in_page,
      .make_servo_driver = [&times] { return std::make_unique<MeasuredServoDriver>(times.servo); },
      .show_controls = browser::enter_controls,
      .show_link = browser::show_link,
      .offers_hints = preferences.offers_hints};
  if (!start.address.embedder.empty()) {
    options.watch_actions = [](double, const Action& action) { tell_action(action); };
  }
  if (start.is_kiosk) options.kiosk_visit = start.lesson ? std::vector{start.lesson} : shipped_lessons();
  options.input_options.virtual_falcon_clock = VirtualLink::Clock::stepped;  // ticks come in bursts
  options.folded_panels = panels_folded_at_first(WindowLayout::first_height / preferences.appearance.scale);
  return options;
}

Page::Page() : Page(Start()) {}

Page::Page(Start start)
    : is_kiosk_(start.is_kiosk),
      keeps_(start.keeps),
      fits_(start.address.fits),
      embedder_(start.address.embedder),
      application_(window_, start.scene, options_for(start, times_)) {
  const StoredPreferences& stored = start.stored;
  if (!stored.remarks.empty()) application_.show_notice(fmt::format("{}", fmt::join(stored.remarks, "\n\n")), true);
  apply(stored.preferences, application_.session());
  application_.session().offers_audience = false;
  application_.session().offers_full_screen = browser::offers_full_screen();
  application_.session().offers_speech = false;  // a screen reader reads the page as it is
  if (keeps_) {
    preference_keeper_.emplace(stored.preferences, application_.session());
    progress_keeper_.emplace(start.progress);
  }
  follow_system();
  follow_colours();
  address_ = line_ = set_up_line(set_up_of(application_.session(), application_.shown()));
  application_.start();
  last_s_ = browser::clock_s();
}

void Page::keep() {
  if (!keeps_) return;
  try {
    preference_keeper_->keep(application_.session());
    progress_keeper_->keep(application_.session().lesson_progress);
  } catch (const Failure& failure) {
    application_.show_notice(failure.what(), true);
  }
}

// What the person has set for all pages.
void Page::follow_system() {
  const bool is_reduced = browser::wants_less_motion();
  if (is_reduced != application_.session().system_reduces_motion) application_.act(FollowSystemMotion{is_reduced});
}

void Page::follow_colours() {
  const std::optional<SystemColours> forced = browser::forced_colours();
  if (std::exchange(forced_colours_, forced) == forced) return;
  application_.session().system_theme = forced ? std::make_shared<const Theme>(system_theme(*forced)) : nullptr;
}

// Somebody has followed a link to another moment of this page, or typed one.
void Page::follow_address() {
  if (is_kiosk_ || !browser::take_fragment_change()) return;
  const std::string fragment = browser::fragment();
  if (fragment.empty()) return;
  try {
    application_.show_set_up(without_percent_signs(fragment));
  } catch (const std::exception& error) {
    application_.show_notice(fmt::format("The set-up in the address of this page cannot be used: {}", error.what()),
                             true);
  }
}

// On the stage Tab leads on to the controls beside it, which have dialogs too. The workbench's own are in the picture
// alone. One visitor's Esc must not leave the next one without keys.
void Page::follow_keys() {
  const Session& session = application_.session();
  window_.set_key_uses({.tab = session.face == Face::workbench, .escape = escape_has_use(session) || is_kiosk_});
  // In a page around this one, nobody else says so.
  const Face before = std::exchange(seen_face_, session.face);
  if (before == session.face || session.face == Face::stage || !browser::is_in_frame()) return;
  application_.show_notice(std::string(stage_language(session.language).controls.leave_workbench), false,
                           session.language);
}

// What somebody has answered must not be lost between two looks.
void Page::tell_embedder() {
  if (embedder_.empty()) return;
  std::string lesson = lesson_json(application_.session()).dump();
  if (lesson == lesson_) return;
  browser::tell_lesson(lesson);
  lesson_ = std::move(lesson);
}

// A phone that is turned has another picture; where the address asks for it, so has each other size.
void Page::follow_size() {
  const WindowSize size = window_.restored_size();
  const WindowSize before = std::exchange(seen_size_, size);
  const bool is_same = before.width == size.width && before.height == size.height;
  const bool is_turned = before.width > 0 && (before.width > before.height) != (size.width > size.height);
  Session& session = application_.session();
  if (!is_same && (fits_ || is_turned)) session.fits_view = true;
  session.has_room_for_workbench = size.width >= least_workbench_width && size.height >= least_workbench_height;
  if (session.has_room_for_workbench || session.face != Face::workbench || size.width == 0) return;
  application_.act(ShowFace{Face::stage});
  application_.show_notice(std::string(stage_language(session.language).refusals.needs_larger_window), false,
                           session.language);
}

// Fingers go farther than they mean to: a view without hand and handle is of no use to anybody.
void Page::follow_fingers() {
  Session& session = application_.session();
  if (!window_.take_end_of_pinch() || session.face != Face::stage) return;
  const Snapshot snapshot = application_.shown().snapshot;
  const StagePicture& picture = application_.screen().stage().picture();
  const auto is_seen = [&](const Vector<2>& world) {
    const Vector<2> place = to_screen(picture.pane.camera, world);
    return contains(picture.scene, place) && !(picture.numbers && contains(*picture.numbers, place)) &&
           !(picture.tools && contains(*picture.tools, place));
  };
  const bool all_seen =
      is_seen(snapshot.goal) && is_seen(snapshot.strategies[index_of(session.settings.active)].device);
  session.fits_view = session.fits_view || !all_seen;
}

// Most browsers bring the graphics back within a second. Where one never does, a page that is loaded again has them:
// the address holds what is shown, and what was chosen is kept. A kiosk's address names no step, and a lesson from a
// file has no address.
void Page::offer_way_back() {
  constexpr int patience = 180;  // frames: 3 s, of a tab that is in sight
  const bool was_offered = frames_without_graphics_ >= patience;
  frames_without_graphics_ = window_.can_draw() ? 0 : std::min(frames_without_graphics_ + 1, patience);
  const bool is_offered = frames_without_graphics_ == patience;
  if (is_offered == was_offered) return;
  const StageLanguage::Page& words = stage_language(application_.session().language).page;
  if (is_offered) keep();
  const std::optional<LessonState>& lesson = application_.session().lesson;
  const bool begins_anew = is_kiosk_ || (lesson && !lesson->lesson->file.empty());
  const std::string_view lost = begins_anew ? words.graphics_lost_in_lesson : words.graphics_lost;
  browser::offer_to_load_again(std::string(is_offered ? lost : ""), std::string(words.load_again));
}

// Once the person has left a new set-up alone for a moment. In a lesson, the step.
void Page::write_address() {
  const Session& session = application_.session();
  if (is_kiosk_ || session.is_editing) return;
  if (session.lesson) {
    const Lesson& lesson = *session.lesson->lesson;
    browser::set_lesson(lesson.file.empty() ? lesson.name : std::string(), session.lesson->step + 1);
    address_.clear();  // whatever comes after the lesson takes its place
    return;
  }
  std::string line = set_up_line(set_up_of(session, application_.shown()));
  if (std::exchange(line_, line) != line || line == address_) return;
  browser::set_fragment(line);
  address_ = std::move(line);
}

void Page::frame() {
  const double now_s = browser::clock_s();
  const double interval_s = now_s - std::exchange(last_s_, now_s);
  if (!browser::is_visible()) return;          // nobody looks: time stands still
  constexpr double longest_interval_s = 0.25;  // a tab that was hidden goes on where it was
  follow_address();
  follow_system();
  application_.update(std::min(interval_s, longest_interval_s));
  if (window_.take_restored()) application_.restart_drawing();
  offer_way_back();
  if (window_.can_draw() && (pacer_.is_due(drawn_s_, now_s) || application_.needs_drawing())) {
    application_.draw();
    drawn_s_ = now_s;
    keep();
    if (++frames_ == 1) {
      times_.ready_s = browser::clock_s();
      browser::tell_ready(embedder_);
    }
    tell_embedder();
  }
  pacer_.waited(window_.poll(0.0), now_s);
  follow_size();
  follow_fingers();
  follow_keys();
  const bool is_later = now_s - looked_at_s_ >= look_every_s;
  if (is_later || controls_.has_news()) controls_.show(application_, is_later);
  if (is_later) {
    looked_at_s_ = now_s;
    browser::keep_from_leaving(application_.reading().recording.is_on);
    follow_colours();
    write_address();
  }
  times_.script.add(browser::clock_s() - now_s);
}

}  // namespace ghostforce
