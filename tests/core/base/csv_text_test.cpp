#include "core/base/csv_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace noonmark {
namespace {

TEST(CsvText, NumbersArePlainAndWhatIsNoNumberIsNothing) {
    CsvText csv({"name", "a", "b", "c"});
    csv.text("x, y").number(1234567.25, 1).number(std::numeric_limits<double>::quiet_NaN(), 1).whole(26781);
    csv.endRow();
    csv.text("=1").number(0.1).number(-std::numeric_limits<double>::infinity()).nothing();
    csv.endRow();
    EXPECT_EQ(csv.take(), "name,a,b,c\r\n\"x, y\",1234567.2,,26781\r\n'=1,0.1,,\r\n");
    EXPECT_EQ(csv.take(), "");
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
