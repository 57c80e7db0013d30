// A session's receipt as one page of paper (A4), for people. Pure, any thread.
#pragma once

#include <vector>

#include "app/picture/panes.h"
#include "app/picture/view.h"
#include "app/shell/receipt.h"

namespace ghostforce {

inline constexpr Vector<2> receipt_sheet_size{595.276, 841.890};  // [points]

// Panes of that page. Of what is long only the beginning stands there, and where the rest is. `measure`: of the letters on
// paper.
std::vector<Pane> receipt_sheet(const Receipt& receipt, const MeasureText& measure);

}  // namespace ghostforce
