// ghostforce figures: the paper's figures, and further ones, each with the numbers that it was drawn from.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/progress.h"
#include "app/base/quoted.h"
#include "app/base/words.h"
#include "app/cli/command.h"
#include "app/cli/option.h"
#include "app/files/output_file.h"
#include "app/files/run_reader.h"
#include "app/tools/figures/figure.h"
#include "app/tools/figures/simulated_motion.h"

namespace ghostforce {
namespace {

struct FiguresOptions {
  std::string folder;
  std::vector<std::string> only;  // empty: all
  std::string hand;               // empty: simulated
};

bool is_wanted(const FiguresOptions& options, std::string_view name) {
  return options.only.empty() || std::ranges::find(options.only, name) != options.only.end();
}

// A recording that no figure is made of would go unseen.
void refuse_hand_without_figure(const FiguresOptions& options) {
  const auto shows_hand = [&](const FigureEntry& entry) { return entry.takes_hand && is_wanted(options, entry.name); };
  if (options.hand.empty() || std::ranges::any_of(figure_catalog(), shows_hand)) return;
  throw Failure(ExitCode::wrong_call, "--hand: only figure-6 shows a hand; add it to --only, or leave out --hand");
}

FigureRequest request_of(const FiguresOptions& options) {
  if (options.hand.empty()) return {};
  const Run run = load_run(options.hand);
  for (const std::string& warning : run.warnings) say("{}\n", warning);
  FigureRequest request{recorded_hand(run, quoted_text(std::filesystem::path(options.hand).filename().string()))};
  for (const std::string& words : request.hand->left_out) say("{}: {}\n", request.hand->name, words);
  return request;
}

int figures(const FiguresOptions& options) {
  if (options.folder.empty()) {
    throw Failure(ExitCode::wrong_call, "-o: the name of the folder is empty; '.' is the current folder");
  }
  refuse_hand_without_figure(options);
  const FigureRequest request = request_of(options);
  OutputFolder folder(options.folder);
  std::size_t count = 0;
  std::vector<std::string> lines;
  {
    Progress progress("drawing", static_cast<std::int64_t>(figure_catalog().size()), true);
    std::int64_t done = 0;
    for (const FigureEntry& entry : figure_catalog()) {
      stop_if_interrupted();
      if (is_wanted(options, entry.name)) {
        const Figure figure = entry.make(request);
        for (const NamedFile& file : figure_files(entry.name, figure)) {
          folder.write(file.name, file.content);
          ++count;
        }
        lines.push_back(fmt::format("{}: {}", entry.name, figure.title));
      }
      progress.at(++done);
    }
  }
  stop_if_interrupted();
  folder.commit();
  for (const std::string& line : lines) say("{}\n", line);
  say("{} files in {}\n", count, quoted_text(options.folder, longest_path));
  return static_cast<int>(ExitCode::done);
}

}  // namespace

std::function<int()> attach_figures(CLI::App& command, FileOptions& files) {
  const auto options = std::make_shared<FiguresOptions>();
  files.writes(add_option(command, "-o,--output DIR", options->folder, "The folder for the files; created if necessary")
                   ->required(),
               [options = options.get()](const std::string& folder) {
                 std::vector<std::string> paths;
                 for (const FigureEntry& entry : figure_catalog()) {
                   if (!is_wanted(*options, entry.name)) continue;
                   for (const std::string_view ending : figure_file_endings) {
                     paths.push_back(fmt::format("{}/{}{}", folder, entry.name, ending));
                   }
                 }
                 return paths;
               });
  std::string list;
  for (const FigureEntry& entry : figure_catalog()) list += fmt::format("  {:28}{}\n", entry.name, entry.sentence);
  add_option(command, "--only NAME", options->only, "Make only these figures")
      ->check(one_of(names_of(figure_catalog())));
  files.reads(
      add_option(command, "--hand RUN.csv", options->hand,
                 "A recording, or a CSV file from 'simulate': figure-6 shows its hand instead of a simulated one"));
  command.footer(fmt::format("Figures:\n{}\n{}", list, command.get_footer()));
  return [options] { return figures(*options); };
}

}  // namespace ghostforce
