#include "app/shell/desktop/drawing_memory.h"

#include <malloc.h>
#include <sched.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include <fmt/format.h>

#include "app/base/failure.h"

namespace ghostforce {
namespace {

// Measured with Mesa 22.3: the smallest limits under which pictures came out, and a third more.
constexpr std::size_t libraries = 256 << 20;
constexpr std::size_t each_later_window = 48 << 20;
constexpr std::size_t each_thread = 96 << 20;  // a stack, and a heap of its own
constexpr std::size_t each_pixel = 32;
constexpr int other_threads = 4;  // of the graphics libraries, besides those that draw
constexpr int most_threads = 16;

// As many as the software renderer draws with.
int thread_count() {
  cpu_set_t processors;
  const int count = sched_getaffinity(0, sizeof processors, &processors) == 0 ? CPU_COUNT(&processors) : most_threads;
  return std::min(count, most_threads);
}

// Nothing of it is touched, so it costs nothing.
bool is_room_for(std::size_t size) {
  void* const memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) return false;
  munmap(memory, size);
  return true;
}

void choose_threads(std::size_t needed) {
  const int threads = thread_count();
  if (!is_room_for(needed + each_thread * static_cast<std::size_t>(threads + other_threads))) {
    setenv("LP_NUM_THREADS", "0", 1);
    mallopt(M_ARENA_MAX, 1);  // one heap for the threads that are left
  } else if (threads == 1) {
    // It would draw without a thread of its own, and take three times as long.
    setenv("LP_NUM_THREADS", "1", 0);
  }
}

}  // namespace

void make_room_for_drawing(int width, int height, std::string_view remedy) {
  static bool are_libraries_there = false;
  const std::size_t pixels = each_pixel * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::size_t needed = pixels + (are_libraries_there ? each_later_window : libraries);
  if (!are_libraries_there) choose_threads(needed);
  if (is_room_for(needed)) {
    are_libraries_there = true;
    return;
  }
  throw Failure(ExitCode::file_trouble,
                fmt::format("drawing needs about {} MB more memory than this program is allowed; raise its limit "
                            "(ulimit -v), or {}",
                            needed >> 20, remedy));
}

}  // namespace ghostforce
