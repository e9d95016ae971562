#include "core/sun/zone_country.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numeric>
#include <utility>

#include "core/geo/lon_lat.h"

namespace noonmark {

namespace {

std::vector<std::string> splitTabs(const std::string& line) {
    std::vector<std::string> fields(1);
    for (const char letter : line)
        if (letter == '\t')
            fields.emplace_back();
        else
            fields.back() += letter;
    return fields;
}

/// The field `wanted` of the first line of a table of the tz database whose field `key` is `value`.
std::string findInTable(const char* table, std::size_t key, std::string_view value, std::size_t wanted) {
    std::ifstream file(std::string("/usr/share/zoneinfo/") + table);
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) continue;
        const std::vector<std::string> fields = splitTabs(line);
        if (fields.size() > std::max(key, wanted) && fields[key] == value) return fields[wanted];
    }
    return {};
}

}  // namespace

std::string countryOfZone(std::string_view zone) { return findInTable("zone.tab", 2, zone, 0); }

namespace {

// "+4042-07400" or with seconds: degrees, minutes, seconds, of which longitudes have three digits of degrees.
std::optional<double> degreesOfDigits(std::string_view text, std::size_t digits) {
    if (text.size() < digits + 3) return std::nullopt;
    const auto numberAt = [&](std::size_t at, std::size_t count) {
        int number = 0;
        if (at + count <= text.size()) std::from_chars(text.data() + at, text.data() + at + count, number);
        return number;
    };
    const double degrees =
        numberAt(1, digits) + numberAt(1 + digits, 2) / 60.0 + numberAt(3 + digits, 2) / 3600.0;
    return text.front() == '-' ? -degrees : degrees;
}

std::optional<LonLat> placeOfZone(std::string_view text) {
    const auto split = text.find_first_of("+-", 1);
    if (split == text.npos) return std::nullopt;
    const auto latitude = degreesOfDigits(text.substr(0, split), 2);
    const auto longitude = degreesOfDigits(text.substr(split), 3);
    return latitude && longitude ? std::optional(LonLat{*longitude, *latitude}) : std::nullopt;
}

// "America/Argentina/Buenos_Aires" -> "Buenos Aires"
std::string townOfZone(std::string_view zone) {
    std::string town(zone.substr(zone.rfind('/') + 1));
    std::ranges::replace(town, '_', ' ');
    return town;
}

}  // namespace

std::optional<ZoneTown> findNearestZoneTown(LonLat place) {
    std::optional<ZoneTown> nearest;
    std::ifstream file("/usr/share/zoneinfo/zone.tab");
    for (std::string line; std::getline(file, line);) {
        const std::vector<std::string> fields = splitTabs(line);
        const auto there =
            fields.size() > 2 && !line.starts_with('#') ? placeOfZone(fields[1]) : std::nullopt;
        if (!there) continue;
        const double distanceM = computeGreatCircleM(*there, place);
        if (!nearest || distanceM < nearest->distanceM)
            nearest = ZoneTown{townOfZone(fields[2]), fields[0], distanceM};
    }
    return nearest;
}

std::optional<ZoneTown> findNearestTown(LonLat place) {
    std::optional<ZoneTown> nearest;
    for (const Town& town : listTowns()) {
        const double distanceM = computeGreatCircleM(town.place, place);
        if (!nearest || distanceM < nearest->distanceM)
            nearest = ZoneTown{town.name, town.country, distanceM};
    }
    return nearest ? nearest : findNearestZoneTown(place);
}

std::string countryName(std::string_view code) {
    std::string name = findInTable("iso3166.tab", 0, code, 1);
    return name.empty() ? std::string(code) : name;
}

std::optional<Warning> questionZone(const Period& period, LonLat place) {
    constexpr double maxHours = 4, degreesPerHour = 15;
    const auto zone = Zone::named(period.zone);
    if (!zone || period.zone.find('/') == std::string::npos || period.zone.starts_with("Etc/"))
        return std::nullopt;
    const auto noon = std::chrono::sys_days(period.start) + std::chrono::hours(12);
    const double clockH = double(zone->offsetAt(noon).count()) / 3600;
    const double apartH = std::abs(std::remainder(clockH - place.lonDeg / degreesPerHour, 24.0));
    if (apartH <= maxHours) return std::nullopt;
    return Warning{
        WarningKind::assumed,
        fmt::format("the clocks of the zone are {:.1f} h from the sun's time here: is it the right zone?",
                    apartH),
        period.zone};
}

namespace {

/// Lower case, with blanks as in the tz database.
std::string plain(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
        if (c == ' ') c = '_';
    }
    return result;
}

/// Levenshtein distance: letters to insert, delete or change.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, changed}));
        }
    }
    return row.back();
}

std::string_view lastPart(std::string_view name) { return name.substr(name.rfind('/') + 1); }

/// The distance between the two, if it is small for their length.
std::optional<std::size_t> nearness(std::string_view wanted, std::string_view candidate) {
    const std::size_t away = distance(wanted, candidate);
    if (away > std::max<std::size_t>(1, wanted.size() / 4)) return std::nullopt;
    return away;
}

}  // namespace

std::vector<std::string> findCloseNames(std::string_view text, const std::vector<std::string>& names,
                                        std::size_t maximum) {
    constexpr std::size_t longestName = 64;
    const std::string wanted = plain(text.substr(0, longestName));
    std::vector<std::pair<std::size_t, std::string>> ranked;
    for (const std::string& name : names) {
        const std::string candidate = plain(name);
        const auto whole = nearness(wanted, candidate);
        const auto part = nearness(lastPart(wanted), lastPart(candidate));
        if (whole || part)
            ranked.emplace_back(std::min(whole.value_or(longestName), part.value_or(longestName)), name);
    }
    std::ranges::stable_sort(ranked, {}, [](const auto& entry) { return entry.first; });
    std::vector<std::string> best;
    for (const auto& [away, name] : ranked) {
        if (best.size() < maximum) best.push_back(name);
    }
    return best;
}

}  // namespace noonmark
