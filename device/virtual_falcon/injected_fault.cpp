#include "device/virtual_falcon/injected_fault.h"

#include <algorithm>
#include <array>

namespace ghostforce {
namespace {

using Fault = InjectedFault;
using Kind = InjectedFaultKind;

template <auto member, auto value = true>
void set(Fault& wrong) noexcept {
  wrong.*member = value;
}

template <ReplyFault fault, int answers, unsigned interval = 1>
void fail(Fault& wrong) noexcept {
  wrong.reply = fault;
  wrong.reply_interval = interval;
  wrong.faulty_replies = answers;
}

constexpr int always = 0;  // as InjectedFault::faulty_replies

constexpr std::array kinds{
    Kind{"absent", "No Falcon is plugged in.", set<&Fault::link, LinkFault::absent>},
    Kind{"not-allowed", "The Falcon is plugged in, but this user may not open it.",
         set<&Fault::link, LinkFault::not_allowed>},
    Kind{"busy", "Another program has the Falcon.", set<&Fault::link, LinkFault::busy>},
    Kind{"unplugged", "The USB cable is pulled out.", set<&Fault::link, LinkFault::unplugged>},
    Kind{"power-lost", "The Falcon has no power: it is silent, and has forgotten its firmware and home.",
         set<&Fault::power_lost>},
    Kind{"power-blink", "The power fails for a moment: firmware and home are forgotten.", set<&Fault::power_blinks>},
    Kind{"lost-first-replies", "The first three answers of the handshake never come.", set<&Fault::lost_replies, 3>},
    Kind{"leading-00", "A byte 00 comes before each answer of the handshake.", set<&Fault::leading_00>},
    Kind{"leading-13", "A byte 13 comes before the 'A' that begins the upload.", set<&Fault::leading_13>},
    Kind{"no-cts", "The device never signals that it is clear to send.", set<&Fault::without_cts>},
    Kind{"corrupted-echo", "One byte of the upload comes back changed, once.",
         set<&Fault::echo, EchoFault::corrupted_once>},
    Kind{"always-corrupted-echo", "One byte of each upload comes back changed.",
         set<&Fault::echo, EchoFault::corrupted_always>},
    Kind{"lost-echo", "One byte of the upload does not come back, once.", set<&Fault::echo, EchoFault::lost_once>},
    Kind{"upload-stops", "After 100 bytes of the upload, the device goes silent.", set<&Fault::upload_stops, 100>},
    Kind{"split-packets", "Answers are split into packets of a few bytes.", set<&Fault::split_packets>},
    Kind{"joined-packets", "Answers are held back until several come at once.", set<&Fault::joined_packets>},
    Kind{"chip-resets", "The USB chip forgets its data rate, format and latency while the cable stays in.",
         set<&Fault::chip_resets>},
    Kind{"short-frames", "Every fourth answer is two bytes short.", set<&Fault::short_frames, 4>},
    Kind{"garbage", "Meaningless bytes come between the answers.", set<&Fault::garbage>},
    Kind{"silence", "The device stops answering.", set<&Fault::silence>},
    Kind{"frozen-encoders", "The encoder values never change, wherever the arms are.", set<&Fault::frozen_encoders>},
    Kind{"reversed-motors", "All three motors push the other way.", set<&Fault::motors_are_reversed>},
    Kind{"late-5ms", "Each answer comes 5 ms late.", set<&Fault::reply_delay_ns, 5'000'000>},
    Kind{"late-50ms", "Each answer comes 50 ms late.", set<&Fault::reply_delay_ns, 50'000'000>},
    Kind{"late-creeping", "Each answer comes 0.1 ms later than the one before.", set<&Fault::reply_creep_ns, 100'000>},
    Kind{"lost-reply", "One answer never comes.", fail<ReplyFault::lost, 1>},
    Kind{"lost-replies", "Every tenth answer never comes.", fail<ReplyFault::lost, always, 10>},
    Kind{"mute", "The device obeys but stops answering.", fail<ReplyFault::lost, always>},
    Kind{"malformed-reply", "One byte of one answer is changed, so that the answer is not valid.",
         fail<ReplyFault::malformed, 1>},
    Kind{"wrong-reply", "One byte of one answer is changed, so that it gives a wrong position.",
         fail<ReplyFault::wrong, 1>},
    Kind{"encoder-glitch", "One answer gives a position that the arms cannot have.", fail<ReplyFault::impossible, 1>},
    Kind{"impossible-encoders", "All answers give a position that the arms cannot have.",
         fail<ReplyFault::impossible, always>},
    Kind{"duplicated-replies", "Each answer comes twice.", set<&Fault::duplicated_replies>},
    Kind{"line-noise", "A burst of 100 meaningless bytes comes before an answer, once.", set<&Fault::noise_bytes, 100>},
    Kind{"forgets-home", "The device forgets its home position, once.", set<&Fault::forgets_home>},
    Kind{"never-homes", "The device never finds its home position.", set<&Fault::never_homes>},
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
