#include "core/io/heights/height_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

struct Row {
    std::string text;
    std::string metres;  ///< empty: not a height
};

// One line of a comma-separated file with "quoted, ""fields""".
std::vector<std::string> fieldsOf(const std::string& line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool doubled = quoted && line.compare(i, 2, "\"\"") == 0;
        if (doubled)
            fields.back() += line[i++];
        else if (line[i] == '"')
            quoted = !quoted;
        else if (line[i] == ',' && !quoted)
            fields.emplace_back();
        else
            fields.back() += line[i];
    }
    return fields;
}

std::vector<Row> rowsOfFile(const std::filesystem::path& file) {
    std::ifstream lines(file);
    std::string line;
    std::getline(lines, line);  // the header
    std::vector<Row> rows;
    while (std::getline(lines, line)) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        const auto fields = fieldsOf(line);
        if (fields.size() >= 2) rows.push_back({fields[0], fields[1]});
    }
    return rows;
}

void expectMetres(const Row& row) {
    const auto metres = parseMetres(row.text);
    if (row.metres.empty()) {
        EXPECT_FALSE(metres) << row.text << " gave " << *metres;
    } else {
        ASSERT_TRUE(metres) << row.text;
        EXPECT_NEAR(*metres, std::stod(row.metres), 1e-9) << row.text;
    }
}

TEST(HeightText, HostileStringsOfMappers) {
    const auto file = tests::sharedData("hostile/osm/height_strings.csv");
    if (!file) GTEST_SKIP() << "shared data is missing: hostile/osm/height_strings.csv";
    const auto rows = rowsOfFile(*file);
    ASSERT_EQ(rows.size(), 27U);
    for (const Row& row : rows) expectMetres(row);
}

TEST(HeightText, WhatPeopleWrite) {
    const std::vector<Row> rows{
        {"12", "12"},
        {"0", "0"},
        {"+7.5", "7.5"},
        {"-1.5 m", "-1.5"},
        {"50.m", "50"},
        {".05m", "0.05"},
        {"3 m.", "3"},
        {"3meters", "3"},
        {"120 cm", "1.2"},
        {"0.25 km", "250"},
        {"3000 ft", "914.4"},
        {"100 feet", "30.48"},
        {"11'", "3.3528"},
        {"11'4\"", "3.4544"},
        {"11' 4\"", "3.4544"},
        {"4 ft 11 in", "1.4986"},
        {"4'11''", "1.4986"},
        {"-4'11\"", "-1.4986"},
        {"36\"", "0.9144"},
        {"12 M", "12"},
        {"\u00A012\u3000", "12"},
        {"\uFF11\uFF12.\uFF15 \uFF4D", "12.5"},
        {"4.60m (15\u20191\u201D)", "4.6"},
        {"15\u20321\u2033 (4.60 m)", "4.5974"},
        {"30 \u043C", "30"},
        {"\u22123 m", "-3"},
    };
    for (const Row& row : rows) expectMetres(row);
}

TEST(HeightText, WhatIsNotOneHeight) {
    for (const char* text : {"",
                             " ",
                             "237;16",
                             "concrete",
                             "7-7",
                             "1,2 m",
                             "1,490 ft",
                             "nan",
                             "inf",
                             "-inf",
                             "1e3",
                             "0x10",
                             ".",
                             ".m",
                             "-",
                             "--3",
                             "1.2.3",
                             "m",
                             "12 furlongs",
                             "12 m 13",
                             "5'6",
                             "5'13\"",
                             "5 ft 6 m",
                             "10 m (50 ft)",
                             "10 m (",
                             "10 m ()",
                             "10 m (10 m) x",
                             "~12",
                             "12?",
                             "5 \xFF",
                             "\xE2\x80",
                             "3\xC0\x80",
                             "\xE0\x80\xB9"})
        expectMetres({text, ""});
    expectMetres({std::string("12\0", 3), ""});
    expectMetres({std::string(400, '9'), ""});
}

TEST(HeightText, BareNumbersAreInTheStatedUnitAndOthersInTheirOwn) {
    EXPECT_NEAR(parseMetres("1000", LengthUnit::feet).value(), 304.8, 1e-9);
    EXPECT_NEAR(parseMetres("3937", LengthUnit::usSurveyFeet).value(), 1200, 1e-9);
    EXPECT_NEAR(parseMetres("1000 m", LengthUnit::feet).value(), 1000, 1e-9);
    EXPECT_NEAR(parseMetres("10 ft").value(), 3.048, 1e-12);
}

TEST(HeightText, Levels) {
    EXPECT_EQ(parseLevels("12"), 12);
    EXPECT_EQ(parseLevels(" 3.5 "), 3.5);
    EXPECT_EQ(parseLevels("\uFF14"), 4);
    EXPECT_EQ(parseLevels("5R"), 5) << "of concrete, in Taiwan";
    EXPECT_EQ(parseLevels("12SRC"), 12);
    EXPECT_EQ(parseLevels("R"), std::nullopt);
    EXPECT_EQ(parseLevels("5X"), std::nullopt);
    EXPECT_EQ(parseLevels("B2"), std::nullopt) << "below the ground";
    EXPECT_EQ(parseLevels("0"), 0);
    for (const char* text : {"", "concrete", "7-7", "3;4", "-1", "2 m", "nan", "1e2", "5+", "3,5"})
        EXPECT_FALSE(parseLevels(text)) << text;
}

// Bytes of height texts in random order get further into the parser than random bytes.
TEST(HeightText, AnyBytesGiveAFiniteNumberOrNothing) {
    const std::string_view likely = "0123456789..'\"'\" -+()mcftinse,;\xE2\x80\x99\xEF\xBC\x94\xC2\xA0\0\xFF";
    std::mt19937 random(20260321);
    for (int i = 0; i < 200000; ++i) {
        std::string text(random() % 24, ' ');
        for (char& c : text) c = i % 2 == 0 ? char(random() % 256) : likely[random() % likely.size()];
        const double metres = parseMetres(text).value_or(0);
        const double levels = parseLevels(text).value_or(0);
        ASSERT_TRUE(std::isfinite(metres) && std::isfinite(levels) && levels >= 0)
            << testing::PrintToString(text);
    }
}

}  // namespace
}  // namespace noonmark
