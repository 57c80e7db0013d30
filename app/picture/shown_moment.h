// ShownMoment: a tick's snapshot and the settings under which it ran, together: what a picture is of. Which strategy is
// the active one is the person's choice, whenever the moment was. Refers to a snapshot that others hold.
#pragma once

#include "core/settings.h"
#include "core/snapshot.h"

namespace ghostforce {

struct ShownMoment {
  Settings settings;
  const Snapshot& snapshot;
  bool is_past = false;  // somebody looks back: nothing newer than this is to be seen
};

}  // namespace ghostforce
