// What a window pastes, and what it waits for, by the programs that own the clipboard.
#include "app/shell/desktop/x11_clipboard.h"

#include <cstdlib>
#include <string>
#include <string_view>
#include <thread>

#include <gtest/gtest.h>

#include "app/base/failure.h"
#include "tests/support/display.h"
#include "tests/support/x_client.h"

namespace ghostforce::x11_clipboard_test {
namespace {

constexpr std::string_view no_answer =
    "The program that owns the clipboard does not answer. Copy the text again, from another program.";

class PastedText : public testing::Test {
 protected:
  PastedText() { setenv("DISPLAY", name_.c_str(), 1); }

  // As the program that owns the clipboard gives it. Again, where a busy machine let it be too late.
  std::string pasted(const std::string& text) {
    other_.own("CLIPBOARD");
    std::string pasted(no_answer);
    while (pasted == no_answer) {
      std::thread owner([&] { other_.answer_with(text); });
      try {
        pasted = X11Clipboard::text();
      } catch (const Failure& failure) {
        pasted = failure.what();
      }
      owner.join();
    }
    return pasted;
  }

  Display display_{320, 240};
  std::string name_ = display_.environment().front().substr(std::string("DISPLAY=").size());
  XClient other_{name_};
};

TEST_F(PastedText, IsEmptyWithoutAnOwner) {
  EXPECT_EQ(X11Clipboard::text(), "");
}

TEST_F(PastedText, IsTheOwners) {
  EXPECT_EQ(pasted("ghostforce run wall45 --set wall.normal_deg=100"),
            "ghostforce run wall45 --set wall.normal_deg=100");
}

TEST_F(PastedText, HasALimit) {
  const std::string longest(std::size_t{1} << 20, 'x');
  EXPECT_EQ(pasted(longest), longest);
  EXPECT_EQ(pasted(longest + "xxxx"), "The text on the clipboard is too long. Copy less of it.");
}

TEST_F(PastedText, IsNotWaitedForWhereTheOwnerIsFrozen) {
  other_.own("CLIPBOARD");
  try {
    X11Clipboard::text();
    ADD_FAILURE() << "nobody has answered";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.what(), no_answer);
  }
}

}  // namespace
}  // namespace ghostforce::x11_clipboard_test
