#include "core/motor_verdict.h"

#include <array>

namespace ghostforce {
namespace {

// In the order of MotorVerdict.
constexpr std::array<std::string_view, 6> sentences{
    "",
    "",
    "Motor {} pushes the wrong way.",
    "Each motor moves the other one's arm.",
    "Motor {} does not push.",
    "It could not be told which arm each motor moves.",
};
static_assert(sentences.size() == static_cast<std::size_t>(MotorVerdict::undecided) + 1);

}  // namespace

std::string_view sentence_of(MotorVerdict verdict) noexcept {
  return sentences[static_cast<std::size_t>(verdict)];
}

}  // namespace ghostforce
