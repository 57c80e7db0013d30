// The inputs as a person may choose among them: the input catalog without what belongs to devices. Any thread.
#pragma once

#include <vector>

#include "app/session/session.h"
#include "device/input_catalog.h"

namespace ghostforce {

// `has_recording`: one is loaded that can be replayed.
inline std::vector<InputChoice> input_choices(bool has_recording) {
  std::vector<InputChoice> choices;
  for (const InputKind& kind : input_catalog()) {
    if (has_recording || !kind.needs_recording) choices.push_back({kind.name, kind.title, kind.sentence});
  }
  return choices;
}

// What the virtual Falcon can be asked to do wrong, after doing nothing wrong.
inline std::vector<InputChoice> misbehaviour_choices() {
  std::vector<InputChoice> choices{{"none", "none", "It does what a Falcon should."}};
  for (const MisbehaviourKind& kind : misbehaviour_catalog()) choices.push_back({kind.name, kind.name, kind.sentence});
  return choices;
}

}  // namespace ghostforce
