#include "app/shell/web/browser.h"

#include <emscripten.h>

#include <cstdlib>
#include <memory>

EM_JS_DEPS(browser, "$UTF8ToString,$stringToNewUTF8")

// clang-format off
EM_JS(char*, read_query, (const char* name), {
  return stringToNewUTF8(new URLSearchParams(location.search).get(UTF8ToString(name)) ?? "");
})
EM_JS(bool, is_in_query, (const char* name), {
  return new URLSearchParams(location.search).has(UTF8ToString(name));
})
EM_JS(char*, read_fragment, (), {
  const text = location.hash.slice(1);
  try {
    return stringToNewUTF8(decodeURIComponent(text));
  } catch (error) {
    return stringToNewUTF8(text);
  }
})
EM_JS(void, write_fragment, (const char* text), {
  try {
    history.replaceState(null, "", Module["addressWith"](encodeURI(UTF8ToString(text))));
  } catch (error) {
    // A page within another one may not; there is no address to see either.
  }
})
EM_JS(void, show_link_to, (const char* text), { Module["showLink"](encodeURI(UTF8ToString(text))); })
EM_JS(bool, has_open_dialog, (), { return document.querySelector("dialog[open]") !== null; })
EM_JS(bool, take_changed_fragment, (), {
  const has_changed = Module["hasNewFragment"] ?? false;
  Module["hasNewFragment"] = false;
  return has_changed;
})
EM_JS(bool, is_in_sight, (), { return !document.hidden; })
EM_JS(bool, has_keys, (), { return document.hasFocus(); })
EM_JS(void, write_clipboard, (const char* text), {
  const words = UTF8ToString(text);
  Module["clipboardText"] = words;
  const by_hand = () => {
    const field = document.createElement("textarea");
    field.value = words;
    document.body.append(field);
    field.select();
    document.execCommand("copy");
    field.remove();
    document.getElementById("stage").focus();
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
EM_JS(void, switch_full_screen, (), {
  const done = document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen?.();
  done?.catch(() => {});
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
})
EM_JS(void, set_unsaved, (bool has_unsaved), { Module["hasUnsaved"] = has_unsaved; })
EM_JS(void, write_spoken, (const char* words), {
  document.getElementById("spoken").textContent = UTF8ToString(words);
})
EM_JS(void, be_ready, (), { Module["showReady"](); })
EM_JS(void, show_problem, (const char* words), { Module["showProblem"](UTF8ToString(words)); })
// clang-format on

namespace ghostforce::browser {
namespace {

std::string text_of(char* text) {
  const std::unique_ptr<char, void (*)(void*)> owned(text, std::free);
  return owned.get();
}

}  // namespace

std::string query(const std::string& name) {
  return text_of(read_query(name.c_str()));
}

bool has_query(const std::string& name) {
  return is_in_query(name.c_str());
}

std::string fragment() {
  return text_of(read_fragment());
}

void set_fragment(const std::string& text) {
  write_fragment(text.c_str());
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

bool is_visible() {
  return is_in_sight();
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

void tell_listeners(const std::string& words) {
  write_spoken(words.c_str());
}

void tell_ready() {
  be_ready();
}

void tell_problem(const std::string& words) {
  show_problem(words.c_str());
}

}  // namespace ghostforce::browser
