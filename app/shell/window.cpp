#include "app/shell/window.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <imgui_impl_opengl3.h>
#include <implot.h>

#include "app/paint/canvas.h"
#include "app/paint/font_file.h"
#include "app/shell/audience_window.h"
#include "app/state/keys.h"

namespace ghostforce {
namespace {

constexpr std::size_t channels = 4;  // red, green, blue, alpha

void whiten(ImTextureData& texture, const ImTextureRect& part) {
  for (int y = part.y; y < part.y + part.h; ++y) {
    const std::span row(static_cast<unsigned char*>(texture.GetPixelsAt(part.x, y)), channels * part.w);
    for (std::size_t texel = 0; texel < row.size(); texel += channels) {
      if (row[texel + 3] == 0) row[texel] = row[texel + 1] = row[texel + 2] = 0xFF;
    }
  }
}

// Makes the empty texels of new textures white and transparent, where Dear ImGui leaves them black and transparent.
// Letters between pixels blend with the texels around them: black ones darkened a letter's edges, and a pale halo had
// grey lines and dots beside it. Between ImGui::Render() and the backend's drawing, which uploads the textures.
void whiten_empty_texels(const ImDrawData& drawing) {
  for (ImTextureData* const texture : *drawing.Textures) {
    if (texture->Format != ImTextureFormat_RGBA32) continue;
    if (texture->Status == ImTextureStatus_WantCreate) {
      whiten(*texture,
             {0, 0, static_cast<unsigned short>(texture->Width), static_cast<unsigned short>(texture->Height)});
    } else if (texture->Status == ImTextureStatus_WantUpdates) {
      for (const ImTextureRect& update : texture->Updates) whiten(*texture, update);
    }
  }
}

void draw_on_framebuffer() {
  whiten_empty_texels(*ImGui::GetDrawData());
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace

Window::Window() {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImPlot::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // nothing is written to the working directory
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
}

Window::~Window() {
  ImPlot::DestroyContext();
  ImGui::DestroyContext();
}

void Window::start_drawing(bool takes_mouse) {
  // What may throw comes first: nobody calls stop_drawing() then.
  const std::string regular = font_file(label_font_file);
  const std::string bold = font_file(bold_label_font_file);
  const std::string number = font_file("DejaVuSansMono.ttf");
  ImGuiIO& io = ImGui::GetIO();
  io.ConfigFlags |= takes_mouse ? ImGuiConfigFlags_None : ImGuiConfigFlags_NoMouse;
  ImGui_ImplOpenGL3_Init(gl::shader_version);
  fonts_.regular = io.Fonts->AddFontFromFileTTF(regular.c_str());
  fonts_.bold = io.Fonts->AddFontFromFileTTF(bold.c_str());
  fonts_.number = io.Fonts->AddFontFromFileTTF(number.c_str());
}

void Window::stop_drawing() noexcept {
  ImGui_ImplOpenGL3_Shutdown();
}

void Window::restart_drawing() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplOpenGL3_Init(gl::shader_version);
}

int Window::pixel_width() const {
  return framebuffer_size().width * density_;
}

int Window::pixel_height() const {
  return framebuffer_size().height * density_;
}

void Window::note_act() noexcept {
  note_change();
  touch_.has_acted = true;
}

void Window::note_move() noexcept {
  note_change();
  touch_.has_moved = true;
}

Window::Touch Window::take_touch() noexcept {
  return std::exchange(touch_, {});
}

void Window::add_key_event(KeyPress press, const char* printed, bool is_down) {
  note_act();
  // X11 tells the modifiers as they were before a modifier's own key.
  const int own = modifier_of(press.key);
  press.modifiers = is_down ? press.modifiers | own : press.modifiers & ~own;
  press.key = key_by_layout(press.key, printed);
  key_events_.push_back({.press = press, .is_down = is_down});
  awaits_character_ = is_down;
}

void Window::add_character(std::uint32_t character) {
  note_act();
  if (!std::exchange(awaits_character_, false) || key_events_.empty()) {
    key_events_.push_back({.press = {}, .character = character});
    return;
  }
  KeyEvent& event = key_events_.back();
  event.press = press_by_character(event.press, character);
  event.character = character;
}

void Window::hand_on(const KeyEvent& event) {
  ImGuiIO& io = ImGui::GetIO();
  if (event.press.key != 0) {
    const auto is_held = [&](int which) { return (event.press.modifiers & which) != 0; };
    io.AddKeyEvent(ImGuiMod_Ctrl, is_held(modifier::control));
    io.AddKeyEvent(ImGuiMod_Shift, is_held(modifier::shift));
    io.AddKeyEvent(ImGuiMod_Alt, is_held(modifier::alt));
    io.AddKeyEvent(ImGuiMod_Super, is_held(modifier::super));
    // By themselves these keys would open menus that there are not.
    if (modifier_of(event.press.key) == 0) io.AddKeyEvent(imgui_key(event.press.key), event.is_down);
  }
  if (event.character != 0) io.AddInputCharacter(event.character);
}

// Dear ImGui takes no press of a key that is down already, as V may still be; and Ctrl may have been up for long.
void Window::add_paste() {
  constexpr KeyPress paste{key::v, modifier::control, false};
  add_key_event(paste, nullptr, false);
  add_key_event(paste, nullptr, true);
  add_key_event(paste, nullptr, false);
  add_key_event({key::left_control, modifier::control, false}, nullptr, false);
}

void Window::note_clipboard_problem(std::string problem) {
  note_change();
  clipboard_problem_ = std::move(problem);
}

void Window::add_dropped_files(std::vector<std::string> paths) {
  note_change();
  std::ranges::move(paths, std::back_inserter(dropped_files_));
}

std::vector<std::string> Window::take_dropped_files() {
  return std::exchange(dropped_files_, {});
}

bool Window::poll(double wait_s) {
  take_events(wait_s);
  return std::exchange(is_stirred_, false);
}

void Window::begin_frame(double interval_s) {
  ImGui_ImplOpenGL3_NewFrame();
  begin_imgui_frame();
  // In place of the one that a backend measures by its own clock. ImGui wants time to pass in every frame.
  ImGui::GetIO().DeltaTime = static_cast<float>(std::max(interval_s, 1e-6));
}

void Window::frame(double interval_s, const std::function<void()>& draw) {
  begin_frame(interval_s);
  ImGui::NewFrame();
  draw();
  ImGui::Render();
  if (pixel_width() > 0 && pixel_height() > 0) draw_on_framebuffer();
  show_frame();
}

std::unique_ptr<AudienceWindow> Window::open_audience(const std::string& /*title*/) {
  return nullptr;
}

void Window::set_visible_drawing(bool is_on) {
  (is_on ? glDisable : glEnable)(GL_RASTERIZER_DISCARD);
}

Image Window::picture() const {
  return gl::pixels_drawn(pixel_width(), pixel_height());
}

Image Window::picture_of(int density, const std::function<void()>& draw) {
  GLint before = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
  // Whatever happens, the next frame is the window's again.
  struct Guard {
    int& density;
    GLuint framebuffer;
    ~Guard() {
      density = 1;
      glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    }
  } const guard{density_, static_cast<GLuint>(before)};
  density_ = density;
  const gl::Canvas canvas(pixel_width(), pixel_height());

  begin_frame(0.0);
  ImGuiIO& io = ImGui::GetIO();
  const ImVec2 pointer = io.MousePos;
  const ImVec2 scale = io.DisplayFramebufferScale;
  io.DisplayFramebufferScale.x *= static_cast<float>(density);
  io.DisplayFramebufferScale.y *= static_cast<float>(density);
  io.AddMousePosEvent(-FLT_MAX, -FLT_MAX);
  ImGui::NewFrame();
  draw();
  ImGui::Render();
  draw_on_framebuffer();
  Image image = picture();
  io.AddMousePosEvent(pointer.x, pointer.y);
  io.DisplayFramebufferScale = scale;
  return image;
}

std::string Window::graphics_description() {
  const auto text = [](GLenum name) {
    const GLubyte* value = glGetString(name);
    return value != nullptr ? reinterpret_cast<const char*>(value) : "unknown";
  };
  return fmt::format("{}, OpenGL {}", text(GL_RENDERER), text(GL_VERSION));
}

namespace {

// Keys that stand in both lists one after another.
struct KeyRow {
  int first, last;
  ImGuiKey first_of_imgui;
};
constexpr std::array key_rows{
    KeyRow{key::digit_0, key::digit_9, ImGuiKey_0},
    KeyRow{key::a, key::z, ImGuiKey_A},
    KeyRow{key::f1, key::f24, ImGuiKey_F1},
    KeyRow{key::number_pad_0, key::number_pad_9, ImGuiKey_Keypad0},
};

}  // namespace

ImGuiKey imgui_key(int key) noexcept {
  for (const KeyRow& row : key_rows) {
    if (key >= row.first && key <= row.last) return static_cast<ImGuiKey>(row.first_of_imgui + (key - row.first));
  }
  switch (key) {
    case key::space:
      return ImGuiKey_Space;
    case key::apostrophe:
      return ImGuiKey_Apostrophe;
    case key::comma:
      return ImGuiKey_Comma;
    case key::minus:
      return ImGuiKey_Minus;
    case key::period:
      return ImGuiKey_Period;
    case key::slash:
      return ImGuiKey_Slash;
    case key::semicolon:
      return ImGuiKey_Semicolon;
    case key::equal:
      return ImGuiKey_Equal;
    case key::left_bracket:
      return ImGuiKey_LeftBracket;
    case key::backslash:
      return ImGuiKey_Backslash;
    case key::right_bracket:
      return ImGuiKey_RightBracket;
    case key::grave_accent:
      return ImGuiKey_GraveAccent;
    case key::world_1:
      return ImGuiKey_Oem102;
    case key::world_2:
      return ImGuiKey_Oem102;
    case key::escape:
      return ImGuiKey_Escape;
    case key::enter:
      return ImGuiKey_Enter;
    case key::tab:
      return ImGuiKey_Tab;
    case key::backspace:
      return ImGuiKey_Backspace;
    case key::insert:
      return ImGuiKey_Insert;
    case key::delete_forward:
      return ImGuiKey_Delete;
    case key::right:
      return ImGuiKey_RightArrow;
    case key::left:
      return ImGuiKey_LeftArrow;
    case key::down:
      return ImGuiKey_DownArrow;
    case key::up:
      return ImGuiKey_UpArrow;
    case key::page_up:
      return ImGuiKey_PageUp;
    case key::page_down:
      return ImGuiKey_PageDown;
    case key::home:
      return ImGuiKey_Home;
    case key::end:
      return ImGuiKey_End;
    case key::caps_lock:
      return ImGuiKey_CapsLock;
    case key::scroll_lock:
      return ImGuiKey_ScrollLock;
    case key::number_lock:
      return ImGuiKey_NumLock;
    case key::print_screen:
      return ImGuiKey_PrintScreen;
    case key::pause:
      return ImGuiKey_Pause;
    case key::number_pad_decimal:
      return ImGuiKey_KeypadDecimal;
    case key::number_pad_divide:
      return ImGuiKey_KeypadDivide;
    case key::number_pad_multiply:
      return ImGuiKey_KeypadMultiply;
    case key::number_pad_subtract:
      return ImGuiKey_KeypadSubtract;
    case key::number_pad_add:
      return ImGuiKey_KeypadAdd;
    case key::number_pad_enter:
      return ImGuiKey_KeypadEnter;
    case key::number_pad_equal:
      return ImGuiKey_KeypadEqual;
    case key::left_shift:
      return ImGuiKey_LeftShift;
    case key::left_control:
      return ImGuiKey_LeftCtrl;
    case key::left_alt:
      return ImGuiKey_LeftAlt;
    case key::left_super:
      return ImGuiKey_LeftSuper;
    case key::right_shift:
      return ImGuiKey_RightShift;
    case key::right_control:
      return ImGuiKey_RightCtrl;
    case key::right_alt:
      return ImGuiKey_RightAlt;
    case key::right_super:
      return ImGuiKey_RightSuper;
    case key::menu:
      return ImGuiKey_Menu;
    default:
      return ImGuiKey_None;
  }
}

int key_by_layout(int key, const char* name) noexcept {
  const bool is_on_number_pad = key >= key::number_pad_0 && key <= key::number_pad_equal;
  if (is_on_number_pad || name == nullptr || name[0] == '\0' || name[1] != '\0') return key;
  const char sign = name[0];
  if (sign >= 'a' && sign <= 'z') return key::a + (sign - 'a');
  if (sign >= 'A' && sign <= 'Z') return key::a + (sign - 'A');
  switch (sign) {
    case '.':
      return key::period;
    case ',':
      return key::comma;
    case '[':
      return key::left_bracket;
    case ']':
      return key::right_bracket;
    case '-':
      return key::minus;
    case '+':
      return key::equal;
    default:
      return key;
  }
}

KeyPress press_by_character(KeyPress press, std::uint32_t character) noexcept {
  switch (character) {
    case '+':
      press.key = key::equal;
      break;
    case '-':
    case 0x2212:  // the sign itself
      press.key = key::minus;
      break;
    case '[':
      press.key = key::left_bracket;
      break;
    case ']':
      press.key = key::right_bracket;
      break;
    default:
      return press;
  }
  press.modifiers &= ~modifier::shift;
  return press;
}

int modifier_of(int key) noexcept {
  switch (key) {
    case key::left_shift:
    case key::right_shift:
      return modifier::shift;
    case key::left_control:
    case key::right_control:
      return modifier::control;
    case key::left_alt:
    case key::right_alt:
      return modifier::alt;
    case key::left_super:
    case key::right_super:
      return modifier::super;
    default:
      return 0;
  }
}

}  // namespace ghostforce
