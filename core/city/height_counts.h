#pragma once

#include <array>
#include <cstddef>

#include "core/city/city.h"

namespace noonmark {

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
