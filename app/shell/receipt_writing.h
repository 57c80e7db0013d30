// A session's receipt as two files beside its recording: JSON for programs (docs/recording.md), and one page of paper (A4)
// for people. UI thread; the page and the JSON are pure.
#pragma once

#include <string>
#include <vector>

#include "app/paint/file_painter.h"
#include "app/picture/panes.h"
#include "app/picture/view.h"
#include "app/shell/receipt.h"

namespace ghostforce {

std::string receipt_json(const Receipt& receipt);

inline constexpr Vector<2> receipt_sheet_size{595.276, 841.890};  // [points]

// Panes of that page. Of what is long only the beginning stands there, and where the rest is. `measure`: of the letters on
// paper.
std::vector<Pane> receipt_sheet(const Receipt& receipt, const MeasureText& measure);

// Both or none, and over no other file. `recording`: its path. Throws Failure(file_trouble). A page in a browser writes
// none.
void write_receipt(const Receipt& receipt, const FilePainter& painter, const std::string& recording);

}  // namespace ghostforce
