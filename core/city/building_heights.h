#pragma once

#include <array>
#include <cstddef>

#include "core/city/city.h"

namespace noonmark {

/// Limits for the height of a building and the elevation of its ground, read or designed. The tallest
/// building has 828 m; towers of 1,000 m are being built, some of 1,700 m have been proposed. Land lies
/// between -430 m (the Dead Sea) and 8,849 m.
inline constexpr double tallestBuildingM = 2000;
inline constexpr double minLandM = -500, maxLandM = 9000;  ///< above the ellipsoid or sea level

/// Height of a storey where a building states none, metres: of new towers, on facades, and where floors are
/// counted. Between homes (some 3 m) and offices (some 4 m). Heights that data state in storeys are read with
/// ReadSettings::metresPerLevel, which is the mean of existing buildings, most of them homes.
inline constexpr double defaultStoreyM = 3.5;

/// Counts of the sources of the heights of a city's parts.
struct HeightCounts {
    std::size_t parts = 0;
    std::array<std::size_t, heightSources.size()> bySource{};  ///< parts, by HeightSource
    double assumedM = 0;        ///< the most common height among the assumed parts; 0: there are none
    bool assumedAlike = false;  ///< all assumed parts have that height, to the centimetre

    [[nodiscard]] std::size_t of(HeightSource source) const { return bySource[std::size_t(source)]; }
    /// Share of parts with an assumed height, 0 to 1.
    [[nodiscard]] double assumedShare() const {
        return parts == 0 ? 0 : double(of(HeightSource::assumed)) / double(parts);
    }
};
HeightCounts countHeights(const City& city);

/// Above this share of assumed heights a result depends on guesses; it is then reported as a headline, not as
/// a note.
inline constexpr double maxAssumedShare = 0.1;

/// Whether the user designed any part of a building: a massing, a placed mesh, a changed height.
bool isProposal(const Building& building);

}  // namespace noonmark
