// The language of the stage and of lessons, one of the catalog. Within a frame, UI thread.
#pragma once

#include "app/widgets/panel_context.h"

namespace ghostforce {

void draw_language_choice(const PanelContext& context);

}  // namespace ghostforce
