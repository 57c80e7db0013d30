#include "app/cli/overwrite_guard.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/output_file.h"

namespace ghostforce {
namespace {

struct KnownInput {
  std::string option;
  std::string path;
  dev_t device;
  ino_t number;
};

// Pipes and devices hold nothing that could be lost.
bool is_plain_file(const std::string& path, struct stat& status) {
  return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

// Where an output goes, in one way of writing; what cannot be followed (a pipe, links in a circle) by its name.
std::filesystem::path destination(const std::string& output) {
  std::error_code error;
  const std::filesystem::path path =
      end_of_links(std::filesystem::absolute(output == "-" ? "/dev/stdout" : output, error));
  std::filesystem::path resolved = std::filesystem::weakly_canonical(path, error);
  return error ? path.lexically_normal() : resolved.lexically_normal();
}

// Two outputs in one place would be one, and the other lost.
void refuse_equal_outputs(std::span<const FileOption> options) {
  std::map<std::filesystem::path, std::string> written;  // and by which option
  for (const FileOption& option : options) {
    if (option.use != FileOption::Use::output) continue;
    for (const std::string& path : option.paths()) {
      const auto [other, is_first] = written.emplace(destination(path), option.name);
      if (is_first) continue;
      throw Failure(ExitCode::wrong_call, fmt::format("{} {}: {} already writes to this file; name another",
                                                      option.name, quoted_text(path, longest_path), other->second));
    }
  }
}

void refuse_links_in_folders(std::span<const FileOption> options) {
  std::error_code error;
  for (const FileOption& option : options) {
    if (option.use != FileOption::Use::output || !option.is_folder) continue;
    for (const std::string& path : option.paths()) {
      if (!std::filesystem::is_symlink(std::filesystem::symlink_status(path, error))) continue;
      throw Failure(ExitCode::wrong_call,
                    fmt::format("{}: {} is a link, and would lead what is written there to another file; remove it, "
                                "or name another folder",
                                option.name, quoted_text(path, longest_path)));
    }
  }
}

}  // namespace

CLI::Option* FileOptions::add(FileOption::Use use, CLI::Option* option, const FilesOf& files) {
  list_.push_back({use, option, option->get_name(),
                   [option, files] {
                     if (!files) return option->results();
                     std::vector<std::string> paths;
                     for (const std::string& word : option->results())
                       std::ranges::copy(files(word), std::back_inserter(paths));
                     return paths;
                   },
                   use == FileOption::Use::output && files != nullptr});
  return option;
}

FileOptions::FilesOf path_unless_one_of(std::vector<std::string_view> shipped) {
  return [shipped = std::move(shipped)](const std::string& word) {
    const bool is_shipped = std::ranges::find(shipped, word) != shipped.end();
    return is_shipped ? std::vector<std::string>{} : std::vector{word};
  };
}

void refuse_to_overwrite(std::span<const FileOption> options) {
  refuse_equal_outputs(options);
  struct stat status {};
  std::vector<KnownInput> inputs;
  for (const FileOption& option : options) {
    if (option.use != FileOption::Use::input) continue;
    for (const std::string& path : option.paths()) {
      if (is_plain_file(path, status)) inputs.push_back({option.name, path, status.st_dev, status.st_ino});
    }
  }
  const auto input_at = [&] {
    return std::ranges::find_if(inputs, [&](const KnownInput& input) {
      return input.device == status.st_dev && input.number == status.st_ino;
    });
  };
  for (const FileOption& option : options) {
    if (option.use != FileOption::Use::output) continue;
    for (const std::string& path : option.paths()) {
      if (!is_plain_file(path, status)) continue;
      const auto input = input_at();
      if (input == inputs.end()) continue;
      throw Failure(
          ExitCode::wrong_call,
          fmt::format("{} {}: would overwrite {}, which this command reads as {}; name another file", option.name,
                      quoted_text(path, longest_path), quoted_text(input->path, longest_path), input->option));
    }
  }
  refuse_links_in_folders(options);
  if (fstat(STDOUT_FILENO, &status) != 0 || !S_ISREG(status.st_mode)) return;
  if (const auto input = input_at(); input != inputs.end()) {
    throw Failure(ExitCode::wrong_call,
                  fmt::format("standard output goes to {}, which this command reads as {}; redirect it elsewhere",
                              quoted_text(input->path, longest_path), input->option));
  }
}

}  // namespace ghostforce
