#include <fmt/chrono.h>
#include <fmt/format.h>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <regex>
#include <string>

#include "app/cli/base/command.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/shared_options.h"
#include "core/sun/civil_time.h"
#include "core/sun/sun_paths.h"

namespace noonmark::cli {

namespace {

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

std::optional<std::chrono::minutes> offsetOf(const std::string& at) {
    static const std::regex pattern(R"(.*[T ].*?(?:(Z)|([+-])(\d\d):?(\d\d)))");
    std::smatch found;
    if (!std::regex_match(at, found, pattern)) return std::nullopt;
    if (found[1].matched) return std::chrono::minutes(0);
    const std::chrono::minutes size =
        std::chrono::hours(std::stoi(found[3])) + std::chrono::minutes(std::stoi(found[4]));
    return found[2] == "-" ? -size : size;
}

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

using Json = nlohmann::ordered_json;

struct SunOptions {
    Observer observer;
    std::string at;
    std::string zone;
    bool centre = false;
    double aboveHorizonM = 0;
    bool json = false;
};

// The sun at a place: its position, and the events of one day.
struct SunReport {
    SolarPosition position;
    SunEvents events;
    WallClock clock;
    Instant at;
};

std::string_view nameOf(DayKind kind) {
    switch (kind) {
        case DayKind::ordinary:
            return "ordinary";
        case DayKind::polarDay:
            return "polar day";
        case DayKind::polarNight:
            return "polar night";
    }
    return "unknown";
}

Result<SunReport> sunReport(const SunOptions& options) {
    const auto clock = WallClock::from(options.zone, options.at);
    if (!clock) return tl::make_unexpected(clock.error());
    const auto at = clock->instant(options.at);
    if (!at) return tl::make_unexpected(at.error());
    if (const auto known = Ephemeris::over(options.observer, *at, *at); !known)
        return tl::make_unexpected(known.error());
    const SunriseRule rule = options.centre ? SunriseRule::centre : SunriseRule::upperLimb;
    return SunReport{computeSolarPosition(options.observer, *at),
                     computeSunEvents(options.observer, clock->midnightBefore(*at), rule,
                                      computeHorizonDip(options.aboveHorizonM)),
                     *clock, *at};
}

Json timeJson(const SunReport& report, const std::optional<Instant>& at) {
    return at ? Json(report.clock.text(*at)) : Json();
}

Json toJson(const SunReport& report) {
    Json json;
    json["at"] = report.clock.text(report.at);
    json["azimuth_deg"] = report.position.azimuth.value;
    json["altitude_true_deg"] = report.position.altitude.value;
    json["altitude_apparent_deg"] = report.position.altitudeApparent.value;
    json["day_kind"] = nameOf(report.events.kind);
    json["sunrise"] = timeJson(report, report.events.sunrise);
    json["transit"] = report.clock.text(report.events.transit);
    json["sunset"] = timeJson(report, report.events.sunset);
    return json;
}

void print(const SunReport& report, std::ostream& out) {
    const auto degrees = [](Degrees angle) { return fmt::format("{:.4f} deg", angle.value); };
    const auto time = [&](const std::optional<Instant>& at) {
        return at ? report.clock.text(*at) : std::string("none: ") + std::string(nameOf(report.events.kind));
    };
    Table table;
    table.add("time", report.clock.text(report.at));
    table.add("azimuth", degrees(report.position.azimuth) + " from true north, clockwise");
    table.add("altitude, true", degrees(report.position.altitude));
    table.add("altitude, apparent", degrees(report.position.altitudeApparent) + " with refraction");
    table.add("sunrise", time(report.events.sunrise));
    table.add("transit", report.clock.text(report.events.transit));
    table.add("sunset", time(report.events.sunset));
    table.print(out);
}

int runSun(const SunOptions& options, const Console& console) {
    const auto report = sunReport(options);
    if (!report) return fail(console, report.error(), exitUsage);
    if (options.json)
        console.out << toJson(*report).dump(2) << '\n';
    else
        print(*report, console.out);
    return exitOk;
}

void addAirOptions(CLI::App& command, Observer& observer) {
    command.add_option("--elevation", observer.elevationM, "Height of the observer above the ellipsoid, m")
        ->capture_default_str()
        ->check(within(-500.0, 9000.0))
        ->type_name("M");
    command.add_option("--pressure", observer.pressureHPa, "Air pressure for refraction, hPa")
        ->capture_default_str()
        ->check(within(0.0, 1200.0))
        ->type_name("HPA");
    command.add_option("--temperature", observer.temperatureC, "Air temperature for refraction, deg C")
        ->capture_default_str()
        ->check(within(-90.0, 60.0))
        ->type_name("C");
}

}  // namespace

void addSunCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<SunOptions>();
    CLI::App* command =
        app.add_subcommand("sun", "Show the position of the sun and the times of sunrise and sunset");
    command->add_option("--lat", options->observer.place.latDeg, "Latitude, degrees, north positive")
        ->required()
        ->check(within(-90.0, 90.0))
        ->type_name("DEG");
    command->add_option("--lon", options->observer.place.lonDeg, "Longitude, degrees, east positive")
        ->required()
        ->check(within(-180.0, 180.0))
        ->type_name("DEG");
    command
        ->add_option("--at", options->at,
                     "Time, for example 2003-10-17T12:30:30-07:00; without an offset, in --zone")
        ->required()
        ->type_name("TIME");
    command->add_option("--zone", options->zone, "Time zone of the output (default: the offset of --at)")
        ->type_name("ZONE");
    addAirOptions(*command, options->observer);
    command
        ->add_option("--above-horizon", options->aboveHorizonM,
                     "Height of the observer above the surface in which the horizon lies (the sea, a plain), "
                     "m: the dip "
                     "of that horizon makes sunrise earlier")
        ->capture_default_str()
        ->check(within(0.0, 9000.0))
        ->type_name("M");
    command->add_flag("--centre", options->centre,
                      "Define sunrise by the sun's centre at 0 deg, not by its upper limb on the horizon "
                      "(-0.833 deg in the default air)");
    addJsonFlag(*command, options->json);
    command->footer(
        "noonmark-cli sun --lat 40.75 --lon -73.98 --at 2026-03-21T09:00:00 --zone America/New_York");
    command->callback(
        [options, &run] { run = [options](const Console& console) { return runSun(*options, console); }; });
}

}  // namespace noonmark::cli
