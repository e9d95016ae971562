#include "core/receivers/place.h"

#include <algorithm>
#include <cmath>

#include "core/describe/text.h"

namespace noonmark {

namespace {

constexpr std::array<std::string_view, placeKinds.size()> kindNames{
    "park",     "playground", "schoolyard", "plaza",         NM_TEXT("greenstreet"),
    "cemetery", "street",     "facade",     "stained glass", "other"};

}  // namespace

std::string_view nameOf(PlaceKind kind) { return kindNames[std::size_t(kind)]; }

std::optional<PlaceKind> parsePlaceKind(std::string_view name) {
    const auto found = std::ranges::find(kindNames, name);
    if (found == kindNames.end()) return std::nullopt;
    return placeKinds[std::size_t(found - kindNames.begin())];
}

namespace {

using std::chrono::hours;
using std::chrono::month_day;

constexpr double tropicDeg = 23.44;

// grows, then the hours of use
PlaceDefaults defaults(bool grows, int fromHour, int toHour) {
    PlaceDefaults made;
    made.grows = grows;
    made.usedFrom = hours(fromHour);
    made.usedTo = hours(toHour);
    return made;
}

month_day halfAYearLater(month_day day) {
    const unsigned month = (unsigned(day.month()) + 5) % 12 + 1;
    const auto last = std::chrono::month_day_last(std::chrono::month(month));
    const unsigned maximum = unsigned((std::chrono::year(2026) / last).day());
    return {last.month(), std::chrono::day(std::min(unsigned(day.day()), maximum))};
}

}  // namespace

PlaceDefaults defaultsOf(PlaceKind kind) {
    switch (kind) {
        case PlaceKind::park:
            return defaults(true, 6, 22);
        case PlaceKind::playground:
            return defaults(false, 8, 20);
        case PlaceKind::schoolyard:
            return defaults(false, 8, 18);
        case PlaceKind::greenstreet:
        case PlaceKind::cemetery:
            return defaults(true, 0, 24);
        case PlaceKind::plaza:
        case PlaceKind::street:
        case PlaceKind::facade:
        case PlaceKind::stainedGlass:
        case PlaceKind::other:
            break;
    }
    return defaults(false, 0, 24);
}

bool Season::holds(month_day day) const {
    return first <= last ? first <= day && day <= last : first <= day || day <= last;
}

Season growingSeason(PlaceKind kind, double latDeg) {
    const PlaceDefaults standard = defaultsOf(kind);
    if (std::abs(latDeg) < tropicDeg)
        return {{std::chrono::January, std::chrono::day{1}}, {std::chrono::December, std::chrono::day{31}}};
    if (latDeg > 0) return {standard.growsFrom, standard.growsTo};
    return {halfAYearLater(standard.growsFrom), halfAYearLater(standard.growsTo)};
}

}  // namespace noonmark
