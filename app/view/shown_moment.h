// ShownMoment: a tick's snapshot and the settings under which it ran, together: what a picture is of. Refers to what
// others hold.
#pragma once

#include "core/settings.h"
#include "core/snapshot.h"

namespace ghostforce {

struct ShownMoment {
  const Settings& settings;
  const Snapshot& snapshot;
  bool is_past = false;  // somebody looks back: nothing newer than this is to be seen
};

}  // namespace ghostforce
