// A session's receipt as two files beside its recording: JSON for programs (docs/recording.md), and a page for people
// (receipt_sheet.h). UI thread.
#pragma once

#include <string>

#include "app/paint/file_painter.h"
#include "app/shell/receipt.h"

namespace ghostforce {

std::string receipt_json(const Receipt& receipt);

// Both or none, and over no other file. `recording`: its path. Throws Failure(file_trouble). A page in a browser writes
// none.
void write_receipt(const Receipt& receipt, const FilePainter& painter, const std::string& recording);

}  // namespace ghostforce
