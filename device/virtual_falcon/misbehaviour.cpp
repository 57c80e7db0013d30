#include "device/virtual_falcon/misbehaviour.h"

#include <algorithm>
#include <array>

namespace ghostforce {
namespace {

constexpr void fail_always(Misbehaviour& wrong, ReplyFault fault) noexcept {
  wrong.reply = fault;
  wrong.reply_interval = 1;
  wrong.faulty_replies = 0;
}

constexpr void fail_once(Misbehaviour& wrong, ReplyFault fault) noexcept {
  fail_always(wrong, fault);
  wrong.faulty_replies = 1;
}

constexpr std::array kinds{
    MisbehaviourKind{"absent", "No Falcon is plugged in.",
                     [](Misbehaviour& wrong) noexcept { wrong.link = LinkFault::absent; }},
    MisbehaviourKind{"not-allowed", "The Falcon is there, and this user may not open it.",
                     [](Misbehaviour& wrong) noexcept { wrong.link = LinkFault::not_allowed; }},
    MisbehaviourKind{"busy", "Another program has the Falcon.",
                     [](Misbehaviour& wrong) noexcept { wrong.link = LinkFault::busy; }},
    MisbehaviourKind{"unplugged", "The USB cable is pulled out.",
                     [](Misbehaviour& wrong) noexcept { wrong.link = LinkFault::unplugged; }},
    MisbehaviourKind{"power-lost", "The Falcon has no current: it is silent, and has forgotten firmware and home.",
                     [](Misbehaviour& wrong) noexcept { wrong.power_lost = true; }},
    MisbehaviourKind{"power-blink", "The current fails for a moment: firmware and home are forgotten.",
                     [](Misbehaviour& wrong) noexcept { wrong.power_blinks = true; }},
    MisbehaviourKind{"lost-first-replies", "The first three answers of the hand-shake never come.",
                     [](Misbehaviour& wrong) noexcept { wrong.lost_replies = 3; }},
    MisbehaviourKind{"leading-00", "A byte 00 comes before each answer of the hand-shake.",
                     [](Misbehaviour& wrong) noexcept { wrong.leading_00 = true; }},
    MisbehaviourKind{"leading-13", "A byte 13 comes before the 'A' that begins the upload.",
                     [](Misbehaviour& wrong) noexcept { wrong.leading_13 = true; }},
    MisbehaviourKind{"no-cts", "The device never says that it is clear to send.",
                     [](Misbehaviour& wrong) noexcept { wrong.without_cts = true; }},
    MisbehaviourKind{"corrupted-echo", "One byte of the upload comes back changed, once.",
                     [](Misbehaviour& wrong) noexcept { wrong.echo = EchoFault::corrupted_once; }},
    MisbehaviourKind{"always-corrupted-echo", "One byte of each upload comes back changed.",
                     [](Misbehaviour& wrong) noexcept { wrong.echo = EchoFault::corrupted_always; }},
    MisbehaviourKind{"lost-echo", "One byte of the upload does not come back, once.",
                     [](Misbehaviour& wrong) noexcept { wrong.echo = EchoFault::lost_once; }},
    MisbehaviourKind{"upload-stops", "After 100 bytes of the upload the device is silent.",
                     [](Misbehaviour& wrong) noexcept { wrong.upload_stops = 100; }},
    MisbehaviourKind{"split-packets", "Answers come cut into packets of a few bytes.",
                     [](Misbehaviour& wrong) noexcept { wrong.split_packets = true; }},
    MisbehaviourKind{"joined-packets", "Answers are held back until several come at once.",
                     [](Misbehaviour& wrong) noexcept { wrong.joined_packets = true; }},
    MisbehaviourKind{"short-frames", "Every fourth answer lacks two bytes.",
                     [](Misbehaviour& wrong) noexcept { wrong.short_frames = 4; }},
    MisbehaviourKind{"garbage", "Bytes that mean nothing come between the answers.",
                     [](Misbehaviour& wrong) noexcept { wrong.garbage = true; }},
    MisbehaviourKind{"silence", "The device stops answering.",
                     [](Misbehaviour& wrong) noexcept { wrong.silence = true; }},
    MisbehaviourKind{"frozen-encoders", "The encoders say the same, wherever the arms are.",
                     [](Misbehaviour& wrong) noexcept { wrong.frozen_encoders = true; }},
    MisbehaviourKind{"late-5ms", "Each answer comes 5 ms late.",
                     [](Misbehaviour& wrong) noexcept { wrong.reply_delay_ns = 5'000'000; }},
    MisbehaviourKind{"late-50ms", "Each answer comes 50 ms late.",
                     [](Misbehaviour& wrong) noexcept { wrong.reply_delay_ns = 50'000'000; }},
    MisbehaviourKind{"late-creeping", "Each answer comes 0.1 ms later than the one before.",
                     [](Misbehaviour& wrong) noexcept { wrong.reply_creep_ns = 100'000; }},
    MisbehaviourKind{"lost-reply", "One answer never comes.",
                     [](Misbehaviour& wrong) noexcept { fail_once(wrong, ReplyFault::lost); }},
    MisbehaviourKind{"lost-replies", "Every tenth answer never comes.",
                     [](Misbehaviour& wrong) noexcept {
                       fail_always(wrong, ReplyFault::lost);
                       wrong.reply_interval = 10;
                     }},
    MisbehaviourKind{"mute", "The device obeys, and stops answering.",
                     [](Misbehaviour& wrong) noexcept { fail_always(wrong, ReplyFault::lost); }},
    MisbehaviourKind{"malformed-reply", "One byte of one answer comes changed, so that it is no answer.",
                     [](Misbehaviour& wrong) noexcept { fail_once(wrong, ReplyFault::malformed); }},
    MisbehaviourKind{"wrong-reply", "One byte of one answer comes changed, so that it tells of another place.",
                     [](Misbehaviour& wrong) noexcept { fail_once(wrong, ReplyFault::wrong); }},
    MisbehaviourKind{"encoder-glitch", "One answer tells of a place where the arms cannot be.",
                     [](Misbehaviour& wrong) noexcept { fail_once(wrong, ReplyFault::impossible); }},
    MisbehaviourKind{"impossible-encoders", "All answers tell of a place where the arms cannot be.",
                     [](Misbehaviour& wrong) noexcept { fail_always(wrong, ReplyFault::impossible); }},
    MisbehaviourKind{"duplicated-replies", "Each answer comes twice.",
                     [](Misbehaviour& wrong) noexcept { wrong.duplicated_replies = true; }},
    MisbehaviourKind{"line-noise", "A burst of 100 bytes that mean nothing comes before an answer, once.",
                     [](Misbehaviour& wrong) noexcept { wrong.noise_bytes = 100; }},
    MisbehaviourKind{"forgets-home", "The device has forgotten its home position, once.",
                     [](Misbehaviour& wrong) noexcept { wrong.forgets_home = true; }},
    MisbehaviourKind{"never-homes", "The device never finds its home position.",
                     [](Misbehaviour& wrong) noexcept { wrong.never_homes = true; }},
};

}  // namespace

std::span<const MisbehaviourKind> misbehaviour_catalog() noexcept {
  return kinds;
}

const MisbehaviourKind* find_misbehaviour(std::string_view name) noexcept {
  const auto found = std::ranges::find(kinds, name, &MisbehaviourKind::name);
  return found == kinds.end() ? nullptr : &*found;
}

}  // namespace ghostforce
