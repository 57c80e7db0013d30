#include "app/picture/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace ghostforce {
namespace {

// A number and its unit, or what it counts, are one word.
std::size_t end_of_word(std::string_view words, std::size_t at) {
  const auto is_digit = [](char letter) { return letter >= '0' && letter <= '9'; };
  for (std::size_t end = at;; ++end) {
    end = std::min(words.find(' ', end), words.size());
    const bool goes_on = end > at && end < words.size() && (is_digit(words[end - 1]) || words[end - 1] == ' ');
    if (!goes_on) return end;
    while (end + 1 < words.size() && words[end + 1] == ' ') ++end;
  }
}

// Words with the spaces between them, and how wide each is.
class MeasuredWords {
 public:
  MeasuredWords(std::string_view words, const TextStyle& style, const MeasureText& measure) {
    for (std::size_t at = 0; at < words.size();) {
      const std::size_t end = end_of_word(words, at);
      if (end > at) {
        words_.emplace_back(words.substr(at, end - at));
        widths_.push_back(measure(words_.back(), style).x);
      }
      at = end + 1;
    }
    // Between letters, as some fonts have none at a line's end.
    space_ = measure("a a", style).x - measure("aa", style).x;
  }

  std::size_t size() const { return words_.size(); }

  std::vector<std::string> lines(double width) const {
    std::vector<std::string> lines(1);
    double line_width = 0.0;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const double longer = line_width + space_ + widths_[i];
      if (lines.back().empty()) {
        lines.back() = words_[i];
        line_width = widths_[i];
      } else if (longer <= width) {
        lines.back() += ' ' + words_[i];
        line_width = longer;
      } else {
        lines.push_back(words_[i]);
        line_width = widths_[i];
      }
    }
    return lines;
  }

  // How many lines those are, without making them.
  std::size_t line_count(double width) const { return counted(width).lines; }

  // The least width with which there are no more lines than so.
  double least_width(std::size_t most_lines) const {
    double width = 0.0;
    for (Count count = counted(width); count.lines > most_lines; count = counted(width)) {
      width = count.next_width + rounding;
    }
    return width;
  }

 private:
  static constexpr double rounding = 1e-6;

  struct Count {
    std::size_t lines = 1;
    double next_width = std::numeric_limits<double>::infinity();  // the least with which a line takes one word more
  };
  Count counted(double width) const {
    Count count;
    double line_width = 0.0;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const double longer = line_width + space_ + widths_[i];
      const bool begins_line = i == 0 || longer > width;
      if (begins_line && i > 0) {
        ++count.lines;
        count.next_width = std::min(count.next_width, longer);
      }
      line_width = begins_line ? widths_[i] : longer;
    }
    return count;
  }

  std::vector<std::string> words_;
  std::vector<double> widths_;
  double space_ = 0.0;
};

}  // namespace

std::vector<std::string> broken_into_lines(std::string_view words, double width, const TextStyle& style,
                                           const MeasureText& measure) {
  const MeasuredWords measured(words, style, measure);
  std::vector<std::string> lines = measured.lines(width);
  if (lines.size() == 1) return lines;
  return measured.lines(std::min(width, measured.least_width(lines.size())));
}

std::size_t line_count(std::string_view words, double width, const TextStyle& style, const MeasureText& measure) {
  return MeasuredWords(words, style, measure).line_count(width);
}

std::vector<std::string> broken_in_two(std::string_view words, const TextStyle& style, const MeasureText& measure) {
  const MeasuredWords measured(words, style, measure);
  return measured.lines(measured.least_width(2));
}

namespace {

std::string with_sign(double value, int decimals, std::string_view plus) {
  const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
  if (is_zero) return digits;
  return fmt::format("{}{}", value < 0.0 ? "−" : plus, digits);
}

}  // namespace

std::string decimal_text(double value, int decimals) {
  return with_sign(value, decimals, "");
}

std::string signed_decimal_text(double value, int decimals) {
  return with_sign(value, decimals, "+");
}

std::string deviation_text(double deviation) {
  return decimal_text(std::max(1.0, deviation), 0);
}

}  // namespace ghostforce
