// Operator: the person in front of a device that is being measured, as the measurement sees one: told things, asked to do
// things, and answering in lines of text. On a terminal, out of a file, or simulated. What a person can be asked to do is
// the device's own: an Action is a plain value with a Kind, one of which is say_yes_or_no. UI thread.
//
// What asks throws Failure: interrupted; answer_is_no where nobody is there any more; and Leave or Skip, where the person
// wants to.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ghostforce {

struct LeaveMeasurement {};  // the person has typed q
struct SkipMeasurement {};   // the person has typed s

inline constexpr std::string_view measuring_keys =
    "Enter: done, continue. s: skip this step. q: end, with or without a report. Ctrl+C: end at once and write "
    "nothing.\n";

template <typename Action>
class OperatorFor {
 public:
  OperatorFor() = default;
  OperatorFor(const OperatorFor&) = delete;
  OperatorFor& operator=(const OperatorFor&) = delete;
  virtual ~OperatorFor() = default;

  // Never while a motor is on: a terminal may take its time.
  virtual void tell(std::string_view words) = 0;

  // Says what to do and waits for a line: the answer, or an empty one when it is done. None: nobody is there any more.
  virtual std::optional<std::string> ask(const Action& action, std::string_view words) = 0;

  // While motors are on, and never waits: it is time for what the person has been told before.
  virtual void cue(const Action& action) = 0;

  bool says_yes(std::string_view words) {
    Action action{};
    action.kind = Action::Kind::say_yes_or_no;
    const auto line = ask(action, words);
    return line && (line->starts_with('y') || line->starts_with('Y'));
  }
};

// The line that was typed, without spaces around it.
std::string answer_of(const std::optional<std::string>& line);
// Empty: the answer is no number from `least` to `greatest`; `complaint` says so.
std::optional<double> number_of_answer(const std::string& answer, double least, double greatest, std::string_view unit,
                                       std::string& complaint);

template <typename Action>
std::string ask_person(OperatorFor<Action>& person, const Action& action, std::string_view words) {
  return answer_of(person.ask(action, words));
}

// Asks until the answer is a number from `least` to `greatest`.
template <typename Action>
double ask_person_number(OperatorFor<Action>& person, const Action& action, std::string_view words, double least,
                         double greatest, std::string_view unit) {
  for (;;) {
    std::string complaint;
    const auto value = number_of_answer(ask_person(person, action, words), least, greatest, unit, complaint);
    if (value) return *value;
    person.tell(complaint);
  }
}

}  // namespace ghostforce
