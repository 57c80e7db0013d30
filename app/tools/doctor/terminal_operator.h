// TerminalOperatorFor: a person at a terminal, or a file of answers: words go to the error output, lines come from the
// standard input. In a rehearsal a simulated person, who has act(action), does what is asked, and answers where the line
// is empty. UI thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/tools/doctor/operator.h"

namespace ghostforce {

void tell_on_terminal(std::string_view words);
// `simulated`: what a simulated person answers, who has done what was asked; none: the device is real.
std::optional<std::string> ask_on_terminal(std::string_view words, const std::optional<std::string>& simulated);

template <typename Action, typename Person>
class TerminalOperatorFor final : public OperatorFor<Action> {
 public:
  // Null: the device is real. Else it must live as long as this.
  explicit TerminalOperatorFor(Person* simulated) : simulated_(simulated) {}

  void tell(std::string_view words) override { tell_on_terminal(words); }
  std::optional<std::string> ask(const Action& action, std::string_view words) override {
    return ask_on_terminal(words, simulated_ == nullptr ? std::nullopt : std::optional(simulated_->act(action)));
  }
  void cue(const Action& action) override {
    if (simulated_ != nullptr) simulated_->act(action);
  }

 private:
  Person* simulated_;
};

}  // namespace ghostforce
