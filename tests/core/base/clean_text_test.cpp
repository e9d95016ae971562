#include "core/base/safe_text.h"

#include <gtest/gtest.h>

#include "core/base/result.h"
#include "core/base/warnings.h"

namespace noonmark {
namespace {

TEST(CleanText, IsOneLineWithoutCommandsOfATerminal) {
    EXPECT_EQ(cleanText("Käse \u6771\u4EAC"), "Käse \u6771\u4EAC");
    EXPECT_EQ(cleanText("a\x1b[2Jb\nnoonmark-cli: done\r"), "a [2Jb noonmark-cli: done ");
    EXPECT_EQ(cleanText("a\u009B2Jb\u007Fc"), "a 2Jb c") << "C1 and DEL";
    EXPECT_EQ(cleanText("a\u2028b\u202Ec\u2067d"), "a b c d");
    EXPECT_EQ(cleanText("\u2027\u202F\u2065\u206A\u00A0"), "\u2027\u202F\u2065\u206A\u00A0");
    EXPECT_EQ(cleanText("\xFF\xC0\xAF\xED\xA0\x80\xE2\x80"), "????????");
    EXPECT_EQ(cleanText("\u00E9\u00E9\u00E9", 2), "\u00E9\u00E9");
}

TEST(CleanText, OfSeveralLinesKeepsTheirEnds) {
    EXPECT_EQ(cleanLines("a\tb\r\nc\n\nd\x1b[m\re\n"), "a\tb\r\nc\n\nd [m e\n");
    EXPECT_EQ(cleanLines(""), "");
    EXPECT_EQ(cleanLines("\r"), " ");
}

TEST(CleanText, ErrorsAndWarningsAreOneLine) {
    const Error error{"What\x1b[2J", "file\nfalse", "Do\r\nthis"};
    EXPECT_EQ(error.text(), "file false: What [2J. Do  this");
    EXPECT_EQ(lineOf({WarningKind::dropped, "is\x1b bad", {"way\n1"}}), "1 dropped: is  bad (way 1)");
}

TEST(CountOf, HasTheNounInItsNumber) {
    EXPECT_EQ(countOf(1, "tile"), "1 tile");
    EXPECT_EQ(countOf(0, "tile"), "0 tiles");
    EXPECT_EQ(countOf(1204, "tile"), "1,204 tiles");
    EXPECT_EQ(countOf(2, "city", "cities"), "2 cities");
}

}  // namespace
}  // namespace noonmark
