#include "device/virtual_haply/haply_fault.h"

#include <algorithm>
#include <array>

namespace ghostforce {
namespace {

template <auto member, auto value = true>
void set_haply(InjectedHaplyFault& wrong) noexcept {
  wrong.*member = value;
}

template <auto member>
void halve(InjectedHaplyFault& wrong) noexcept {
  wrong.*member *= 0.5;
}

template <std::uint8_t motors>
void reverse(InjectedHaplyFault& wrong) noexcept {
  wrong.reversed_motors |= motors;
}

template <HaplyReplyFault fault, int replies, unsigned interval = 1>
void spoil_replies(InjectedHaplyFault& wrong) noexcept {
  wrong.reply = fault;
  wrong.reply_interval = interval;
  wrong.faulty_replies = replies;
}

constexpr int all_replies = 0;  // as InjectedHaplyFault::faulty_replies

constexpr std::array haply_kinds{
    InjectedHaplyFaultKind{"absent", "No board is plugged in.",
                           set_haply<&InjectedHaplyFault::link, LinkFault::absent>},
    InjectedHaplyFaultKind{"not-allowed", "The board is plugged in, but this user may not open its port.",
                           set_haply<&InjectedHaplyFault::link, LinkFault::not_allowed>},
    InjectedHaplyFaultKind{"busy", "Another program has the port.",
                           set_haply<&InjectedHaplyFault::link, LinkFault::busy>},
    InjectedHaplyFaultKind{"unplugged", "The USB cable is pulled out; the motors keep what they were told.",
                           set_haply<&InjectedHaplyFault::link, LinkFault::unplugged>},
    InjectedHaplyFaultKind{"power-lost", "Motors and encoders have no power; the board goes on answering.",
                           set_haply<&InjectedHaplyFault::power_lost>},
    InjectedHaplyFaultKind{"unconfigured", "The board takes no set up: its replies are its address and no angles.",
                           set_haply<&InjectedHaplyFault::refuses_set_ups>},
    InjectedHaplyFaultKind{"other-id",
                           "Another program has set up the board for another address, and has left a force, once.",
                           set_haply<&InjectedHaplyFault::is_another_programs>},
    InjectedHaplyFaultKind{"torn-packet",
                           "One packet reaches the board in two pieces, so that it takes torques for commands.",
                           set_haply<&InjectedHaplyFault::tears_packet>},
    InjectedHaplyFaultKind{"late-5ms", "Each reply comes 5 ms late.",
                           set_haply<&InjectedHaplyFault::reply_delay_ns, 5'000'000>},
    InjectedHaplyFaultKind{"late-50ms", "Each reply comes 50 ms late.",
                           set_haply<&InjectedHaplyFault::reply_delay_ns, 50'000'000>},
    InjectedHaplyFaultKind{"late-creeping", "Each reply comes 0.1 ms later than the one before.",
                           set_haply<&InjectedHaplyFault::reply_creep_ns, 100'000>},
    InjectedHaplyFaultKind{"lost-reply", "One reply never comes.", spoil_replies<HaplyReplyFault::lost, 1>},
    InjectedHaplyFaultKind{"lost-replies", "Every tenth reply never comes.",
                           spoil_replies<HaplyReplyFault::lost, all_replies, 10>},
    InjectedHaplyFaultKind{"mute", "The board obeys but stops answering.",
                           spoil_replies<HaplyReplyFault::lost, all_replies>},
    InjectedHaplyFaultKind{"short-reply", "One reply lacks its last three bytes.",
                           spoil_replies<HaplyReplyFault::shortened, 1>},
    InjectedHaplyFaultKind{"duplicated-replies", "Each reply comes twice.",
                           set_haply<&InjectedHaplyFault::duplicated_replies>},
    InjectedHaplyFaultKind{"garbage", "A modem manager's commands go to the board, and come between the replies.",
                           set_haply<&InjectedHaplyFault::garbage>},
    InjectedHaplyFaultKind{"wrong-sign-1", "The motor of arm 1 pushes the other way.", reverse<1>},
    InjectedHaplyFaultKind{"wrong-sign-2", "The motor of arm 2 pushes the other way.", reverse<2>},
    InjectedHaplyFaultKind{"half-resolution", "Both encoders count half as many steps, so that angles change by half.",
                           halve<&InjectedHaplyFault::encoder_share>},
    InjectedHaplyFaultKind{"wrong-zero-pose", "The person holds both arms 8° too far outwards for the zero pose.",
                           set_haply<&InjectedHaplyFault::zero_pose_error_degrees, 8>},
    InjectedHaplyFaultKind{"impossible-angles", "All replies give angles of arms that have passed through each other.",
                           spoil_replies<HaplyReplyFault::crossed, all_replies>},
    InjectedHaplyFaultKind{"frozen-encoder", "The encoder of arm 1 stops counting.",
                           set_haply<&InjectedHaplyFault::frozen_encoders, std::uint8_t{1}>},
    InjectedHaplyFaultKind{"frozen-encoders", "Both encoders stop counting.",
                           set_haply<&InjectedHaplyFault::frozen_encoders, std::uint8_t{3}>},
    InjectedHaplyFaultKind{"encoder-jump", "The encoder of arm 1 jumps by 20°, once, as soon as a motor pushes.",
                           set_haply<&InjectedHaplyFault::encoder_jump_degrees, 20>},
    InjectedHaplyFaultKind{"restarts", "The board restarts and forgets its set up and its angles, once.",
                           set_haply<&InjectedHaplyFault::restarts>},
    InjectedHaplyFaultKind{"touched-1200-baud", "The port was set to 1200 baud: the board vanishes when it is closed.",
                           set_haply<&InjectedHaplyFault::touched_at_1200_baud>},
    InjectedHaplyFaultKind{"no-dtr", "The DTR line is low: the board obeys and sends nothing.",
                           set_haply<&InjectedHaplyFault::dtr_is_low>},
    InjectedHaplyFaultKind{"garbage-float", "The board takes one positive torque for a negative one.",
                           set_haply<&InjectedHaplyFault::spoils_torque>},
    InjectedHaplyFaultKind{"not-a-number", "One reply gives an angle that is not a number.",
                           spoil_replies<HaplyReplyFault::not_a_number, 1>},
    InjectedHaplyFaultKind{"silent", "No such board is at the port: whatever is there never answers.",
                           set_haply<&InjectedHaplyFault::program, BoardProgram::silent>},
    InjectedHaplyFaultKind{"chatty", "The board runs another program, which sends lines of text.",
                           set_haply<&InjectedHaplyFault::program, BoardProgram::chatty>},
};

}  // namespace

std::span<const InjectedHaplyFaultKind> injected_haply_fault_catalog() noexcept {
  return haply_kinds;
}

const InjectedHaplyFaultKind* find_injected_haply_fault(std::string_view name) noexcept {
  const auto found = std::ranges::find(haply_kinds, name, &InjectedHaplyFaultKind::name);
  return found == haply_kinds.end() ? nullptr : &*found;
}

}  // namespace ghostforce
