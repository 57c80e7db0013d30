#include "device/virtual_haply/haply_fault.h"

#include <algorithm>
#include <array>

namespace ghostforce {
namespace {

using HaplyFault = InjectedHaplyFault;
using HaplyFaultKind = InjectedHaplyFaultKind;

template <auto member, auto value = true>
void set_haply(HaplyFault& wrong) noexcept {
  wrong.*member = value;
}

template <std::uint8_t motors>
void reverse(HaplyFault& wrong) noexcept {
  wrong.reversed_motors |= motors;
}

template <HaplyReplyFault fault, int replies, unsigned interval = 1>
void spoil_replies(HaplyFault& wrong) noexcept {
  wrong.reply = fault;
  wrong.reply_interval = interval;
  wrong.faulty_replies = replies;
}

constexpr int all_replies = 0;  // as InjectedHaplyFault::faulty_replies

constexpr std::array haply_kinds{
    HaplyFaultKind{"absent", "No board is plugged in.", set_haply<&HaplyFault::link, LinkFault::absent>},
    HaplyFaultKind{"not-allowed", "The board is plugged in, but this user may not open its port.",
                   set_haply<&HaplyFault::link, LinkFault::not_allowed>},
    HaplyFaultKind{"busy", "Another program has the port.", set_haply<&HaplyFault::link, LinkFault::busy>},
    HaplyFaultKind{"unplugged", "The USB cable is pulled out; the motors keep what they were told.",
                   set_haply<&HaplyFault::link, LinkFault::unplugged>},
    HaplyFaultKind{"power-lost", "Motors and encoders have no power; the board goes on answering.",
                   set_haply<&HaplyFault::power_lost>},
    HaplyFaultKind{"unconfigured", "The board takes no set up: its replies are its address and no angles.",
                   set_haply<&HaplyFault::refuses_set_ups>},
    HaplyFaultKind{"other-id", "Another program has set up the board for another address, and has left a force, once.",
                   set_haply<&HaplyFault::is_another_programs>},
    HaplyFaultKind{"torn-packet", "One packet reaches the board in two pieces, so that it takes torques for commands.",
                   set_haply<&HaplyFault::tears_packet>},
    HaplyFaultKind{"late-5ms", "Each reply comes 5 ms late.", set_haply<&HaplyFault::reply_delay_ns, 5'000'000>},
    HaplyFaultKind{"late-50ms", "Each reply comes 50 ms late.", set_haply<&HaplyFault::reply_delay_ns, 50'000'000>},
    HaplyFaultKind{"late-creeping", "Each reply comes 0.1 ms later than the one before.",
                   set_haply<&HaplyFault::reply_creep_ns, 100'000>},
    HaplyFaultKind{"lost-reply", "One reply never comes.", spoil_replies<HaplyReplyFault::lost, 1>},
    HaplyFaultKind{"lost-replies", "Every tenth reply never comes.",
                   spoil_replies<HaplyReplyFault::lost, all_replies, 10>},
    HaplyFaultKind{"mute", "The board obeys but stops answering.", spoil_replies<HaplyReplyFault::lost, all_replies>},
    HaplyFaultKind{"short-reply", "One reply lacks its last three bytes.",
                   spoil_replies<HaplyReplyFault::shortened, 1>},
    HaplyFaultKind{"duplicated-replies", "Each reply comes twice.", set_haply<&HaplyFault::duplicated_replies>},
    HaplyFaultKind{"garbage", "A modem manager's commands go to the board, and come between the replies.",
                   set_haply<&HaplyFault::garbage>},
    HaplyFaultKind{"wrong-sign-1", "The motor of arm 1 pushes the other way.", reverse<1>},
    HaplyFaultKind{"wrong-sign-2", "The motor of arm 2 pushes the other way.", reverse<2>},
    HaplyFaultKind{"half-resolution", "Both encoders count half as many steps, so that angles change by half.",
                   set_haply<&HaplyFault::encoder_share, 0.5>},
    HaplyFaultKind{"wrong-zero-pose", "The person holds both arms 8° too far outwards for the zero pose.",
                   set_haply<&HaplyFault::zero_pose_error_degrees, 8.0>},
    HaplyFaultKind{"impossible-angles", "All replies give angles of arms that have passed through each other.",
                   spoil_replies<HaplyReplyFault::crossed, all_replies>},
    HaplyFaultKind{"frozen-encoder", "The encoder of arm 1 stops counting.",
                   set_haply<&HaplyFault::frozen_encoders, std::uint8_t{1}>},
    HaplyFaultKind{"frozen-encoders", "Both encoders stop counting.",
                   set_haply<&HaplyFault::frozen_encoders, std::uint8_t{3}>},
    HaplyFaultKind{"encoder-jump", "The encoder of arm 1 jumps by 20°, once.",
                   set_haply<&HaplyFault::encoder_jump_degrees, 20.0>},
    HaplyFaultKind{"restarts", "The board restarts and forgets its set up and its angles, once.",
                   set_haply<&HaplyFault::restarts>},
    HaplyFaultKind{"touched-1200-baud", "The port was set to 1200 baud: the board vanishes when it is closed.",
                   set_haply<&HaplyFault::touched_at_1200_baud>},
    HaplyFaultKind{"no-dtr", "The DTR line is low: the board obeys and sends nothing.",
                   set_haply<&HaplyFault::dtr_is_low>},
    HaplyFaultKind{"garbage-float", "The board takes one positive torque for a negative one.",
                   set_haply<&HaplyFault::spoils_torque>},
    HaplyFaultKind{"not-a-number", "One reply gives an angle that is not a number.",
                   spoil_replies<HaplyReplyFault::not_a_number, 1>},
    HaplyFaultKind{"silent", "No such board is at the port: whatever is there never answers.",
                   set_haply<&HaplyFault::program, BoardProgram::silent>},
    HaplyFaultKind{"chatty", "The board runs another program, which sends lines of text.",
                   set_haply<&HaplyFault::program, BoardProgram::chatty>},
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
