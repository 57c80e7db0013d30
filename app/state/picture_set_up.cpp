#include "app/state/picture_set_up.h"

#include <cerrno>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/input_file.h"
#include "app/files/picture_title.h"
#include "app/files/png_file.h"
#include "app/state/set_up_line.h"

namespace ghostforce {
namespace {

constexpr std::string_view line_begins = "ghostforce run ";

// From where it begins to the end of the text; empty: there is none.
std::string_view line_in(std::string_view text) noexcept {
  const std::size_t at = text.rfind(line_begins);
  return at == std::string_view::npos ? std::string_view() : trimmed(text.substr(at));
}

std::string line_in_png(const std::string& path) {
  const PngFile file(path, PngWords::read);
  for (const PngText& text : file.texts()) {
    if (const std::string_view line = line_in(text.text); !line.empty()) return std::string(line);
  }
  return {};
}

std::string line_in_picture(const std::string& path) {
  FileContents file = file_contents(path);
  // A PNG has no largest size, and its reader looks at the pixels only when it is asked for them.
  if (file.error == EFBIG || file.text.starts_with("\x89PNG")) return line_in_png(path);
  if (file.error != 0) throw unreadable(quoted_text(path, longest_path), file.error);
  return std::string(line_in(file.text.starts_with("%PDF-") ? pdf_title(file.text) : svg_title(file.text)));
}

}  // namespace

std::vector<PngText> picture_texts(const SetUp& set_up) {
  return {software_text(), {"Description", set_up_line(set_up)}};
}

std::string picture_title(std::string_view title, const SetUp& set_up) {
  return fmt::format("{}: {}", title, set_up_line(set_up));
}

SetUp read_picture_set_up(const std::string& path) {
  const std::string shown = quoted_text(path, longest_path);
  const std::string line = line_in_picture(path);
  if (line.empty()) {
    throw ReadError(ReadError::Kind::wrong, {{.file = shown,
                                              .what = "the picture does not say what it shows",
                                              .remedy = "give one that ghostforce has saved; other programs may take "
                                                        "that out when they save it again"}});
  }
  try {
    return read_set_up_line(line);
  } catch (const ReadError& error) {
    std::vector<ReadProblem> problems = error.problems();
    for (ReadProblem& problem : problems) {
      problem.what = words_of(problem);
      problem.remedy.clear();
      problem.file = shown;
      problem.line = 0;
    }
    throw ReadError(error.kind(), std::move(problems));
  }
}

}  // namespace ghostforce
