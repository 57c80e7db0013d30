// StageControl: a text or a control of the stage, with its parts and with the Actions that it leads to. stage_controls.h
// makes a tree of them. Values; UI thread.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/state/action.h"

namespace ghostforce {

enum class StageControlKind : std::uint8_t {
  group,    // with a heading and parts
  dialog,   // a group that has been opened, and can be closed
  choices,  // a group of which one is chosen
  folded,   // a group that opens when it is asked for
  rows,     // a group of a list, with a heading
  text,
  told,    // a text that is told when it has changed and settled
  status,  // a text that is told when it appears
  alert,   // the same, at once
  button,
  file,    // a button that asks the person's system for a file to open
  toggle,  // a button that stays pressed
  choice,
  range,
};

struct StageControl {
  using Act = std::function<std::vector<Action>(double value)>;

  std::string id;
  StageControlKind kind = StageControlKind::text;
  std::string words;  // its name, or the text
  // More words. Of a range: its value with the unit, which is all that is told of it. Of a group that can go: what is
  // told when it has gone.
  std::string about{};
  std::string refusal{};   // why it cannot be used now; empty: it can
  std::string language{};  // code of that of its words; empty: that of all
  bool is_on = false;      // a toggle, a choice
  double value = 0.0;      // of a range, as are those below
  double least = 0.0;
  double greatest = 1.0;
  double step = 1.0;  // of an arrow key
  std::vector<StageControl> parts{};
  Act act{};  // what it leads to, in the session as it is by then; empty: it is only read
};

}  // namespace ghostforce
