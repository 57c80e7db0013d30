// The lists of all keys and of all actions, in groups.
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/stage/control_pieces.h"
#include "app/state/key_bindings.h"
#include "app/state/palette_catalog.h"

namespace ghostforce {
namespace {

using Kind = StageControlKind;

// Under the headings of their groups.
class GroupedRows {
 public:
  GroupedRows(const ControlSource& source, std::string id, std::string_view words)
      : source_(source), id_(std::move(id)), words_(words) {}

  void add(ActionGroup group, StageControl row) {
    row.id = fmt::format("{}-{}", id_, ++count_);
    groups_.at(static_cast<std::size_t>(group)).push_back(std::move(row));
  }

  StageControl list() && {
    const auto headings = words_of(source_.language.action_groups);
    ControlParts parts;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (groups_[i].empty()) continue;
      parts.push_back(
          group_control(fmt::format("{}-group-{}", id_, i + 1), Kind::rows, headings.at(i), std::move(groups_[i])));
    }
    return group_control(id_ + "s", Kind::folded, words_, std::move(parts));
  }

 private:
  const ControlSource& source_;
  std::string id_;
  std::string_view words_;
  std::size_t count_ = 0;
  std::array<ControlParts, action_group_count> groups_;
};

}  // namespace

StageControl key_list(const ControlSource& source) {
  GroupedRows rows(source, "key", source.language.menu_rows.keys.title);
  ActionGroup group{};
  for (const KeyBinding& binding : key_table()) {
    if (!binding.group.empty()) group = action_group_of(binding.group);
    if (binding.shown.empty()) continue;
    rows.add(group,
             text_control(
                 {}, Kind::text,
                 fmt::format("{}: {}", counterpart(english_stage.key_names, source.language.key_names, binding.shown),
                             sentence_in(source.language, binding))));
  }
  return std::move(rows).list();
}

StageControl action_list(const ControlSource& source) {
  GroupedRows rows(source, "action", source.language.palette.title);
  for (PaletteEntry& entry : palette_catalog(source.session, source.loop)) {
    const Action action = entry.action;
    rows.add(entry.group, {.id = {},
                           .kind = Kind::button,
                           .words = std::move(entry.words),
                           .refusal = std::move(entry.refusal),
                           .act = [action](double) { return std::vector{action}; }});
  }
  return std::move(rows).list();
}

}  // namespace ghostforce
