#include "core/base/csv_text.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

TEST(CsvField, IsQuotedWhereItsTextWouldEndIt) {
    EXPECT_EQ(csvField("Bryant Park"), "Bryant Park");
    EXPECT_EQ(csvField("a, b"), "\"a, b\"");
    EXPECT_EQ(csvField("5\" \nlot"), "\"5\"\" \nlot\"");
    EXPECT_EQ(csvField(""), "");
}

TEST(CsvField, FormulasOfStrangersAreTexts) {
    EXPECT_EQ(csvField("=HYPERLINK(\"http://x\",\"y\")"), "\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\"");
    EXPECT_EQ(csvField("=1+1"), "'=1+1");
    EXPECT_EQ(csvField("@SUM(A1)"), "'@SUM(A1)");
    EXPECT_EQ(csvField("+A1(2)"), "'+A1(2)");
    EXPECT_EQ(csvField("-2+3+cmd|' /C calc'!A0"), "'-2+3+cmd|' /C calc'!A0");
    for (const char* text :
         {"+A1", "-A1+B2", "-1-2", "+'file:///x'#$Sheet.A1", "- the park", "-", "-1 -2", "\tx"})
        EXPECT_EQ(disarmFormula(text), std::string("'") + text);
    for (const char* text : {"-5", "+0.5", "-5 m2", "-5 m²", "a=b"}) EXPECT_EQ(csvField(text), text);
    for (const char* text : {" =1", "\u3000=1", "\uFF1D1+1", "\uFF0BA1", "\uFF0D2+3", "\uFF20SUM(A1)",
                             "\uFE66x", "\u22122+3", "'=1"})
        EXPECT_EQ(disarmFormula(text), std::string("'") + text);
    for (const char* text : {"\u22125 m2", "'quoted'", "\uFF15", ""}) EXPECT_EQ(disarmFormula(text), text);
}

}  // namespace
}  // namespace noonmark
