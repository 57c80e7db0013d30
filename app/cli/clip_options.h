// Which moments a clip shows, as a person types them.
#pragma once

#include <string_view>

#include "app/desktop/offscreen.h"

namespace ghostforce {

// FROM:TO:FPS, in seconds and pictures a second. Throws Failure(wrong_call).
ClipTimes clip_times_from(std::string_view text);

}  // namespace ghostforce
