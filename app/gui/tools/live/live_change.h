#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/receivers/place.h"
#include "scenarios/impact/impact.h"
#include "scenarios/impact/impact_figures.h"

namespace noonmark {

/// The cells of a place on the grid of a live shadow.
struct GridPlace {
    std::string name;
    std::vector<std::uint32_t> cells;  ///< ascending, at least one
    bool whole = true;                 ///< false: the place reaches beyond the grid
};

/// The places with cells on the grid, in their order. O(places + their cells).
std::vector<GridPlace> findPlaceCells(const std::vector<Place>& places, const Grid& grid);

/// How a shape changes the shadow on a place.
struct PlaceChange {
    std::string name;
    bool whole = true;  ///< false: measured only as far as the grid reaches
    ImpactFigures figures;
};

/// What a shape changes: gross and continuous shadow of the ground that is open with and without it.
struct LiveChange {
    Impact impact;
    std::array<ImpactFigures, defaultThresholdsMin.size()> figures;  ///< by threshold
    /// Shadow changes beside the edge of what is measured: probably beyond it, too.
    bool reachesBeyond = false;
    /// The cell with the most new gross shadow; none: there is no new shadow.
    std::optional<std::uint32_t> worst;
    /// The places with new gross shadow, those with most area over the first threshold first, then by their
    /// most minutes.
    std::vector<PlaceChange> places;
};

/// Fields on the same grid, each with its receivers. Receivers on roofs are left out. O(cells).
LiveChange computeLiveChange(const Receivers& before, const ShadowField& fieldBefore, const Receivers& after,
                             const ShadowField& fieldAfter, const std::vector<GridPlace>& places);

}  // namespace noonmark
