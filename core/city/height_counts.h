#pragma once

#include <array>
#include <cstddef>

#include "core/city/city.h"

namespace noonmark {

/// Where the heights of a city's parts come from.
struct HeightCounts {
    std::size_t parts = 0;
    std::array<std::size_t, heightSources.size()> bySource{};  ///< parts, by HeightSource
    double assumedM = 0;        ///< the height that most assumed parts have; 0: there are none
    bool assumedAlike = false;  ///< all of them have it, to the centimetre

    [[nodiscard]] std::size_t of(HeightSource source) const { return bySource[std::size_t(source)]; }
    /// Of the parts' heights, 0 to 1.
    [[nodiscard]] double assumedShare() const {
        return parts == 0 ? 0 : double(of(HeightSource::assumed)) / double(parts);
    }
};
HeightCounts countHeights(const City& city);

/// Above this share of assumed heights a result rests on a guess: that is a headline, not a note.
inline constexpr double mostAssumedShare = 0.1;

}  // namespace noonmark
