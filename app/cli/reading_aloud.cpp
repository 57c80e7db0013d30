#include "app/cli/reading_aloud.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/files/output_file.h"
#include "app/state/lesson_file.h"

namespace ghostforce {
namespace {

// Of the sentence: a lesson's text, or the stage's own.
std::string_view spoken_language(const Session& session) {
  if (session.lesson) return language_in(*session.lesson->lesson, session.language);
  return stage_language(session.language).code;
}

}  // namespace

ReadingAloud::ReadingAloud(std::optional<double> printed_hz, int descriptor) {
  if (!printed_hz) return;
  printed_.emplace(*printed_hz);
  writer_ = std::make_unique<NewestLineWriter>(descriptor, printed_header());
}

void ReadingAloud::follow(Application& application, double interval_s) {
  if (writer_) print(application, interval_s);
  speak(application, interval_s);
}

void ReadingAloud::finish_printing() {
  if (!writer_) return;
  output_problem_ = writer_->finish();
  writer_.reset();
}

void ReadingAloud::print(Application& application, double interval_s) {
  output_problem_ = writer_->problem();
  if (output_problem_ != 0) {
    writer_.reset();
    if (output_problem_ == EPIPE) return;
    application.show_notice(fmt::format("The values are no longer printed: {}.", reason_of(output_problem_)), true);
    return;
  }
  if (!printed_->advance(interval_s)) return;
  const ShownMoment shown = application.shown();
  if (auto line = printed_->poll(application.stage_reading(), shown.snapshot.time_s, shown.is_past)) {
    writer_->put(std::move(*line));
  }
}

void ReadingAloud::speak(Application& application, double interval_s) {
  constexpr double looks_every_s = 0.1;
  Session& session = application.session();
  std::string problem = speech_.update(interval_s);
  if (!session.speaks) {
    speech_.end();
    settled_ = {};
    session.speech_problem.clear();
    return;
  }
  if (!session.speech_problem.empty()) return;
  since_sentence_s_ += interval_s;
  if (problem.empty() && since_sentence_s_ >= looks_every_s) {
    const double since_s = std::exchange(since_sentence_s_, 0.0);
    if (const auto sentence = settled_.take(application.stage_reading().sentence, since_s)) {
      problem = speech_.say(*sentence, spoken_language(session));
    }
  }
  if (problem.empty()) return;
  session.speech_problem = problem;
  application.show_notice(std::move(problem), true);
}

namespace {

constexpr std::string_view unknown = "-";

std::string with_sign(double value, double least_shown, std::string digits) {
  return value <= -least_shown ? "-" + digits : digits;
}

std::string force_column(const std::optional<double>& newton) {
  if (!newton || !std::isfinite(*newton)) return std::string(unknown);
  return with_sign(*newton, least_shown_force, force_number(*newton));
}

std::string slide_column(const std::optional<double>& metres) {
  if (!metres || !std::isfinite(*metres)) return std::string(unknown);
  return slide_number(*metres);
}

// What would end a column or a line becomes a space.
std::string on_one_line(std::string words) {
  std::ranges::replace_if(
      words, [](char letter) { return static_cast<unsigned char>(letter) < ' '; }, ' ');
  return words;
}

// All columns but the time's, which is the last.
std::string columns_of(const StageReading& reading) {
  const StageNumbers& numbers = reading.numbers;
  return fmt::format("{}\t{}\t{}\t{}\t{}\t{}", on_one_line(reading.sentence), strategy(reading.strategy).name,
                     force_column(numbers.force), force_column(numbers.wall_share), force_column(numbers.ghost_force),
                     slide_column(numbers.slide));
}

}  // namespace

std::string printed_header() {
  return "# sentence\tstrategy\tforce N\twall's share N\tghost force N\tslide mm\ttime s\n";
}

bool PrintedValues::advance(double interval_s) noexcept {
  since_s_ += interval_s;
  return since_s_ >= period_s_;
}

std::optional<std::string> PrintedValues::poll(const StageReading& reading, double time_s, bool is_past) {
  std::string columns = columns_of(reading);
  std::string line = fmt::format("{}\t{:.3f}\n", columns, time_s);
  if (is_past) columns = line;
  if (columns == printed_) return std::nullopt;
  printed_ = std::move(columns);
  since_s_ = 0.0;
  return line;
}

}  // namespace ghostforce
