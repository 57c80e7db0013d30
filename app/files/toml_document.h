// A TOML file that a person wrote, read strictly by a list of its keys: scenes, cases, calibrations, preferences.
// Whatever is unknown, missing, of the wrong type or out of range is told with line and column, all of it at once and
// in the order in which a person reads; words are made for the first problems alone (read_error.h). One thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/quoted.h"
#include "app/files/read_error.h"

namespace ghostforce {

// What a number may be, in the file's unit; both ends included.
struct NumberLimits {
  double least = -std::numeric_limits<double>::max();
  double greatest = std::numeric_limits<double>::max();
  std::string_view unit{};
  bool may_be_infinite = false;
  bool whole = false;
};

// "0.1 to 10 mm, or inf"
std::string range_words(const NumberLimits& limits);

class TomlReader;
struct TomlKey;

// The value of a key, or an element of it; it lives as long as its reader. What is read is empty where it is wrong, and
// that has been told then.
class TomlValue {
 public:
  // Null: it is no text.
  const std::string* as_text() const;
  // Empty: it is no integer.
  std::optional<std::int64_t> as_integer() const;
  // Whether it comes from --set, not from the file.
  bool is_override() const noexcept { return override_number_ != 0; }

  std::optional<double> number(const NumberLimits& limits) const;
  std::optional<bool> yes_or_no() const;
  // One that can be shown.
  std::optional<std::string> text(bool may_have_lines = false) const;
  // The number of its text in the list.
  std::optional<std::size_t> word(std::span<const std::string_view> words) const;

  // Of an array; `remedy` says what is wanted instead of anything else.
  std::optional<std::size_t> count(std::string_view remedy) const;
  TomlValue operator[](std::size_t element) const;
  template <std::size_t count>
  std::optional<std::array<double, count>> numbers(const NumberLimits& limits, std::string_view remedy) const {
    std::array<double, count> result{};
    return read_numbers(result, limits, remedy) ? std::optional(result) : std::nullopt;
  }

  bool is_table() const noexcept;
  // Of a table within the file, strictly by a list of its keys, whose `table` is empty. Keys that are not in the list go
  // to `other`, in the order of the alphabet; where it returns false, and without it, they are unknown. False: it is no
  // table.
  using TakeOther = std::function<bool(std::string_view name, const TomlValue& value)>;
  bool read_table(std::span<const TomlKey> keys, const TakeOther& other = {}) const;

  // "the key KEY: what; remedy". A remedy may begin with "; ", as the words of did_you_mean() do.
  void refuse(std::string_view what, std::string_view remedy) const;
  // "is a number", or "holds" one.
  void refuse_type(std::string_view remedy, std::string_view verb = "is") const;

  // Where it is, for a message that is made later; without words.
  ReadProblem place() const;

 private:
  friend class TomlReader;
  bool read_numbers(std::span<double> into, const NumberLimits& limits, std::string_view remedy) const;
  TomlValue child(std::string_view name, const void* node) const;

  TomlReader* reader_ = nullptr;
  const void* node_ = nullptr;       // a toml::node
  std::size_t override_number_ = 0;  // 0: in the file; else the number of the --set, from 1
  std::string_view table_{};
  std::string_view name_{};
};

struct TomlKey {
  std::string_view table;  // "" at the top of the file
  std::string_view name;
  std::function<void(const TomlValue&)> read;    // none: its value is asked for by find()
  std::optional<std::string_view> if_missing{};  // what to do then; none: it may be missing
};

// What reads a number; `si` is how much of SI's unit the file's is.
template <typename Number>
auto number_into(Number& into, const NumberLimits& limits, double si = 1.0) {
  return [&into, limits, si](const TomlValue& value) {
    if (const auto number = value.number(limits)) into = static_cast<Number>(*number * si);
  };
}

inline auto yes_or_no_into(bool& into) {
  return [&into](const TomlValue& value) { into = value.yes_or_no().value_or(into); };
}

// What reads the name of an entry of a catalog, and hands on the entry.
template <typename Entry, typename Take>
auto catalog_entry(std::span<const Entry> catalog, Take take) {
  return [catalog, take](const TomlValue& value) {
    if (const auto word = value.word(names_of(catalog))) take(catalog[*word]);
  };
}

class TomlReader {
 public:
  // The end of a message about an unknown key, as "; did you mean '…'?"
  using Suggest = std::function<std::string(std::string_view table, std::string_view name)>;

  // `shown_path` is what messages call the file.
  explicit TomlReader(std::string_view shown_path);
  ~TomlReader();
  TomlReader(const TomlReader&) = delete;
  TomlReader& operator=(const TomlReader&) = delete;

  // False: it is no TOML, and nothing else can be read.
  bool parse(std::string_view text);

  // The next argument of --set: another value for the key TABLE.NAME, or what is wrong with it. The last of equals
  // holds, and all of them before the file. The value is TOML, save that a text may come without quotes: where only a
  // text is possible whatever it is, 42 too, and elsewhere a single word.
  void override_key(std::string_view argument, std::string_view key, std::string_view value, bool holds_text);
  void refuse_override(std::string_view argument, std::string_view what, std::string_view remedy);

  // The key format at the top of the file is a number from 1 to `newest`; a file without it is told to write `meant`.
  // False: nothing else in the file can be relied on.
  bool has_known_format(std::int64_t newest = 1, std::int64_t meant = 1);

  // Tells of what is unknown and missing, and reads the values in the order of the list. Without `suggest`, a key of
  // the list is proposed. The list must live until the problems have been told.
  void read(std::span<const TomlKey> keys, Suggest suggest = {});
  // The values alone: what is unknown may be of a newer program.
  void read_values(std::span<const TomlKey> keys);

  // The file as a table: what holds tables of tables, or tables that somebody else names, is read from there with
  // read_table() alone.
  TomlValue whole();

  bool is_empty() const;
  bool has_table(std::string_view name) const;
  std::optional<TomlValue> find(std::string_view table, std::string_view name);

  // At the beginning of the file, or where a value stands.
  void refuse(std::string_view what, std::string_view remedy, const std::optional<TomlValue>& at = {});

  std::vector<ReadProblem> problems() const;
  // Throws ReadError(wrong) where there are any.
  void finish() const;

 private:
  friend class TomlValue;
  void find_unknown();
  void find_missing();

  struct Content;  // toml++'s
  std::unique_ptr<Content> content_;
};

// "TABLE.NAME"; at the top of the file just the name.
std::string dotted_name(std::string_view table, std::string_view name);

// A text as TOML writes it: in double quotes, on one line.
std::string toml_string(std::string_view text);

}  // namespace ghostforce
