#include "core/base/json_number.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace noonmark {
namespace {

template <class Integer>
Integer numberIn(const char* text) {
    return wholeNumberFrom<Integer>(nlohmann::json::parse(text));
}

TEST(JsonNumber, TakesWholeNumbersThatTheTypeHolds) {
    EXPECT_EQ(numberIn<int>("-7"), -7);
    EXPECT_EQ(numberIn<int>("7.0"), 7);
    EXPECT_EQ(numberIn<unsigned>("4294967295"), 4294967295U);
    EXPECT_EQ(numberIn<std::uint64_t>("18446744073709551615"), 18446744073709551615U);
    EXPECT_EQ(numberIn<std::uint64_t>("9007199254740992.0"), 9007199254740992U);
}

TEST(JsonNumber, RefusesAllOthers) {
    for (const char* text : {"-1", "4294967296", "1e300", "-1e300", "0.5", "1.8446744073709552e19"})
        EXPECT_THROW(numberIn<unsigned>(text), std::out_of_range) << text;
    EXPECT_THROW(numberIn<int>("2147483648"), std::out_of_range);
    EXPECT_THROW(numberIn<std::size_t>("-1"), std::out_of_range);
    EXPECT_THROW(numberIn<int>("\"7\""), nlohmann::json::exception);
    EXPECT_THROW(numberIn<int>("null"), nlohmann::json::exception);
}

TEST(JsonNumber, AMemberMayBeMissing) {
    const auto json = nlohmann::json::parse(R"({"count":3})");
    EXPECT_EQ(wholeNumberIn(json, "count", 0), 3);
    EXPECT_EQ(wholeNumberIn(json, "other", 5), 5);
}

}  // namespace
}  // namespace noonmark
