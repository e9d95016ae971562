#include "app/cli/base/wall_clock.h"

#include <fmt/format.h>

#include <regex>

namespace noonmark::cli {

namespace {

std::optional<std::chrono::minutes> offsetOf(const std::string& at) {
    static const std::regex pattern(R"(.*[T ].*?(?:(Z)|([+-])(\d\d):?(\d\d)))");
    std::smatch found;
    if (!std::regex_match(at, found, pattern)) return std::nullopt;
    if (found[1].matched) return std::chrono::minutes(0);
    const std::chrono::minutes size =
        std::chrono::hours(std::stoi(found[3])) + std::chrono::minutes(std::stoi(found[4]));
    return found[2] == "-" ? -size : size;
}

}  // namespace

Result<WallClock> WallClock::from(const std::string& zone, const std::string& at) {
    WallClock clock;
    if (!zone.empty()) {
        auto named = Zone::named(zone);
        if (!named) return tl::make_unexpected(named.error());
        clock.zone_ = *std::move(named);
        return clock;
    }
    const auto offset = offsetOf(at);
    if (!offset)
        return failure("The time has no offset from UTC", at,
                       "Add it (2026-03-21T09:00:00-04:00), or give --zone America/New_York");
    clock.offset_ = *offset;
    return clock;
}

Result<Instant> WallClock::instant(const std::string& at) const {
    return parseInstant(at, zone_ ? *zone_ : Zone::utc());
}

Instant WallClock::midnightBefore(Instant at) const {
    if (zone_) return zone_->instantAt(zone_->dateAt(at), std::chrono::minutes(0));
    return Instant(std::chrono::floor<std::chrono::days>(at + offset_)) - offset_;
}

std::string WallClock::text(Instant at) const {
    const Instant rounded = std::chrono::round<std::chrono::seconds>(at);
    if (zone_) return zone_->text(rounded);
    const std::string there =
        Zone::utc().text(rounded + offset_);  // "2003-10-17T12:30:30" followed by UTC's offset
    const auto size = std::chrono::abs(offset_);
    return fmt::format("{}{}{:02}:{:02}", there.substr(0, 19), offset_.count() < 0 ? '-' : '+',
                       size.count() / 60, size.count() % 60);
}

}  // namespace noonmark::cli
