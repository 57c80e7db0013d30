#include "app/state/set_up_of.h"

#include <cerrno>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/input_file.h"
#include "app/files/picture_title.h"
#include "app/files/png_file.h"
#include "app/files/scene_file.h"
#include "app/state/set_up.h"

namespace ghostforce {
namespace {

// A circle goes round the goal that was there before it.
bool hand_is_at_session_goal(const Session& session, const ShownMoment& shown) {
  const bool goes_round = session.circle_test.is_on || session.stage.mode == StageMode::round;
  return !shown.is_past && (session.pointer_moves_goal || goes_round);
}

Vector<2> goal_of(const Session& session, const ShownMoment& shown) {
  const Vector<2>& seen = shown.snapshot.goal;
  const bool is_known = std::isfinite(seen.x) && std::isfinite(seen.y);
  return nearest_in_scene(hand_is_at_session_goal(session, shown) || !is_known ? session.goal : seen);
}

// How stiff the hand was at that moment is told by its path.
void leave_hand_to_path(const Settings& chosen, Settings& settings) {
  std::optional<double>& believed = settings.stiffnesses.believed_k_u;
  settings.stiffnesses.k_u = chosen.stiffnesses.k_u;
  if (!chosen.stiffnesses.believed_k_u && believed == chosen.stiffnesses.k_u) believed.reset();
}

}  // namespace

SetUp set_up_of(const Session& session, const ShownMoment& shown) {
  SetUp set_up{*session.scene, {}, session.face, StageMode::none};
  set_up.scene.settings = shown.settings;
  if (!set_up.scene.stiffness_path.is_empty()) leave_hand_to_path(session.settings, set_up.scene.settings);
  set_up.scene.view = session.shown;
  set_up.scene.goal.points.back() = goal_of(session, shown);
  set_up.scene = rounded_to_file(std::move(set_up.scene));
  set_up.goal = set_up.scene.goal.points.back();
  if (session.face == Face::stage) set_up.mode = session.stage.mode;
  return set_up;
}

namespace {

constexpr std::string_view line_begins = "ghostforce run ";

// From where it begins to the end of the text; empty: there is none.
std::string_view line_in(std::string_view text) noexcept {
  const std::size_t at = text.rfind(line_begins);
  return at == std::string_view::npos ? std::string_view() : trimmed(text.substr(at));
}

std::string line_in_png(const std::string& path) {
  const PngFile file(path, PngWords::read);
  for (const PngText& text : file.texts()) {
    if (const std::string_view line = line_in(text.text); !line.empty()) return std::string(line);
  }
  return {};
}

std::string line_in_picture(const std::string& path) {
  FileContents file = file_contents(path);
  // A PNG has no largest size, and its reader looks at the pixels only when it is asked for them.
  if (file.error == EFBIG || file.text.starts_with("\x89PNG")) return line_in_png(path);
  if (file.error != 0) throw unreadable(quoted_text(path, longest_path), file.error);
  return std::string(line_in(file.text.starts_with("%PDF-") ? pdf_title(file.text) : svg_title(file.text)));
}

}  // namespace

std::vector<PngText> picture_texts(const SetUp& set_up) {
  return {software_text(), {"Description", set_up_line(set_up)}};
}

std::string picture_title(std::string_view title, const SetUp& set_up) {
  return fmt::format("{}: {}", title, set_up_line(set_up));
}

SetUp read_picture_set_up(const std::string& path) {
  const std::string shown = quoted_text(path, longest_path);
  const std::string line = line_in_picture(path);
  if (line.empty()) {
    throw ReadError(ReadError::Kind::wrong, {{.file = shown,
                                              .what = "the picture does not say what it shows",
                                              .remedy = "give one that ghostforce has saved; other programs may take "
                                                        "that out when they save it again"}});
  }
  try {
    return read_set_up_line(line);
  } catch (const ReadError& error) {
    std::vector<ReadProblem> problems = error.problems();
    for (ReadProblem& problem : problems) {
      problem.what = words_of(problem);
      problem.remedy.clear();
      problem.file = shown;
      problem.line = 0;
    }
    throw ReadError(error.kind(), std::move(problems));
  }
}

}  // namespace ghostforce
