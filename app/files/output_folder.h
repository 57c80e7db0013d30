// A folder of files that are written all or not at all: until commit() there are temporary files in it, and without
// commit(), or where that fails half-way, everything is as it was (output_file.h says where that cannot be); not even
// the folder is left behind if it was not there before. Not for the servo thread.
//
// Every function may throw Failure: file_trouble with path, reason and remedy; interrupted.
#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/output_file.h"

namespace ghostforce {

class OutputFolder {
 public:
  // Makes the folder, and those above it. Fails at once where it can never hold a file, not after long work.
  explicit OutputFolder(const std::string& path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // `name` is that of a file in the folder.
  void write(const std::string& name, std::string_view content);

  void commit();

 private:
  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  // folders, the innermost first
  std::deque<OutputFile> files_;
  bool is_committed_ = false;
};

}  // namespace ghostforce
