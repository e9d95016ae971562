#include "core/base/wording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <thread>

#include "core/base/units.h"
#include "core/describe/fill_text.h"

namespace noonmark {
namespace {

/// A language of capitals, with a decimal comma.
class CapitalWording final : public Wording {
public:
    [[nodiscard]] std::string text(std::string_view english) const override {
        std::string text(english);
        std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::toupper(c)); });
        return text;
    }
    [[nodiscard]] std::string ruleText(std::string_view english) const override {
        return "rule: " + std::string(english);
    }
    [[nodiscard]] std::string numbers(std::string_view english) const override {
        std::string text(english);
        std::ranges::replace(text, '.', ',');
        return text;
    }
    [[nodiscard]] std::string date(std::chrono::year_month_day) const override { return "a day"; }
    [[nodiscard]] std::string month(std::chrono::month, bool) const override { return "a month"; }
    [[nodiscard]] std::string code() const override { return "cap"; }
};

TEST(Wording, WithoutAScopeTextsAreEnglish) {
    EXPECT_TRUE(isEnglishInUse());
    EXPECT_EQ(findScopedWording(), nullptr);
    EXPECT_EQ(localText("shadow area"), "shadow area");
    EXPECT_EQ(localNumbers("12.5"), "12.5");
    using namespace std::chrono;
    EXPECT_EQ(wordingInUse().date(2026y / December / 21), "21 December 2026");
    EXPECT_EQ(wordingInUse().month(September, true), "Sep");
}

TEST(Wording, AScopeHoldsForWhatPeopleReadInItsThread) {
    const CapitalWording capitals;
    const WordingScope words(capitals);
    EXPECT_EQ(localText("shadow area"), "SHADOW AREA");
    EXPECT_EQ(fillText("%1 of %2", {"a", "%1"}), "a OF %1") << "values are neither translated nor searched";
    EXPECT_EQ(formatLength(12.5, UnitSystem::imperial), "41,0 FT");
    EXPECT_EQ(formatNumber(12.5, 1), "12.5") << "files are written with it";
    EXPECT_EQ(inEnglish([] { return localText("for machines"); }), "for machines");
    EXPECT_EQ(localText("again"), "AGAIN");
    std::string other;
    std::thread([&] { other = localText("other thread"); }).join();
    EXPECT_EQ(other, "other thread");
}

TEST(Wording, TheScopeAroundHoldsAgainAfterAnInnerOne) {
    const CapitalWording capitals;
    {
        const WordingScope outer(capitals);
        { const WordingScope inner(englishWording()); }
        EXPECT_EQ(localText("a"), "A");
        EXPECT_EQ(findScopedWording(), &capitals);
    }
    EXPECT_EQ(localText("a"), "a");
}

}  // namespace
}  // namespace noonmark
