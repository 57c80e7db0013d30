#include "tests/emulation/usb_fault.h"

#include <array>
#include <stdexcept>
#include <string>

namespace ghostforce {
namespace {

constexpr std::uint8_t latency_request = 0x09;
constexpr std::uint8_t reset_request = 0x00;

constexpr std::array kinds{
    UsbFaultKind{"in-stall", "One transfer from the device stalls; the next is well.",
                 [](UsbFault& wrong) noexcept { wrong.in = {.failures = 1, .error = EPIPE}; }},
    UsbFaultKind{"out-stall", "One transfer to the device stalls; the next is well.",
                 [](UsbFault& wrong) noexcept { wrong.out = {.failures = 1, .error = EPIPE}; }},
    UsbFaultKind{"in-halt", "Transfers from the device stall until the halt is cleared.",
                 [](UsbFault& wrong) noexcept { wrong.in.halts = true; }},
    UsbFaultKind{"out-halt", "Transfers to the device stall until the halt is cleared.",
                 [](UsbFault& wrong) noexcept { wrong.out.halts = true; }},
    UsbFaultKind{"both-halt", "Transfers both ways stall until each halt is cleared.",
                 [](UsbFault& wrong) noexcept { wrong.in.halts = wrong.out.halts = true; }},
    UsbFaultKind{"in-error", "One transfer from the device fails on the wire.",
                 [](UsbFault& wrong) noexcept { wrong.in = {.failures = 1, .error = EPROTO}; }},
    UsbFaultKind{"in-errors-16", "16 transfers from the device fail on the wire.",
                 [](UsbFault& wrong) noexcept { wrong.in = {.failures = 16, .error = EPROTO}; }},
    UsbFaultKind{"in-errors-40", "40 transfers from the device fail on the wire.",
                 [](UsbFault& wrong) noexcept { wrong.in = {.failures = 40, .error = EPROTO}; }},
    UsbFaultKind{"in-errors-200", "200 transfers from the device fail with a wrong checksum.",
                 [](UsbFault& wrong) noexcept { wrong.in = {.failures = 200, .error = EILSEQ}; }},
    UsbFaultKind{"in-timeouts-40", "40 transfers from the device fail because nothing answers on the wire.",
                 [](UsbFault& wrong) noexcept { wrong.in = {.failures = 40, .error = ETIME}; }},
    UsbFaultKind{"in-babble", "The device sends more than was asked for, once.",
                 [](UsbFault& wrong) noexcept { wrong.in = {.failures = 1, .error = EOVERFLOW}; }},
    UsbFaultKind{"in-babble-40", "The device sends more than was asked for, 40 times.",
                 [](UsbFault& wrong) noexcept { wrong.in = {.failures = 40, .error = EOVERFLOW}; }},
    UsbFaultKind{"out-error", "One transfer to the device fails on the wire.",
                 [](UsbFault& wrong) noexcept { wrong.out = {.failures = 1, .error = EPROTO}; }},
    UsbFaultKind{"out-errors-40", "40 transfers to the device fail on the wire.",
                 [](UsbFault& wrong) noexcept { wrong.out = {.failures = 40, .error = EPROTO}; }},
    UsbFaultKind{"out-errors-5", "Five transfers to the device fail on the wire.",
                 [](UsbFault& wrong) noexcept { wrong.out = {.failures = 5, .error = EPROTO}; }},
    UsbFaultKind{"in-nak-100ms", "For 0.1 s nothing comes from the device.",
                 [](UsbFault& wrong) noexcept { wrong.in.nak_ms = 100; }},
    UsbFaultKind{"in-nak", "Nothing comes from the device any more.",
                 [](UsbFault& wrong) noexcept { wrong.in.nak_ms = EndpointFaults::for_ever; }},
    UsbFaultKind{"out-nak-10ms", "For 10 ms the device takes nothing.",
                 [](UsbFault& wrong) noexcept { wrong.out.nak_ms = 10; }},
    UsbFaultKind{"out-nak-100ms", "For 0.1 s the device takes nothing.",
                 [](UsbFault& wrong) noexcept { wrong.out.nak_ms = 100; }},
    UsbFaultKind{"out-nak", "The device takes nothing any more.",
                 [](UsbFault& wrong) noexcept { wrong.out.nak_ms = EndpointFaults::for_ever; }},
    UsbFaultKind{"control-nak", "The device answers no request any more.",
                 [](UsbFault& wrong) noexcept { wrong.control_nak_ms = EndpointFaults::for_ever; }},
    UsbFaultKind{"control-nak-3s-when-taken", "For 3 s after it is taken the device answers no request, once.",
                 [](UsbFault& wrong) noexcept { wrong.control_nak_ms_when_taken = 3000; }},
    UsbFaultKind{"latency-refused", "The request for the chip's latency is refused, once.",
                 [](UsbFault& wrong) noexcept {
                   wrong.refused_request = latency_request;
                   wrong.refusals = 1;
                 }},
    UsbFaultKind{"latency-always-refused", "The request for the chip's latency is refused each time.",
                 [](UsbFault& wrong) noexcept {
                   wrong.refused_request = latency_request;
                   wrong.refusals = EndpointFaults::for_ever;
                 }},
    UsbFaultKind{"purge-refused", "The request to empty the chip's buffers is refused, once.",
                 [](UsbFault& wrong) noexcept {
                   wrong.refused_request = reset_request;
                   wrong.refusals = 1;
                 }},
    UsbFaultKind{"in-halt-slow-clear", "As in-halt, and clearing it takes 1 s.",
                 [](UsbFault& wrong) noexcept {
                   wrong.in.halts = true;
                   wrong.clear_halt_ms = 1000;
                 }},
    UsbFaultKind{"in-halts-again", "As in-halt, and as soon as it is cleared it halts again.",
                 [](UsbFault& wrong) noexcept { wrong.in.halts = wrong.in.halts_again = true; }},
    UsbFaultKind{"in-halt-no-clear", "As in-halt, and the device answers no request, so that it cannot be cleared.",
                 [](UsbFault& wrong) noexcept {
                   wrong.in.halts = true;
                   wrong.control_nak_ms = EndpointFaults::for_ever;
                 }},
    UsbFaultKind{"unplugged", "The cable is pulled out.", [](UsbFault& wrong) noexcept { wrong.is_unplugged = true; }},
};

}  // namespace

std::span<const UsbFaultKind> usb_fault_catalog() noexcept {
  return kinds;
}

UsbFault usb_fault(std::string_view name) {
  for (const UsbFaultKind& kind : kinds) {
    if (kind.name != name) continue;
    UsbFault wrong;
    kind.add(wrong);
    return wrong;
  }
  throw std::invalid_argument("no USB fault is named " + std::string(name));
}

}  // namespace ghostforce
