#include "core/sun/civil_time.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cstdlib>

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

Instant Zone::instantAt(CivilDate date, minutes sinceMidnight) const {
    return instantOf(local_days{date} + sinceMidnight);
}

CivilDate Zone::dateAt(Instant at) const {
    const sys_seconds second = floor<seconds>(at);
    return floor<days>(second + offsetAt(second));
}

std::string Zone::text(Instant at) const {
    const minutes offset = floor<minutes>(offsetAt(floor<seconds>(at)));
    const auto wallClock = at + offset;
    const auto midnight = floor<days>(wallClock);
    const hh_mm_ss time{wallClock - midnight};
    std::string text = fmt::format("{}T{:02}:{:02}:{:02}", formatText(CivilDate{midnight}),
                                   time.hours().count(), time.minutes().count(), time.seconds().count());
    if (time.subseconds() != 0ms) text += fmt::format(".{:03}", time.subseconds().count());
    const auto size = abs(offset).count();
    return text + fmt::format("{}{:02}:{:02}", offset < 0min ? '-' : '+', size / 60, size % 60);
}

std::string formatText(CivilDate date) {
    return fmt::format("{:04}-{:02}-{:02}", int(date.year()), unsigned(date.month()), unsigned(date.day()));
}

std::string formatText(minutes timeOfDay) {
    return fmt::format("{:02}:{:02}", timeOfDay.count() / 60, timeOfDay.count() % 60);
}

namespace {

/// Takes fields of digits from the left of a text.
class TextReader {
public:
    explicit TextReader(std::string_view text) : rest_(text) {}

    /// Exactly `count` digits; -1 if there are fewer.
    int digits(std::size_t count) {
        if (rest_.size() < count) return -1;
        int value = 0;
        for (const char c : rest_.substr(0, count)) {
            if (c < '0' || c > '9') return -1;
            value = value * 10 + (c - '0');
        }
        rest_.remove_prefix(count);
        return value;
    }

    bool takeIf(char c) {
        if (!rest_.starts_with(c)) return false;
        rest_.remove_prefix(1);
        return true;
    }

    [[nodiscard]] bool atEnd() const { return rest_.empty(); }
    [[nodiscard]] std::string_view rest() const { return rest_; }

private:
    std::string_view rest_;
};

tl::unexpected<Error> badText(std::string_view text, std::string_view kind, std::string advice) {
    return failure(fmt::format("\"{}\" is not a {}", text, kind), std::string(kind), std::move(advice));
}

tl::unexpected<Error> notInCalendar(std::string_view text, CivilDate date) {
    if (!date.month().ok()) return badText(text, "date", "Months run from 01 to 12");
    const unsigned lastDay = unsigned((date.year() / date.month() / last).day());
    return badText(
        text, "date",
        fmt::format("Month {:02} of {} has {} days", unsigned(date.month()), int(date.year()), lastDay));
}

/// "09:00", up to "24:00"
std::optional<milliseconds> takeTime(TextReader& fields) {
    const int hour = fields.digits(2);
    if (hour < 0 || !fields.takeIf(':')) return std::nullopt;
    const int minute = fields.digits(2);
    if (hour > 24 || minute < 0 || minute > 59 || (hour == 24 && minute > 0)) return std::nullopt;
    return hours{hour} + minutes{minute};
}

/// ":30", ":30.5"; 0 if there is none.
std::optional<milliseconds> takeSeconds(TextReader& fields) {
    if (!fields.takeIf(':')) return 0ms;
    const int second = fields.digits(2);
    if (second < 0 || second > 59) return std::nullopt;
    milliseconds value = seconds{second};
    if (!fields.takeIf('.')) return value;
    milliseconds unit = 100ms;
    int digit = fields.digits(1);
    if (digit < 0) return std::nullopt;
    for (; digit >= 0; digit = fields.digits(1), unit /= 10) value += digit * unit;
    return value;
}

/// "-07:00", "-0700", "-07", "Z"
std::optional<minutes> takeOffset(TextReader& fields) {
    if (fields.takeIf('Z') || fields.takeIf('z')) return 0min;
    const bool west = fields.takeIf('-');
    if (!west && !fields.takeIf('+')) return std::nullopt;
    const int hour = fields.digits(2);
    const bool hasMinutes = fields.takeIf(':') || !fields.atEnd();
    const int minute = hasMinutes ? fields.digits(2) : 0;
    if (hour < 0 || hour > 23 || minute < 0 || minute > 59) return std::nullopt;
    const minutes offset = hours{hour} + minutes{minute};
    return west ? -offset : offset;
}

constexpr auto instantAdvice = "Write it like 2003-10-17T12:30:30-07:00, or without the offset";

/// Parses what follows the date and the T: time, seconds, offset.
Result<Instant> instantOn(CivilDate date, std::string_view time, const Zone& zone, std::string_view whole) {
    TextReader fields(time);
    const auto minute = takeTime(fields);
    const auto second = minute ? takeSeconds(fields) : std::nullopt;
    if (!second || *minute + *second > 24h) return badText(whole, "date and time", instantAdvice);
    const auto wallClock = local_days{date} + *minute + *second;
    if (fields.atEnd()) {
        const auto wholeSecond = floor<seconds>(wallClock);
        return zone.instantOf(wholeSecond) + (wallClock - wholeSecond);
    }
    const auto offset = takeOffset(fields);
    if (!offset || !fields.atEnd()) return badText(whole, "date and time", instantAdvice);
    return Instant{wallClock.time_since_epoch()} - *offset;
}

}  // namespace

Result<CivilDate> parseDate(std::string_view text) {
    constexpr auto advice = "Write it like 2026-03-21: year, month, day";
    TextReader fields(text);
    const int year = fields.digits(4);
    const bool firstDash = fields.takeIf('-');
    const int month = fields.digits(2);
    const bool secondDash = fields.takeIf('-');
    const int day = fields.digits(2);
    const bool complete = year >= 0 && firstDash && month >= 0 && secondDash && day >= 0 && fields.atEnd();
    if (!complete) return badText(text, "date", advice);
    const CivilDate date{std::chrono::year{year}, std::chrono::month{unsigned(month)},
                         std::chrono::day{unsigned(day)}};
    if (!date.ok()) return notInCalendar(text, date);
    return date;
}

Result<minutes> parseTimeOfDay(std::string_view text) {
    constexpr auto advice = "Write it like 09:00, from 00:00 to 24:00";
    const std::string padded = fmt::format("{}{}", text.find(':') == 1 ? "0" : "", text);
    TextReader fields(padded);
    const auto time = takeTime(fields);
    if (!time || !fields.atEnd()) return badText(text, "time of day", advice);
    return duration_cast<minutes>(*time);
}

Result<Instant> parseInstant(std::string_view text, const Zone& zone) {
    constexpr std::size_t dateLength = 10;
    const bool separated =
        text.size() > dateLength && std::string_view("Tt ").find(text[dateLength]) != std::string_view::npos;
    if (!separated) return badText(text, "date and time", instantAdvice);
    const auto date = parseDate(text.substr(0, dateLength));
    if (!date) return tl::make_unexpected(date.error());
    return instantOn(*date, text.substr(dateLength + 1), zone, text);
}

}  // namespace noonmark
