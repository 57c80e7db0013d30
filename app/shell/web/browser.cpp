#include "app/shell/web/browser.h"

#include <emscripten.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>

EM_JS_DEPS(browser, "$UTF8ToString,$stringToNewUTF8")

// clang-format off
EM_JS(char*, read_query, (), { return stringToNewUTF8(location.search); })
EM_JS(bool, is_origin_of_page, (const char* text), {
  const value = UTF8ToString(text);
  try {
    return value.startsWith("http") && new URL(value).origin === value;
  } catch {
    return false;
  }
})
EM_JS(char*, read_fragment, (), { return stringToNewUTF8(location.hash.slice(1)); })
EM_JS(void, write_fragment, (const char* text), {
  Module["replaceAddress"](Module["addressWith"](encodeURI(UTF8ToString(text))));
})
EM_JS(void, write_lesson, (const char* name, int step), {
  const address = new URL(location.href);
  const lesson = UTF8ToString(name);
  for (const [key, value] of [["lesson", lesson], ["step", step]]) {
    if (lesson) address.searchParams.set(key, value);
    else address.searchParams.delete(key);
  }
  address.hash = "";
  if (address.href !== location.href) Module["replaceAddress"](address.href);
})
EM_JS(void, show_link_to, (const char* text), { Module["showLink"](encodeURI(UTF8ToString(text))); })
EM_JS(bool, has_open_dialog, (), { return document.querySelector("dialog[open]") !== null; })
EM_JS(bool, take_changed_fragment, (), {
  const has_changed = Module["hasNewFragment"] ?? false;
  Module["hasNewFragment"] = false;
  return has_changed;
})
EM_JS(bool, is_in_sight, (), { return !document.hidden; })
EM_JS(bool, has_page_around, (), { return window.top !== window.self; })
EM_JS(bool, prefers_reduced_motion, (), {
  const query = Module["reducedMotion"] ||= matchMedia("(prefers-reduced-motion: reduce)");
  return query.matches;
})
EM_JS(bool, read_forced_colours, (int* colours), {
  const query = Module["forcedColours"] ||= matchMedia("(forced-colors: active)");
  if (!query.matches) return false;
  const probe = document.createElement("i");
  probe.style.forcedColorAdjust = "none";
  document.body.append(probe);
  for (const name of ["Canvas", "CanvasText", "LinkText", "Highlight", "GrayText"]) {
    probe.style.color = name;
    const [red, green, blue] = getComputedStyle(probe).color.match(/[0-9]+/g);
    HEAP32[colours >> 2] = (red << 16) | (green << 8) | blue;
    colours += 4;
  }
  probe.remove();
  return true;
})
EM_JS(bool, has_keys, (), { return document.hasFocus(); })
EM_JS(void, write_clipboard, (const char* text), {
  const words = UTF8ToString(text);
  Module["clipboardText"] = words;
  const by_hand = () => {
    const focused = document.activeElement;
    const field = document.createElement("textarea");
    field.value = words;
    document.body.append(field);
    field.select();
    document.execCommand("copy");
    field.remove();
    focused?.focus();
  };
  // Only pages from a safe place have a clipboard.
  if (navigator.clipboard) navigator.clipboard.writeText(words).catch(by_hand);
  else by_hand();
})
EM_JS(char*, read_pasted, (), { return stringToNewUTF8(Module["clipboardText"] ?? ""); })
EM_JS(bool, take_pasted, (), {
  const has_pasted = Module["hasPasted"] ?? false;
  Module["hasPasted"] = false;
  return has_pasted;
})
EM_JS(bool, may_fill_screen, (), { return document.fullscreenEnabled ?? false; })
EM_JS(void, switch_full_screen, (), {
  const done = document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen?.();
  done?.catch((error) => console.warn("The browser does not change to or from full screen: " + error.message));
})
EM_JS(bool, fills_screen, (), { return document.fullscreenElement !== null; })
EM_JS(void, listen_to_document, (), {
  addEventListener("beforeunload", (event) => { if (Module["hasUnsaved"]) event.preventDefault(); });
  addEventListener("hashchange", () => Module["hasNewFragment"] = true);
  addEventListener("paste", (event) => {
    Module["clipboardText"] = event.clipboardData?.getData("text/plain") ?? "";
    Module["hasPasted"] = true;
  });
  const stage = document.getElementById("stage");
  stage.addEventListener("contextmenu", (event) => event.preventDefault());
  stage.addEventListener("touchstart", () => stage.focus());
  stage.addEventListener("focus", () => Module["hasGivenKeysBack"] = false);
})
EM_JS(void, set_unsaved, (bool has_unsaved), { Module["hasUnsaved"] = has_unsaved; })
EM_JS(void, focus_controls, (), { document.querySelector("#controls h1").focus(); })
EM_JS(void, write_controls, (const char* json), { Module["showControls"](JSON.parse(UTF8ToString(json))); })
EM_JS(bool, is_canvas_focused, (), { return document.activeElement === Module["canvas"]; })
EM_JS(bool, is_nothing_focused, (), { return document.activeElement === document.body; })
EM_JS(bool, is_within_another_page, (), { return window.top !== window.self; })
EM_JS(bool, has_given_keys_back, (), { return Module["hasGivenKeysBack"] ?? false; })
EM_JS(void, blur_canvas, (), {
  if (document.activeElement === Module["canvas"]) Module["tellKeysGivenBack"]();
  Module["canvas"].blur();
  Module["hasGivenKeysBack"] = true;
})
EM_JS(void, be_ready, (const char* embedder), { Module["showReady"](UTF8ToString(embedder)); })
EM_JS(void, hand_on_lesson, (const char* lesson), { Module["tellLesson"]?.(JSON.parse(UTF8ToString(lesson))); })
EM_JS(void, hand_on_action, (const char* action), { Module["tellAction"]?.(UTF8ToString(action)); })
EM_JS(void, show_way_back, (const char* words, const char* button), {
  Module["offerToLoadAgain"](UTF8ToString(words), UTF8ToString(button));
})
EM_JS(void, show_problem, (const char* words), { Module["showProblem"](UTF8ToString(words)); })
// clang-format on

namespace ghostforce::browser {
namespace {

std::string text_of(char* text) {
  const std::unique_ptr<char, void (*)(void*)> owned(text, std::free);
  return owned.get();
}

}  // namespace

std::string query() {
  return text_of(read_query());
}

bool is_origin(const std::string& value) {
  return is_origin_of_page(value.c_str());
}

std::string fragment() {
  return text_of(read_fragment());
}

void set_fragment(const std::string& text) {
  write_fragment(text.c_str());
}

void set_lesson(const std::string& name, std::size_t step) {
  write_lesson(name.c_str(), static_cast<int>(step));
}

void show_link(const std::string& text) {
  show_link_to(text.c_str());
}

bool shows_dialog() {
  return has_open_dialog();
}

bool take_fragment_change() {
  return take_changed_fragment();
}

bool is_in_frame() {
  return has_page_around();
}

bool is_visible() {
  return is_in_sight();
}

bool wants_less_motion() {
  return prefers_reduced_motion();
}

std::optional<SystemColours> forced_colours() {
  std::array<int, 5> read{};
  if (!read_forced_colours(read.data())) return std::nullopt;
  const auto colour = [&](std::size_t i) { return rgb(static_cast<std::uint32_t>(read[i])); };
  return SystemColours{.canvas = colour(0),
                       .canvas_text = colour(1),
                       .link_text = colour(2),
                       .highlight = colour(3),
                       .gray_text = colour(4)};
}

bool has_focus() {
  return has_keys();
}

double clock_s() {
  return 0.001 * emscripten_get_now();
}

void copy_text(const std::string& text) {
  write_clipboard(text.c_str());
}

std::string pasted_text() {
  return text_of(read_pasted());
}

bool take_paste() {
  return take_pasted();
}

bool offers_full_screen() {
  return may_fill_screen();
}

void toggle_full_screen() {
  switch_full_screen();
}

bool is_full_screen() {
  return fills_screen();
}

void listen() {
  listen_to_document();
}

void keep_from_leaving(bool has_unsaved) {
  set_unsaved(has_unsaved);
}

void show_controls(const std::string& json) {
  write_controls(json.c_str());
}

void enter_controls() {
  focus_controls();
}

bool canvas_has_keys() {
  return is_canvas_focused() || (is_nothing_focused() && !has_given_keys_back() && !is_within_another_page());
}

bool canvas_has_focus() {
  return is_canvas_focused();
}

void leave_canvas() {
  blur_canvas();
}

void tell_ready(const std::string& embedder) {
  be_ready(embedder.c_str());
}

void tell_lesson(const std::string& lesson) {
  hand_on_lesson(lesson.c_str());
}

void tell_action(const std::string& action) {
  hand_on_action(action.c_str());
}

void offer_to_load_again(const std::string& words, const std::string& button) {
  show_way_back(words.c_str(), button.c_str());
}

void tell_problem(const std::string& words) {
  show_problem(words.c_str());
}

}  // namespace ghostforce::browser
