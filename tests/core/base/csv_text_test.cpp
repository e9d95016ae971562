#include <gtest/gtest.h>
#include <limits>

#include "core/base/csv_text.h"

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
        EXPECT_EQ(escapeFormula(text), std::string("'") + text);
    for (const char* text : {"-5", "+0.5", "-5 m2", "-5 m²", "a=b"}) EXPECT_EQ(csvField(text), text);
    for (const char* text : {" =1", "\u3000=1", "\uFF1D1+1", "\uFF0BA1", "\uFF0D2+3", "\uFF20SUM(A1)",
                             "\uFE66x", "\u22122+3", "'=1"})
        EXPECT_EQ(escapeFormula(text), std::string("'") + text);
    for (const char* text : {"\u22125 m2", "'quoted'", "\uFF15", ""}) EXPECT_EQ(escapeFormula(text), text);
}

TEST(CsvText, NumbersArePlainAndWhatIsNoNumberIsNothing) {
    CsvText csv({"name", "a", "b", "c"});
    csv.text("x, y").number(1234567.25, 1).number(std::numeric_limits<double>::quiet_NaN(), 1).whole(26781);
    csv.endRow();
    csv.text("=1").number(0.1).number(-std::numeric_limits<double>::infinity()).nothing();
    csv.endRow();
    EXPECT_EQ(csv.take(), "name,a,b,c\r\n\"x, y\",1234567.2,,26781\r\n'=1,0.1,,\r\n");
    EXPECT_EQ(csv.take(), "");
}

TEST(CsvText, WhatRoundsToZeroHasNoSign) {
    CsvText csv({"a", "b", "c", "d", "e"});
    csv.number(-0.00004, 4).number(-0.0).number(-0.00006, 4).number(-0.4, 0).number(-10.0, 1).endRow();
    EXPECT_EQ(csv.take(), "a,b,c,d,e\r\n0.0000,0,-0.0001,0,-10.0\r\n");
}

TEST(CsvText, ATextIsReadBackAsItWas) {
    for (const char* text :
         {"=1+1", "'=1+1", "''", "'a", "-5 m2", "- park", "a;b", "a\tb", "\"", "\uFF1D1", " =1"}) {
        CsvText csv({"name", "other"});
        csv.text(text).nothing().endRow();
        EXPECT_EQ(parseCsvRows(csv.take()).at(1).fields.at(0), std::string(text)) << text;
    }
}

}  // namespace

}  // namespace noonmark
