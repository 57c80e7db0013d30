// TerminalOperator: a person at a terminal, or a file of answers: words go to the error output, lines come from the
// standard input. In a rehearsal a simulated person does what is asked, and answers where the line is empty. UI thread.
#pragma once

#include <string>

#include "app/tools/measure/operator.h"
#include "device/virtual_falcon/measured_person.h"

namespace ghostforce {

class TerminalOperator final : public Operator {
 public:
  // Null: the device is real. Else it must live as long as this.
  explicit TerminalOperator(MeasuredPerson* simulated) : simulated_(simulated) {}

  void tell(std::string_view words) override;
  std::optional<std::string> ask(const OperatorAction& action, std::string_view words) override;
  void cue(const OperatorAction& action) override;

 private:
  std::optional<std::string> read_line();

  MeasuredPerson* simulated_;
  std::string typed_;  // beyond the last line
};

}  // namespace ghostforce
