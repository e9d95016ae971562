#include "core/base/wording.h"

#include <fmt/format.h>
#include <array>

namespace noonmark {

namespace {

class English final : public Wording {
public:
    [[nodiscard]] std::string text(std::string_view english) const override { return std::string(english); }
    [[nodiscard]] std::string ruleText(std::string_view english) const override {
        return std::string(english);
    }
    [[nodiscard]] std::string numbers(std::string_view english) const override {
        return std::string(english);
    }
    [[nodiscard]] std::string date(std::chrono::year_month_day day) const override {
        return fmt::format("{} {} {}", unsigned(day.day()), month(day.month(), false), int(day.year()));
    }
    [[nodiscard]] std::string month(std::chrono::month month, bool isShort) const override {
        static constexpr std::array<std::string_view, 12> names{
            "January", "February", "March",     "April",   "May",      "June",
            "July",    "August",   "September", "October", "November", "December"};
        constexpr std::size_t shortLength = 3;
        const std::string_view name = names[unsigned(month) - 1];
        return std::string(isShort ? name.substr(0, shortLength) : name);
    }
    [[nodiscard]] std::string code() const override { return "en"; }
};

thread_local const Wording* inUse = nullptr;

}  // namespace

const Wording& englishWording() {
    static const English english;
    return english;
}

const Wording& wordingInUse() { return inUse ? *inUse : englishWording(); }

const Wording* findScopedWording() { return inUse; }

WordingScope::WordingScope(const Wording& wording) : before_(inUse) { inUse = &wording; }
WordingScope::~WordingScope() { inUse = before_; }

}  // namespace noonmark
