// Titles in SVG and PDF files, as this and other programs write them.
#include <string>

#include <gtest/gtest.h>

#include "app/files/picture_title.h"

namespace ghostforce::picture_title_test {
namespace {

using namespace std::string_literals;

TEST(SvgTitle, IsReadAsOthersWriteIt) {
  EXPECT_EQ(svg_title("<svg><title>a: b</title></svg>"), "a: b");
  EXPECT_EQ(svg_title("<svg>\n<title\n id=\"title1\">it&#39;s &quot;x&quot; &lt;&amp;&gt; &#x41;</title>"),
            "it's \"x\" <&> A");
  EXPECT_EQ(svg_title("<title>&unknown; & &#0; &#1114112;</title>"), "&unknown; & &#0; &#1114112;");
}

TEST(SvgTitle, IsEmptyWhereThereIsNone) {
  for (const std::string text : {"", "<svg/>", "<title", "<title>", "<title>a", "<title>a</titl", "<title/"}) {
    EXPECT_EQ(svg_title(text), "") << text;
  }
}

TEST(PdfTitle, IsReadAsOthersWriteIt) {
  EXPECT_EQ(pdf_title("/Title (a \\(b\\) \\\\ (c) \\101\\\nd)"), "a (b) \\ (c) Ad");
  EXPECT_EQ(pdf_title("/Title<FEFF004103C10042>"), "A?B");
  EXPECT_EQ(pdf_title("/Title(\xFE\xFF\0A\0B)"s), "AB");
  EXPECT_EQ(pdf_title("/Title (old) /Title (new)"), "new");
}

TEST(PdfTitle, IsEmptyWhereThereIsNone) {
  for (const std::string text : {"", "/Title", "/Title ", "/Title 5", "/Title (a", "/Title (a\\", "/Title (a\\)",
                                 "/Title <4g>", "/Title <", "/Titl"}) {
    EXPECT_EQ(pdf_title(text), "") << text;
  }
}

}  // namespace
}  // namespace ghostforce::picture_title_test
