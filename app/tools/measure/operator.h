// Operator: the person in front of a Falcon that is being measured, as the measurement sees one: told things, asked to
// do things, and answering in lines of text. On a terminal, out of a file, or simulated. UI thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "device/virtual_falcon/operator_action.h"

namespace ghostforce {

class Operator {
 public:
  Operator() = default;
  Operator(const Operator&) = delete;
  Operator& operator=(const Operator&) = delete;
  virtual ~Operator() = default;

  // Never while a motor is on: a terminal may take its time.
  virtual void tell(std::string_view words) = 0;

  // Says what to do and waits for a line: the answer, or an empty one when it is done. None: nobody is there any more.
  virtual std::optional<std::string> ask(const OperatorAction& action, std::string_view words) = 0;

  // While motors are on, and never waits: it is time for what the person has been told before.
  virtual void cue(const OperatorAction& action) = 0;

  bool says_yes(std::string_view words) {
    const auto line = ask({.kind = OperatorAction::Kind::say_yes_or_no}, words);
    return line && (line->starts_with('y') || line->starts_with('Y'));
  }
};

}  // namespace ghostforce
