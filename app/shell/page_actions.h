// What a page around this one can have done here, by name (docs/web.md): the way in of its messages. Main thread.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/state/action.h"

namespace ghostforce {

class Application;

struct PageAction {
  std::string_view name;
  Action action;
};

std::span<const PageAction> page_actions();

// Each returns why it cannot be done, for the person who wrote the other page or in the words of this one; empty: it is
// done. What a lesson or a kiosk keeps to itself, or what would change nothing, a page around it cannot do either.
std::string act_by_name(Application& application, std::string_view name);
std::string show_line(Application& application, const std::string& line);
std::string begin_lesson_by_name(Application& application, std::string_view name);

}  // namespace ghostforce
