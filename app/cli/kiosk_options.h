// --kiosk, the visitor's mode (app/state/kiosk_visit.h, docs/kiosk.md), and what cannot be asked for together with it.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "app/state/lesson.h"

namespace CLI {
class App;
}

namespace ghostforce {

// What ends the visitor's mode, for the person at the terminal.
inline constexpr std::string_view end_of_kiosk =
    "Visitor's mode: Ctrl+Alt+Shift+Q in the window ends it, and so does Ctrl+C here.";

struct KioskOptions {
  bool is_on = false;

  void attach(CLI::App& command);
  // Throws Failure(wrong_call) where --kiosk stands beside an option that it contradicts.
  void refuse_contradictions() const;
  // Those that go round: the one that was asked for, else all that come with the program. Empty without --kiosk.
  std::vector<std::shared_ptr<const Lesson>> lessons(const std::shared_ptr<const Lesson>& asked_for) const;

 private:
  const CLI::App* command_ = nullptr;  // once attached
};

}  // namespace ghostforce
