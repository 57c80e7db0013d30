#include "device/virtual_falcon/injected_fault.h"

#include <algorithm>
#include <array>

namespace ghostforce {
namespace {

constexpr void fail_always(InjectedFault& wrong, ReplyFault fault) noexcept {
  wrong.reply = fault;
  wrong.reply_interval = 1;
  wrong.faulty_replies = 0;
}

constexpr void fail_once(InjectedFault& wrong, ReplyFault fault) noexcept {
  fail_always(wrong, fault);
  wrong.faulty_replies = 1;
}

constexpr std::array kinds{
    InjectedFaultKind{"absent", "No Falcon is plugged in.",
                      [](InjectedFault& wrong) noexcept { wrong.link = LinkFault::absent; }},
    InjectedFaultKind{"not-allowed", "The Falcon is there, and this user may not open it.",
                      [](InjectedFault& wrong) noexcept { wrong.link = LinkFault::not_allowed; }},
    InjectedFaultKind{"busy", "Another program has the Falcon.",
                      [](InjectedFault& wrong) noexcept { wrong.link = LinkFault::busy; }},
    InjectedFaultKind{"unplugged", "The USB cable is pulled out.",
                      [](InjectedFault& wrong) noexcept { wrong.link = LinkFault::unplugged; }},
    InjectedFaultKind{"power-lost", "The Falcon has no current: it is silent, and has forgotten firmware and home.",
                      [](InjectedFault& wrong) noexcept { wrong.power_lost = true; }},
    InjectedFaultKind{"power-blink", "The current fails for a moment: firmware and home are forgotten.",
                      [](InjectedFault& wrong) noexcept { wrong.power_blinks = true; }},
    InjectedFaultKind{"lost-first-replies", "The first three answers of the hand-shake never come.",
                      [](InjectedFault& wrong) noexcept { wrong.lost_replies = 3; }},
    InjectedFaultKind{"leading-00", "A byte 00 comes before each answer of the hand-shake.",
                      [](InjectedFault& wrong) noexcept { wrong.leading_00 = true; }},
    InjectedFaultKind{"leading-13", "A byte 13 comes before the 'A' that begins the upload.",
                      [](InjectedFault& wrong) noexcept { wrong.leading_13 = true; }},
    InjectedFaultKind{"no-cts", "The device never says that it is clear to send.",
                      [](InjectedFault& wrong) noexcept { wrong.without_cts = true; }},
    InjectedFaultKind{"corrupted-echo", "One byte of the upload comes back changed, once.",
                      [](InjectedFault& wrong) noexcept { wrong.echo = EchoFault::corrupted_once; }},
    InjectedFaultKind{"always-corrupted-echo", "One byte of each upload comes back changed.",
                      [](InjectedFault& wrong) noexcept { wrong.echo = EchoFault::corrupted_always; }},
    InjectedFaultKind{"lost-echo", "One byte of the upload does not come back, once.",
                      [](InjectedFault& wrong) noexcept { wrong.echo = EchoFault::lost_once; }},
    InjectedFaultKind{"upload-stops", "After 100 bytes of the upload the device is silent.",
                      [](InjectedFault& wrong) noexcept { wrong.upload_stops = 100; }},
    InjectedFaultKind{"split-packets", "Answers come cut into packets of a few bytes.",
                      [](InjectedFault& wrong) noexcept { wrong.split_packets = true; }},
    InjectedFaultKind{"joined-packets", "Answers are held back until several come at once.",
                      [](InjectedFault& wrong) noexcept { wrong.joined_packets = true; }},
    InjectedFaultKind{"short-frames", "Every fourth answer lacks two bytes.",
                      [](InjectedFault& wrong) noexcept { wrong.short_frames = 4; }},
    InjectedFaultKind{"garbage", "Bytes that mean nothing come between the answers.",
                      [](InjectedFault& wrong) noexcept { wrong.garbage = true; }},
    InjectedFaultKind{"silence", "The device stops answering.",
                      [](InjectedFault& wrong) noexcept { wrong.silence = true; }},
    InjectedFaultKind{"frozen-encoders", "The encoders say the same, wherever the arms are.",
                      [](InjectedFault& wrong) noexcept { wrong.frozen_encoders = true; }},
    InjectedFaultKind{"late-5ms", "Each answer comes 5 ms late.",
                      [](InjectedFault& wrong) noexcept { wrong.reply_delay_ns = 5'000'000; }},
    InjectedFaultKind{"late-50ms", "Each answer comes 50 ms late.",
                      [](InjectedFault& wrong) noexcept { wrong.reply_delay_ns = 50'000'000; }},
    InjectedFaultKind{"late-creeping", "Each answer comes 0.1 ms later than the one before.",
                      [](InjectedFault& wrong) noexcept { wrong.reply_creep_ns = 100'000; }},
    InjectedFaultKind{"lost-reply", "One answer never comes.",
                      [](InjectedFault& wrong) noexcept { fail_once(wrong, ReplyFault::lost); }},
    InjectedFaultKind{"lost-replies", "Every tenth answer never comes.",
                      [](InjectedFault& wrong) noexcept {
                        fail_always(wrong, ReplyFault::lost);
                        wrong.reply_interval = 10;
                      }},
    InjectedFaultKind{"mute", "The device obeys, and stops answering.",
                      [](InjectedFault& wrong) noexcept { fail_always(wrong, ReplyFault::lost); }},
    InjectedFaultKind{"malformed-reply", "One byte of one answer comes changed, so that it is no answer.",
                      [](InjectedFault& wrong) noexcept { fail_once(wrong, ReplyFault::malformed); }},
    InjectedFaultKind{"wrong-reply", "One byte of one answer comes changed, so that it tells of another place.",
                      [](InjectedFault& wrong) noexcept { fail_once(wrong, ReplyFault::wrong); }},
    InjectedFaultKind{"encoder-glitch", "One answer tells of a place where the arms cannot be.",
                      [](InjectedFault& wrong) noexcept { fail_once(wrong, ReplyFault::impossible); }},
    InjectedFaultKind{"impossible-encoders", "All answers tell of a place where the arms cannot be.",
                      [](InjectedFault& wrong) noexcept { fail_always(wrong, ReplyFault::impossible); }},
    InjectedFaultKind{"duplicated-replies", "Each answer comes twice.",
                      [](InjectedFault& wrong) noexcept { wrong.duplicated_replies = true; }},
    InjectedFaultKind{"line-noise", "A burst of 100 bytes that mean nothing comes before an answer, once.",
                      [](InjectedFault& wrong) noexcept { wrong.noise_bytes = 100; }},
    InjectedFaultKind{"forgets-home", "The device has forgotten its home position, once.",
                      [](InjectedFault& wrong) noexcept { wrong.forgets_home = true; }},
    InjectedFaultKind{"never-homes", "The device never finds its home position.",
                      [](InjectedFault& wrong) noexcept { wrong.never_homes = true; }},
};

}  // namespace

std::span<const InjectedFaultKind> injected_fault_catalog() noexcept {
  return kinds;
}

const InjectedFaultKind* find_injected_fault(std::string_view name) noexcept {
  const auto found = std::ranges::find(kinds, name, &InjectedFaultKind::name);
  return found == kinds.end() ? nullptr : &*found;
}

}  // namespace ghostforce
