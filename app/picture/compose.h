// compose: (settings, snapshot, history, camera, theme) → marks, and nothing else. Reads no clock, no device, no
// global: the same input gives the same picture, in the window, in a PNG and in a test. One file per layer.
#pragma once

#include "app/picture/marks.h"
#include "app/picture/picture_memory.h"
#include "app/picture/view.h"

namespace ghostforce {

// `memory`: where words stood in the picture before, `interval_s` ago; as it is made: there was none. `earlier`: marks of
// an earlier picture, to be thrown away; the new ones take their room, which a screen that is drawn sixty times a second
// need not ask the system for each time.
Marks compose(const View& view, PaneMemory& memory, double interval_s = 0.0, Marks earlier = {});

}  // namespace ghostforce
