#include "app/shell/web/page.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/failure.h"
#include "app/base/language.h"
#include "app/files/read_error.h"
#include "app/files/scene_file.h"
#include "app/shell/preferences.h"
#include "app/shell/web/browser.h"
#include "app/shell/web/page_inputs.h"
#include "app/state/lesson_file.h"
#include "app/state/set_up.h"
#include "app/state/set_up_of.h"
#include "device/servo/servo_driver.h"
#include "device/virtual_falcon/virtual_link.h"

namespace ghostforce {
namespace {

constexpr const char* first_scene = "wall45";
// For what the page tells beside the picture.
constexpr double look_every_s = 0.5;

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

}  // namespace

struct Page::Start {
  bool is_kiosk = browser::has_query("kiosk");
  StoredPreferences stored = is_kiosk ? for_visitors(load_preferences()) : load_preferences();
  LessonProgress progress = is_kiosk ? LessonProgress{} : load_lesson_progress(stored.remarks);
  std::shared_ptr<const Lesson> lesson;
  std::optional<SetUp> set_up;
  Scene scene = load_scene(first_scene);

  // A mistake in the address is told, and the page opens without it.
  Start() {
    const auto attempt = [this](const char* what, const auto& act) {
      try {
        act();
      } catch (const std::exception& error) {
        stored.remarks.push_back(fmt::format("{} in the address of this page cannot be used: {}", what, error.what()));
      }
    };
    if (const std::string name = browser::query("lesson"); !name.empty()) {
      attempt("The lesson", [&] { lesson = std::make_shared<const Lesson>(load_lesson(name)); });
    }
    if (const std::string line = browser::fragment(); !line.empty() && !lesson && !is_kiosk) {
      attempt("The set-up", [&] { set_up = read_set_up_line(line); });
    }
    if (set_up) {
      scene = set_up->scene;
      stored.preferences.face = set_up->face;
    }
    Preferences& preferences = stored.preferences;
    const std::string asked_for = browser::query("language");
    preferences.language = wanted_language(asked_for.empty() ? preferences.language : asked_for, locale_variables());
  }
};

ApplicationOptions Page::options_for(const Start& start, Times& times) {
  const Preferences& preferences = start.stored.preferences;
  ApplicationOptions options{
      .appearance = preferences.appearance,
      .face = preferences.face,
      .mode = start.set_up ? start.set_up->mode : StageMode::none,
      .lesson = start.lesson,
      .language = preferences.language,
      .lesson_progress = start.progress,
      .inputs = page_inputs(),
      .why_no_falcon = why_no_falcon_in_page,
      .make_servo_driver = [&times] { return std::make_unique<MeasuredServoDriver>(times.servo); },
      .show_link = browser::show_link,
      .offers_hints = preferences.offers_hints};
  if (start.is_kiosk) options.kiosk_visit = start.lesson ? std::vector{start.lesson} : shipped_lessons();
  options.input_options.virtual_falcon_clock = VirtualLink::Clock::stepped;  // ticks come in bursts
  options.folded_panels = panels_folded_at_first(WindowLayout::first_height / preferences.appearance.scale);
  return options;
}

Page::Page() : Page(Start()) {}

Page::Page(Start start) : is_kiosk_(start.is_kiosk), application_(window_, start.scene, options_for(start, times_)) {
  const StoredPreferences& stored = start.stored;
  if (!stored.remarks.empty()) application_.show_notice(fmt::format("{}", fmt::join(stored.remarks, "\n\n")), true);
  apply(stored.preferences, application_.session());
  application_.session().offers_audience = false;
  application_.session().offers_speech = false;  // a screen reader reads the page as it is
  if (!is_kiosk_) {
    preference_keeper_.emplace(stored.preferences, application_.session());
    progress_keeper_.emplace(start.progress);
  }
  address_ = line_ = set_up_line(set_up_of(application_.session(), application_.shown()));
  application_.start();
  last_s_ = browser::clock_s();
}

void Page::keep() {
  if (is_kiosk_) return;
  try {
    preference_keeper_->keep(application_.session());
    progress_keeper_->keep(application_.session().lesson_progress);
  } catch (const Failure& failure) {
    application_.show_notice(failure.what(), true);
  }
}

// Somebody has followed a link to another moment of this page, or typed one.
void Page::follow_address() {
  if (is_kiosk_ || !browser::take_fragment_change()) return;
  const std::string line = browser::fragment();
  if (line.empty()) return;
  try {
    application_.show_set_up(line);
  } catch (const std::exception& error) {
    application_.show_notice(fmt::format("The set-up in the address of this page cannot be used: {}", error.what()),
                             true);
  }
}

// The stage's sentence, for those who do not see it: screen readers read what changes there.
void Page::tell_listeners() {
  std::string sentence = application_.stage_reading().sentence;
  if (sentence == spoken_) return;
  browser::tell_listeners(sentence);
  spoken_ = std::move(sentence);
}

// Once the person has left a new set-up alone for a moment.
void Page::write_address() {
  const Session& session = application_.session();
  if (is_kiosk_ || session.lesson || session.is_editing) return;
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
  application_.update(std::min(interval_s, longest_interval_s));
  if (window_.take_restored()) application_.restart_drawing();
  if (window_.can_draw() && (pacer_.is_due(drawn_s_, now_s) || application_.needs_drawing())) {
    application_.draw();
    drawn_s_ = now_s;
    keep();
    if (++frames_ == 1) {
      times_.ready_s = browser::clock_s();
      browser::tell_ready();
    }
  }
  pacer_.waited(window_.poll(0.0), now_s);
  if (now_s - looked_at_s_ >= look_every_s) {
    looked_at_s_ = now_s;
    browser::keep_from_leaving(application_.reading().recording.is_on);
    tell_listeners();
    write_address();
  }
  times_.script.add(browser::clock_s() - now_s);
}

}  // namespace ghostforce
