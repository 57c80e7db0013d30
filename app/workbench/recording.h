// What the record button and the recording panel share.
#pragma once

#include <string>

#include "app/widgets/panel_context.h"

namespace ghostforce {

// Begins a recording under the name in the panel's field, or else under a proposed one; or ends the one that is made.
void toggle_recording(const PanelContext& context);

// How long it is, how large, and what it has lost.
std::string words_about(const RecordingReading& recording);

}  // namespace ghostforce
