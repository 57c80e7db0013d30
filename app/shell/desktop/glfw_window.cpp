#include "app/shell/desktop/glfw_window.h"

#include <chrono>
#include <cmath>
#include <system_error>
#include <utility>

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui_impl_glfw.h>

#include "app/shell/desktop/display_watch.h"
#include "app/shell/desktop/glfw_audience_window.h"
#include "app/shell/keyboard.h"
#include "app/state/keys.h"

// ImGui's OpenGL backend has a loader of its own that looks into libGL, where it finds nothing under OSMesa. This is
// its entry for a loader that knows better.
extern "C" int imgl3wInit2(void (*(*)(const char*))());

// GLFW's header for it wants those of Xlib.
extern "C" unsigned long glfwGetX11Window(GLFWwindow* window);

namespace ghostforce {

GlfwWindow::GlfwWindow(const WindowOptions& options) : opengl_(OpenGlWindow::open(options)) {
  if (options.offscreen) {
    fit_canvas();
  } else {
    glfwSwapInterval(1);
    glfwSetWindowSizeLimits(handle(), least_window_width, least_window_height, GLFW_DONT_CARE, GLFW_DONT_CARE);
  }
  glfwSetWindowUserPointer(handle(), this);
  glfwSetCursorPosCallback(handle(), on_pointer);  // these before ImGui's, which then call them
  glfwSetCursorEnterCallback(handle(), on_anything);
  glfwSetMouseButtonCallback(handle(), on_act);
  glfwSetScrollCallback(handle(), on_act);
  glfwSetWindowFocusCallback(handle(), on_focus);
  glfwSetWindowRefreshCallback(handle(), on_anything);  // ImGui has none for this and the next two
  glfwSetWindowIconifyCallback(handle(), on_anything);
  glfwSetFramebufferSizeCallback(handle(), on_anything);
  glfwSetDropCallback(handle(), on_drop);
  glfwSetWindowSizeCallback(handle(), on_resize);  // ImGui has none
  restored_size_ = size();
  imgl3wInit2(opengl_.loader());
  start_drawing(options.takes_mouse);
  ImGui_ImplGlfw_InitForOpenGL(handle(), true);
  glfwSetKeyCallback(handle(), on_key);  // in place of ImGui's: it gets what is handed on
  glfwSetCharCallback(handle(), on_character);
  if (glfwGetPlatform() == GLFW_PLATFORM_X11) x11_clipboard_.emplace();
  if (glfwGetPlatform() == GLFW_PLATFORM_WAYLAND) wayland_clipboard_.emplace();
  ImGuiPlatformIO& platform = ImGui::GetPlatformIO();
  platform.Platform_ClipboardUserData = this;
  platform.Platform_SetClipboardTextFn = [](ImGuiContext*, const char* text) {
    static_cast<GlfwWindow*>(ImGui::GetPlatformIO().Platform_ClipboardUserData)->set_clipboard_text(text);
  };
  platform.Platform_GetClipboardTextFn = [](ImGuiContext*) -> const char* {
    auto* const window = static_cast<GlfwWindow*>(ImGui::GetPlatformIO().Platform_ClipboardUserData);
    std::optional<std::string> text = window->clipboard_text();
    if (!text) return nullptr;  // nothing is pasted into the field yet
    window->pasting_.field_text = *std::move(text);
    return window->pasting_.field_text.c_str();
  };
}

GlfwWindow::~GlfwWindow() {
  stop_drawing();
  ImGui_ImplGlfw_Shutdown();
}

bool GlfwWindow::should_close() const {
  return glfwWindowShouldClose(handle()) == GLFW_TRUE;
}

void GlfwWindow::close() {
  glfwSetWindowShouldClose(handle(), GLFW_TRUE);
}

void GlfwWindow::stay_open() {
  glfwSetWindowCloseCallback(handle(), [](GLFWwindow* window) { glfwSetWindowShouldClose(window, GLFW_FALSE); });
  glfwSetWindowAttrib(handle(), GLFW_AUTO_ICONIFY, GLFW_FALSE);
}

void GlfwWindow::set_title(const std::string& title) {
  glfwSetWindowTitle(handle(), title.c_str());
}

void GlfwWindow::resize(int width, int height) {
  glfwSetWindowSize(handle(), width, height);
}

float GlfwWindow::display_scale() const {
  // Where the framebuffer is denser than the window's coordinates (Wayland), ImGui draws denser by itself.
  const int width = size().width;
  if (width > 0 && pixel_width() != width) return 1.0F;
  float scale = 1.0F;
  glfwGetWindowContentScale(handle(), &scale, nullptr);
  return scale > 0.0F ? scale : 1.0F;
}

WindowSize GlfwWindow::size() const {
  WindowSize size;
  glfwGetWindowSize(handle(), &size.width, &size.height);
  return size;
}

WindowSize GlfwWindow::framebuffer_size() const {
  WindowSize size;
  glfwGetFramebufferSize(handle(), &size.width, &size.height);
  return size;
}

bool GlfwWindow::is_full_screen() const {
  return glfwGetWindowMonitor(handle()) != nullptr;
}

bool GlfwWindow::is_maximized() const {
  return glfwGetWindowAttrib(handle(), GLFW_MAXIMIZED) == GLFW_TRUE;
}

bool GlfwWindow::has_focus() const {
  // Without a display there is nobody to give it; a test may say that it is gone.
  if (glfwGetPlatform() == GLFW_PLATFORM_NULL) return was_told_of_focus_;
  const DisplayWatch* const watch = opengl_.watch();
  return glfwGetWindowAttrib(handle(), GLFW_FOCUSED) == GLFW_TRUE && (watch == nullptr || !watch->keyboard_is_taken());
}

void GlfwWindow::maximize() {
  glfwMaximizeWindow(handle());
}

void GlfwWindow::restore(int width, int height) {
  if (is_full_screen()) toggle_full_screen();
  if (is_maximized()) glfwRestoreWindow(handle());
  const auto scaled = [this](int length) {
    return static_cast<int>(std::lround(static_cast<float>(length) * display_scale()));
  };
  const WindowSize fitting = fitted({width, height});
  resize(scaled(fitting.width), scaled(fitting.height));
}

WindowSize GlfwWindow::restored_size() const {
  const WindowSize restored = !is_full_screen() && !is_maximized() ? size() : restored_size_;
  const auto unscaled = [this](int length) {
    return static_cast<int>(std::lround(static_cast<float>(length) / display_scale()));
  };
  return {unscaled(restored.width), unscaled(restored.height)};
}

void GlfwWindow::toggle_full_screen() {
  if (is_full_screen()) {
    glfwSetWindowMonitor(handle(), nullptr, restored_corner_.x, restored_corner_.y, restored_size_.width,
                         restored_size_.height, 0);
    return;
  }
  GLFWmonitor* const monitor = monitor_of(handle());
  const GLFWvidmode* const mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  if (mode == nullptr) return;
  if (!is_maximized()) restored_size_ = size();
  glfwGetWindowPos(handle(), &restored_corner_.x, &restored_corner_.y);
  glfwSetWindowMonitor(handle(), monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

namespace {

GlfwWindow& window_of(GLFWwindow* handle) {
  return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(handle));
}

// GLFW's keys are ours (app/state/keys.h).
static_assert(GLFW_KEY_SPACE == key::space && GLFW_KEY_APOSTROPHE == key::apostrophe && GLFW_KEY_COMMA == key::comma &&
              GLFW_KEY_MINUS == key::minus && GLFW_KEY_PERIOD == key::period && GLFW_KEY_SLASH == key::slash &&
              GLFW_KEY_SEMICOLON == key::semicolon && GLFW_KEY_EQUAL == key::equal &&
              GLFW_KEY_LEFT_BRACKET == key::left_bracket && GLFW_KEY_BACKSLASH == key::backslash &&
              GLFW_KEY_RIGHT_BRACKET == key::right_bracket && GLFW_KEY_GRAVE_ACCENT == key::grave_accent);
static_assert(GLFW_KEY_0 == key::digit_0 && GLFW_KEY_9 == key::digit_9 && GLFW_KEY_A == key::a && GLFW_KEY_Z == key::z);
static_assert(GLFW_KEY_WORLD_1 == key::world_1 && GLFW_KEY_WORLD_2 == key::world_2);
static_assert(GLFW_KEY_ESCAPE == key::escape && GLFW_KEY_ENTER == key::enter && GLFW_KEY_TAB == key::tab &&
              GLFW_KEY_BACKSPACE == key::backspace && GLFW_KEY_INSERT == key::insert &&
              GLFW_KEY_DELETE == key::delete_forward && GLFW_KEY_RIGHT == key::right && GLFW_KEY_LEFT == key::left &&
              GLFW_KEY_DOWN == key::down && GLFW_KEY_UP == key::up && GLFW_KEY_PAGE_UP == key::page_up &&
              GLFW_KEY_PAGE_DOWN == key::page_down && GLFW_KEY_HOME == key::home && GLFW_KEY_END == key::end &&
              GLFW_KEY_CAPS_LOCK == key::caps_lock && GLFW_KEY_SCROLL_LOCK == key::scroll_lock &&
              GLFW_KEY_NUM_LOCK == key::number_lock && GLFW_KEY_PRINT_SCREEN == key::print_screen &&
              GLFW_KEY_PAUSE == key::pause);
static_assert(GLFW_KEY_F1 == key::f1 && GLFW_KEY_F12 == key::f12 && GLFW_KEY_F24 == key::f24);
static_assert(GLFW_KEY_KP_0 == key::number_pad_0 && GLFW_KEY_KP_9 == key::number_pad_9 &&
              GLFW_KEY_KP_DECIMAL == key::number_pad_decimal && GLFW_KEY_KP_DIVIDE == key::number_pad_divide &&
              GLFW_KEY_KP_MULTIPLY == key::number_pad_multiply && GLFW_KEY_KP_SUBTRACT == key::number_pad_subtract &&
              GLFW_KEY_KP_ADD == key::number_pad_add && GLFW_KEY_KP_ENTER == key::number_pad_enter &&
              GLFW_KEY_KP_EQUAL == key::number_pad_equal);
static_assert(GLFW_KEY_LEFT_SHIFT == key::left_shift && GLFW_KEY_LEFT_CONTROL == key::left_control &&
              GLFW_KEY_LEFT_ALT == key::left_alt && GLFW_KEY_LEFT_SUPER == key::left_super &&
              GLFW_KEY_RIGHT_SHIFT == key::right_shift && GLFW_KEY_RIGHT_CONTROL == key::right_control &&
              GLFW_KEY_RIGHT_ALT == key::right_alt && GLFW_KEY_RIGHT_SUPER == key::right_super &&
              GLFW_KEY_MENU == key::menu && GLFW_KEY_LAST == key::last);
static_assert(GLFW_MOD_SHIFT == modifier::shift && GLFW_MOD_CONTROL == modifier::control &&
              GLFW_MOD_ALT == modifier::alt && GLFW_MOD_SUPER == modifier::super);

constexpr int known_modifiers = GLFW_MOD_SHIFT | GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;

}  // namespace

template <typename... What>
void GlfwWindow::on_anything(GLFWwindow* handle, What...) {
  window_of(handle).note_change();
}

template <typename... What>
void GlfwWindow::on_act(GLFWwindow* handle, What...) {
  window_of(handle).note_act();
}

void GlfwWindow::on_focus(GLFWwindow* handle, int is_focused) {
  window_of(handle).was_told_of_focus_ = is_focused == GLFW_TRUE;
  window_of(handle).note_change();
}

void GlfwWindow::on_pointer(GLFWwindow* handle, double /*x*/, double /*y*/) {
  window_of(handle).note_move();
}

void GlfwWindow::on_key(GLFWwindow* handle, int key, int scancode, int action, int modifiers) {
  window_of(handle).add_key_event({key, modifiers & known_modifiers, action == GLFW_REPEAT},
                                  glfwGetKeyName(key, scancode), action != GLFW_RELEASE);
}

// GLFW tells it right after the key that has typed it; what an input method composes has none.
void GlfwWindow::on_character(GLFWwindow* handle, unsigned int character) {
  window_of(handle).add_character(character);
}

void GlfwWindow::on_resize(GLFWwindow* handle, int width, int height) {
  GlfwWindow& window = window_of(handle);
  if (!window.is_full_screen() && !window.is_maximized()) window.restored_size_ = {width, height};
}

void GlfwWindow::on_drop(GLFWwindow* handle, int count, const char** paths) {
  window_of(handle).add_dropped_files({paths, paths + count});
}

void GlfwWindow::take_events(double wait_s) {
  if (wait_s > 0.0) {
    glfwWaitEventsTimeout(wait_s);
  } else {
    glfwPollEvents();
  }
  if (wayland_clipboard_) wayland_clipboard_->poll();
  take_text_read();
  const DisplayWatch* const watch = opengl_.watch();
  end_if_display_is_lost(watch != nullptr ? watch->loss() : DisplayLoss::none);
}

// As large as the window has become. Mesa rounds along edges as in a window's own framebuffer where, like that, it is
// rasterised from above and has depth and stencil, which nothing here uses.
void GlfwWindow::fit_canvas() {
  const auto [width, height] = framebuffer_size();
  if (canvas_ && canvas_->width() == width && canvas_->height() == height) return;
  canvas_.emplace(width, height);
  depth_.emplace();
  glBindRenderbuffer(GL_RENDERBUFFER, depth_->name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_->name());
  if (GLAD_GL_MESA_framebuffer_flip_y != 0) {
    glFramebufferParameteriMESA(GL_FRAMEBUFFER, GL_FRAMEBUFFER_FLIP_Y_MESA, GL_TRUE);
  }
}

void GlfwWindow::begin_imgui_frame() {
  if (canvas_) fit_canvas();
  ImGui_ImplGlfw_NewFrame();
}

void GlfwWindow::show_frame() {
  if (!canvas_) glfwSwapBuffers(handle());
}

std::unique_ptr<AudienceWindow> GlfwWindow::open_audience(const std::string& title) {
  return std::make_unique<GlfwAudienceWindow>(
      GlfwAudienceWindow::FirstWindow{handle(), fonts(), canvas_.has_value(), on_key, on_character, on_anything<>},
      title);
}

std::string GlfwWindow::portal_name() const {
  return glfwGetPlatform() == GLFW_PLATFORM_X11 ? fmt::format("x11:{:x}", glfwGetX11Window(handle())) : std::string();
}

void GlfwWindow::set_clipboard_text(const std::string& text) {
  if (x11_clipboard_) return x11_clipboard_->copy(handle(), text);
  if (wayland_clipboard_ && wayland_clipboard_->copy(text)) return;
  glfwSetClipboardString(handle(), text.c_str());
}

// By a thread of its own: the text's owner is another program, and neither the frames nor the motors wait for it.
std::optional<std::string> GlfwWindow::clipboard_text() {
  if (!x11_clipboard_ && !wayland_clipboard_) {
    const char* const text = glfwGetClipboardString(handle());
    return text == nullptr ? "" : text;
  }
  if (pasting_.untaken > 0) {
    --pasting_.untaken;
    return pasting_.text;
  }
  ++pasting_.asked;
  if (!pasting_.reading.valid()) begin_reading();
  return std::nullopt;
}

void GlfwWindow::begin_reading() {
  std::packaged_task<std::string()> task(x11_clipboard_ ? [] { return X11Clipboard::text(); }
                                                        : [] { return WaylandClipboard::text(); });
  pasting_.reading = task.get_future();
  try {
    pasting_.reader = std::jthread([task = std::move(task)]() mutable {
      task();
      glfwPostEmptyEvent();
    });
  } catch (const std::system_error& error) {
    pasting_.reading = {};
    pasting_.asked = 0;
    note_clipboard_problem(fmt::format("The clipboard cannot be read: {}.", error.code().message()));
  }
}

void GlfwWindow::take_text_read() {
  // Nobody has taken it, and it may not be the clipboard's any more.
  if (!Keyboard::is_waiting(*this)) pasting_.untaken = 0;
  if (!pasting_.reading.valid()) return;
  if (pasting_.reading.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  const int asked = std::exchange(pasting_.asked, 0);
  try {
    pasting_.text = pasting_.reading.get();
    pasting_.untaken = asked;
    for (int i = 0; i < asked; ++i) add_paste();
  } catch (const Failure& failure) {
    note_clipboard_problem(failure.what());
  }
}

DisplayKind GlfwWindow::display_kind() const {
  switch (glfwGetPlatform()) {
    case GLFW_PLATFORM_X11:
      return DisplayKind::x11;
    case GLFW_PLATFORM_WAYLAND:
      return DisplayKind::wayland;
    default:
      return DisplayKind::none;
  }
}

}  // namespace ghostforce
