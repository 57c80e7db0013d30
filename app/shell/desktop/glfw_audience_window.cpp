#include "app/shell/desktop/glfw_audience_window.h"

#include <algorithm>
#include <utility>

#include <GLFW/glfw3.h>
#include <glad/gl.h>
#include <imgui_impl_opengl3.h>

#include "app/base/failure.h"
#include "app/shell/desktop/opengl_window.h"

namespace ghostforce {
namespace {

constexpr WindowSize usual_size{960, 540};
constexpr int beside_first = 48;  // of the first window's corner [screen coordinates]
constexpr double double_click_s = 0.4;

GLFWwindow* create_audience_window(const GlfwAudienceWindow::FirstWindow& first, const std::string& title) {
  hint_window(first.is_offscreen ? std::optional(Renderer::egl) : std::nullopt);
  // Keys stay with the first window, and with them its motors; and it is full screen while the first one has them.
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHint(GLFW_FOCUSED, GLFW_FALSE);
  glfwWindowHint(GLFW_FOCUS_ON_SHOW, GLFW_FALSE);
  glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
  const auto [width, height] = fitted(usual_size);
  GLFWwindow* const window =
      glfwCreateWindow(width, height, title.c_str(), nullptr, first.is_offscreen ? nullptr : first.handle);
  if (window == nullptr) throw Failure(ExitCode::no_display, "The desktop opens no second window.");
  return window;
}

DesktopArea area_of(GLFWmonitor* monitor) {
  DesktopArea area;
  glfwGetMonitorPos(monitor, &area.x, &area.y);
  if (const GLFWvidmode* const mode = glfwGetVideoMode(monitor)) {
    area.width = mode->width;
    area.height = mode->height;
  }
  return area;
}

// Null: there is no other.
GLFWmonitor* other_monitor(GLFWwindow* first) {
  GLFWmonitor* const own = monitor_of(first);
  if (own == nullptr) return nullptr;
  int count = 0;
  GLFWmonitor** const monitors = glfwGetMonitors(&count);
  std::vector<DesktopArea> areas;
  for (int i = 0; i < count; ++i) areas.push_back(area_of(monitors[i]));
  const auto apart = find_area_apart(area_of(own), areas);
  return apart ? monitors[*apart] : nullptr;
}

GlfwAudienceWindow& audience_window_of(GLFWwindow* handle) {
  return *static_cast<GlfwAudienceWindow*>(glfwGetWindowUserPointer(handle));
}

}  // namespace

// While it lives, what is drawn is this window's.
class GlfwAudienceWindow::Target {
 public:
  explicit Target(const GlfwAudienceWindow& window) : window_(window) {
    if (window.canvas_) {
      glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before_);
      window.canvas_->bind();
    } else {
      glfwMakeContextCurrent(window.handle());
    }
  }
  ~Target() {
    if (window_.canvas_) {
      glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before_));
    } else {
      glfwMakeContextCurrent(window_.first_.handle);
    }
  }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

 private:
  const GlfwAudienceWindow& window_;
  GLint before_ = 0;
};

void GlfwAudienceWindow::Destroy::operator()(GLFWwindow* window) const {
  glfwDestroyWindow(window);
}

GlfwAudienceWindow::GlfwAudienceWindow(const FirstWindow& first, const std::string& title)
    : first_(first), window_(create_audience_window(first, title)), words_(ImGui::GetDrawListSharedData()) {
  if (first.is_offscreen) {
    GLint before = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
    canvas_.emplace(usual_size.width, usual_size.height);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before));
  }
  {
    const Target target(*this);
    painter_.emplace(first.fonts);
    if (!canvas_) glfwSwapInterval(0);  // the first window waits for its display already
  }
  glfwSetWindowUserPointer(handle(), this);
  glfwSetKeyCallback(handle(), on_key);
  glfwSetCharCallback(handle(), on_character);
  glfwSetMouseButtonCallback(handle(), on_button);
  glfwSetWindowRefreshCallback(handle(), on_change);
  glfwSetWindowCloseCallback(handle(), on_change);
  glfwSetFramebufferSizeCallback(handle(), on_change);
  stand_beside_first();
  if (GLFWmonitor* const other = other_monitor(first.handle)) fill(other);
  glfwShowWindow(handle());
}

GlfwAudienceWindow::~GlfwAudienceWindow() {
  const Target target(*this);
  painter_.reset();
}

bool GlfwAudienceWindow::should_close() const {
  return glfwWindowShouldClose(handle()) == GLFW_TRUE;
}

Vector<2> GlfwAudienceWindow::size() const {
  WindowSize size;
  glfwGetWindowSize(handle(), &size.width, &size.height);
  return {size.width, size.height};
}

bool GlfwAudienceWindow::is_full_screen() const {
  return glfwGetWindowMonitor(handle()) != nullptr;
}

void GlfwAudienceWindow::stand_beside_first() {
  int x = 0, y = 0;
  glfwGetWindowPos(first_.handle, &x, &y);
  const auto [width, height] = fitted(usual_size);
  glfwSetWindowMonitor(handle(), nullptr, x + beside_first, y + beside_first, width, height, 0);
  fills_monitor_ = false;
}

void GlfwAudienceWindow::fill(GLFWmonitor* monitor) {
  const GLFWvidmode* const mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  if (mode == nullptr) return;
  glfwSetWindowMonitor(handle(), monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  fills_monitor_ = true;
}

void GlfwAudienceWindow::toggle_full_screen() {
  is_full_screen() ? stand_beside_first() : fill(monitor_of(handle()));
}

void GlfwAudienceWindow::prepare(std::vector<Pane> panes, const Theme& theme) {
  panes_ = std::move(panes);
  theme_ = theme;
  const Vector<2> extent = size();
  words_._ResetForNewFrame();
  words_.PushTexture(ImGui::GetIO().Fonts->TexRef);
  words_.PushClipRect({0.0F, 0.0F}, {static_cast<float>(extent.x), static_cast<float>(extent.y)});
  for (const Pane& pane : panes_) {
    const ImVec2 corner{static_cast<float>(pane.corner.x), static_cast<float>(pane.corner.y)};
    paint_labels(pane.marks, pane.camera, first_.fonts, corner, 1.0, words_);
  }
}

void GlfwAudienceWindow::show() {
  // GLFW leaves a window as large as its monitor was when that is gone.
  if (fills_monitor_ && !is_full_screen()) stand_beside_first();
  int width = 0, height = 0;
  glfwGetFramebufferSize(handle(), &width, &height);
  const Vector<2> extent = size();
  if (width <= 0 || height <= 0 || extent.x <= 0.0) return;
  const Target target(*this);
  if (canvas_ && (canvas_->width() != width || canvas_->height() != height)) canvas_.emplace(width, height);
  const double density = width / extent.x;
  painter_->paint_without_words(panes_, theme_, {0.0F, 0.0F}, density, width, height);
  ImDrawData words;
  words.Valid = true;
  words.DisplaySize = {static_cast<float>(extent.x), static_cast<float>(extent.y)};
  words.FramebufferScale = {static_cast<float>(density), static_cast<float>(density)};
  words.AddDrawList(&words_);
  ImGui_ImplOpenGL3_RenderDrawData(&words);
  if (!canvas_) glfwSwapBuffers(handle());
}

Image GlfwAudienceWindow::picture() const {
  const Target target(*this);
  return gl::pixels_drawn(canvas_->width(), canvas_->height());
}

void GlfwAudienceWindow::on_key(GLFWwindow* handle, int key, int scancode, int action, int modifiers) {
  GlfwAudienceWindow& window = audience_window_of(handle);
  if (key != GLFW_KEY_F11) {
    window.first_.on_key(window.first_.handle, key, scancode, action, modifiers);
  } else if (action == GLFW_PRESS) {
    window.toggle_full_screen();
  }
}

void GlfwAudienceWindow::on_character(GLFWwindow* handle, unsigned int character) {
  const FirstWindow& first = audience_window_of(handle).first_;
  first.on_character(first.handle, character);
}

void GlfwAudienceWindow::on_button(GLFWwindow* handle, int button, int action, int /*modifiers*/) {
  if (button != GLFW_MOUSE_BUTTON_LEFT || action != GLFW_PRESS) return;
  GlfwAudienceWindow& window = audience_window_of(handle);
  const double now_s = glfwGetTime();
  const bool is_double = now_s - std::exchange(window.pressed_at_s_, now_s) <= double_click_s;
  if (!is_double) return;
  window.pressed_at_s_ = -1.0;
  window.toggle_full_screen();
}

template <typename... What>
void GlfwAudienceWindow::on_change(GLFWwindow* handle, What...) {
  const FirstWindow& first = audience_window_of(handle).first_;
  first.on_change(first.handle);
}

std::optional<std::size_t> find_area_apart(const DesktopArea& own, std::span<const DesktopArea> all) noexcept {
  const auto found = std::ranges::find_if(all, [&own](const DesktopArea& area) {
    const bool is_beside = area.x >= own.x + own.width || own.x >= area.x + area.width;
    const bool is_below = area.y >= own.y + own.height || own.y >= area.y + area.height;
    return area.width > 0 && area.height > 0 && (is_beside || is_below);
  });
  return found == all.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - all.begin()));
}

}  // namespace ghostforce
