#include "app/shell/keyboard.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include <imgui_internal.h>

#include "app/state/keys.h"
#include "app/widgets/focus.h"
#include "app/workbench/dialogs.h"

namespace ghostforce {
namespace {

// Until Dear ImGui has moved the focus, and until a window has appeared and its field takes letters [frames].
constexpr int focus_moves = 2;
constexpr int window_appears = 3;

bool is_enter(int key) {
  return key == key::enter || key == key::number_pad_enter;
}

bool is_arrow(int key) {
  return key == key::left || key == key::right || key == key::up || key == key::down;
}

bool is_end(int key) {
  return key == key::home || key == key::end;
}

bool is_typing() {
  return ImGui::GetCurrentContext()->WantTextInputNextFrame > 0;
}

bool is_menu_open() {
  return !ImGui::GetCurrentContext()->OpenPopupStack.empty();
}

// Of what was handed on. It takes one press of a key in a frame.
bool has_imgui_more_to_take() {
  return std::ranges::any_of(ImGui::GetCurrentContext()->InputEventsQueue, [](const ImGuiInputEvent& event) {
    return event.Type == ImGuiInputEventType_Key || event.Type == ImGuiInputEventType_Text;
  });
}

std::optional<Nudge> nudge_of(const KeyPress& press) {
  if (press.key == key::home) return Nudge{Nudge::Way::to_least};
  if (press.key == key::end) return Nudge{Nudge::Way::to_greatest};
  if (!is_arrow(press.key)) return std::nullopt;
  const bool is_fine = (press.modifiers & (modifier::shift | modifier::alt)) != 0;
  const bool is_coarse = (press.modifiers & modifier::control) != 0;
  const double size = is_fine ? 0.1 : is_coarse ? 10.0 : 1.0;
  const bool is_up = press.key == key::right || press.key == key::up;
  return Nudge{Nudge::Way::step, is_up ? size : -size};
}

// The arrows to the sides do nothing there, but they are not the goal's either.
std::optional<ScrollStep> scroll_of(const KeyPress& press) {
  constexpr float everything = 1e6F;
  constexpr float lines_of_an_arrow = 3.0F;
  if (press.modifiers != 0) return std::nullopt;
  switch (press.key) {
    case key::down:
      return ScrollStep{.lines = lines_of_an_arrow};
    case key::up:
      return ScrollStep{.lines = -lines_of_an_arrow};
    case key::left:
    case key::right:
      return ScrollStep{};
    case key::page_down:
      return ScrollStep{.pages = 1.0F};
    case key::page_up:
      return ScrollStep{.pages = -1.0F};
    case key::home:
      return ScrollStep{.pages = -everything};
    case key::end:
      return ScrollStep{.pages = everything};
    default:
      return std::nullopt;
  }
}

// In a field arrows, Home and End move the cursor or a mark.
bool is_page(int key) {
  return key == key::page_down || key == key::page_up;
}

}  // namespace

bool Keyboard::is_waiting(Window& window) {
  return !window.key_events().empty() || has_imgui_more_to_take();
}

void Keyboard::wait(int frames) {
  frames_to_wait_ = std::max(frames_to_wait_, frames);
}

// A dialog that closes leaves the focus as it was when it opened; another face, and another visitor, begins without.
void Keyboard::follow_windows(const Session& session) {
  const bool was_open = dialog_ != Dialog::none;
  const bool is_open = session.dialog != Dialog::none;
  if (!was_open && is_open) had_focus_ = has_focus();
  if (was_open && !is_open && !had_focus_) leave_focus();
  const std::uint32_t departures = session.kiosk_visit ? session.kiosk_visit->departures : 0;
  const bool is_other_visitor = std::exchange(departures_, departures) != departures;
  if (face_ != session.face || is_other_visitor) leave_focus();
  dialog_ = session.dialog;
  face_ = session.face;
}

void Keyboard::take(Window& window, const Session& session, const ActionSink& apply) {
  has_pressed_ = false;
  frames_to_wait_ = std::max(0, frames_to_wait_ - 1);
  follow_windows(session);
  std::deque<KeyEvent>& events = window.key_events();
  if (!has_imgui_more_to_take()) {
    while (!events.empty() && frames_to_wait_ == 0) {
      const KeyEvent event = events.front();
      events.pop_front();
      act(event, session, apply);
      follow_windows(session);
    }
  }
  // Whatever waits, this does not.
  const auto turns_off = [](const KeyEvent& event) { return event.is_down && event.press.key == key::escape; };
  if (session.has_motors && std::ranges::any_of(events, turns_off)) apply(StopMotors{});
}

void Keyboard::act(const KeyEvent& event, const Session& session, const ActionSink& apply) {
  const KeyPress& press = event.press;
  // Who drags something may press a modifier on the way.
  if (!event.is_down || press.key == 0 || modifier_of(press.key) != 0) return Window::hand_on(event);
  has_pressed_ = true;
  if (press.key == key::escape) {
    Window::hand_on(event);
    wait(focus_moves);
    const bool leaves_dialog = session.dialog != Dialog::none && !is_menu_open();
    const bool leaves_control = is_menu_open() || is_typing();
    if (!leaves_dialog) leave_focus();
    if (leaves_dialog || !leaves_control) return act_on_table(press, session, false, apply);
    if (session.has_motors) apply(StopMotors{});
    return;
  }
  if (press.key == key::tab) {
    Window::hand_on(event);
    return wait(focus_moves);
  }
  if (const auto step = scroll_of(press); step && scrolls(session.dialog)) {
    const bool belongs_to_control = is_menu_open() || ((is_typing() || has_focus()) && !is_page(press.key));
    if (!belongs_to_control) return scroll(session.dialog, *step);
  }
  if (is_typing()) {
    Window::hand_on(event);
    if (is_enter(press.key)) wait(focus_moves);
    return act_on_table(press, session, true, apply);
  }
  if (is_menu_open() && (is_arrow(press.key) || is_end(press.key) || is_enter(press.key))) {
    Window::hand_on(event);
    return wait(focus_moves);
  }
  if (has_focus() && is_enter(press.key)) {
    Window::hand_on(event);
    return wait(window_appears);
  }
  if (has_focus() && (is_arrow(press.key) || is_end(press.key))) {
    if (const auto nudge = nudge_of(press); nudge && focus_takes_arrows()) {
      nudge_focused(*nudge);
      // Each press is a change of its own to take back; those of a key held down are one.
      if (!press.is_repeat) wait(1);
    } else {
      Window::hand_on(event);
      wait(focus_moves);
    }
    return;
  }
  // What is typed at a dialog whose field has lost the focus is for no shortcut.
  act_on_table(press, session, has_field(session.dialog), apply);
}

void Keyboard::act_on_table(const KeyPress& press, const Session& session, bool is_typing, const ActionSink& apply) {
  const auto window_of = [&] { return std::tuple(session.dialog, session.face); };
  const auto picture_of = [&] { return std::tuple(session.stage.mode, session.stage.reveals_asked, session.scene); };
  const auto window_before = window_of();
  const auto picture_before = picture_of();
  if (const std::optional<Action> action = action_of_key(press, is_typing)) apply(*action);
  if (window_of() != window_before) wait(window_appears);
  // These are followed in a frame.
  if (picture_of() != picture_before || session.fits_view || is_enter(press.key)) wait(1);
}

}  // namespace ghostforce
