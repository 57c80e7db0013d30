// The set-up that is on the screen: what Ctrl+C copies and a picture carries. UI thread.
#pragma once

#include "app/picture/shown_moment.h"
#include "app/state/session.h"
#include "app/state/set_up.h"

namespace ghostforce {

// Of the moment that is shown, which somebody may look back at: with its settings, and its goal as the place of the hand,
// whoever moved it. As a file would hold it, so that its line restores it exactly.
SetUp set_up_of(const Session& session, const ShownMoment& shown);

}  // namespace ghostforce
