// What `check` found, as one value, and what is written of it: a page for people, XML for the machinery that runs
// tests, and JSON for other programs. Not for the servo thread.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/output_file.h"
#include "app/tools/check/case_file.h"
#include "app/tools/check/verdict.h"

namespace ghostforce {

struct CheckReport {
  std::string folder;              // of the cases, as the person named it
  std::string to_folder;           // where pictures of cases that fail lie; empty: none is stored
  std::vector<const Case*> cases;  // in the verdicts' order
  std::vector<Verdict> verdicts{};

  std::ptrdiff_t failed() const;
  // "12 cases, 1 failed"
  std::string counts() const;
  double duration_s() const;
};

// The page holds all that it needs but the pictures, which are files beside it. It says nothing by colour alone.
std::string report_as_html(const CheckReport& report);
// A testcase per case, as JUnit's readers take it.
std::string report_as_junit(const CheckReport& report);
// One document, as docs/check.md describes it; no newline at its end.
std::string report_as_json(const CheckReport& report);

// A folder with the page, the XML and the pictures.
class ReportFolder {
 public:
  // Makes the folder where there is none. Throws Failure(file_trouble) now where nothing can be written there.
  explicit ReportFolder(const std::string& folder);

  // Of a case that fails, NAME.expected.png, NAME.actual.png and NAME.diff.png. They are written beside what is there,
  // and put in its place by write(). Their bytes are not kept until then: in the verdict each picture
  // that there is has_value() afterwards, and its text has no bytes.
  void take_pictures(Verdict& verdict);

  // Those pictures, report.html and junit.xml; what an older report has left of a picture that is none now is removed.
  // Nothing else in the folder is touched.
  void write(const CheckReport& report);

  // After a check without a result: the pages of an earlier one would pass for its own. Its pictures stay, and so does
  // what only has a page's name.
  static void remove_earlier_pages(const std::string& folder);

  // Whether a file in the folder is called as if it were one of these.
  static bool may_write(std::string_view path);

 private:
  std::string folder_;
  OutputFile html_;
  OutputFile junit_;
  std::deque<OutputFile> pictures_;
};

}  // namespace ghostforce
