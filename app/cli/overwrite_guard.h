// No command writes over what it reads, or over another output of its own: its outputs are looked at once, before any
// work, whatever they are called and whichever links lead there. Not for the servo thread.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ghostforce {

// An option or argument that names files, as it was given.
struct FileOption {
  enum class Use { input, output };
  Use use;
  const CLI::Option* option;
  std::string name;  // of the option, for messages
  std::function<std::vector<std::string>()> paths;
  bool is_folder;  // an output's value is a folder, and these are files in it
};

// The options of one command that name files, in the order in which they were added.
class FileOptions {
 public:
  // The files that a word on the command line means.
  using FilesOf = std::function<std::vector<std::string>(const std::string& word)>;

  // The option's value is the path of a file, or means files, that the command reads. Or writes: then it is a folder
  // for them.
  CLI::Option* reads(CLI::Option* option, FilesOf files = nullptr) {
    return add(FileOption::Use::input, option, files);
  }
  CLI::Option* writes(CLI::Option* option, FilesOf files = nullptr) {
    return add(FileOption::Use::output, option, files);
  }

  std::span<const FileOption> list() const noexcept { return list_; }

 private:
  CLI::Option* add(FileOption::Use use, CLI::Option* option, const FilesOf& files);

  std::vector<FileOption> list_;
};

// Of a word that may be the name of something shipped: that is no file, anything else a path.
FileOptions::FilesOf path_unless_one_of(std::vector<std::string_view> shipped);

// The standard output counts as an output of every command. Throws Failure(wrong_call) where an output is a plain file
// that is an input or another output too, and where a file in a folder for outputs is a link: it would lead to a place
// that nobody has named.
void refuse_to_overwrite(std::span<const FileOption> options);

}  // namespace ghostforce
