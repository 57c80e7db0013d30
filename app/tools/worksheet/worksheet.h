// A lesson as a worksheet on paper: its questions beside pictures of the stage, to be answered with a pen; and the same
// with the answers, for the teacher. One page if the lesson is not too long. The same lesson gives the same bytes. One
// thread at a time.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/panes.h"
#include "app/state/lesson.h"
#include "app/tools/worksheet/worksheet_layout.h"

namespace ghostforce {

struct WorksheetChoice {
  std::string language{"en"};  // where the lesson has it; else as words_in()
  const WorksheetPaper* paper = &worksheet_paper_catalog.front();
  WorksheetSide side = WorksheetSide::questions;
};

// Each page's panes: the page with its words, and pictures on it. Throws Failure: wrong_call where a step's loop is
// unstable; interrupted; file_trouble where the font cannot be read.
std::vector<std::vector<Pane>> worksheet_of(const std::shared_ptr<const Lesson>& lesson, const WorksheetChoice& choice);

// A PDF of pages of that paper; there is at least one.
std::string worksheet_file(std::span<const std::vector<Pane>> pages, const WorksheetPaper& paper,
                           std::string_view title);

}  // namespace ghostforce
