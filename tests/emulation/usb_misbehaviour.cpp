#include "tests/emulation/usb_misbehaviour.h"

#include <array>
#include <stdexcept>
#include <string>

namespace ghostforce {
namespace {

constexpr std::uint8_t latency_request = 0x09;
constexpr std::uint8_t reset_request = 0x00;

constexpr std::array kinds{
    UsbMisbehaviourKind{"in-stall", "One transfer from the device stalls; the next is well.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.in = {.failures = 1, .error = EPIPE}; }},
    UsbMisbehaviourKind{"out-stall", "One transfer to the device stalls; the next is well.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.out = {.failures = 1, .error = EPIPE}; }},
    UsbMisbehaviourKind{"in-halt", "Transfers from the device stall until the halt is cleared.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.in.halts = true; }},
    UsbMisbehaviourKind{"out-halt", "Transfers to the device stall until the halt is cleared.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.out.halts = true; }},
    UsbMisbehaviourKind{"both-halt", "Transfers both ways stall until each halt is cleared.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.in.halts = wrong.out.halts = true; }},
    UsbMisbehaviourKind{"in-error", "One transfer from the device fails on the wire.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.in = {.failures = 1, .error = EPROTO}; }},
    UsbMisbehaviourKind{"in-errors-16", "16 transfers from the device fail on the wire.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.in = {.failures = 16, .error = EPROTO}; }},
    UsbMisbehaviourKind{"in-errors-40", "40 transfers from the device fail on the wire.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.in = {.failures = 40, .error = EPROTO}; }},
    UsbMisbehaviourKind{"in-errors-200", "200 transfers from the device fail with a wrong checksum.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.in = {.failures = 200, .error = EILSEQ}; }},
    UsbMisbehaviourKind{"in-timeouts-40", "40 transfers from the device fail because nothing answers on the wire.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.in = {.failures = 40, .error = ETIME}; }},
    UsbMisbehaviourKind{"in-babble", "The device sends more than was asked for, once.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.in = {.failures = 1, .error = EOVERFLOW}; }},
    UsbMisbehaviourKind{"in-babble-40", "The device sends more than was asked for, 40 times.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.in = {.failures = 40, .error = EOVERFLOW}; }},
    UsbMisbehaviourKind{"out-error", "One transfer to the device fails on the wire.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.out = {.failures = 1, .error = EPROTO}; }},
    UsbMisbehaviourKind{"out-errors-40", "40 transfers to the device fail on the wire.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.out = {.failures = 40, .error = EPROTO}; }},
    UsbMisbehaviourKind{"in-nak-100ms", "For 0.1 s nothing comes from the device.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.in.nak_ms = 100; }},
    UsbMisbehaviourKind{"in-nak", "Nothing comes from the device any more.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.in.nak_ms = EndpointFaults::for_ever; }},
    UsbMisbehaviourKind{"out-nak-10ms", "For 10 ms the device takes nothing.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.out.nak_ms = 10; }},
    UsbMisbehaviourKind{"out-nak-100ms", "For 0.1 s the device takes nothing.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.out.nak_ms = 100; }},
    UsbMisbehaviourKind{"out-nak", "The device takes nothing any more.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.out.nak_ms = EndpointFaults::for_ever; }},
    UsbMisbehaviourKind{"control-nak-3s", "For 3 s the device answers no request.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.control_nak_ms = 3000; }},
    UsbMisbehaviourKind{"control-nak-3s-when-taken", "For 3 s after it is taken the device answers no request, once.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.control_nak_ms_when_taken = 3000; }},
    UsbMisbehaviourKind{"latency-refused", "The request for the chip's latency is refused, once.",
                        [](UsbMisbehaviour& wrong) noexcept {
                          wrong.refused_request = latency_request;
                          wrong.refusals = 1;
                        }},
    UsbMisbehaviourKind{"latency-always-refused", "The request for the chip's latency is refused each time.",
                        [](UsbMisbehaviour& wrong) noexcept {
                          wrong.refused_request = latency_request;
                          wrong.refusals = EndpointFaults::for_ever;
                        }},
    UsbMisbehaviourKind{"purge-refused", "The request to empty the chip's buffers is refused, once.",
                        [](UsbMisbehaviour& wrong) noexcept {
                          wrong.refused_request = reset_request;
                          wrong.refusals = 1;
                        }},
    UsbMisbehaviourKind{"in-halt-slow-clear", "As in-halt, and clearing it takes 1 s.",
                        [](UsbMisbehaviour& wrong) noexcept {
                          wrong.in.halts = true;
                          wrong.clear_halt_ms = 1000;
                        }},
    UsbMisbehaviourKind{"in-halts-again", "As in-halt, and as soon as it is cleared it halts again.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.in.halts = wrong.in.halts_again = true; }},
    UsbMisbehaviourKind{"in-halt-no-clear",
                        "As in-halt, and the device answers no request, so that it cannot be cleared.",
                        [](UsbMisbehaviour& wrong) noexcept {
                          wrong.in.halts = true;
                          wrong.control_nak_ms = EndpointFaults::for_ever;
                        }},
    UsbMisbehaviourKind{"unplugged", "The cable is pulled out.",
                        [](UsbMisbehaviour& wrong) noexcept { wrong.is_unplugged = true; }},
};

}  // namespace

std::span<const UsbMisbehaviourKind> usb_misbehaviour_catalog() noexcept {
  return kinds;
}

UsbMisbehaviour usb_misbehaviour(std::string_view name) {
  for (const UsbMisbehaviourKind& kind : kinds) {
    if (kind.name != name) continue;
    UsbMisbehaviour wrong;
    kind.add(wrong);
    return wrong;
  }
  throw std::invalid_argument("no USB fault is named " + std::string(name));
}

}  // namespace ghostforce
