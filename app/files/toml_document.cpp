#include "app/files/toml_document.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "app/base/typed_text.h"
#include "app/files/toml_parse.h"

namespace ghostforce {
namespace {

constexpr std::string_view format_name = "format";
constexpr std::int64_t oldest_format = 1;

// Where something is wrong; sorts as a person reads.
struct Place {
  std::size_t override_number = 0;  // 0: in the file; else the number of the --set, from 1
  toml::source_index line = 1;
  toml::source_index column = 1;

  auto operator<=>(const Place&) const = default;
};

Place in_file(toml::source_position position) {
  return {0, std::max<toml::source_index>(position.line, 1), std::max<toml::source_index>(position.column, 1)};
}

struct Override {
  std::string argument;
  std::string key;    // dotted; empty: it is wrong
  toml::table value;  // under the name "value"
};

// What a person calls a value of this type.
std::string_view type_words(const toml::node& node) noexcept {
  constexpr std::array<std::string_view, 10> words{"nothing",        "a table",       "an array",      "a string",
                                                   "a number",       "a number",      "true or false", "a date or time",
                                                   "a date or time", "a date or time"};
  static_assert(static_cast<std::size_t>(toml::node_type::date_time) + 1 == words.size());
  return words[static_cast<std::size_t>(node.type())];
}

std::optional<toml::table> parse_toml_value(std::string_view value) {
  ParsedToml parsed = parse_toml(fmt::format("value = {}\n", value));
  // A line break in the value could have begun another key.
  if (parsed.problem || parsed.table.size() != 1) return std::nullopt;
  return std::move(parsed.table);
}

bool is_word(std::string_view value) noexcept {
  return std::all_of(value.begin(), value.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_'; });
}

std::optional<toml::table> parse_override(bool holds_text, std::string_view value) {
  const bool is_quoted = value.starts_with('"') || value.starts_with('\'');
  if (holds_text && !is_quoted) return parse_toml_value(toml_string(value));
  if (value.empty()) return std::nullopt;
  if (std::optional<toml::table> parsed = parse_toml_value(value)) return parsed;
  return is_word(value) ? parse_toml_value(toml_string(value)) : std::nullopt;
}

const TomlKey* find_key(std::span<const TomlKey> keys, std::string_view table, std::string_view name) {
  for (const TomlKey& key : keys)
    if (key.table == table && key.name == name) return &key;
  return nullptr;
}

bool contains(std::span<const std::string_view> words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

std::vector<std::string_view> tables_of(std::span<const TomlKey> keys) {
  std::vector<std::string_view> tables;
  for (const TomlKey& key : keys) {
    if (!key.table.empty() && !contains(tables, key.table)) tables.push_back(key.table);
  }
  return tables;
}

std::vector<std::string_view> needed_in(std::span<const TomlKey> keys, std::string_view table) {
  std::vector<std::string_view> needed;
  for (const TomlKey& key : keys)
    if (key.table == table && key.if_missing) needed.push_back(key.name);
  return needed;
}

std::string suggestion(std::string_view name, std::span<const std::string_view> here) {
  const std::string near = did_you_mean(name, here);
  return near.empty() ? fmt::format("; the keys here are {}", listed(here)) : near;
}

std::string suggestion(std::span<const TomlKey> keys, std::string_view table, std::string_view name) {
  std::vector<std::string_view> here;
  for (const TomlKey& key : keys) {
    if (key.name == name) {
      return fmt::format("; did you mean '{}'?{}", dotted_name(key.table, key.name),
                         key.table.empty() ? " It belongs before the first [table]" : "");
    }
    if (key.table == table) here.push_back(key.name);
  }
  if (table.empty()) std::ranges::copy(tables_of(keys), std::back_inserter(here));
  return suggestion(name, here);
}

ReadProblem problem(std::string what, std::string_view remedy) {
  if (remedy.starts_with("; ")) remedy.remove_prefix(2);
  return {.what = std::move(what), .remedy = std::string(remedy)};
}

const toml::node& node_at(const void* node) noexcept {
  return *static_cast<const toml::node*>(node);
}

}  // namespace

struct TomlReader::Content {
  std::string shown_path;
  toml::table file{};
  std::vector<Override> overrides{};
  std::span<const TomlKey> keys{};
  Suggest suggest{};
  ProblemList<Place, ReadProblem> problems{};
  std::set<std::string, std::less<>> names{};  // of tables within tables, for messages

  static Place place_of(const TomlValue& value) {
    if (value.override_number_ > 0) return {value.override_number_};
    return in_file(node_at(value.node_).source().begin);
  }

  ReadProblem at(const Place& place, ReadProblem words) const {
    if (place.override_number > 0) {
      words.file = fmt::format("--set {}", quoted_text(overrides[place.override_number - 1].argument));
    } else {
      words.file = shown_path;
      words.line = place.line;
      words.column = place.column;
    }
    return words;
  }
};

std::string range_words(const NumberLimits& limits) {
  constexpr NumberLimits any;
  if (limits.least == any.least && limits.greatest == any.greatest) {
    return limits.unit.empty() ? "any finite number" : fmt::format("a finite number of {}", limits.unit);
  }
  return fmt::format("{} to {}{}{}{}", limits.least, limits.greatest, limits.unit.empty() ? "" : " ", limits.unit,
                     limits.may_be_infinite ? ", or inf" : "");
}

// --- Values ---

void TomlValue::refuse(std::string_view what, std::string_view remedy) const {
  reader_->refuse(fmt::format("the key {}: {}", dotted_name(table_, name_), what), remedy, *this);
}

void TomlValue::refuse_type(std::string_view remedy, std::string_view verb) const {
  refuse(fmt::format("{} {}", verb, type_words(node_at(node_))), remedy);
}

ReadProblem TomlValue::place() const {
  return reader_->content_->at(TomlReader::Content::place_of(*this), {});
}

std::optional<std::int64_t> TomlValue::as_integer() const {
  const auto* const number = node_at(node_).as_integer();
  return number == nullptr ? std::nullopt : std::optional(number->get());
}

const std::string* TomlValue::as_text() const {
  const auto* const text = node_at(node_).as_string();
  return text == nullptr ? nullptr : &text->get();
}

std::optional<double> TomlValue::number(const NumberLimits& limits) const {
  // A path has a hundred thousand numbers: words are made for those that are wrong.
  const auto need = [&] {
    return fmt::format("give {}{}", limits.whole ? "a whole number, " : "", range_words(limits));
  };
  const toml::value<std::int64_t>* const integer = node_at(node_).as_integer();
  const std::optional<double> number =
      integer != nullptr ? static_cast<double>(integer->get()) : node_at(node_).value_exact<double>();
  if (!number) {
    refuse_type(need());
  } else if (limits.whole && integer == nullptr && std::isfinite(*number)) {
    refuse("has a decimal point or an exponent", need());
  } else if (!(*number >= limits.least && *number <= limits.greatest) &&
             !(limits.may_be_infinite && *number == std::numeric_limits<double>::infinity())) {  // NaN, too
    refuse(fmt::format("{} is out of range", *number), need());
  } else {
    return number;
  }
  return std::nullopt;
}

std::optional<bool> TomlValue::yes_or_no() const {
  if (const auto* const value = node_at(node_).as_boolean()) return value->get();
  refuse_type("give true or false");
  return std::nullopt;
}

std::optional<std::string> TomlValue::text(bool may_have_lines) const {
  const std::string* const value = as_text();
  if (value == nullptr) {
    refuse_type("give a string in quotes");
  } else if (const auto what = unshowable_in(*value, may_have_lines)) {
    refuse(fmt::format("contains {}", *what), "remove it");
  } else {
    return *value;
  }
  return std::nullopt;
}

std::optional<std::size_t> TomlValue::word(std::span<const std::string_view> words) const {
  const std::string* const value = as_text();
  if (value == nullptr) {
    refuse_type(fmt::format("give one of {}", listed(words)));
    return std::nullopt;
  }
  const auto found = std::ranges::find(words, *value);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  refuse(fmt::format("'{}' is not one of {}", quoted_text(*value), listed(words)), did_you_mean(*value, words));
  return std::nullopt;
}

std::optional<std::size_t> TomlValue::count(std::string_view remedy) const {
  if (const toml::array* const array = node_at(node_).as_array()) return array->size();
  refuse_type(remedy);
  return std::nullopt;
}

TomlValue TomlValue::operator[](std::size_t element) const {
  TomlValue value = *this;
  value.node_ = node_at(node_).as_array()->get(element);
  return value;
}

bool TomlValue::read_numbers(std::span<double> into, const NumberLimits& limits, std::string_view remedy) const {
  const auto there = count(remedy);
  if (there && *there != into.size()) refuse(fmt::format("is an array of {}", *there), remedy);
  bool is_good = there == into.size();
  for (std::size_t i = 0; is_good && i < into.size(); ++i) {
    const TomlValue value = (*this)[i];
    if (limits.whole && node_at(value.node_).is_floating_point()) {
      value.refuse("has a decimal point or an exponent", "give whole numbers");
      is_good = false;
    } else if (const auto number = value.number(limits)) {
      into[i] = *number;
    } else {
      is_good = false;
    }
  }
  return is_good;
}

TomlValue TomlValue::child(std::string_view name, const void* node) const {
  auto& names = reader_->content_->names;
  TomlValue value = *this;
  value.node_ = node;
  value.table_ = *names.insert(dotted_name(table_, name_)).first;
  value.name_ = *names.insert(quoted_text(name)).first;
  return value;
}

bool TomlValue::is_table() const noexcept {
  return node_at(node_).is_table();
}

bool TomlValue::read_table(std::span<const TomlKey> keys, const TakeOther& other) const {
  const toml::table* const table = node_at(node_).as_table();
  if (table == nullptr) {
    refuse_type(fmt::format("write a table with the keys {}", listed(names_of(keys))));
    return false;
  }
  auto& problems = reader_->content_->problems;
  const std::string path = dotted_name(table_, name_);
  for (const auto& [key, node] : *table) {
    if (find_key(keys, "", key.str()) != nullptr) continue;
    if (other && other(key.str(), child(key.str(), &node))) continue;
    problems.add(in_file(key.source().begin), [path, name = key.str(), here = names_of(keys)] {
      return problem(fmt::format("the key {} is unknown", dotted_name(path, quoted_text(name))),
                     suggestion(name, here));
    });
  }
  for (const TomlKey& key : keys) {
    if (const toml::node* const node = table->get(key.name)) {
      if (key.read) key.read(child(key.name, node));
    } else if (key.if_missing) {
      problems.add(in_file(table->source().begin),
                   problem(fmt::format("the key {} is missing", dotted_name(path, key.name)), *key.if_missing));
    }
  }
  return true;
}

// --- The file and --set as TOML ---

TomlReader::TomlReader(std::string_view shown_path)
    : content_(std::make_unique<Content>(Content{.shown_path = quoted_text(shown_path, longest_path)})) {}

TomlReader::~TomlReader() = default;

bool TomlReader::parse(std::string_view text) {
  ParsedToml parsed = parse_toml(text);
  if (parsed.problem) {
    content_->problems.add(in_file(parsed.problem->position), problem(std::move(parsed.problem->what), ""));
  }
  content_->file = std::move(parsed.table);
  return content_->problems.empty();
}

void TomlReader::override_key(std::string_view argument, std::string_view key, std::string_view value,
                              bool holds_text) {
  if (std::optional<toml::table> parsed = parse_override(holds_text, value)) {
    content_->overrides.push_back({std::string(argument), std::string(key), std::move(*parsed)});
    return;
  }
  refuse_override(
      argument,
      fmt::format("the key {}: {}", key,
                  value.empty() ? "it has no value" : fmt::format("{} is not a value", quoted_text(value))),
      holds_text ? "give a string in UTF-8" : "give a number such as 1.5, inf, or an array such as [0.0, 10.0]");
}

void TomlReader::refuse_override(std::string_view argument, std::string_view what, std::string_view remedy) {
  content_->overrides.push_back({std::string(argument), "", {}});
  content_->problems.add({content_->overrides.size()}, problem(std::string(what), remedy));
}

TomlValue TomlReader::whole() {
  TomlValue value;
  value.reader_ = this;
  value.node_ = &content_->file;
  return value;
}

bool TomlReader::is_empty() const {
  return content_->file.empty();
}

bool TomlReader::has_table(std::string_view name) const {
  return content_->file[name].is_table();
}

std::optional<TomlValue> TomlReader::find(std::string_view table, std::string_view name) {
  TomlValue value;
  const auto& overrides = content_->overrides;
  for (std::size_t number = overrides.size(); number > 0 && value.node_ == nullptr; --number) {
    if (overrides[number - 1].key != dotted_name(table, name)) continue;
    value.node_ = overrides[number - 1].value.get("value");
    value.override_number_ = number;
  }
  const toml::table* const in = table.empty() ? &content_->file : content_->file[table].as_table();
  if (value.node_ == nullptr && in != nullptr) value.node_ = in->get(name);
  if (value.node_ == nullptr) return std::nullopt;
  value.reader_ = this;
  value.table_ = table;
  value.name_ = name;
  return value;
}

// --- What is there and what is not ---

bool TomlReader::has_known_format(std::int64_t newest, std::int64_t meant) {
  const auto value = find("", format_name);
  const std::string remedy =
      newest == oldest_format ? "write format = 1" : fmt::format("write format = 1 or {}", newest);
  if (!value) {
    refuse("the key format is missing", fmt::format("start the file with format = {}", meant));
    return true;
  }
  const auto* const number = node_at(value->node_).as_integer();
  if (number == nullptr) {
    value->refuse_type(remedy);
  } else if (number->get() < oldest_format) {
    value->refuse(fmt::format("is {}", number->get()), remedy);
  } else if (number->get() > newest) {
    const std::string known = newest == oldest_format ? "format 1" : fmt::format("formats 1 to {}", newest);
    value->refuse(fmt::format("is {}, but this program only knows {}", number->get(), known),
                  "a newer version may read it");
    return false;
  }
  return true;
}

void TomlReader::find_unknown() {
  const std::vector<std::string_view> tables = tables_of(content_->keys);
  // Of a million such keys the first few get words.
  const auto refuse_key = [this](std::string_view table, const toml::key& key) {
    content_->problems.add(in_file(key.source().begin), [content = content_.get(), table, name = key.str()] {
      return problem(fmt::format("the key {} is unknown", dotted_name(table, quoted_text(name))),
                     content->suggest ? content->suggest(table, name) : suggestion(content->keys, table, name));
    });
  };
  for (const auto& [key, node] : content_->file) {
    const std::string_view name = key.str();
    if (contains(tables, name)) {
      if (const toml::table* const table = node.as_table()) {
        for (const auto& [inner, value] : *table) {
          if (find_key(content_->keys, name, inner.str()) == nullptr) refuse_key(name, inner);
        }
      } else {
        content_->problems.add(in_file(key.source().begin),
                               problem(fmt::format("{} is {}, but must be a table", name, type_words(node)),
                                       fmt::format("write [{}] on a line of its own", name)));
      }
    } else if (find_key(content_->keys, "", name) != nullptr) {
      continue;
    } else if (!node.is_table() || tables.empty()) {
      refuse_key("", key);
    } else {
      content_->problems.add(in_file(key.source().begin), [content = content_.get(), name] {
        const std::vector<std::string_view> known = tables_of(content->keys);
        const std::string near = did_you_mean(name, known);
        return problem(fmt::format("the table [{}] is unknown", quoted_text(name)),
                       near.empty() ? fmt::format("the tables are {}", listed(known)) : near);
      });
    }
  }
}

void TomlReader::find_missing() {
  std::vector<std::string_view> absent;
  for (const TomlKey& key : content_->keys) {
    if (!key.if_missing || find(key.table, key.name)) continue;
    const toml::node* const table = content_->file.get(key.table);
    if (!key.table.empty() && table == nullptr) {
      if (contains(absent, key.table)) continue;
      absent.push_back(key.table);
      const std::string with = fmt::format("write it with {}", listed(needed_in(content_->keys, key.table)));
      refuse(fmt::format("the table [{}] is missing", key.table), with);
    } else if (key.table.empty() || table->is_table()) {
      content_->problems.add(
          key.table.empty() ? Place{} : in_file(table->source().begin),
          problem(fmt::format("the key {} is missing", dotted_name(key.table, key.name)), *key.if_missing));
    }
  }
}

void TomlReader::read(std::span<const TomlKey> keys, Suggest suggest) {
  content_->keys = keys;
  content_->suggest = std::move(suggest);
  find_unknown();
  find_missing();
  read_values(keys);
}

void TomlReader::read_values(std::span<const TomlKey> keys) {
  for (const TomlKey& key : keys) {
    if (!key.read) continue;
    if (const auto value = find(key.table, key.name)) key.read(*value);
  }
}

// --- Telling what is wrong ---

void TomlReader::refuse(std::string_view what, std::string_view remedy, const std::optional<TomlValue>& at) {
  content_->problems.add(at ? Content::place_of(*at) : Place{}, problem(std::string(what), remedy));
}

std::vector<ReadProblem> TomlReader::problems() const {
  std::vector<ReadProblem> result;
  const std::size_t more = content_->problems.tell(
      [&](const Place& place, ReadProblem words) { result.push_back(content_->at(place, std::move(words))); });
  if (more > 0) result.push_back({.what = fmt::format("… and {} more", more)});
  return result;
}

void TomlReader::finish() const {
  if (!content_->problems.empty()) throw ReadError(ReadError::Kind::wrong, problems());
}

std::string dotted_name(std::string_view table, std::string_view name) {
  return table.empty() ? std::string(name) : fmt::format("{}.{}", table, name);
}

std::string toml_string(std::string_view text) {
  constexpr std::string_view special = "\"\\\n\t\r";
  constexpr std::string_view escapes = "\"\\ntr";
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (const std::size_t at = special.find(c); at != std::string_view::npos) {
      result.append("\\").append(1, escapes[at]);
    } else if (byte < 0x20 || byte == 0x7F) {
      result += fmt::format("\\u{:04X}", byte);
    } else {
      result += c;
    }
  }
  return result + '"';
}

}  // namespace ghostforce
