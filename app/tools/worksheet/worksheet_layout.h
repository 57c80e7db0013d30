// Places what a worksheet says on pages: on one page if that can be, with pictures as large as it allows, else on as
// many as are needed; letters never become smaller. Points of the page (1/72 inch), y down; pure, any thread.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/camera.h"
#include "app/picture/marks.h"
#include "app/picture/screen_box.h"
#include "app/picture/view.h"
#include "app/tools/worksheet/worksheet_item.h"

namespace ghostforce {

struct WorksheetPaper {
  std::string_view name;  // on the command line
  Vector<2> size;         // [points]
};
inline constexpr std::array worksheet_paper_catalog{
    WorksheetPaper{"a4", {595.276, 841.890}},
    WorksheetPaper{"letter", {612.0, 792.0}},
};

// To the paper's edges: printers leave out about a third of that.
inline constexpr double worksheet_margin = 40.0;
// The size of the smallest letters, and the height of a line of them.
inline constexpr double least_worksheet_em = 9.0;

struct WorksheetContent {
  std::string title;                 // with the lesson's number
  std::string how;                   // to work with the page
  std::vector<std::string> footers;  // the first that has room on the line is taken, else the last
  std::vector<WorksheetItem> items;
  std::string in_short;  // what the lesson says about itself; empty: lines to write on
  const WorksheetPhrases& phrases;
  WorksheetSide side = WorksheetSide::questions;
};

struct WorksheetPicture {
  std::size_t step;  // of the lesson
  ScreenBox box;
  bool hides_handle;
};

struct WorksheetPage {
  Camera camera;  // of the whole page
  Marks marks;
  std::vector<WorksheetPicture> pictures;
};

std::vector<WorksheetPage> worksheet_pages(const WorksheetContent& content, const Vector<2>& size,
                                           const MeasureText& measure);

}  // namespace ghostforce
