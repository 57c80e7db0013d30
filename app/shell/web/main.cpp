// The page's main: starts it, hands it the browser's frames, and is the only catcher. The functions below are what
// scripts of the page call (app/shell/web/page.html).
#include <emscripten.h>

#include <exception>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "app/base/quoted.h"
#include "app/files/scene_file.h"
#include "app/shell/page_actions.h"
#include "app/shell/web/browser.h"
#include "app/shell/web/page.h"
#include "app/shell/web/page_state.h"
#include "app/state/lesson_file.h"
#include "app/state/stage_language.h"

namespace {

std::unique_ptr<ghostforce::Page> page;

// The answer of a call, until the next one.
const char* answer(std::string text) {
  static std::string kept;
  kept = std::move(text);
  return kept.c_str();
}

// `act` returns why it could not be done.
const char* why_not(const auto& act) {
  try {
    return answer(act());
  } catch (const std::exception& error) {
    return answer(error.what());
  }
}

void stop_with(const char* why) {
  emscripten_cancel_main_loop();
  const std::string& language = page->application().session().language;
  ghostforce::browser::tell_problem(ghostforce::filled(ghostforce::stage_language(language).page.stopped, why));
}

void frame() {
  try {
    page->frame();
  } catch (const std::exception& error) {
    stop_with(error.what());
  } catch (...) {
    stop_with("the browser refused something");
  }
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* ghostforce_state() {
  return answer(page ? ghostforce::page_state(*page) : "{\"ready\":false}");
}

EMSCRIPTEN_KEEPALIVE const char* ghostforce_simulate(const char* scene, const char* strategy) {
  try {
    return answer(ghostforce::simulated_rows(scene, strategy));
  } catch (const std::exception& error) {
    return answer(std::string("# ") + error.what() + "\n");
  }
}

EMSCRIPTEN_KEEPALIVE const char* ghostforce_replay(const char* recording) {
  try {
    return answer(ghostforce::replayed(recording));
  } catch (const std::exception& error) {
    return answer(nlohmann::json{{"agrees", false}, {"words", error.what()}}.dump());
  }
}

EMSCRIPTEN_KEEPALIVE const char* ghostforce_show(const char* line) {
  return why_not([&] { return ghostforce::show_line(page->application(), line); });
}

EMSCRIPTEN_KEEPALIVE const char* ghostforce_begin_lesson(const char* name) {
  return why_not([&] { return ghostforce::begin_lesson_by_name(page->application(), name); });
}

EMSCRIPTEN_KEEPALIVE const char* ghostforce_act(const char* name) {
  return why_not([&] { return ghostforce::act_by_name(page->application(), name); });
}

EMSCRIPTEN_KEEPALIVE const char* ghostforce_actions() {
  return answer(nlohmann::json(ghostforce::names_of(ghostforce::page_actions())).dump());
}

EMSCRIPTEN_KEEPALIVE const char* ghostforce_on_page(double x_m, double y_m) {
  const ghostforce::Vector<2> place = ghostforce::on_page(*page, {x_m, y_m});
  return answer(nlohmann::json::array({place.x, place.y}).dump());
}

EMSCRIPTEN_KEEPALIVE void ghostforce_use_control(const char* id, double value) {
  try {
    page->use_control(id, value);
  } catch (const std::exception& error) {
    page->application().show_notice(error.what(), true);
  }
}

EMSCRIPTEN_KEEPALIVE const char* ghostforce_scenes() {
  return answer(nlohmann::json(ghostforce::shipped_scene_names()).dump());
}

EMSCRIPTEN_KEEPALIVE const char* ghostforce_lessons() {
  return answer(nlohmann::json(ghostforce::shipped_lesson_names()).dump());
}

}  // extern "C"

int main() {
  try {
    page = std::make_unique<ghostforce::Page>();
  } catch (const std::exception& error) {
    ghostforce::browser::tell_problem(error.what());
    return 1;
  }
  emscripten_set_main_loop(frame, 0, false);
  return 0;
}
