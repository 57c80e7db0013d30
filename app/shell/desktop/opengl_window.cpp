#include "app/shell/desktop/opengl_window.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <latch>
#include <system_error>
#include <thread>
#include <vector>

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <glad/gl.h>
#include <malloc.h>
#include <sched.h>
#include <sys/mman.h>

#include "app/base/failure.h"

// GLFW's header for it wants those of Xlib.
extern "C" unsigned long glfwGetX11Window(GLFWwindow* window);

namespace ghostforce {
namespace {

std::string last_glfw_error() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description != nullptr ? description : "no reason given";
}

constexpr const char* offscreen_advice =
    "pictures can be made without a display: ghostforce render wall45 -o wall45.png";

[[noreturn]] void refuse(Renderer renderer, std::string_view reason) {
  throw Failure(ExitCode::no_display, fmt::format("{}; {}", reason, entry_of(renderer).source));
}

// What the machine has when it does not have OpenGL 3.3, for the error message.
std::string describe_lesser_opengl() {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 1);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_ANY_PROFILE);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  GLFWwindow* window = glfwCreateWindow(16, 16, "", nullptr, nullptr);
  if (window == nullptr) return "no OpenGL at all (" + last_glfw_error() + ")";
  glfwMakeContextCurrent(window);
  // glGetString is older than every loader's minimum version, so it is asked for by hand.
  using GetString = const unsigned char* (*)(unsigned int);
  const auto get_string = reinterpret_cast<GetString>(glfwGetProcAddress("glGetString"));
  const auto text = [&](unsigned int name) {
    const unsigned char* value = get_string != nullptr ? get_string(name) : nullptr;
    return value != nullptr ? reinterpret_cast<const char*>(value) : "unknown";
  };
  std::string description = fmt::format("OpenGL {} on {}", text(GL_VERSION), text(GL_RENDERER));
  glfwDestroyWindow(window);
  return description;
}

bool has_watch() {
  return glfwGetPlatform() == GLFW_PLATFORM_X11;
}

GLFWwindow* create_window(const WindowOptions& options, const std::optional<Renderer>& renderer) {
  hint_window(renderer);
  // Its watch hears from the beginning where its keys go.
  if (has_watch()) glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  WindowSize size{options.width, options.height};
  if (options.fits_monitor) size = fitted(size);
  GLFWwindow* window = glfwCreateWindow(size.width, size.height, options.title.c_str(), nullptr, nullptr);
  if (window != nullptr) return window;
  const std::string reason = last_glfw_error();
  if (renderer) refuse(*renderer, fmt::format("{} (there is {})", reason, describe_lesser_opengl()));
  throw Failure(ExitCode::no_display, fmt::format("the window needs OpenGL 3.3, but there is {} ({}); a newer graphics "
                                                  "driver may help, and {}",
                                                  describe_lesser_opengl(), reason, offscreen_advice));
}

}  // namespace

void hint_window(std::optional<Renderer> renderer) {
  glfwDefaultWindowHints();
  if (renderer == Renderer::osmesa) {
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_OSMESA_CONTEXT_API);
  } else if (renderer) {
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  }
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "ghostforce");
  glfwWindowHintString(GLFW_WAYLAND_APP_ID, "ghostforce");
}

OpenGlWindow::Library::Library(const WindowOptions& options, std::optional<Renderer> renderer) {
  if (renderer && *renderer != Renderer::gpu) choose_offscreen_driver();
  make_room_for_drawing(options.width, options.height,
                        renderer ? "make the picture smaller, or an .svg or .pdf" : "close other programs");
  // Asking for Wayland where there is none makes its library complain on stderr.
  const int on_display = std::getenv("WAYLAND_DISPLAY") != nullptr ? GLFW_ANY_PLATFORM : GLFW_PLATFORM_X11;
  glfwInitHint(GLFW_PLATFORM, renderer ? GLFW_PLATFORM_NULL : on_display);
  if (glfwInit() == GLFW_TRUE) {
    watch_display();
    return;
  }
  const std::string reason = last_glfw_error();
  glfwTerminate();
  throw Failure(ExitCode::no_display,
                fmt::format("there is no display to open a window on ({}); {}", reason, offscreen_advice));
}

OpenGlWindow::Library::~Library() {
  glfwTerminate();
}

void OpenGlWindow::Destroy::operator()(GLFWwindow* window) const {
  expect_window(0);
  glfwDestroyWindow(window);
}

OpenGlWindow::OpenGlWindow(const WindowOptions& options, std::optional<Renderer> renderer)
    : library_(options, renderer), window_(create_window(options, renderer)) {
  if (renderer && *renderer != Renderer::osmesa) {
    try {
      egl_.emplace(*renderer);
    } catch (const Failure& failure) {
      refuse(*renderer, failure.what());
    }
  } else {
    glfwMakeContextCurrent(handle());
  }
  if (gladLoadGL(loader()) < GLAD_MAKE_VERSION(3, 3)) {
    throw Failure(ExitCode::no_display,
                  fmt::format("the driver offers OpenGL 3.3, but it cannot be loaded: {}",
                              glGetString != nullptr ? Window::graphics_description() : "unknown"));
  }
  if (has_watch()) {
    const auto window = static_cast<std::uint32_t>(glfwGetX11Window(handle()));
    watch_.emplace(window, options.when_lost);
    expect_window(window);
    glfwShowWindow(handle());
  }
}

OpenGlWindow OpenGlWindow::open(const WindowOptions& options) {
  if (!options.offscreen) return {options, std::nullopt};
  std::string problems = "pictures cannot be drawn here:";
  for (const RendererEntry& entry : renderer_catalog()) {
    const bool is_wanted = options.renderer ? entry.renderer == *options.renderer : entry.is_tried_unasked;
    if (!is_wanted) continue;
    try {
      return {options, entry.renderer};
    } catch (const Failure& failure) {
      if (failure.code() != ExitCode::no_display) throw;
      problems += fmt::format("\n  --renderer {}: {}", entry.name, failure.what());
    }
  }
  throw Failure(ExitCode::no_display, problems);
}

OpenGlWindow::Loader OpenGlWindow::loader() const {
  return egl_ ? EglContext::loader() : glfwGetProcAddress;
}

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

// Whether this user may start so many at a time (ulimit -u).
bool may_start_threads(int count) {
  std::latch end(1);
  std::vector<std::jthread> threads;
  bool is_allowed = true;
  try {
    for (int i = 0; i < count; ++i) threads.emplace_back([&end] { end.wait(); });
  } catch (const std::system_error&) {
    is_allowed = false;
  }
  end.count_down();
  return is_allowed;
}

void choose_threads(std::size_t needed) {
  const int threads = thread_count();
  if (!is_room_for(needed + each_thread * static_cast<std::size_t>(threads + other_threads)) ||
      !may_start_threads(threads + other_threads)) {
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

WindowSize fitted(WindowSize size) {
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return size;
  int x = 0, y = 0, width = 0, height = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
  if (width < least_window_width || height < least_window_height) return size;
  // Where a window's coordinates are pixels, GLFW makes it larger by the display's scale.
  float scale = 1.0F;
  if (glfwGetPlatform() == GLFW_PLATFORM_X11) glfwGetMonitorContentScale(monitor, &scale, nullptr);
  const auto before_scaling = [scale](int length) { return static_cast<int>(static_cast<float>(length) / scale); };
  return {std::min(size.width, before_scaling(width)), std::min(size.height, before_scaling(height))};
}

GLFWmonitor* monitor_of(GLFWwindow* window) {
  int x = 0, y = 0, width = 0, height = 0;
  glfwGetWindowPos(window, &x, &y);
  glfwGetWindowSize(window, &width, &height);
  GLFWmonitor* best = glfwGetPrimaryMonitor();
  int most = 0;
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  for (int i = 0; i < count; ++i) {
    int left = 0, top = 0;
    glfwGetMonitorPos(monitors[i], &left, &top);
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
    if (mode == nullptr) continue;
    const int across = std::min(x + width, left + mode->width) - std::max(x, left);
    const int down = std::min(y + height, top + mode->height) - std::max(y, top);
    if (const int shared = std::max(0, across) * std::max(0, down); shared > most) {
      most = shared;
      best = monitors[i];
    }
  }
  return best;
}

}  // namespace ghostforce
