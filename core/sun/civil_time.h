#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/sun/solar_position.h"

namespace noonmark {

/// The POSIX TZ rule in the last line of a time zone file ("EST5EDT,M3.2.0,M11.1.0"), which holds for all
/// time after the last listed change. Files of the tz database list changes up to 2037 at most; "slim" files
/// only up to the last change of the law.
class PosixRule {
public:
    /// Nothing if the text is not such a rule.
    static std::optional<PosixRule> parsed(std::string_view text);

    /// Offset of local time from UTC, east positive.
    [[nodiscard]] std::chrono::seconds offsetAt(std::chrono::sys_seconds at) const;

    /// A day of the year and a time of that day when the clocks change; the time may lie on a neighbouring
    /// day.
    struct Change {
        enum class Kind { weekday, dayWithoutLeap, dayOfYear };  // "M3.2.0", "J60", "59"
        Kind kind = Kind::weekday;
        unsigned month = 1;  // 1 to 12
        unsigned week = 1;   // 1 to 5; 5 is the last
        unsigned day = 0;    // 0 Sunday to 6; or the day of the year
        std::chrono::seconds time{0};
    };

private:
    struct DaylightSaving {
        std::chrono::seconds offset{0};
        Change start;
        Change end;
    };

    std::chrono::seconds standard_{0};
    std::optional<DaylightSaving> daylightSaving_;
};

using CivilDate = std::chrono::year_month_day;

/// An IANA zone ("America/New_York"): the rules of the tz database, never a fixed offset.
class Zone {
public:
    /// Error for an unknown name; the advice lists similar names.
    static Result<Zone> named(std::string_view ianaName);
    static Zone utc();

    [[nodiscard]] const std::string& name() const { return name_; }

    /// The instant of a wall-clock time. Minutes may exceed 24 x 60; they then lie on the following days. A
    /// time that DST skips gives the instant of the jump; a time that occurs twice gives the first.
    [[nodiscard]] Instant instantAt(CivilDate date, std::chrono::minutes sinceMidnight) const;
    [[nodiscard]] Instant instantOf(std::chrono::local_seconds wallClock) const;

    /// The civil date of an instant.
    [[nodiscard]] CivilDate dateAt(Instant at) const;

    /// Local time minus UTC.
    [[nodiscard]] std::chrono::seconds offsetAt(std::chrono::sys_seconds at) const;

    /// ISO 8601 with offset: "2026-03-21T09:00:00-04:00"; with milliseconds if they are not 0. Offsets of
    /// local mean time (before 1940) are rounded to the minute that ISO 8601 allows, and the time with them.
    [[nodiscard]] std::string text(Instant at) const;

private:
    struct Rules;
    std::string name_ = "UTC";
    std::shared_ptr<const Rules> rules_;  // null: UTC
};

/// The IANA names known on this machine, sorted.
std::vector<std::string> zoneNames();

Result<CivilDate> parseDate(std::string_view text);  ///< "2026-03-21"
/// "09:00"; "24:00" is the end of the day
Result<std::chrono::minutes> parseTimeOfDay(std::string_view text);
/// "2003-10-17T12:30:30-07:00"; a text without an offset is in `zone`.
Result<Instant> parseInstant(std::string_view text, const Zone& zone);
std::string formatText(CivilDate date);                  ///< "2026-03-21"
std::string formatText(std::chrono::minutes timeOfDay);  ///< "09:00"

/// The day of a common year, 1 to 365, by which leaf days are counted in leap years, too: 29 February is 60,
/// as 1 March.
inline int dayOfCommonYear(CivilDate date) {
    using namespace std::chrono;
    constexpr year common{2026};
    return int((sys_days(common / date.month() / date.day()) - sys_days(common / January / 1)).count()) + 1;
}

}  // namespace noonmark
