// The inputs as a person may choose among them: the input catalog without what belongs to devices. Any thread.
#pragma once

#include <vector>

#include "app/session.h"
#include "device/input_catalog.h"

namespace ghostforce {

inline std::vector<InputChoice> input_choices() {
  std::vector<InputChoice> choices;
  for (const InputKind& kind : input_catalog()) choices.push_back({kind.name, kind.title, kind.sentence});
  return choices;
}

}  // namespace ghostforce
