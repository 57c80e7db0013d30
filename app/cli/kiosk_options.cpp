#include "app/cli/kiosk_options.h"

#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/contradictions.h"
#include "app/state/face.h"
#include "app/state/lesson_shelf.h"
#include "device/report/input_choice.h"

namespace ghostforce {
namespace {

constexpr std::string_view lessons_say = "the lessons say what is on the stage";

std::vector<Contradiction> beside_kiosk() {
  std::vector<Contradiction> list{
      Contradiction{"SCENE", "", lessons_say},
      Contradiction{"--set", "", lessons_say},
      Contradiction{"--goal-mm", "", lessons_say},
      Contradiction{"--strategy", "", lessons_say},
      Contradiction{"--mode", "", lessons_say},
      Contradiction{"--view", face_name(Face::workbench), "visitors see the stage only"},
      Contradiction{"--record", "", "nothing of a visit is stored"},
      Contradiction{"--record-session", "", "nothing of a visit is stored"},
      Contradiction{"--shader-dir", "", "visitors must not see what is wrong with a shader"},
  };
  for (const InputChoice& hand : hands_moving_by_themselves) {
    list.push_back({"--input", hand.name, "visitors move the hand themselves"});
  }
  return list;
}

}  // namespace

void KioskOptions::attach(CLI::App& command) {
  command_ = &command;
  command.add_flag(
      "--kiosk", is_on,
      "For visitors of an open day or a museum: full screen, the lessons in a loop, back to the start after "
      "90 s without a hand, and no way to files; with --lesson, that one over and over (docs/kiosk.md)");
}

void KioskOptions::refuse_contradictions() const {
  if (is_on) ghostforce::refuse_contradictions(*command_, "--kiosk", beside_kiosk());
}

std::vector<std::shared_ptr<const Lesson>> KioskOptions::lessons(const std::shared_ptr<const Lesson>& asked_for) const {
  if (!is_on) return {};
  return asked_for ? std::vector{asked_for} : shipped_lessons();
}

}  // namespace ghostforce
