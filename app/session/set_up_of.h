// The set-up that is on the screen: what Ctrl+C copies and a picture carries. UI thread.
#pragma once

#include "app/session/session.h"
#include "app/set_up/set_up.h"
#include "app/view/shown_moment.h"

namespace ghostforce {

// Of the moment that is shown, which somebody may look back at: with its settings, and its goal as the place of the hand,
// whoever moved it. As a file would hold it, so that its line restores it exactly.
SetUp set_up_of(const Session& session, const ShownMoment& shown);

}  // namespace ghostforce
