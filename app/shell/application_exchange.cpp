// What is handed on and taken in: files that are opened, set-ups that are copied and pasted.
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/input_file.h"
#include "app/files/run.h"
#include "app/files/run_reader.h"
#include "app/files/scene_file.h"
#include "app/runs/replay.h"
#include "app/shell/application.h"
#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "app/state/mode_changes.h"
#include "app/state/set_up.h"
#include "app/state/set_up_of.h"

namespace ghostforce {
namespace {

bool has_line(std::string_view text, std::string_view beginning) {
  for (std::size_t at = text.find(beginning); at != std::string_view::npos; at = text.find(beginning, at + 1)) {
    if (at == 0 || text[at - 1] == '\n') return true;
  }
  return false;
}

bool begins_like_picture(std::string_view text) {
  const bool is_svg = trimmed(text).starts_with('<') && text.find("<svg") != std::string_view::npos;
  return text.starts_with("\x89PNG\r\n") || text.starts_with("%PDF-") || is_svg;
}

bool begins_like_run(std::string_view text) {
  return text.starts_with("# ghostforce ") || has_line(text, run_columns);
}

// Every step of a lesson has such a line, and no scene has.
bool begins_like_lesson(std::string_view text) {
  return has_line(text, "[[step]]");
}

bool begins_like_scene(std::string_view text) {
  return has_line(text, "format") || has_line(text, "[wall]");
}

bool ends_like(std::string_view path, std::string_view ending) {
  if (ending.empty() || path.size() < ending.size()) return false;
  return std::ranges::equal(path.substr(path.size() - ending.size()), ending, {},
                            [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
}

// Empty: there is none, or it cannot be read.
std::optional<std::string> beginning_of(const std::string& path) {
  constexpr std::size_t enough = 1 << 16;
  std::string text;
  const int error = read_pieces(path, [&text](std::string_view piece) {
    text += piece;
    return text.size() < enough;
  });
  return error == 0 ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace

// What a file is that somebody opens or drops on the window. Its content tells, and its name only where that does not:
// people rename files.
struct Application::FileKind {
  std::string_view words;
  bool (*begins_like_one)(std::string_view beginning);
  std::array<std::string_view, 3> endings;  // of names; empty: no more of them
  void (Application::*open)(const std::string& path);

  static const std::array<FileKind, 4> all;
  static const FileKind& scene() noexcept { return all.back(); }

  // Null: it is of another kind, or a folder, a pipe or the like; never waits for these. Where there is no file, or it
  // cannot be read, a scene is meant: that may be a name, and its reader tells what is wrong.
  static const FileKind* of(const std::string& path) {
    if (!kind_instead_of_file(path).empty()) return nullptr;
    const std::optional<std::string> beginning = beginning_of(path);
    if (!beginning) return &scene();
    for (const FileKind& kind : all) {
      if (kind.begins_like_one(*beginning)) return &kind;
    }
    for (const FileKind& kind : all) {
      if (std::ranges::any_of(kind.endings, [&](std::string_view ending) { return ends_like(path, ending); })) {
        return &kind;
      }
    }
    return nullptr;
  }
};

// The first that fits.
constexpr std::array<Application::FileKind, 4> Application::FileKind::all{{
    {"a picture that ghostforce has saved (.png, .svg, .pdf)",
     begins_like_picture,
     {".png", ".svg", ".pdf"},
     &Application::show_picture},
    {"a recording (.csv)", begins_like_run, {".csv"}, &Application::replay_run},
    {"a lesson (.toml)", begins_like_lesson, {}, &Application::open_lesson},
    {"a scene (.toml)", begins_like_scene, {".toml"}, &Application::open_scene},
}};

void Application::open_for_dialog(const std::string& name_or_path) {
  if (session_.dialog != Dialog::open_scene) return open(name_or_path);
  Form& form = session_.form;
  form.problem.clear();
  form.suggestion.clear();
  try {
    open(name_or_path);
    session_.dialog = Dialog::none;
  } catch (const Failure& failure) {
    if (failure.code() == ExitCode::interrupted) throw;
    form.problem = failure.what();
  } catch (const ReadError& error) {
    form.problem = error.what();
    if (!error.problems().empty()) form.suggestion = error.problems().front().suggestion;
  }
}

void Application::open(const std::string& name_or_path) {
  // For what is of no kind the reader of scenes finds the words.
  const FileKind* const kind = FileKind::of(name_or_path);
  (this->*(kind != nullptr ? *kind : FileKind::scene()).open)(name_or_path);
}

void Application::open_dropped(const std::vector<std::string>& paths) {
  const std::string& path = paths.front();
  const std::string_view no_file = kind_instead_of_file(path);
  if (FileKind::of(path) == nullptr) {
    std::string kinds;
    for (const FileKind& kind : FileKind::all) kinds.append(kinds.empty() ? "" : "; ").append(kind.words);
    throw Failure(ExitCode::wrong_call,
                  fmt::format("{} is {}.\nWhat can be dropped here: {}.", quoted_text(path, longest_path),
                              no_file.empty() ? "of no kind that can be opened" : no_file, kinds));
  }
  dismiss_notice();
  open(path);
  if (session_.dialog == Dialog::open_scene) session_.dialog = Dialog::none;
  if (paths.size() == 1) return;
  add_to_notice(
      fmt::format("Only one file can be open at a time. This is the first: {}", quoted_text(path, longest_path)));
}

void Application::open_scene(const std::string& name_or_path) {
  const auto scene = std::make_shared<const Scene>(load_scene(name_or_path));
  use(*input_, scene, scene->settings);
}

void Application::open_lesson(const std::string& name_or_path) {
  begin_lesson(session_, std::make_shared<const Lesson>(load_lesson(name_or_path)));
}

void Application::show_picture(const std::string& path) {
  const SetUp set_up = read_picture_set_up(path);
  dismiss_notice();
  show(set_up);
  add_to_notice(filled(notice_words().picture_shown, quoted_text(path, longest_path)));
}

void Application::replay_run(const std::string& path) {
  const Run run = load_run(path);
  if (!run.scene) {
    throw Failure(
        ExitCode::wrong_call,
        fmt::format("{}: the run does not say which scene it belongs to. Name the scene on the command line, as in\n"
                    "ghostforce run wall45 --input replay:RUN.csv",
                    quoted_text(path, longest_path)));
  }
  const auto scene = std::make_shared<const Scene>(scene_since(run, run.ticks.front()));
  auto hand = std::make_shared<const GoalPath>(goal_path_of(run));
  std::swap(input_options_.recorded_hand, hand);
  try {
    use(*std::ranges::find_if(inputs_, &InputEntry::needs_recording), scene, scene->settings);
  } catch (...) {
    std::swap(input_options_.recorded_hand, hand);
    throw;
  }
  input_choices_ = choices_of(inputs_, true);
  show_notice(fmt::format("Replaying {}{}{}", quoted_text(path, longest_path), run.warnings.empty() ? "" : "\n",
                          fmt::join(run.warnings, "\n")),
              false);
}

UndoState Application::undo_state() const {
  UndoState state{.scene = session_.scene,
                  .settings = session_.settings,
                  .belief_source = session_.belief_source,
                  .goal = session_.goal,
                  .goal_is_chosen = session_.pointer_moves_goal,
                  .view = session_.shown,
                  .face = session_.face,
                  .mode = session_.stage.mode};
  if (session_.motor_line_turns) state.settings.actuated_angle = session_.scene->settings.actuated_angle;
  if (session_.lesson) {
    // It goes as it has come, and leaves nothing to undo.
    const LessonState::Before& before = session_.lesson->before;
    state.settings = before.settings;
    state.belief_source = before.belief_source;
    state.goal = before.goal;
    state.face = before.face;
    state.mode = StageMode::none;
  }
  return state;
}

void Application::show(const UndoState& wanted) {
  leave_stage_mode(session_);
  // A mode that brought an input of its own has asked for the one before.
  const std::string input = std::exchange(session_.wanted_input, {}).value_or(session_.input);
  use(input_of(input), wanted.scene, wanted.settings, wanted.goal);
  hand_following_.restore(wanted.settings, wanted.belief_source, session_);
  session_.shown = wanted.view;
  session_.stage.is_black = false;
  apply_now(ShowFace{wanted.face});
  if (wanted.mode != StageMode::none) apply_now(ToggleMode{wanted.mode});
}

void Application::show(const SetUp& set_up) {
  const auto scene = std::make_shared<const Scene>(set_up.scene);
  show(UndoState{.scene = scene,
                 .settings = scene->settings,
                 .goal = set_up.goal,
                 .view = scene->view,
                 .face = set_up.face,
                 .mode = set_up.mode});
}

void Application::show_set_up(const std::string& line) {
  const SetUp set_up = read_set_up_line(line);
  dismiss_notice();
  show(set_up);
}

void Application::copy_set_up() {
  window_.set_clipboard_text(set_up_line(set_up_of(session_, shown())));
  show_notice(std::string(notice_words().copied_set_up), false, session_.language);
}

void Application::paste_set_up(const PasteSetUp& wanted) {
  try {
    show_set_up(wanted.line);
  } catch (const ReadError& error) {
    return show_notice(fmt::format("The clipboard holds no set-up: {}.\nCopy one with Ctrl+C.", error.what()), true);
  }
  add_to_notice(std::string(notice_words().pasted_set_up));
}

// Another scene may have ended a recording, and the person must read that too.
void Application::add_to_notice(const std::string& words) {
  if (has_failed_) return show_notice(words, false, session_.language);
  const bool is_problem = session_.notice && session_.notice->is_problem;
  show_notice(session_.notice ? fmt::format("{}\n{}", session_.notice->words, words) : words, is_problem,
              session_.language);
}

}  // namespace ghostforce
