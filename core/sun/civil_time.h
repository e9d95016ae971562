#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/sun/solar_position.h"

namespace noonmark {

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

}  // namespace noonmark
