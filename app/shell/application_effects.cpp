// What the application does for the session: windows, files, inputs, the clipboard.
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/file_exchange.h"
#include "app/files/output_file.h"
#include "app/files/scene_file.h"
#include "app/shell/application.h"
#include "app/shell/preferences.h"
#include "app/state/live_table.h"
#include "app/state/mode_changes.h"
#include "app/state/permit.h"
#include "app/state/scene_view.h"
#include "app/state/set_up.h"
#include "app/state/set_up_of.h"
#include "app/state/user_measurement_guide.h"
#include "app/workbench/plot_export.h"

namespace ghostforce {

struct Application::EffectDoer {
  Application& application;

  void operator()(const Quit&) const { application.window_.close(); }
  void operator()(const ToggleFullScreen&) const { application.window_.toggle_full_screen(); }
  void operator()(const ToggleAudience&) const { application.toggle_audience(); }
  void operator()(const Undo&) const { application.take_back(true); }
  void operator()(const Redo&) const { application.take_back(false); }
  void operator()(const OpenScene& wanted) const { application.open_for_dialog(wanted.name_or_path); }
  void operator()(const OpenLesson& wanted) const { application.open_lesson(wanted.name_or_path); }
  void operator()(const DropFiles& dropped) const { application.open_dropped(dropped.paths); }
  void operator()(const SaveScene& wanted) const {
    application.save(wanted.path, [&] { return scene_text(scene_as_seen(application.session_)); });
  }
  void operator()(const SavePicture& wanted) const {
    application.save(wanted.path, [&] { return application.picture_bytes(wanted); });
  }
  void operator()(const SaveClip& wanted) const { application.save_clip(wanted); }
  void operator()(const SavePlots& wanted) const {
    application.save(wanted.path, [&] {
      return plot_file(application.session_, application.shown(), application.history_, wanted, application.painter_);
    });
  }
  void operator()(const CopyPicture& wanted) const { application.copy_picture(wanted); }
  void operator()(const CopyValues&) const {
    application.window_.set_clipboard_text(live_table(application.shown().snapshot));
    application.show_notice(std::string(application.notice_words().copied_values), false,
                            application.session_.language);
  }
  void operator()(const CopySetUp&) const { application.copy_set_up(); }
  void operator()(const PasteSetUp& wanted) const { application.paste_set_up(wanted); }
  void operator()(const ShowLink&) const {
    if (!application.show_link_) return;
    application.show_link_(set_up_line(set_up_of(application.session_, application.shown())));
  }
  void operator()(const ShowControls&) const {
    if (application.show_controls_) application.show_controls_();
  }
  void operator()(const StartRecording& wanted) const { application.start_recording(wanted.path); }
  void operator()(const StopRecording&) const {
    const std::string words = application.end_recording();
    if (!words.empty()) application.show_notice(words, !application.recording_problem_.empty());
  }
  void operator()(const ResetPreferences&) const {
    reset_preferences(application.session_, application.window_);
    application.show_notice("All preferences are as they were at first.", false);
  }
};

void Application::do_effects() {
  has_failed_ = false;
  std::vector<std::string> dropped = window_.take_dropped_files();
  take_answer_of_chooser(dropped);
  if (!dropped.empty()) hear(DropFiles{std::move(dropped)});
  // A step of a lesson may bring an input of its own, for visitors too.
  const std::optional<std::string> input = std::exchange(session_.wanted_input, {});
  if (input && *input != session_.input) attempt([&] { use_at_request(input_of(*input)); });
  for (const Effect& effect : std::exchange(effects_, {})) {
    // What was done before it may have changed what is allowed.
    const auto do_permitted = [&](const auto& wanted) {
      if (!permit(session_, wanted)) EffectDoer{*this}(wanted);
    };
    attempt([&] { std::visit(do_permitted, effect); });
  }
  has_failed_ = false;
}

// Of the desktop's own dialog. Nobody waits any more for a place where the form has been closed meanwhile.
void Application::take_answer_of_chooser(std::vector<std::string>& dropped) {
  FileAnswer answer = take_chosen_files();
  if (!answer.problem.empty()) show_notice(answer.problem, true);
  if (!answer.question.new_file) {
    std::ranges::move(answer.paths, std::back_inserter(dropped));
  } else if (std::exchange(session_.form.awaits_place, false) && !answer.paths.empty()) {
    session_.form.path = std::move(answer.paths.front());
  }
}

void Application::attempt(const std::function<void()>& work) {
  try {
    work();
  } catch (const Failure& failure) {
    if (failure.code() == ExitCode::interrupted) throw;
    show_notice(failure.what(), true);
  } catch (const ReadError& error) {
    show_notice(error.what(), true);
  } catch (const BrokenPipe&) {
    show_notice("No program is reading from that pipe any more. Save to a file instead.", true);
  }
}

// A path that cannot be written is found out before the work is done.
void Application::save(const std::string& path, const std::function<std::string()>& make_bytes) {
  OutputFile file(path);
  file.write(make_bytes());
  file.commit();
  hand_out(path);
  show_notice(filled(notice_words().saved, quoted_text(path, longest_path)), false, session_.language);
}

void Application::toggle_audience() {
  const std::string title(stage_language(session_.language).lecture.window);
  std::unique_ptr<AudienceWindow> window = session_.has_audience ? nullptr : window_.open_audience(title);
  session_.has_audience = window != nullptr;
  screen_.show_to(std::move(window));
  drawn_.reset();
}

// But for what has failed just now.
void Application::dismiss_notice() {
  if (!has_failed_) session_.notice.reset();
}

// A mode that cannot have its input does not begin.
void Application::use_at_request(const InputEntry& entry) {
  try {
    use(entry, session_.scene, session_.settings);
  } catch (...) {
    if (session_.stage.mode == StageMode::round && !session_.circle_test.is_on) leave_stage_mode(session_);
    throw;
  }
}

void Application::take_back(bool undo) {
  // What a measurement has set is its own: to take it back is to cancel it.
  if (is_measuring(session_)) return cancel_measurement(session_);
  // What is being changed right now is one more step to take back.
  undo_.note(undo_state(), false);
  const UndoState earlier = undo_.present();
  const std::optional<UndoState> wanted = undo ? undo_.undo() : undo_.redo();
  if (!wanted) return;
  if (wanted->scene == session_.scene) {
    hand_following_.restore(wanted->settings, wanted->belief_source, session_);
    const bool moves_goal = session_.pointer_moves_goal && wanted->goal_is_chosen && session_.goal != wanted->goal;
    if (moves_goal) {
      session_.goal = wanted->goal;
      if (session_.face == Face::stage) session_.fits_view = true;  // the view may have followed the hand elsewhere
    }
  } else {
    show(*wanted);
  }
  // Where it is read.
  const bool is_on_stage = session_.face == Face::stage;
  const StageLanguage& language = is_on_stage ? stage_language(session_.language) : english_stage;
  const UndoState& before = undo ? *wanted : earlier;
  const UndoState& after = undo ? earlier : *wanted;
  show_notice(filled(undo ? language.changes.undone : language.changes.redone,
                     is_on_stage ? words_of_change(before, after, language) : words_of_change(before, after)),
              false, is_on_stage ? session_.language : "en");
}

}  // namespace ghostforce
