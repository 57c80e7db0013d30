#include "app/shell/desktop/opengl_window.h"

#include <glad/gl.h>

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <cstdlib>
#include <string_view>

#include "app/base/failure.h"
#include "app/shell/desktop/display_loss.h"
#include "app/shell/desktop/drawing_memory.h"
#include "app/shell/desktop/monitors.h"
#include "app/shell/desktop/offscreen_driver.h"
#include "app/shell/window.h"

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

}  // namespace ghostforce
