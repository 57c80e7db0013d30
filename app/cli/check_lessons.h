// What `ghostforce check` says about lessons.
#pragma once

#include <string>
#include <vector>

namespace ghostforce {

// A word on the command line that is rather a lesson than a folder of cases.
bool may_be_lesson(const std::string& word);

// Reads each as the window would, and prints what it finds, step by step. Returns an exit code: done; answer_is_no where
// a step cannot be done; wrong_call or file_trouble where a lesson cannot be read.
int check_lessons(const std::vector<std::string>& lessons);

}  // namespace ghostforce
