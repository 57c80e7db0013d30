#include "app/files/growing_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/files/output_file.h"

namespace ghostforce {

int open_growing_file(const std::string& path) noexcept {
  return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
}

Failure no_growing_file(const std::string& path, std::string_view kind, int error) {
  const std::string shown = quoted_text(path, longest_path);
  return Failure(ExitCode::file_trouble,
                 error == EEXIST ? fmt::format("{} already exists, and {} never overwrites a file; choose another name",
                                               shown, kind)
                                 : fmt::format("{} cannot be written: {}", shown, reason_of(error)));
}

int append_whole(int descriptor, std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t count = write(descriptor, text.data(), text.size());
    if (count >= 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

}  // namespace ghostforce
