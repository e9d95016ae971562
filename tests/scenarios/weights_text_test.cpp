#include "scenarios/weights/time_weights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/csv_text.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark::tests {
namespace {

using namespace std::chrono;
using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

std::string whyNot(const std::string& csv) {
    const auto table = parseWeightsCsv(csv, "mine");
    return table ? "no error" : table.error().text();
}

std::vector<std::vector<std::string>> fieldsOf(std::string_view text) {
    std::vector<std::vector<std::string>> fields;
    for (const CsvRow& row : parseCsvRows(text)) fields.push_back(row.fields);
    return fields;
}

// Line numbers count empty lines and line breaks within quotes, as an editor does.
TEST(CsvRows, KnowTheirLines) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        std::string text;
        for (const char* line : {"a,b", "", "1,\"x", "y\"", "2,z", ""}) text += line + end;
        std::vector<std::size_t> lines;
        for (const CsvRow& row : parseCsvRows(text)) lines.push_back(row.line);
        EXPECT_THAT(lines, ElementsAre(1, 3, 5));
    }
    EXPECT_THAT(whyNot("first,last,weight\n\n01-01,02-30,1\n"), HasSubstr("line 3, last: '02-30'"));
}

TEST(CsvRows, TakesWhatSpreadsheetsWrite) {
    EXPECT_THAT(fieldsOf("\xEF\xBB\xBF"
                         "a,b\r\n 1 ,\"x, \"\"y\"\"\n\"\r\n\r\n2,\"\"\n"),
                ElementsAre(ElementsAre("a", "b"), ElementsAre("1", "x, \"y\"\n"), ElementsAre("2", "")));
    EXPECT_THAT(fieldsOf("a;b\n1,5;2"), ElementsAre(ElementsAre("a", "b"), ElementsAre("1,5", "2")));
    EXPECT_TRUE(parseCsvRows("").empty());
    EXPECT_TRUE(parseCsvRows("\n\n").empty());
}

TEST(WeightsText, GoesOutAndIn) {
    TimeWeights table = makeMonthlyWeights();
    table.intervals[0].name = "cold, \"dark\"";
    table.intervals[1].from = 8h + 30min;
    table.intervals[1].weight = -1.0 / 3;
    EXPECT_EQ(parseWeightsCsv(weightsCsv(table), "default").value(), table);
    EXPECT_EQ(parseWeightsJson(weightsJson(table), "default").value(), table);
}

TEST(WeightsText, NeedsOnlyDaysAndAWeight) {
    const TimeWeights table = parseWeightsCsv("Weight,LAST,first\n0.5,02-29,12-01\n", "mine").value();
    ASSERT_EQ(table.intervals.size(), 1U);
    EXPECT_EQ(table.intervals[0].name, "12-01 to 02-29");
    EXPECT_EQ(table.intervals[0].to, 24h);
    EXPECT_TRUE(table.intervals[0].holds(2026y / January / 1, 0h));
}

TEST(WeightsText, SaysTheLineAndWhatIsWrongWithIt) {
    EXPECT_THAT(whyNot(""), HasSubstr("empty"));
    EXPECT_THAT(whyNot("first,last,weight\n"), HasSubstr("no intervals"));
    EXPECT_THAT(whyNot("first,last,weight\n01-01,12-31\n"), HasSubstr("line 2: The row has 2 fields"));
    EXPECT_THAT(whyNot("first,last,wieght\n01-01,12-31,1\n"), HasSubstr("no column 'wieght'"));
    EXPECT_THAT(whyNot("first,last,weight\n01-01,02-30,1\n"), HasSubstr("line 2, last: '02-30'"));
    EXPECT_THAT(whyNot("first,last,weight\n01-01,12-31,1.5\n"), HasSubstr("'1.5' is not a weight"));
    EXPECT_THAT(whyNot("first,last,weight\n01-01,12-31,nan\n"), HasSubstr("'nan' is not a weight"));
    EXPECT_THAT(whyNot("first,last,weight\n01-01,12-31,\n"), HasSubstr("'' is not a weight"));
    EXPECT_THAT(whyNot("first,last,from,weight\n01-01,12-31,8 Uhr,1\n"), HasSubstr("line 2, from"));
    EXPECT_THAT(whyNot("first,last,weight\n01-01,12-31,1\n06-01,06-30,0\n"), HasSubstr("overlap"));
    for (const char* json : {"", "{}", "[1]", "[{}]", R"([{"first":1,"last":"12-31","weight":1}])",
                             R"([{"first":"01-01","last":"12-31","weight":"much"}])", "[[[[[["})
        EXPECT_FALSE(parseWeightsJson(json, "mine")) << json;
}

TEST(WeightsText, DatesThatAreNoneAndColumnsThatStandTwiceAreRefused) {
    for (const char* date : {"257-01", "06-257", "02-30", "13-01", "00-10"}) {
        const auto table = parseWeightsCsv(std::string("first,last,weight\n") + date + ",12-31,1\n", "table");
        ASSERT_FALSE(table) << date;
        EXPECT_NE(table.error().what.find("not a day of the year"), std::string::npos) << table.error().what;
    }
    const auto twice = parseWeightsCsv("first,first,last,weight\n01-01,02-01,12-31,1\n", "table");
    ASSERT_FALSE(twice);
    EXPECT_NE(twice.error().what.find("appears twice"), std::string::npos) << twice.error().what;
}

TEST(WeightsText, AFileIsJsonOrCsvByItsBeginning) {
    const TemporaryFolder folder;
    const TimeWeights table = makeMonthlyWeights();
    EXPECT_EQ(readWeights(folder.file("a.txt", "\n " + weightsJson(table)), "default").value(), table);
    EXPECT_EQ(readWeights(folder.file("b.txt", weightsCsv(table)), "default").value(), table);
    EXPECT_THAT(readWeights(folder.path("gone"), "x").error().text(), HasSubstr("gone"));
    EXPECT_FALSE(readWeights(folder.file("large.csv", std::string(1'000'001, 'x')), "x"));
    EXPECT_FALSE(readWeights(folder.file("binary.csv", std::string("\0\xFF,;\"\n\0", 7)), "x"));
}

}  // namespace
}  // namespace noonmark::tests
