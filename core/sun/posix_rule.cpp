#include "core/sun/posix_rule.h"

#include <algorithm>
#include <charconv>

namespace noonmark {

namespace {

using namespace std::chrono;

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Consumes the text from the left, piece by piece; after a missing piece everything fails.
class Scanner {
public:
    explicit Scanner(std::string_view text) : rest_(text) {}

    [[nodiscard]] bool good() const { return good_; }
    [[nodiscard]] bool atEnd() const { return rest_.empty(); }

    bool takeIf(char c) {
        if (!rest_.starts_with(c)) return false;
        rest_.remove_prefix(1);
        return true;
    }

    void expect(char c) { good_ &= takeIf(c); }

    /// "EST", "<+1030>"
    void name() {
        const bool bracketed = takeIf('<');
        const auto end =
            std::ranges::find_if(rest_, [=](char c) { return bracketed ? c == '>' : !isLetter(c); });
        good_ &= end - rest_.begin() >= 3;
        rest_.remove_prefix(std::size_t(end - rest_.begin()));
        if (bracketed) expect('>');
    }

    unsigned number(unsigned highest) {
        unsigned value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        good_ &= error == std::errc{} && value <= highest;
        rest_.remove_prefix(std::size_t(end - rest_.data()));
        return value;
    }

    /// "5", "-10:30", "+1:00:00"
    seconds time(unsigned maxHours) {
        const bool negative = takeIf('-');
        if (!negative) takeIf('+');
        seconds value = hours{number(maxHours)};
        if (takeIf(':')) value += minutes{number(59)};
        if (takeIf(':')) value += seconds{number(59)};
        return negative ? -value : value;
    }

    [[nodiscard]] bool atTime() const { return !rest_.empty() && !rest_.starts_with(','); }

private:
    std::string_view rest_;
    bool good_ = true;
};

// POSIX; a change of the clocks may lie up to a week from its day (RFC 8536).
constexpr unsigned maxHoursOfOffset = 24;
constexpr unsigned maxHoursOfChange = 167;

PosixRule::Change takeChange(Scanner& scanner) {
    using Kind = PosixRule::Change::Kind;
    PosixRule::Change change;
    scanner.expect(',');
    if (scanner.takeIf('M')) {
        change.month = scanner.number(12);
        scanner.expect('.');
        change.week = scanner.number(5);
        scanner.expect('.');
        change.day = scanner.number(6);
    } else {
        change.kind = scanner.takeIf('J') ? Kind::dayWithoutLeap : Kind::dayOfYear;
        change.day = scanner.number(365);
    }
    change.time = scanner.takeIf('/') ? scanner.time(maxHoursOfChange) : hours{2};
    return change;
}

bool isCalendar(const PosixRule::Change& change) {
    if (change.kind == PosixRule::Change::Kind::weekday) return change.month >= 1 && change.week >= 1;
    return change.kind == PosixRule::Change::Kind::dayOfYear || change.day >= 1;
}

sys_days dayOf(const PosixRule::Change& change, year inYear) {
    if (change.kind == PosixRule::Change::Kind::weekday) {
        const weekday day{change.day};
        const month inMonth{change.month};
        return change.week == 5 ? sys_days{inYear / inMonth / day[last]}
                                : sys_days{inYear / inMonth / day[change.week]};
    }
    const sys_days newYear = inYear / January / 1;
    if (change.kind == PosixRule::Change::Kind::dayOfYear) return newYear + days{change.day};
    const bool afterLeapDay = inYear.is_leap() && change.day >= 60;  // "J60" is March 1 in every year
    return newYear + days{change.day - 1 + afterLeapDay};
}

}  // namespace

std::optional<PosixRule> PosixRule::parsed(std::string_view text) {
    PosixRule rule;
    Scanner scanner(text);
    scanner.name();
    rule.standard_ = -scanner.time(maxHoursOfOffset);  // POSIX counts west as positive
    if (scanner.good() && !scanner.atEnd()) {
        DaylightSaving daylightSaving;
        scanner.name();
        daylightSaving.offset =
            scanner.atTime() ? -scanner.time(maxHoursOfOffset) : rule.standard_ + hours{1};
        daylightSaving.start = takeChange(scanner);
        daylightSaving.end = takeChange(scanner);
        if (!isCalendar(daylightSaving.start) || !isCalendar(daylightSaving.end)) return std::nullopt;
        rule.daylightSaving_ = daylightSaving;
    }
    if (!scanner.good() || !scanner.atEnd()) return std::nullopt;
    return rule;
}

seconds PosixRule::offsetAt(sys_seconds at) const {
    if (!daylightSaving_) return standard_;
    const year inYear = year_month_day{floor<days>(at + standard_)}.year();
    const sys_seconds start = dayOf(daylightSaving_->start, inYear) + daylightSaving_->start.time - standard_;
    const sys_seconds end =
        dayOf(daylightSaving_->end, inYear) + daylightSaving_->end.time - daylightSaving_->offset;
    // In the southern hemisphere summer time spans new year
    const bool isSummer = start < end ? at >= start && at < end : at >= start || at < end;
    return isSummer ? daylightSaving_->offset : standard_;
}

}  // namespace noonmark
