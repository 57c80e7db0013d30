#include "app/files/input_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include "app/base/interruption.h"
#include "app/base/typed_text.h"

namespace ghostforce {
namespace {

std::string_view remedy_for(int error) noexcept {
  switch (error) {
    case EACCES:
    case EPERM:
      return "change its permissions";
    case EIO:
      return "check the disk, or name another file";
    case EMFILE:
    case ENFILE:
      return "close other programs, or raise the limit of open files (ulimit -n)";
    default:
      return "name another file";
  }
}

}  // namespace

int read_pieces(const std::filesystem::path& path, const std::function<bool(std::string_view piece)>& take) {
  const int descriptor = open_unless_interrupted(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return errno;
  struct Closer {
    int descriptor;
    ~Closer() { close(descriptor); }
  } const closer{descriptor};

  constexpr std::size_t longest_piece = 1 << 16;
  std::array<char, longest_piece> piece;
  while (true) {
    wait_to_read(descriptor);
    const ssize_t count = read(descriptor, piece.data(), piece.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count < 0) return errno;
    if (count == 0 || !take({piece.data(), static_cast<std::size_t>(count)})) return 0;
  }
}

FileContents file_contents(const std::filesystem::path& path) {
  std::string text;
  const int error = read_pieces(path, [&](std::string_view piece) {
    text += piece;
    return text.size() <= largest_text_file;
  });
  if (error != 0) return {{}, error};
  if (text.size() > largest_text_file) return {{}, EFBIG};
  return {std::move(text), 0};
}

std::vector<std::filesystem::path> paths_in(const std::filesystem::path& folder, std::error_code& error) {
  std::vector<std::filesystem::path> paths;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    paths.push_back(entry->path());
  }
  std::ranges::sort(paths);
  return paths;
}

std::optional<std::string> nearest_name_in(const std::filesystem::path& folder, std::string_view word,
                                           const std::function<std::string(const std::filesystem::path&)>& name_of) {
  std::error_code ignored;
  std::vector<std::string> names;
  for (const std::filesystem::path& path : paths_in(folder, ignored)) names.push_back(name_of(path));
  std::ranges::sort(names);
  const auto near = nearest_name(word, std::vector<std::string_view>(names.begin(), names.end()));
  return near ? std::optional<std::string>(*near) : std::nullopt;
}

std::string_view kind_instead_of_file(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_type type = fs::status(path, error).type();
  switch (type) {
    case fs::file_type::regular:
      return "";
    case fs::file_type::directory:
      return "a folder";
    case fs::file_type::fifo:
      return "a pipe";
    case fs::file_type::socket:
      return "a socket";
    case fs::file_type::block:
    case fs::file_type::character:
      return "a device";
    case fs::file_type::not_found:
      break;
    default:
      if (error != std::errc::too_many_symbolic_link_levels) return "";
  }
  std::error_code none;
  return fs::is_symlink(fs::symlink_status(path, none)) ? "a broken link" : "";
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
