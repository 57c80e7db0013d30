#include "app/state/lesson_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "app/base/language.h"
#include "app/base/quoted.h"
#include "app/files/scene_file.h"
#include "app/files/scene_keys.h"
#include "app/state/lesson_quantities.h"
#include "app/state/set_up.h"
#include "core/conventions.h"

namespace ghostforce {
namespace {

constexpr double full_turn_deg = 360.0;
constexpr std::string_view need_word = "write it: the person reads it on the stage";

// --- Pieces of a step ---

std::shared_ptr<const SetUp> read_set_up(const TomlValue& value) {
  const std::optional<std::string> line = value.text();
  if (!line) return nullptr;
  try {
    SetUp set_up = read_set_up_line(*line);
    if (set_up.face == Face::stage) return std::make_shared<const SetUp>(std::move(set_up));
    value.refuse("shows the workbench", "lessons are shown on the stage: leave out --view workbench");
  } catch (const ReadError& error) {
    if (error.kind() == ReadError::Kind::unreadable) throw;
    for (ReadProblem problem : error.problems()) {
      const std::string remedy = std::exchange(problem.remedy, "");
      value.refuse(words_of(problem), remedy);
    }
  }
  return nullptr;
}

template <typename Id, std::size_t size>
std::set<Id> read_word_list(const TomlValue& value, const std::array<LessonWord<Id>, size>& catalog) {
  std::set<Id> chosen;
  const std::vector<std::string_view> words = names_of(catalog);
  const std::string need = fmt::format("give an array of words, as in [\"{}\"]", words.front());
  for (std::size_t i = 0, count = value.count(need).value_or(0); i < count; ++i) {
    const auto word = value[i].word(words);
    if (word && !chosen.insert(catalog[*word].id).second) value[i].refuse("is there twice", "give each word once");
  }
  return chosen;
}

std::optional<LessonSlider> read_slider(const TomlValue& value) {
  LessonSlider slider;
  std::optional<NumberLimits> limits;
  const auto read_key = [&](const TomlValue& key) {
    const std::optional<std::string> name = key.text();
    if (!name) return;
    slider.key = find_scene_key(*name);
    if (slider.key == nullptr) {
      key.refuse(fmt::format("'{}' is no key of a scene", quoted_text(*name)), suggest_scene_key(*name));
      return;
    }
    limits = is_setting(*slider.key) ? limits_of(*slider.key) : std::nullopt;
    if (limits) return;
    key.refuse(fmt::format("'{}' is no number that can be changed while the scene runs", *name),
               "give one such as user.believed_k_u_N_per_m");
    slider.key = nullptr;
  };
  const auto read_end = [&](double& end) {
    return [&slider, &limits, &end](const TomlValue& number) {
      NumberLimits allowed = limits.value_or(NumberLimits{});
      allowed.may_be_infinite = false;
      allowed.whole = false;
      if (slider.key != nullptr && slider.key->name.ends_with("_deg")) {
        // Angles have no end, but a slider has.
        allowed.least = -full_turn_deg;
        allowed.greatest = full_turn_deg;
      }
      if (const auto read = number.number(allowed)) end = *read;
    };
  };
  const std::array keys{
      TomlKey{"", "key", read_key, "name the key that it changes, as --set does"},
      TomlKey{"", "from", read_end(slider.least), "give the number at its left end"},
      TomlKey{"", "to", read_end(slider.greatest), "give the number at its right end"},
  };
  slider.least = 0.0;
  slider.greatest = std::numeric_limits<double>::infinity();
  if (!value.read_table(keys) || slider.key == nullptr || std::isinf(slider.greatest)) return std::nullopt;
  if (slider.least < slider.greatest) return slider;
  value.refuse(fmt::format("goes from {} to {}", slider.least, slider.greatest), "let it go from less to more");
  return std::nullopt;
}

void read_condition(const TomlValue& value, std::vector<LessonCondition>& conditions) {
  LessonCondition condition;
  bool has_quantity = false;
  int bounds = 0;
  const auto read_bound = [&](double& bound) {
    return [&bound, &bounds](const TomlValue& number) {
      ++bounds;
      if (const auto read = number.number({})) bound = *read;
    };
  };
  const std::array keys{
      TomlKey{"", "quantity",
              catalog_entry(lesson_quantity_catalog(),
                            [&](const LessonQuantityEntry& entry) {
                              condition.quantity = entry.id;
                              has_quantity = true;
                            }),
              "name what the task is about"},
      TomlKey{"", "at_least", read_bound(condition.least)},
      TomlKey{"", "at_most", read_bound(condition.greatest)},
  };
  if (!value.read_table(keys)) return;
  if (bounds == 0) {
    value.refuse("has neither at_least nor at_most", "give one of them, or both");
  } else if (!(condition.least <= condition.greatest)) {
    value.refuse(fmt::format("wants at least {} and at most {}", condition.least, condition.greatest),
                 "no number is both");
  } else if (has_quantity) {
    conditions.push_back(condition);
  }
}

// --- Which keys a question uses ---

struct KeyOfQuestion {
  std::string_view name;
  std::optional<LessonQuestion> question;  // empty: of any question
  std::string_view if_missing{};           // what to do then; empty: it may be missing
};
constexpr std::array keys_of_questions{
    KeyOfQuestion{"hidden", {}},
    KeyOfQuestion{"reveal", {}},
    KeyOfQuestion{"right", LessonQuestion::choose, "give the number of the right answer, from 1"},
    KeyOfQuestion{"within_mm", LessonQuestion::guess, "say how near to the truth a guess counts as right"},
    KeyOfQuestion{"until", LessonQuestion::task,
                  "say what has to be true, as in [{ quantity = \"slide_mm\", at_most = 1 }]"},
    KeyOfQuestion{"with", LessonQuestion::task},
};

std::string_view question_name(LessonQuestion id) {
  return std::ranges::find(lesson_question_catalog, id, &LessonWord<LessonQuestion>::id)->name;
}

// `table` is that of the step, `found` where each of the keys stands.
void check_keys_of_question(const TomlValue& table, LessonQuestion question,
                            const std::array<std::optional<TomlValue>, keys_of_questions.size()>& found) {
  for (std::size_t i = 0; i < keys_of_questions.size(); ++i) {
    const KeyOfQuestion& key = keys_of_questions[i];
    const bool belongs = key.question ? *key.question == question : question != LessonQuestion::none;
    if (found[i] && !belongs) {
      found[i]->refuse(key.question ? fmt::format("belongs to question = \"{}\"", question_name(*key.question))
                                    : "belongs to a question, and this step has none",
                       "leave it out, or change the question");
    } else if (!found[i] && belongs && !key.if_missing.empty()) {
      table.refuse(fmt::format("the question \"{}\" needs the key {}", question_name(question), key.name),
                   key.if_missing);
    }
  }
}

// --- Words ---

std::size_t characters_in(std::string_view text) {
  std::size_t count = 0;
  while (!text.empty()) {
    text.remove_prefix(std::max<std::size_t>(first_character(text).length, 1));
    ++count;
  }
  return count;
}

// Reads a text that must fit.
auto words_into(std::string& into, std::size_t most) {
  return [&into, most](const TomlValue& value) {
    const std::string* const written = value.as_text();
    if (written != nullptr && written->find('\n') != std::string::npos) {
      value.refuse("has more than one line", "write it in one: the stage breaks it where it has to");
      return;
    }
    const std::optional<std::string> text = value.text();
    if (!text) return;
    const std::size_t length = characters_in(*text);
    if (length == 0) {
      value.refuse("is empty", need_word);
    } else if (length > most) {
      value.refuse(fmt::format("is {} characters long", length),
                   fmt::format("give {} at most, so that it fits on the stage", most));
    } else {
      into = *text;
    }
  };
}

}  // namespace

// --- Steps ---

void LessonReader::read_name(const TomlValue& value, LessonStep& step) {
  constexpr std::size_t longest = 40;
  const std::optional<std::string> name = value.text();
  if (!name) return;
  const bool is_word = std::ranges::all_of(
      *name, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_'; });
  if (name->empty() || name->size() > longest || !is_word) {
    value.refuse(fmt::format("'{}' is no name for a step", quoted_text(*name)),
                 fmt::format("give 1 to {} of a to z, 0 to 9, - and _", longest));
  } else if (*name == "title" || *name == "about") {
    value.refuse(fmt::format("'{}' is what the lesson's own words are called", *name), "give another name");
  } else if (std::ranges::find(lesson_.steps, *name, &LessonStep::name) != lesson_.steps.end()) {
    value.refuse(fmt::format("'{}' is the name of an earlier step", *name), "give each step a name of its own");
  } else {
    step.name = *name;
  }
}

void LessonReader::read_step(const TomlValue& table, LessonStep& step, StepFacts& facts) {
  std::array<std::optional<TomlValue>, keys_of_questions.size()> found;
  // Reads a key of a question, and remembers where it stands.
  const auto of_question = [&found](std::string_view name, auto read) {
    const auto* const row = std::ranges::find(keys_of_questions, name, &KeyOfQuestion::name);
    const auto place = static_cast<std::size_t>(row - keys_of_questions.begin());
    return TomlKey{"", name, [&found, place, read](const TomlValue& value) {
                     found[place] = value;
                     read(value);
                   }};
  };
  bool has_set_up = false;
  const auto read_conditions = [&](const TomlValue& value) {
    constexpr std::string_view need = "give an array, as in [{ quantity = \"slide_mm\", at_most = 1 }]";
    const auto count = value.count(need);
    if (count == 0U) value.refuse("is empty", need);
    for (std::size_t i = 0; i < count.value_or(0); ++i) read_condition(value[i], step.conditions);
  };
  const std::array keys{
      TomlKey{"", "name", [&](const TomlValue& value) { read_name(value, step); },
              "give the step a name: its words stand below [LANGUAGE.NAME]"},
      TomlKey{"", "set_up",
              [&](const TomlValue& value) {
                has_set_up = true;
                step.set_up = read_set_up(value);
              }},
      TomlKey{"", "controls",
              [&](const TomlValue& value) { step.controls = read_word_list(value, lesson_control_catalog); }},
      TomlKey{"", "slider", [&](const TomlValue& value) { step.slider = read_slider(value); }},
      TomlKey{"", "question",
              [&](const TomlValue& value) {
                const auto word = value.word(names_of(lesson_question_catalog));
                facts.knows_question = word.has_value();
                if (word) step.question = lesson_question_catalog[*word].id;
              }},
      of_question("hidden",
                  [&](const TomlValue& value) { step.secrets = read_word_list(value, lesson_secret_catalog); }),
      of_question("reveal", [&](const TomlValue& value) { step.reveal = read_set_up(value); }),
      of_question("right",
                  [&](const TomlValue& value) {
                    const auto number = value.number(
                        {.least = 1.0, .greatest = static_cast<double>(most_lesson_answers), .whole = true});
                    if (!number) return;
                    step.right_answer = static_cast<std::size_t>(*number) - 1;
                    facts.right = value;
                  }),
      of_question("within_mm", number_into(step.within, {0.1, 100.0, "mm"}, 1.0 / mm_per_m)),
      of_question("until", read_conditions),
      of_question("with", catalog_entry(std::span<const Strategy>(strategy_catalog()),
                                        [&](const Strategy& chosen) { step.with = chosen.id; })),
  };
  if (!table.read_table(keys)) return;
  if (facts.knows_question) check_keys_of_question(table, step.question, found);
  if (lesson_.steps.empty() && !has_set_up) {
    table.refuse("the first step has no set_up", "arrange the stage, press Ctrl+C, and paste the line as its set_up");
  }
  if (step.question == LessonQuestion::task && step.controls.empty() && !step.slider) {
    table.refuse("there is a task, but nothing to do it with", "give controls or a slider");
  }
}

void LessonReader::read_steps(const TomlValue& steps) {
  constexpr std::string_view need = "begin each step with [[step]]";
  const auto there = steps.count(need);
  if (there == 0U) steps.refuse("is empty", need);
  const std::size_t count = there.value_or(0);
  if (count > most_lesson_steps) {
    steps.refuse(fmt::format("has {} steps", count), fmt::format("give {} at most", most_lesson_steps));
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    LessonStep step;
    StepFacts facts;
    read_step(steps[i], step, facts);
    lesson_.steps.push_back(std::move(step));
    facts_.push_back(std::move(facts));
  }
}

// --- Languages ---

void LessonReader::compare_answers(const TomlValue& answers, std::size_t number, std::size_t count) {
  StepFacts& facts = facts_[number];
  if (count < fewest_lesson_answers || count > most_lesson_answers) {
    answers.refuse(fmt::format("has {} of them", count),
                   fmt::format("give {} or {}", fewest_lesson_answers, most_lesson_answers));
  } else if (!facts.answers) {
    facts.answers = count;
    if (facts.right && lesson_.steps[number].right_answer >= count) {
      facts.right->refuse(fmt::format("{} is out of range", lesson_.steps[number].right_answer + 1),
                          fmt::format("the step has {} answers: give 1 to {}", count, count));
    }
  } else if (*facts.answers != count) {
    answers.refuse(fmt::format("has {} of them, but [{}] has {}", count, first_language_, *facts.answers),
                   fmt::format("translate each answer of [{}.{}]", first_language_, lesson_.steps[number].name));
  }
}

void LessonReader::read_step_words(const TomlValue& table, std::size_t number, LessonStepWords& words) {
  const StepFacts& facts = facts_[number];
  const LessonQuestion question = lesson_.steps[number].question;
  const bool chooses = question == LessonQuestion::choose;
  const bool asks = question != LessonQuestion::none;
  const auto refuse = [&](std::string_view what) {
    return [what](const TomlValue& value) { value.refuse(what, "leave it out, or add a question to the step"); };
  };
  const auto read_answers = [&](const TomlValue& value) {
    constexpr std::string_view need = "give an array of texts in quotes";
    const auto count = value.count(need);
    if (!count) return;
    compare_answers(value, number, *count);
    words.answers.resize(std::min(*count, most_lesson_answers));
    for (std::size_t i = 0; i < words.answers.size(); ++i) {
      words_into(words.answers[i], longest_lesson_answer)(value[i]);
    }
  };
  const auto ignore = [](const TomlValue&) {};
  std::vector<TomlKey> keys{{"", "text", words_into(words.text, longest_lesson_text), need_word}};
  const auto add = [&](std::string_view name, bool is_used, auto read, std::string_view if_missing,
                       std::string_view if_unused) {
    TomlKey& key = keys.emplace_back(TomlKey{"", name, ignore});
    if (!facts.knows_question) return;
    if (is_used) {
      key.read = read;
      key.if_missing = if_missing;
    } else {
      key.read = refuse(if_unused);
    }
  };
  add("answers", chooses, read_answers, "give the answers to choose from", "belongs to question = \"choose\"");
  add("right", asks, words_into(words.right, longest_lesson_text), "say what the person learns from a right answer",
      "belongs to a question, and this step has none");
  add("wrong", asks, words_into(words.wrong, longest_lesson_text),
      "say what the person learns from another answer, or from none", "belongs to a question, and this step has none");
  table.read_table(keys);
}

void LessonReader::read_language(std::string_view language, const TomlValue& table) {
  LessonWords& words = lesson_.words[std::string(language)];
  words.steps.resize(lesson_.steps.size());
  if (first_language_.empty()) first_language_ = language;
  std::vector<TomlKey> keys{
      {"", "title", words_into(words.title, longest_lesson_title), "give the lesson's title in this language"},
      {"", "about", words_into(words.about, longest_lesson_text), "say in a sentence what the lesson is about"},
  };
  for (std::size_t i = 0; i < lesson_.steps.size(); ++i) {
    if (lesson_.steps[i].name.empty()) continue;
    keys.push_back({"", lesson_.steps[i].name,
                    [this, i, &words](const TomlValue& value) { read_step_words(value, i, words.steps[i]); },
                    "add it as a table with the step's text: each step needs words in each language"});
  }
  table.read_table(keys);
}

// --- The file ---

Lesson LessonReader::read(std::string_view text) {
  std::vector<std::pair<std::string, TomlValue>> languages;
  std::optional<TomlValue> picture;
  const bool is_toml = toml_.parse(text);
  if (is_toml && toml_.has_table("wall")) {
    toml_.refuse("this is a scene, not a lesson",
                 "ghostforce equilibrium tells whether it is right, and ghostforce run opens it");
  } else if (is_toml && toml_.has_known_format()) {
    const std::array keys{
        TomlKey{"", "format", [](const TomlValue&) {}},
        TomlKey{"", "number", number_into(lesson_.number, {}),
                "give the lesson's place among others, as in number = 3"},
        TomlKey{"", "hidden",
                [&](const TomlValue& value) { lesson_.secrets = read_word_list(value, lesson_secret_catalog); }},
        TomlKey{"", "picture", [&](const TomlValue& value) { picture = value; }},
        TomlKey{"", "picture_of",
                catalog_entry(std::span<const LessonWord<LessonSubject>>(lesson_subject_catalog),
                              [&](const LessonWord<LessonSubject>& word) { lesson_.picture_of = word.id; })},
        TomlKey{"", "step", [&](const TomlValue& steps) { read_steps(steps); }},
    };
    toml_.whole().read_table(keys, [&](std::string_view name, const TomlValue& value) {
      if (!value.is_table()) return false;
      if (is_language_code(name)) {
        languages.emplace_back(name, value);
      } else {
        value.refuse("is no language", "the words of a language stand in a table such as [en] or [es]");
      }
      return true;
    });
    std::vector<std::string_view> names;
    for (const LessonStep& step : lesson_.steps) names.push_back(step.name);
    if (picture && !names.empty()) lesson_.picture = picture->word(names).value_or(0);
    // The others are compared with English, if it is there.
    std::ranges::stable_partition(languages, [](const auto& language) { return language.first == "en"; });
    for (const auto& [language, table] : languages) read_language(language, table);
    if (!toml_.find("", "step")) toml_.refuse("the lesson has no steps", "begin each step with [[step]]");
    if (languages.empty()) toml_.refuse("the lesson has no words", "add a table for a language, such as [en]");
  }
  toml_.finish();
  return std::move(lesson_);
}

}  // namespace ghostforce
