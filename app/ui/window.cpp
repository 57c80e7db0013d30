#include "app/ui/window.h"

#include <glad/gl.h>

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>
#include <implot.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "app/console/failure.h"
#include "app/paint/font_file.h"
#include "app/paint/font_texture.h"
#include "app/paint/gl/handle.h"
#include "app/ui/display_loss.h"
#include "app/ui/drawing_memory.h"
#include "app/ui/key_layout.h"
#include "app/ui/monitors.h"
#include "app/ui/offscreen_driver.h"

// Of the GLFW backend, which exports it for those who feed Dear ImGui themselves, but declares it nowhere.
ImGuiKey ImGui_ImplGlfw_KeyToImGuiKey(int key, int scancode);

// ImGui's OpenGL backend has a loader of its own that looks into libGL, where it finds nothing under OSMesa. This is
// its entry for a loader that knows better.
extern "C" int imgl3wInit2(void (*(*)(const char*))());

namespace ghostforce {
namespace {

std::string last_glfw_error() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description != nullptr ? description : "no reason given";
}

// In place of the one that the backend measures by its own clock. ImGui wants time to pass in every frame.
void set_interval(double interval_s) {
  ImGui::GetIO().DeltaTime = static_cast<float>(std::max(interval_s, 1e-6));
}

void draw_on_framebuffer() {
  whiten_empty_texels(*ImGui::GetDrawData());
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

constexpr const char* offscreen_advice =
    "pictures can be made without a display: ghostforce render wall45 -o wall45.png";

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

GLFWwindow* create_window(const WindowOptions& options) {
  glfwDefaultWindowHints();
  if (options.offscreen) glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_OSMESA_CONTEXT_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "ghostforce");
  glfwWindowHintString(GLFW_WAYLAND_APP_ID, "ghostforce");
  WindowSize size{options.width, options.height};
  if (options.fits_monitor) size = fitted(size);
  GLFWwindow* window = glfwCreateWindow(size.width, size.height, options.title.c_str(), nullptr, nullptr);
  if (window != nullptr) return window;
  const std::string reason = last_glfw_error();
  if (options.offscreen) {
    throw Failure(ExitCode::no_display,
                  fmt::format("cannot draw offscreen: {} (there is {}); this needs OSMesa with OpenGL 3.3, Debian's "
                              "package libosmesa6",
                              reason, describe_lesser_opengl()));
  }
  throw Failure(ExitCode::no_display, fmt::format("the window needs OpenGL 3.3, but there is {} ({}); a newer graphics "
                                                  "driver may help, and {}",
                                                  describe_lesser_opengl(), reason, offscreen_advice));
}

}  // namespace

Window::Library::Library(const WindowOptions& options) {
  const bool offscreen = options.offscreen;
  if (offscreen) choose_offscreen_driver();
  make_room_for_drawing(options.width, options.height,
                        offscreen ? "make the picture smaller, or an .svg or .pdf" : "close other programs");
  // Asking for Wayland where there is none makes its library complain on stderr.
  const int on_display = std::getenv("WAYLAND_DISPLAY") != nullptr ? GLFW_ANY_PLATFORM : GLFW_PLATFORM_X11;
  glfwInitHint(GLFW_PLATFORM, offscreen ? GLFW_PLATFORM_NULL : on_display);
  if (glfwInit() == GLFW_TRUE) {
    watch_display();
    return;
  }
  const std::string reason = last_glfw_error();
  glfwTerminate();
  throw Failure(ExitCode::no_display,
                fmt::format("there is no display to open a window on ({}); {}", reason, offscreen_advice));
}

Window::Library::~Library() {
  glfwTerminate();
}

void Window::Destroy::operator()(GLFWwindow* window) const {
  glfwDestroyWindow(window);
}

Window::Window(const WindowOptions& options) : library_(options), window_(create_window(options)) {
  glfwMakeContextCurrent(handle());
  if (gladLoadGL(glfwGetProcAddress) < GLAD_MAKE_VERSION(3, 3)) {
    throw Failure(ExitCode::no_display,
                  fmt::format("the driver offers OpenGL 3.3, but it cannot be loaded: {}", graphics_description()));
  }
  glfwSwapInterval(options.offscreen ? 0 : 1);
  if (!options.offscreen) {
    glfwSetWindowSizeLimits(handle(), least_window_width, least_window_height, GLFW_DONT_CARE, GLFW_DONT_CARE);
  }
  glfwSetWindowUserPointer(handle(), this);
  glfwSetCursorPosCallback(handle(), on_pointer);  // these before ImGui's, which then call them
  glfwSetCursorEnterCallback(handle(), on_anything);
  glfwSetMouseButtonCallback(handle(), on_act);
  glfwSetScrollCallback(handle(), on_act);
  glfwSetWindowFocusCallback(handle(), on_anything);
  glfwSetWindowRefreshCallback(handle(), on_anything);  // ImGui has none for this and the next two
  glfwSetWindowIconifyCallback(handle(), on_anything);
  glfwSetFramebufferSizeCallback(handle(), on_anything);
  glfwSetDropCallback(handle(), on_drop);
  glfwSetWindowSizeCallback(handle(), on_resize);  // ImGui has none
  glfwGetWindowSize(handle(), &restored_size_.width, &restored_size_.height);
  start_imgui(options.takes_mouse);
  glfwSetKeyCallback(handle(), on_key);  // in place of ImGui's: it gets what is handed on
  glfwSetCharCallback(handle(), on_character);
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImPlot::DestroyContext();
  ImGui::DestroyContext();
}

void Window::start_imgui(bool takes_mouse) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImPlot::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // nothing is written to the working directory
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  io.ConfigFlags |= takes_mouse ? ImGuiConfigFlags_None : ImGuiConfigFlags_NoMouse;
  ImGui_ImplGlfw_InitForOpenGL(handle(), true);
  imgl3wInit2(glfwGetProcAddress);
  ImGui_ImplOpenGL3_Init("#version 330 core");
  fonts_.regular = io.Fonts->AddFontFromFileTTF(font_file(label_font_file).c_str());
  fonts_.bold = io.Fonts->AddFontFromFileTTF(font_file(bold_label_font_file).c_str());
  fonts_.number = io.Fonts->AddFontFromFileTTF(font_file("DejaVuSansMono.ttf").c_str());
}

bool Window::should_close() const {
  return glfwWindowShouldClose(handle()) == GLFW_TRUE;
}

void Window::close() {
  glfwSetWindowShouldClose(handle(), GLFW_TRUE);
}

void Window::stay_open() {
  glfwSetWindowCloseCallback(handle(), [](GLFWwindow* window) { glfwSetWindowShouldClose(window, GLFW_FALSE); });
  glfwSetWindowAttrib(handle(), GLFW_AUTO_ICONIFY, GLFW_FALSE);
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(handle(), title.c_str());
}

void Window::resize(int width, int height) {
  glfwSetWindowSize(handle(), width, height);
}

float Window::display_scale() const {
  // Where the framebuffer is denser than the window's coordinates (Wayland), ImGui draws denser by itself.
  int width = 0;
  glfwGetWindowSize(handle(), &width, nullptr);
  if (width > 0 && pixel_width() != width) return 1.0F;
  float scale = 1.0F;
  glfwGetWindowContentScale(handle(), &scale, nullptr);
  return scale > 0.0F ? scale : 1.0F;
}

int Window::pixel_width() const {
  int width = 0;
  glfwGetFramebufferSize(handle(), &width, nullptr);
  return width * density_;
}

int Window::pixel_height() const {
  int height = 0;
  glfwGetFramebufferSize(handle(), nullptr, &height);
  return height * density_;
}

bool Window::is_full_screen() const {
  return glfwGetWindowMonitor(handle()) != nullptr;
}

bool Window::is_maximized() const {
  return glfwGetWindowAttrib(handle(), GLFW_MAXIMIZED) == GLFW_TRUE;
}

bool Window::has_focus() const {
  // Without a display there is nobody to give it; what a test says about it is known to ImGui.
  if (glfwGetPlatform() == GLFW_PLATFORM_NULL) return !ImGui::GetIO().AppFocusLost;
  return glfwGetWindowAttrib(handle(), GLFW_FOCUSED) == GLFW_TRUE;
}

void Window::maximize() {
  glfwMaximizeWindow(handle());
}

void Window::restore(int width, int height) {
  if (is_full_screen()) toggle_full_screen();
  if (is_maximized()) glfwRestoreWindow(handle());
  const auto scaled = [this](int length) {
    return static_cast<int>(std::lround(static_cast<float>(length) * display_scale()));
  };
  const WindowSize size = fitted({width, height});
  resize(scaled(size.width), scaled(size.height));
}

WindowSize Window::restored_size() const {
  WindowSize size = restored_size_;
  if (!is_full_screen() && !is_maximized()) glfwGetWindowSize(handle(), &size.width, &size.height);
  const auto unscaled = [this](int length) {
    return static_cast<int>(std::lround(static_cast<float>(length) / display_scale()));
  };
  return {unscaled(size.width), unscaled(size.height)};
}

void Window::toggle_full_screen() {
  if (is_full_screen()) {
    glfwSetWindowMonitor(handle(), nullptr, restored_corner_.x, restored_corner_.y, restored_size_.width,
                         restored_size_.height, 0);
    return;
  }
  GLFWmonitor* const monitor = monitor_of(handle());
  const GLFWvidmode* const mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  if (mode == nullptr) return;
  if (!is_maximized()) glfwGetWindowSize(handle(), &restored_size_.width, &restored_size_.height);
  glfwGetWindowPos(handle(), &restored_corner_.x, &restored_corner_.y);
  glfwSetWindowMonitor(handle(), monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

template <typename... What>
void Window::on_anything(GLFWwindow* handle, What...) {
  static_cast<Window*>(glfwGetWindowUserPointer(handle))->is_stirred_ = true;
}

template <typename... What>
void Window::on_act(GLFWwindow* handle, What... what) {
  on_anything(handle, what...);
  static_cast<Window*>(glfwGetWindowUserPointer(handle))->touch_.has_acted = true;
}

void Window::on_pointer(GLFWwindow* handle, double x, double y) {
  on_anything(handle, x, y);
  static_cast<Window*>(glfwGetWindowUserPointer(handle))->touch_.has_moved = true;
}

Window::Touch Window::take_touch() noexcept {
  return std::exchange(touch_, {});
}

namespace {

constexpr int known_modifiers = GLFW_MOD_SHIFT | GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;

}  // namespace

void Window::on_key(GLFWwindow* handle, int key, int scancode, int action, int modifiers) {
  on_act(handle);
  auto& window = *static_cast<Window*>(glfwGetWindowUserPointer(handle));
  const bool is_down = action != GLFW_RELEASE;
  // X11 tells the modifiers as they were before a modifier's own key.
  const int own = modifier_of(key);
  modifiers = is_down ? modifiers | own : modifiers & ~own;
  const int chosen = key_by_layout(key, glfwGetKeyName(key, scancode));
  window.key_events_.push_back({{chosen, modifiers & known_modifiers, action == GLFW_REPEAT}, is_down, scancode});
  window.awaits_character_ = is_down;
}

// GLFW tells it right after the key that has typed it; what an input method composes has none.
void Window::on_character(GLFWwindow* handle, unsigned int character) {
  on_act(handle);
  auto& window = *static_cast<Window*>(glfwGetWindowUserPointer(handle));
  if (!std::exchange(window.awaits_character_, false) || window.key_events_.empty()) {
    window.key_events_.push_back({.press = {}, .character = character});
    return;
  }
  KeyEvent& event = window.key_events_.back();
  event.press = press_by_character(event.press, character);
  event.character = character;
}

void Window::hand_on(const KeyEvent& event) {
  ImGuiIO& io = ImGui::GetIO();
  if (event.press.key != 0) {
    const auto is_held = [&](int modifier) { return (event.press.modifiers & modifier) != 0; };
    io.AddKeyEvent(ImGuiMod_Ctrl, is_held(GLFW_MOD_CONTROL));
    io.AddKeyEvent(ImGuiMod_Shift, is_held(GLFW_MOD_SHIFT));
    io.AddKeyEvent(ImGuiMod_Alt, is_held(GLFW_MOD_ALT));
    io.AddKeyEvent(ImGuiMod_Super, is_held(GLFW_MOD_SUPER));
    // By themselves these keys would open menus that there are not.
    if (modifier_of(event.press.key) == 0) {
      io.AddKeyEvent(ImGui_ImplGlfw_KeyToImGuiKey(event.press.key, event.scancode), event.is_down);
    }
  }
  if (event.character != 0) io.AddInputCharacter(event.character);
}

void Window::on_resize(GLFWwindow* handle, int width, int height) {
  auto& window = *static_cast<Window*>(glfwGetWindowUserPointer(handle));
  if (!window.is_full_screen() && !window.is_maximized()) window.restored_size_ = {width, height};
}

void Window::on_drop(GLFWwindow* handle, int count, const char** paths) {
  on_anything(handle);
  auto& window = *static_cast<Window*>(glfwGetWindowUserPointer(handle));
  window.dropped_files_.insert(window.dropped_files_.end(), paths, paths + count);
}

bool Window::poll(double wait_s) {
  if (wait_s > 0.0) {
    glfwWaitEventsTimeout(wait_s);
  } else {
    glfwPollEvents();
  }
  end_if_display_is_lost();
  return std::exchange(is_stirred_, false);
}

void Window::frame(double interval_s, const std::function<void()>& draw) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  set_interval(interval_s);
  ImGui::NewFrame();
  draw();
  ImGui::Render();
  if (pixel_width() > 0 && pixel_height() > 0) draw_on_framebuffer();
  glfwSwapBuffers(handle());
}

void Window::set_visible_drawing(bool is_on) {
  (is_on ? glDisable : glEnable)(GL_RASTERIZER_DISCARD);
}

Image Window::picture() const {
  Image image{pixel_width(), pixel_height(), {}};
  const std::ptrdiff_t row = 3 * std::ptrdiff_t{image.width};
  image.rgb.resize(static_cast<std::size_t>(row) * static_cast<std::size_t>(image.height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, image.width, image.height, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  // OpenGL counts rows from below.
  for (int y = 0; y < image.height / 2; ++y) {
    const auto upper = image.rgb.begin() + row * y;
    std::swap_ranges(upper, upper + row, image.rgb.end() - row * (y + 1));
  }
  return image;
}

Image Window::picture_of(int density, const std::function<void()>& draw) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  if (std::max(pixel_width(), pixel_height()) * density > largest) {
    throw Failure(ExitCode::wrong_call, fmt::format("the graphics driver draws pictures of {} pixels at most each way; "
                                                    "choose a smaller one",
                                                    largest));
  }
  // Whatever happens, the next frame is the window's again.
  struct Guard {
    int& density;
    ~Guard() {
      density = 1;
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }
  } const guard{density_};
  density_ = density;
  gl::Framebuffer framebuffer;
  gl::Renderbuffer colours;
  glBindRenderbuffer(GL_RENDERBUFFER, colours.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, pixel_width(), pixel_height());
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours.name());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Failure(ExitCode::wrong_call,
                  "the graphics driver has no room for a picture of this size; choose a smaller "
                  "one");
  }

  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  set_interval(0.0);
  ImGuiIO& io = ImGui::GetIO();
  const ImVec2 pointer = io.MousePos;
  io.DisplayFramebufferScale.x *= static_cast<float>(density);
  io.DisplayFramebufferScale.y *= static_cast<float>(density);
  io.AddMousePosEvent(-FLT_MAX, -FLT_MAX);
  ImGui::NewFrame();
  draw();
  ImGui::Render();
  draw_on_framebuffer();
  Image image = picture();
  io.AddMousePosEvent(pointer.x, pointer.y);
  return image;
}

std::string Window::graphics_description() const {
  const auto text = [](GLenum name) {
    const GLubyte* value = glGetString != nullptr ? glGetString(name) : nullptr;
    return value != nullptr ? reinterpret_cast<const char*>(value) : "unknown";
  };
  return fmt::format("{}, OpenGL {}", text(GL_RENDERER), text(GL_VERSION));
}

}  // namespace ghostforce
