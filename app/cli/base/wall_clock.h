#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "core/sun/civil_time.h"

namespace noonmark::cli {

/// Reads and writes times as the user does: in a time zone of the tz database, or at the fixed offset given
/// with the time.
class WallClock {
public:
    /// Uses the zone if one is named, otherwise the offset at the end of `at` ("...-07:00", "...Z"). Error:
    /// an unknown zone, or neither is given.
    static Result<WallClock> from(const std::string& zone, const std::string& at);

    /// Parses an instant.
    [[nodiscard]] Result<Instant> instant(const std::string& at) const;
    /// 0:00 on the civil day of an instant.
    [[nodiscard]] Instant midnightBefore(Instant at) const;
    /// ISO 8601 with offset, whole seconds (rounded): "2003-10-17T12:30:30-07:00".
    [[nodiscard]] std::string text(Instant at) const;

private:
    std::optional<Zone> zone_;
    std::chrono::minutes offset_{0};
};

}  // namespace noonmark::cli
