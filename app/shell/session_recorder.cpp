#include "app/shell/session_recorder.h"

#include <cerrno>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/files/growing_file.h"
#include "app/files/output_file.h"

namespace ghostforce {

SessionRecorder::SessionRecorder(const std::string& path, const SessionStart& start)
    : path_(path), descriptor_(open_growing_file(path)) {
  constexpr std::string_view kind = "a session";
  if (descriptor_.number() < 0) throw no_growing_file(path, kind, errno);
  append(start_line(start));
  if (error_ == 0) return;
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  throw no_growing_file(path, kind, error_);
}

void SessionRecorder::write_choices(const Session& session) {
  for (const Action& choice : {Action(ChangeAppearance{session.appearance}), Action(ChangeViewOptions{session.options}),
                               Action(ChangePlots{session.plots}), Action(ChangeSpaceMouse{session.spacemouse}),
                               Action(ChangeSpeed{session.speed}), Action(ChooseLanguage{session.language})}) {
    write(0.0, choice);
  }
}

std::string SessionRecorder::problem() const {
  if (error_ == 0) return {};
  return fmt::format("{} does not hold the whole session: {}", quoted_text(path_, longest_path), reason_of(error_));
}

void SessionRecorder::append(const std::string& line) noexcept {
  if (error_ == 0) error_ = append_whole(descriptor_.number(), line);
}

}  // namespace ghostforce
