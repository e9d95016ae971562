#pragma once

#include <chrono>

#include "core/receivers/place.h"

namespace noonmark {

/// What is assumed about places of a kind where nothing else is stated. A rule or a project may say
/// otherwise.
struct PlaceDefaults {
    bool grows = false;  ///< has plants that need sun in the growing season
    /// Growing season of the northern mid-latitudes, both days included: April to October, as New York's
    /// environmental review takes it. growingSeason() turns it round in the south.
    std::chrono::month_day growsFrom{std::chrono::April, std::chrono::day{1}};
    std::chrono::month_day growsTo{std::chrono::October, std::chrono::day{31}};
    /// Hours of use on the wall clock, minutes after midnight. With the sun down they do not count.
    std::chrono::minutes usedFrom{0};
    std::chrono::minutes usedTo{24 * 60};
    bool operator==(const PlaceDefaults&) const = default;
};

PlaceDefaults defaultsOf(PlaceKind kind);

/// First and last day of a season, both included; it may run across the new year.
struct Season {
    std::chrono::month_day first, last;
    [[nodiscard]] bool holds(std::chrono::month_day day) const;
    bool operator==(const Season&) const = default;
};

/// The growing season of a kind at a latitude: south of the equator half a year later. All year within the
/// tropics.
Season growingSeason(PlaceKind kind, double latDeg);

}  // namespace noonmark
