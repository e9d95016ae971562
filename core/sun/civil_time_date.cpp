#include <date/tz.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/sun/civil_time.h"
#include "core/sun/zone_country.h"

namespace noonmark {

namespace {

using namespace std::chrono_literals;
using std::chrono::days;
using std::chrono::minutes;
using std::chrono::seconds;
using std::chrono::sys_seconds;

const char* const zoneFolder = "/usr/share/zoneinfo";  // where the system's date library reads from

/// The last line of the zone's file: the rule that applies after its last listed change.
std::optional<PosixRule> ruleOf(const std::string& zone) {
    std::ifstream file(std::filesystem::path(zoneFolder) / zone, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (!bytes.ends_with('\n')) return std::nullopt;
    bytes.pop_back();
    return PosixRule::parsed(std::string_view(bytes).substr(bytes.rfind('\n') + 1));
}

/// False for names in the folder that are not zones: the machine's own setting, and one that means that
/// nothing is set.
bool isZone(const std::string& name) {
    return name != "localtime" && name != "posixrules" && name != "Factory";
}

tl::unexpected<Error> unknownZone(std::string_view name) {
    const auto close = findCloseNames(name, zoneNames());
    return failure(fmt::format("\"{}\" is not a time zone", name), "zone",
                   close.empty() ? "Give a name such as America/New_York or UTC"
                                 : fmt::format("Did you mean {}?", fmt::join(close, ", ")));
}

}  // namespace

struct Zone::Rules {
    const date::time_zone* listed;
    std::optional<PosixRule> afterwards;

    [[nodiscard]] seconds offsetAt(sys_seconds at) const {
        const date::sys_info info = listed->get_info(at);
        const bool afterLastChange = info.end >= date::sys_days{date::year::max() / date::January / 1};
        return afterLastChange && afterwards ? afterwards->offsetAt(at) : info.offset;
    }
};

Zone Zone::utc() { return {}; }

Result<Zone> Zone::named(std::string_view ianaName) {
    if (ianaName == "UTC") return utc();
    try {
        Zone zone;
        zone.name_ = std::string(ianaName);
        const auto& zones = date::get_tzdb().zones;
        const auto found =
            std::ranges::find(zones, zone.name_, [](const auto& entry) { return entry.name(); });
        if (found == zones.end() || !isZone(zone.name_)) return unknownZone(ianaName);
        zone.rules_ = std::make_shared<const Rules>(Rules{&*found, ruleOf(zone.name_)});
        // Reads the file now, while an error can still be reported
        static_cast<void>(zone.rules_->offsetAt({}));
        return zone;
    } catch (const std::exception& error) {
        return failure(fmt::format("The time zone database cannot be read ({})", error.what()), zoneFolder,
                       "Install the package tzdata");
    }
}

seconds Zone::offsetAt(sys_seconds at) const { return rules_ ? rules_->offsetAt(at) : 0s; }

Instant Zone::instantOf(std::chrono::local_seconds wallClock) const {
    // Offsets well before and after: in no zone are two changes this close, or a change this large.
    const sys_seconds asUtc{wallClock.time_since_epoch()};
    const seconds before = offsetAt(asUtc - 36h);
    const seconds after = offsetAt(asUtc + 36h);
    if (offsetAt(asUtc - before) == before) return asUtc - before;
    if (offsetAt(asUtc - after) == after) return asUtc - after;
    sys_seconds early = asUtc - after;  // the clocks jump over this time: find when
    sys_seconds late = asUtc - before;
    while (late - early > 1s) {
        const sys_seconds middle = early + (late - early) / 2;
        (offsetAt(middle) == before ? early : late) = middle;
    }
    return late;
}

std::vector<std::string> zoneNames() {
    std::vector<std::string> names{"UTC"};
    try {
        for (const auto& zone : date::get_tzdb().zones) {
            if (isZone(zone.name()) && zone.name() != "UTC") names.push_back(zone.name());
        }
    } catch (const std::exception&) {
        return names;  // without the database only UTC is known; `Zone::named` says what is missing
    }
    std::ranges::sort(names);
    return names;
}

}  // namespace noonmark
