#include "app/files/input_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "app/console/interruption.h"

namespace ghostforce {
namespace {

std::string_view remedy_for(int error) noexcept {
  switch (error) {
    case EACCES:
    case EPERM:
      return "change its permissions";
    case EIO:
      return "check the disk, or name another";
    case EMFILE:
    case ENFILE:
      return "close other programs, or raise the limit of open files (ulimit -n)";
    default:
      return "name another";
  }
}

}  // namespace

FileContents file_contents(const std::filesystem::path& path) {
  const int descriptor = open_unless_interrupted(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return {{}, errno};
  struct Closer {
    int descriptor;
    ~Closer() { close(descriptor); }
  } const closer{descriptor};

  FileContents contents;
  std::array<char, 1 << 16> piece;
  while (true) {
    const ssize_t count = read(descriptor, piece.data(), piece.size());
    if (count == 0) return contents;
    if (count < 0 && errno != EINTR) return {{}, errno};
    if (count < 0) {
      stop_if_interrupted();
      continue;
    }
    contents.text.append(piece.data(), static_cast<std::size_t>(count));
    if (contents.text.size() > largest_text_file) return {{}, EFBIG};
  }
}

std::string unreadable_words(int error) {
  return std::generic_category().message(error) + "; " + std::string(remedy_for(error));
}

ReadError unreadable(std::string_view shown_path, int error, std::string_view joint) {
  return {ReadError::Kind::unreadable,
          {{.file = std::string(shown_path),
            .what = "cannot be read: " + std::generic_category().message(error),
            .remedy = std::string(remedy_for(error)),
            .joint = joint}}};
}

}  // namespace ghostforce
