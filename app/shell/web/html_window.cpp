#include "app/shell/web/html_window.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <emscripten/html5.h>
#include <imgui.h>

#include "app/base/failure.h"
#include "app/files/file_exchange.h"
#include "app/shell/web/browser.h"
#include "app/state/key_bindings.h"
#include "app/state/keys.h"
#include "app/widgets/focus.h"

namespace ghostforce {
namespace {

constexpr const char* canvas = "#stage";

// The only character of a UTF-8 text; 0: there are none, or several ("Enter").
std::uint32_t only_character(std::string_view text) noexcept {
  if (text.empty()) return 0;
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = first < 0x80U ? 1 : first < 0xE0U ? 2 : first < 0xF0U ? 3 : 4;
  if (text.size() != length) return 0;
  constexpr std::array<unsigned, 5> masks{0, 0x7FU, 0x1FU, 0x0FU, 0x07U};
  std::uint32_t character = first & masks[length];
  for (const char next : text.substr(1)) character = character << 6U | (static_cast<unsigned char>(next) & 0x3FU);
  return character;
}

int modifiers_of(const EmscriptenKeyboardEvent& event) noexcept {
  return (event.shiftKey ? modifier::shift : 0) | (event.ctrlKey ? modifier::control : 0) |
         (event.altKey ? modifier::alt : 0) | (event.metaKey ? modifier::super : 0);
}

// A field that somebody types into needs all keys that edit; the browser keeps copying and pasting, which tell the
// page.
bool edits_field(const KeyPress& press) noexcept {
  return ImGui::GetIO().WantTextInput && press.key < key::f1 && press.key != key::v;
}

}  // namespace

// What the browser calls. Each says whether the browser may not act on it too.
struct HtmlWindow::Events {
  static HtmlWindow& window_of(void* window) { return *static_cast<HtmlWindow*>(window); }

  static bool key(int type, const EmscriptenKeyboardEvent* event, void* data) {
    HtmlWindow& window = window_of(data);
    const bool is_down = type == EMSCRIPTEN_EVENT_KEYDOWN;
    if (is_down && (browser::shows_dialog() || !browser::canvas_has_keys())) return false;
    const KeyPress press{key_of_code(event->code), modifiers_of(*event), event->repeat};
    if (press.key == key::tab && !(window.uses_tab() && browser::canvas_has_focus())) return false;
    if (is_down && press.key == key::escape && !window.uses_escape()) browser::leave_canvas();
    const std::uint32_t character = only_character(event->key);
    // With Shift a key types another sign than the one that it is called by; letters stay letters.
    const bool is_letter = character < 0x80U && std::isalpha(static_cast<int>(character)) != 0;
    const char* const printed = character != 0 && (!event->shiftKey || is_letter) ? event->key : nullptr;
    // What is pasted comes after its key.
    if (is_down && press.key == key::v && press.modifiers == modifier::control) return false;
    if (press.key != 0) window.add_key_event(press, printed, is_down);
    // AltGr is Control and Alt on some systems.
    const bool types = character != 0 && event->ctrlKey == event->altKey && !event->metaKey;
    if (is_down && types) window.add_character(character);
    return is_down && (is_ours(press, ImGui::GetIO().WantTextInput) || edits_field(press));
  }

  static bool mouse(int type, const EmscriptenMouseEvent* event, void* data) {
    HtmlWindow& window = window_of(data);
    ImGuiIO& io = ImGui::GetIO();
    io.AddMousePosEvent(static_cast<float>(event->clientX), static_cast<float>(event->clientY));
    window.note_move();
    if (type == EMSCRIPTEN_EVENT_MOUSEMOVE) return false;
    window.note_act();
    constexpr std::array buttons{ImGuiMouseButton_Left, ImGuiMouseButton_Middle, ImGuiMouseButton_Right};
    if (event->button < buttons.size()) {
      io.AddMouseButtonEvent(buttons[event->button], type == EMSCRIPTEN_EVENT_MOUSEDOWN);
    }
    return false;
  }

  static bool leave(int /*type*/, const EmscriptenMouseEvent* event, void* data) {
    // What is being dragged may leave the page.
    if (event->buttons == 0) ImGui::GetIO().AddMousePosEvent(-FLT_MAX, -FLT_MAX);
    window_of(data).note_move();
    return false;
  }

  static bool wheel(int /*type*/, const EmscriptenWheelEvent* event, void* data) {
    constexpr double pixels_per_notch = 100.0;
    constexpr double lines_per_notch = 3.0;
    const double unit = event->deltaMode == DOM_DELTA_PIXEL  ? pixels_per_notch
                        : event->deltaMode == DOM_DELTA_LINE ? lines_per_notch
                                                             : 1.0;
    ImGui::GetIO().AddMouseWheelEvent(static_cast<float>(-event->deltaX / unit),
                                      static_cast<float>(-event->deltaY / unit));
    window_of(data).note_act();
    return true;  // else the browser zooms too
  }

  static bool touch(int type, const EmscriptenTouchEvent* event, void* data) {
    HtmlWindow& window = window_of(data);
    std::vector<Vector<2>> fingers;
    for (int i = 0; i < event->numTouches; ++i) {
      const EmscriptenTouchPoint& point = event->touches[i];
      const bool has_left =
          point.isChanged && (type == EMSCRIPTEN_EVENT_TOUCHEND || type == EMSCRIPTEN_EVENT_TOUCHCANCEL);
      if (!has_left) fingers.push_back({static_cast<double>(point.clientX), static_cast<double>(point.clientY)});
    }
    window.touches_.follow(fingers, browser::clock_s());
    window.note_act();
    window.note_move();
    return true;  // else a mouse is made up too
  }

  static bool focus(int type, const EmscriptenFocusEvent* /*event*/, void* data) {
    ImGui::GetIO().AddFocusEvent(type == EMSCRIPTEN_EVENT_FOCUS);
    window_of(data).note_change();
    return false;
  }

  static bool context(int type, const void* /*reserved*/, void* data) {
    HtmlWindow& window = window_of(data);
    window.is_lost_ = type == EMSCRIPTEN_EVENT_WEBGLCONTEXTLOST;
    window.is_restored_ = !window.is_lost_;
    if (window.is_lost_) ++window.context_losses_;
    window.note_change();
    return true;  // else it never comes back
  }
};

HtmlWindow::HtmlWindow() {
  EmscriptenWebGLContextAttributes attributes;
  emscripten_webgl_init_context_attributes(&attributes);
  attributes.majorVersion = 2;
  attributes.alpha = false;
  attributes.depth = attributes.stencil = attributes.antialias = false;
  context_ = emscripten_webgl_create_context(canvas, &attributes);
  if (context_ == 0) {
    throw Failure(
        ExitCode::no_display,
        "This page draws with WebGL 2, which this browser does not offer here. Allow hardware acceleration in "
        "its settings, or open the page in a newer browser.");
  }
  emscripten_webgl_make_context_current(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.BackendPlatformName = "html";
  io.AddFocusEvent(browser::has_focus());
  ImGuiPlatformIO& platform = ImGui::GetPlatformIO();
  platform.Platform_ClipboardUserData = this;
  platform.Platform_SetClipboardTextFn = [](ImGuiContext*, const char* text) { browser::copy_text(text); };
  platform.Platform_GetClipboardTextFn = [](ImGuiContext*) {
    static std::string text;
    text = browser::pasted_text();
    return text.c_str();
  };
  take_events(0.0);
  start_drawing(true);
  listen();
}

HtmlWindow::~HtmlWindow() {
  stop_drawing();
  emscripten_webgl_destroy_context(context_);
}

void HtmlWindow::listen() {
  constexpr bool early = true;  // before anything else on the page
  const char* const everywhere = EMSCRIPTEN_EVENT_TARGET_WINDOW;
  emscripten_set_keydown_callback(everywhere, this, early, Events::key);
  emscripten_set_keyup_callback(everywhere, this, early, Events::key);
  emscripten_set_mousemove_callback(everywhere, this, early, Events::mouse);
  emscripten_set_mouseup_callback(everywhere, this, early, Events::mouse);
  emscripten_set_mousedown_callback(canvas, this, early, Events::mouse);
  emscripten_set_mouseleave_callback(canvas, this, early, Events::leave);
  emscripten_set_wheel_callback(canvas, this, early, Events::wheel);
  emscripten_set_touchstart_callback(canvas, this, early, Events::touch);
  emscripten_set_touchmove_callback(canvas, this, early, Events::touch);
  emscripten_set_touchend_callback(canvas, this, early, Events::touch);
  emscripten_set_touchcancel_callback(canvas, this, early, Events::touch);
  emscripten_set_focus_callback(everywhere, this, early, Events::focus);
  emscripten_set_blur_callback(everywhere, this, early, Events::focus);
  emscripten_set_webglcontextlost_callback(canvas, this, early, Events::context);
  emscripten_set_webglcontextrestored_callback(canvas, this, early, Events::context);
  browser::listen();
  listen_for_files_from_outside();
}

bool HtmlWindow::uses_tab() const {
  return key_uses_.tab;
}

bool HtmlWindow::uses_escape() const {
  const bool has_menu = !ImGui::GetCurrentContext()->OpenPopupStack.empty();
  return key_uses_.escape || has_menu || ImGui::GetIO().WantTextInput || ghostforce::has_focus();
}

bool HtmlWindow::take_restored() noexcept {
  const bool was_restored = std::exchange(is_restored_, false);
  if (was_restored) restart_drawing();
  return was_restored;
}

void HtmlWindow::set_title(const std::string& title) {
  emscripten_set_window_title(title.c_str());
}

void HtmlWindow::toggle_full_screen() {
  browser::toggle_full_screen();
}

bool HtmlWindow::is_full_screen() const {
  return browser::is_full_screen();
}

bool HtmlWindow::has_focus() const {
  return browser::has_focus();
}

void HtmlWindow::set_clipboard_text(const std::string& text) {
  browser::copy_text(text);
}

std::optional<std::string> HtmlWindow::clipboard_text() {
  return browser::pasted_text();
}

// The browser has told what happened between the frames. What is left is how large the tab is by now.
void HtmlWindow::take_events(double /*wait_s*/) {
  double width = 0.0;
  double height = 0.0;
  emscripten_get_element_css_size(canvas, &width, &height);
  const double density = emscripten_get_device_pixel_ratio();
  const auto whole = [](double length) { return static_cast<int>(std::lround(length)); };
  const WindowSize pixels{whole(width * density), whole(height * density)};
  size_ = {whole(width), whole(height)};
  if (pixels.width != pixels_.width || pixels.height != pixels_.height) {
    pixels_ = pixels;
    emscripten_set_canvas_element_size(canvas, pixels.width, pixels.height);
    note_change();
  }
  if (browser::take_paste()) add_paste();
  touches_.advance(browser::clock_s());
  if (FileAnswer chosen = take_chosen_files(); !chosen.paths.empty()) add_dropped_files(std::move(chosen.paths));
}

void HtmlWindow::begin_imgui_frame() {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(size_.width), static_cast<float>(size_.height)};
  if (size_.width > 0 && size_.height > 0) {
    io.DisplayFramebufferScale = {static_cast<float>(pixels_.width) / io.DisplaySize.x,
                                  static_cast<float>(pixels_.height) / io.DisplaySize.y};
  }
}

namespace {

struct CodeEntry {
  std::string_view code;
  int key;
};

constexpr std::array codes{
    CodeEntry{"Space", key::space},
    CodeEntry{"Quote", key::apostrophe},
    CodeEntry{"Comma", key::comma},
    CodeEntry{"Minus", key::minus},
    CodeEntry{"Period", key::period},
    CodeEntry{"Slash", key::slash},
    CodeEntry{"Semicolon", key::semicolon},
    CodeEntry{"Equal", key::equal},
    CodeEntry{"BracketLeft", key::left_bracket},
    CodeEntry{"Backslash", key::backslash},
    CodeEntry{"BracketRight", key::right_bracket},
    CodeEntry{"Backquote", key::grave_accent},
    CodeEntry{"IntlBackslash", key::world_1},
    CodeEntry{"Escape", key::escape},
    CodeEntry{"Enter", key::enter},
    CodeEntry{"Tab", key::tab},
    CodeEntry{"Backspace", key::backspace},
    CodeEntry{"Insert", key::insert},
    CodeEntry{"Delete", key::delete_forward},
    CodeEntry{"ArrowRight", key::right},
    CodeEntry{"ArrowLeft", key::left},
    CodeEntry{"ArrowDown", key::down},
    CodeEntry{"ArrowUp", key::up},
    CodeEntry{"PageUp", key::page_up},
    CodeEntry{"PageDown", key::page_down},
    CodeEntry{"Home", key::home},
    CodeEntry{"End", key::end},
    CodeEntry{"CapsLock", key::caps_lock},
    CodeEntry{"ScrollLock", key::scroll_lock},
    CodeEntry{"NumLock", key::number_lock},
    CodeEntry{"PrintScreen", key::print_screen},
    CodeEntry{"Pause", key::pause},
    CodeEntry{"F1", key::f1},
    CodeEntry{"F2", key::f2},
    CodeEntry{"F3", key::f3},
    CodeEntry{"F4", key::f4},
    CodeEntry{"F5", key::f5},
    CodeEntry{"F6", key::f6},
    CodeEntry{"F7", key::f7},
    CodeEntry{"F8", key::f8},
    CodeEntry{"F9", key::f9},
    CodeEntry{"F10", key::f10},
    CodeEntry{"F11", key::f11},
    CodeEntry{"F12", key::f12},
    CodeEntry{"NumpadDecimal", key::number_pad_decimal},
    CodeEntry{"NumpadDivide", key::number_pad_divide},
    CodeEntry{"NumpadMultiply", key::number_pad_multiply},
    CodeEntry{"NumpadSubtract", key::number_pad_subtract},
    CodeEntry{"NumpadAdd", key::number_pad_add},
    CodeEntry{"NumpadEnter", key::number_pad_enter},
    CodeEntry{"NumpadEqual", key::number_pad_equal},
    CodeEntry{"ShiftLeft", key::left_shift},
    CodeEntry{"ControlLeft", key::left_control},
    CodeEntry{"AltLeft", key::left_alt},
    CodeEntry{"MetaLeft", key::left_super},
    CodeEntry{"ShiftRight", key::right_shift},
    CodeEntry{"ControlRight", key::right_control},
    CodeEntry{"AltRight", key::right_alt},
    CodeEntry{"MetaRight", key::right_super},
    CodeEntry{"ContextMenu", key::menu},
};

// KeyA, Digit7, Numpad7: the last letter of a code that is nothing else.
bool is_between(std::string_view code, std::string_view begins, char first, char last) noexcept {
  return code.size() == begins.size() + 1 && code.starts_with(begins) && code.back() >= first && code.back() <= last;
}

}  // namespace

int key_of_code(std::string_view code) noexcept {
  if (is_between(code, "Key", 'A', 'Z')) return key::a + (code.back() - 'A');
  if (is_between(code, "Digit", '0', '9')) return key::digit_0 + (code.back() - '0');
  if (is_between(code, "Numpad", '0', '9')) return key::number_pad_0 + (code.back() - '0');
  const auto entry = std::ranges::find(codes, code, &CodeEntry::code);
  return entry != codes.end() ? entry->key : 0;
}

}  // namespace ghostforce
