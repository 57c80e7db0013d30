#include "app/shell/session_recorder.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/output_file.h"

namespace ghostforce {

SessionRecorder::SessionRecorder(const std::string& path, const SessionStart& start) : path_(path) {
  descriptor_ = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
  const bool exists = descriptor_ < 0 && errno == EEXIST;
  error_ = descriptor_ < 0 ? errno : 0;
  append(start_line(start));
  if (error_ == 0) return;
  if (descriptor_ >= 0) {
    close(descriptor_);
    unlink(path.c_str());
  }
  const std::string shown = quoted_text(path, longest_path);
  throw Failure(
      ExitCode::file_trouble,
      exists ? fmt::format("{} already exists, and a session never overwrites a file; choose another name", shown)
             : fmt::format("{} cannot be written: {}", shown, reason_of(error_)));
}

SessionRecorder::~SessionRecorder() {
  close(descriptor_);
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
  std::string_view rest = line;
  while (error_ == 0 && !rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written >= 0) {
      rest.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      error_ = errno;
    }
  }
}

}  // namespace ghostforce
