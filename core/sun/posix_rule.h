#pragma once

#include <chrono>
#include <optional>
#include <string_view>

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

}  // namespace noonmark
