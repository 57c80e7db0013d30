// A chart's picture as marks, so that the painters that draw scenes draw charts too. Pure, any thread.
#pragma once

#include "app/picture/chart.h"
#include "app/picture/panes.h"
#include "app/picture/theme.h"
#include "app/picture/view.h"

namespace ghostforce {

// The chart as a pane of its own: in its camera one metre is one point, y up. `corner` and `size` in points, `scale` as
// for scenes.
Pane chart_pane(const Chart& chart, const Vector<2>& corner, const Vector<2>& size, const Theme& theme, double scale,
                const MeasureText& measure);

}  // namespace ghostforce
