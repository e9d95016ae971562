#include "core/describe/field_values.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/describe/field_json.h"

namespace noonmark::tests {
namespace {

struct Lamp {
    int bulbs = 3;
    float gapM = 0.001F;
    bool isLit = true;
};

const Fields<Lamp>& lampFields() {
    static const Fields<Lamp> fields{
        field(&Lamp::bulbs, {.key = "bulbs", .label = "Bulbs", .range = ValueRange{1, 8}}),
        field(&Lamp::gapM, {.key = "gap", .label = "Gap", .unit = "m", .range = ValueRange{0, 10}}),
        field(&Lamp::isLit, {.key = "lit", .label = "Lit"})};
    return fields;
}

TEST(NamedFields, HoldTheirDefaultsUntilOthersAreSet) {
    const std::vector<Field> rows = asNamedNumbers(lampFields().rows());
    NamedNumbers numbers;
    const Editable lamp{rows, &numbers};
    EXPECT_EQ(rows[0].get(&numbers), Value(std::int64_t(3)));
    EXPECT_EQ(rows[1].get(&numbers), Value(0.001)) << "as it is written, not as a float holds it";
    EXPECT_EQ(rows[2].get(&numbers), Value(true));
    ASSERT_TRUE(lamp.set(rows[0], std::int64_t(5)));
    ASSERT_TRUE(lamp.set(rows[2], false));
    EXPECT_EQ(numbers, (NamedNumbers{{"bulbs", 5}, {"lit", 0}}));
    ASSERT_TRUE(lamp.set(rows[2], true));
    ASSERT_TRUE(lamp.set(rows[1], 0.001));
    EXPECT_EQ(numbers, (NamedNumbers{{"bulbs", 5}})) << "defaults are not stored";
    EXPECT_FALSE(lamp.set(rows[0], std::string("five")));
    EXPECT_EQ(fieldsJson(Described{rows, &numbers}).dump(), R"({"bulbs":5,"gap":0.001,"lit":true})");
}

TEST(NamedFields, FillTheStruct) {
    Lamp lamp;
    ASSERT_TRUE(readNamedNumbers(lampFields().of(lamp), {{"bulbs", 8}, {"gap", 0.5}, {"lit", 0}, {"x", 7}}));
    EXPECT_EQ(lamp.bulbs, 8);
    EXPECT_EQ(lamp.gapM, 0.5F);
    EXPECT_FALSE(lamp.isLit);
    for (const NamedNumbers& wrong :
         {NamedNumbers{{"bulbs", 2.5}}, NamedNumbers{{"bulbs", 1e300}}, NamedNumbers{{"lit", 2}},
          NamedNumbers{{"bulbs", std::numeric_limits<double>::quiet_NaN()}}})
        EXPECT_FALSE(readNamedNumbers(lampFields().of(lamp), wrong)) << wrong.begin()->first;
}

TEST(NamedFields, AreCheckedByTheirKindAndRange) {
    const std::vector<Field> rows = asNamedNumbers(lampFields().rows());
    const auto adviceOn = [&](const NamedNumbers& numbers) {
        const auto checked = checkRanges({rows, &numbers});
        return checked ? "fits" : checked.error().what + ". " + checked.error().advice;
    };
    EXPECT_EQ(adviceOn({{"bulbs", 8}, {"gap", 0}, {"lit", 1}}), "fits");
    EXPECT_EQ(adviceOn({{"bulbs", 9}}), "Bulbs: 9 is out of range. Give 1 to 8");
    EXPECT_EQ(adviceOn({{"bulbs", 1.5}}), "Bulbs: 1.5 is no whole number. Give 1 to 8");
    EXPECT_EQ(adviceOn({{"gap", 10.5}}), "Gap: 10.5 m is out of range. Give 0 to 10 m");
    EXPECT_EQ(adviceOn({{"lit", -1}}), "Lit: -1 is neither yes nor no. Give yes or no");
}

}  // namespace
}  // namespace noonmark::tests
