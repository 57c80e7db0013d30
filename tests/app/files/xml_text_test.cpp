// What people write, where a reader of XML takes it.
#include "app/files/xml_text.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace ghostforce::xml_text_test {
namespace {

TEST(XmlText, KeepsWordsOfAnyLanguage) {
  for (const std::string_view words : {"", "a wall", "\xC3\xBC \xE2\x82\xAC \xF0\x9F\x98\x80", "\x7F\xC2\x85",
                                       "\xEF\xBF\xBD \xED\x9F\xBF \xEE\x80\x80 \xF4\x8F\xBF\xBF"}) {
    EXPECT_EQ(xml_text(words), words);
  }
}

TEST(XmlText, EscapesWhatMeansSomethingInTextOrAttributes) {
  EXPECT_EQ(xml_text("<a b=\"c\" d='e'>&"), "&lt;a b=&quot;c&quot; d=&#39;e&#39;&gt;&amp;");
  EXPECT_EQ(xml_text("]]>"), "]]&gt;");
  EXPECT_EQ(xml_text("a\tb\nc\rd"), "a&#9;b&#10;c&#13;d");
}

TEST(XmlText, LeavesOutWhatXmlForbids) {
  const std::string sign = "\xEF\xBF\xBD";
  for (int c = 0; c < 0x20; ++c) {
    if (c == '\t' || c == '\n' || c == '\r') continue;
    EXPECT_EQ(xml_text(std::string(1, static_cast<char>(c)) + "x"), sign + "x") << c;
  }
  EXPECT_EQ(xml_text("\xEF\xBF\xBEx\xEF\xBF\xBFy"), sign + sign + sign + "x" + sign + sign + sign + "y");
}

TEST(XmlText, LeavesOutWhatIsNoUtf8) {
  for (const std::string_view wrong : {"\xFF", "\x80", "\xC3", "\xC0\x80", "\xE2\x82", "\xED\xA0\x80", "\xE0\x80\x80",
                                       "\xF4\x90\x80\x80", "\xF0\x8F"}) {
    std::string expected;
    for (std::size_t i = 0; i < wrong.size(); ++i) expected += "\xEF\xBF\xBD";
    EXPECT_EQ(xml_text(std::string(wrong) + "x"), expected + "x");
  }
}

}  // namespace
}  // namespace ghostforce::xml_text_test
