// Report: what `check` found, as a page for people and as XML for the machinery that runs tests. Not for the servo
// thread.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/check/verdict.h"
#include "app/files/output_file.h"

namespace ghostforce {

class Report {
 public:
  // Makes the folder where there is none. Throws Failure(file_trouble) now where nothing can be written there.
  explicit Report(const std::string& to_folder);

  // Of a case that fails, NAME.expected.png, NAME.actual.png and NAME.diff.png. They are written beside what is there,
  // and put in its place by write(). Their bytes are not kept until then: in the verdict each picture
  // that there is has_value() afterwards, and its text has no bytes.
  void take_pictures(Verdict& verdict);

  // Those pictures, report.html and junit.xml; of a case that passes, the three pictures are removed. Nothing else in
  // the folder is touched. `folder` is that of the cases.
  void write(const std::vector<Verdict>& verdicts, std::string_view folder);

  // Of those pictures, those that there are, each as a word and a path: "expected", "actual" and "difference".
  std::vector<std::pair<std::string_view, std::string>> pictures_of(const Verdict& verdict) const;
  std::string html_path() const;
  std::string junit_path() const;

  // Whether a file in the folder is called as if it were one of these.
  static bool may_write(std::string_view path);

 private:
  std::string path_of(std::string_view name) const;
  void remove_picture(const std::string& path) const;

  std::string to_folder_;
  OutputFile html_;
  OutputFile junit_;
  std::deque<OutputFile> pictures_;
};

}  // namespace ghostforce
