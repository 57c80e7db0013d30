#include "app/shell/session_file.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/input_file.h"
#include "app/files/output_file.h"
#include "app/shell/action_text.h"
#include "app/shell/line_text.h"

namespace ghostforce {
namespace {

constexpr LineKind start_kind = line_kind<SessionStart>(
    "ghostforce-session", line_field<&SessionStart::format>("format"), line_field<&SessionStart::program>("program"),
    line_field<&SessionStart::input>("input"), line_field<&SessionStart::face>("face"),
    line_field<&SessionStart::mode>("mode"), line_field<&SessionStart::lesson>("lesson"),
    line_field<&SessionStart::language>("language"), line_field<&SessionStart::width>("width"),
    line_field<&SessionStart::height>("height"), line_field<&SessionStart::scene>("scene"));

constexpr std::string_view end_name = "end";

struct LineWord {
  std::size_t column = 1;
  std::string text{};  // as it stands there; of a value that is quoted what is meant
  std::string name{};  // before the equals sign
  bool has_value = false;
};

class SessionReader {
 public:
  explicit SessionReader(std::string_view shown_path) : shown_path_(shown_path) {}

  RecordedSession read(std::string_view text) {
    RecordedSession session;
    if (text.empty()) {
      throw ReadError(ReadError::Kind::wrong,
                      {{.file = shown_path_,
                        .what = "the file is empty",
                        .remedy = "name one that 'ghostforce run --record-session' has written"}});
    }
    while (!text.empty()) {
      ++line_;
      const std::size_t end = text.find('\n');
      const std::string_view line = text.substr(0, end);
      if (end == std::string_view::npos) {
        refuse(line.size() + 1, "the file ends within this line", "remove the line, of which the rest is lost");
        break;
      }
      text.remove_prefix(end + 1);
      if (!read_line(line, session)) break;
    }
    if (!has_end_ && !session.actions.empty()) session.end_s = session.actions.back().time_s;
    throw_problems();
    return session;
  }

 private:
  using Place = std::pair<std::size_t, std::size_t>;

  // False: of what follows nothing can be said.
  bool read_line(std::string_view line, RecordedSession& session) {
    const std::optional<std::vector<LineWord>> words = split(line);
    if (line_ == 1) {
      const bool is_start = words && !words->empty() && words->front().text == start_kind.name;
      if (!is_start) {
        refuse(1, "this is no recorded session", fmt::format("its first line has to begin with '{}'", start_kind.name));
        return false;
      }
      return read_start(*words, session.start);
    }
    if (has_end_) {
      refuse(1, "something follows the end of the session", "remove it");
      return false;
    }
    if (words) read_timed(*words, session);
    return true;
  }

  // Of a newer format only that can be said.
  bool read_start(const std::vector<LineWord>& words, SessionStart& start) {
    const auto is_format = [](const LineWord& word) { return word.has_value && word.name == "format"; };
    if (const auto told = std::ranges::find_if(words, is_format); told != words.end()) {
      const auto format = number_in<int>(told->text);
      if (format && *format != SessionStart::newest_format) {
        refuse(told->column, fmt::format("the format {} is not known", *format),
               fmt::format("this program reads the format {}; use the one that has written the file",
                           SessionStart::newest_format));
        return false;
      }
    }
    SessionStart read;
    if (read_fields(start_kind, words.front(), std::span(words).subspan(1), &read)) start = std::move(read);
    if (start.width < 1 || start.height < 1 || start.width > most_points || start.height > most_points)
      refuse(1, fmt::format("no window has {}×{} points", start.width, start.height),
             fmt::format("give a width and a height from 1 to {}", most_points));
    return true;
  }

  void read_timed(const std::vector<LineWord>& words, RecordedSession& session) {
    if (words.empty()) return refuse(1, "the line is empty", "remove it");
    const std::optional<double> time_s = number_in<double>(words[0].text);
    if (!time_s || !std::isfinite(*time_s) || *time_s < 0.0 || words[0].has_value) {
      return refuse(1, fmt::format("'{}' is not a time", quoted_text(words[0].text)),
                    "begin the line with the seconds since the session began");
    }
    if (*time_s < last_s_) {
      refuse(1, fmt::format("the time goes back, from {} s to {} s", last_s_, *time_s), "put the lines in their order");
    }
    last_s_ = std::max(last_s_, *time_s);
    if (words.size() < 2) return refuse(1, "the line has a time alone", "name what was done");
    const LineWord& name = words[1];
    const auto fields = std::span(words).subspan(2);
    if (name.text == end_name && !name.has_value) {
      has_end_ = true;
      session.end_s = *time_s;
      for (const LineWord& word : fields) refuse(word.column, "the end has no fields", "remove this");
      return;
    }
    if (auto action = read_action(name, fields)) session.actions.push_back({*time_s, *std::move(action)});
  }

  std::optional<Action> read_action(const LineWord& name, std::span<const LineWord> words) {
    for (const ActionKind& kind : action_kinds()) {
      if (kind.line.name != name.text) continue;
      Action action = kind.make();
      return read_fields(kind.line, name, words, object_of(action)) ? std::optional(std::move(action)) : std::nullopt;
    }
    std::vector<std::string_view> names{end_name};
    for (const ActionKind& kind : action_kinds()) names.push_back(kind.line.name);
    refuse(name.column, fmt::format("'{}' is nothing that can be done", quoted_text(name.text)),
           "name an action of docs/sessions.md" + did_you_mean(name.text, names));
    return std::nullopt;
  }

  // False: not all of it can be read, and the object is of no use.
  bool read_fields(const LineKind& kind, const LineWord& name, std::span<const LineWord> words, void* object) {
    bool is_sound = true;
    std::vector<std::string_view> known;
    const auto refuse_field = [&](std::size_t column, std::string what, std::string remedy) {
      refuse(column, std::move(what), std::move(remedy));
      is_sound = false;
    };
    for (const LineField& field : kind.fields()) {
      known.push_back(field.name);
      const LineWord* found = nullptr;
      for (const LineWord& word : words) {
        if (!word.has_value || word.name != field.name) continue;
        if (found != nullptr) refuse_field(word.column, fmt::format("{} is given twice", field.name), "remove one");
        found = &word;
      }
      if (found == nullptr) {
        refuse_field(name.column, fmt::format("{} lacks {}", kind.name, field.name),
                     fmt::format("add {}=…, {}", field.name, field.type->wanted()));
      } else if (!field.read(found->text, object)) {
        refuse_field(found->column, fmt::format("{} is '{}'", field.name, quoted_text(found->text)),
                     fmt::format("give {}", field.type->wanted()));
      }
    }
    for (const LineWord& word : words) {
      const std::string& typed = word.has_value ? word.name : word.text;
      if (word.has_value && std::ranges::find(known, typed) != known.end()) continue;
      refuse_field(word.column, fmt::format("{} has no '{}'", kind.name, quoted_text(typed)),
                   "remove it" + did_you_mean(typed, known));
    }
    return is_sound;
  }

  // The words between blanks. Empty: one of them is no word.
  std::optional<std::vector<LineWord>> split(std::string_view line) {
    std::vector<LineWord> words;
    std::size_t at = 0;
    while ((at = line.find_first_not_of(' ', at)) != std::string_view::npos) {
      LineWord word{.column = at + 1};
      const std::size_t end = std::min(line.find_first_of(" =", at), line.size());
      word.text = line.substr(at, end - at);
      at = end;
      if (at < line.size() && line[at] == '=') {
        word.has_value = true;
        word.name = std::exchange(word.text, {});
        if (!read_value(line, ++at, word.text)) return std::nullopt;
      }
      words.push_back(std::move(word));
    }
    return words;
  }

  bool read_value(std::string_view line, std::size_t& at, std::string& value) {
    if (at == line.size() || line[at] != '"') {
      const std::size_t end = std::min(line.find(' ', at), line.size());
      value = line.substr(at, end - at);
      at = end;
      return true;
    }
    const std::size_t began = at++;
    constexpr std::string_view letters = "\"\\ntr";
    constexpr std::string_view meant = "\"\\\n\t\r";
    while (at < line.size() && line[at] != '"') {
      if (line[at] != '\\') {
        value += line[at++];
        continue;
      }
      const std::string_view after = line.substr(at + 1);
      const auto code = after.starts_with('u') ? number_in<unsigned>(after.substr(1, 4), 16) : std::nullopt;
      const std::size_t letter = after.empty() ? std::string_view::npos : letters.find(after.front());
      if (letter != std::string_view::npos) {
        value += meant[letter];
        at += 2;
      } else if (code && *code < 0x80 && after.size() > 4) {
        value += static_cast<char>(*code);
        at += 6;
      } else {
        refuse(at + 1, "after this backslash stands no sign that it could mean", "write two for one");
        return false;
      }
    }
    if (at == line.size()) {
      refuse(began + 1, "the quote is not closed", "end the text with \"");
      return false;
    }
    if (++at < line.size() && line[at] != ' ') {
      refuse(at + 1, "something follows the quote", "put a blank between them");
      return false;
    }
    return true;
  }

  void refuse(std::size_t column, std::string what, std::string remedy) {
    problems_.add(Place{line_, column}, ReadProblem{.file = shown_path_,
                                                    .line = line_,
                                                    .column = column,
                                                    .what = std::move(what),
                                                    .remedy = std::move(remedy)});
  }

  void throw_problems() const {
    if (problems_.empty()) return;
    std::vector<ReadProblem> told;
    const std::size_t more =
        problems_.tell([&](const Place&, ReadProblem problem) { told.push_back(std::move(problem)); });
    if (more > 0) told.push_back({.what = fmt::format("… and {} more", more)});
    throw ReadError(ReadError::Kind::wrong, std::move(told));
  }

  static constexpr int most_points = 16384;

  std::string shown_path_;
  std::size_t line_ = 0;
  double last_s_ = 0.0;
  bool has_end_ = false;
  ProblemList<Place, ReadProblem> problems_;
};

}  // namespace

std::string start_line(const SessionStart& start) {
  return kind_text(start_kind, &start) + '\n';
}

std::string action_line(const TimedAction& timed) {
  return fmt::format("{} {}\n", timed.time_s, action_text(timed.action));
}

std::string end_line(double time_s) {
  return fmt::format("{} {}\n", time_s, end_name);
}

std::string session_text(const RecordedSession& session) {
  std::string text = start_line(session.start);
  for (const TimedAction& timed : session.actions) text += action_line(timed);
  return text + end_line(session.end_s);
}

RecordedSession read_session(std::string_view text, std::string_view shown_path) {
  return SessionReader(shown_path).read(text);
}

RecordedSession load_session(const std::string& path) {
  const std::string shown = quoted_text(path, longest_path);
  const FileContents file = file_contents(path);
  if (file.error == ENOENT || file.error == ENOTDIR) {
    throw ReadError(ReadError::Kind::wrong,
                    {{.file = shown, .what = "there is no such file", .remedy = "name a recorded session"}});
  }
  if (file.error != 0) throw unreadable(shown, file.error);
  return read_session(file.text, shown);
}

SessionRecorder::SessionRecorder(const std::string& path, const SessionStart& start)
    : path_(path), descriptor_(open_growing_file(path)) {
  constexpr std::string_view kind = "a session";
  if (descriptor_.number() < 0) throw no_growing_file(path, kind, errno);
  append(start_line(start));
  if (error_ == 0) return;
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  throw no_growing_file(path, kind, error_);
}

void SessionRecorder::write_choices(const Session& session) {
  for (const Action& choice : {Action(ChangeAppearance{session.appearance}), Action(ChangeMotion{session.motion}),
                               Action(ChangeViewOptions{session.options}), Action(ChangePlots{session.plots}),
                               Action(ChangeSpaceMouse{session.spacemouse}), Action(ChangeSpeed{session.speed}),
                               Action(ChooseLanguage{session.language})}) {
    write(0.0, choice);
  }
}

std::string SessionRecorder::problem() const {
  if (error_ == 0) return {};
  return fmt::format("{} does not hold the whole session: {}", quoted_text(path_, longest_path), reason_of(error_));
}

void SessionRecorder::append(const std::string& line) noexcept {
  if (error_ == 0) error_ = append_whole(descriptor_.number(), line);
}

}  // namespace ghostforce
