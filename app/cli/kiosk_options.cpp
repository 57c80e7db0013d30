#include "app/cli/kiosk_options.h"

#include <array>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/console/failure.h"
#include "app/lessons/lesson_shelf.h"
#include "app/view/stage/face.h"
#include "core/input_choice.h"

namespace ghostforce {
namespace {

constexpr std::string_view lessons_say = "the lessons say what is on the stage";
constexpr std::string_view visitors_move = "visitors move the hand themselves";

struct Contradiction {
  std::string option;
  std::string_view value;  // its beginning; empty: any
  std::string_view reason;
};

const std::vector<Contradiction>& contradictions() {
  static const std::vector<Contradiction> all{
      {"SCENE", "", lessons_say},
      {"--set", "", lessons_say},
      {"--goal-mm", "", lessons_say},
      {"--strategy", "", lessons_say},
      {"--mode", "", lessons_say},
      {"--view", face_name(Face::workbench), "visitors see the stage only"},
      {"--record", "", "nothing of a visit is stored"},
      {"--shader-dir", "", "visitors must not see what is wrong with a shader"},
      {"--input", scripted_hand.name, visitors_move},
      {"--input", circling_hand.name, visitors_move},
      {"--input", replayed_hand.name, visitors_move},
  };
  return all;
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
  if (!is_on) return;
  for (const Contradiction& each : contradictions()) {
    const CLI::Option* const option = command_->get_option_no_throw(each.option);
    if (option == nullptr || option->count() == 0 || !option->as<std::string>().starts_with(each.value)) continue;
    throw Failure(ExitCode::wrong_call,
                  fmt::format("--kiosk and {}{}{} contradict each other: {}; leave out one of them", each.option,
                              each.value.empty() ? "" : " ", each.value, each.reason));
  }
}

std::vector<std::shared_ptr<const Lesson>> KioskOptions::lessons(const std::shared_ptr<const Lesson>& asked_for) const {
  if (!is_on) return {};
  return asked_for ? std::vector{asked_for} : shipped_lessons();
}

}  // namespace ghostforce
