#include "app/file_contents.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "app/interruption.h"

namespace ghostforce {
namespace {

// Calls again what a signal has ended, unless the signal shall end the program.
template <typename Call>
auto finished(Call&& call) {
  while (true) {
    const auto result = call();
    if (result >= 0 || errno != EINTR) return result;
    stop_if_interrupted();
  }
}

}  // namespace

FileContents file_contents(const std::filesystem::path& path) {
  const int descriptor = finished([&] { return open(path.c_str(), O_RDONLY | O_CLOEXEC); });
  if (descriptor < 0) return {{}, errno};
  struct Closer {
    int descriptor;
    ~Closer() { close(descriptor); }
  } const closer{descriptor};

  FileContents contents;
  std::array<char, 1 << 16> piece;
  while (true) {
    const ssize_t count = finished([&] { return read(descriptor, piece.data(), piece.size()); });
    if (count == 0) return contents;
    if (count < 0) return {{}, errno};
    contents.text.append(piece.data(), static_cast<std::size_t>(count));
    if (contents.text.size() > largest_text_file) return {{}, EFBIG};
  }
}

}  // namespace ghostforce
