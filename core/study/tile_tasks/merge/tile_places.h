#pragma once

#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/measures/statistics.h"
#include "core/receivers/place.h"
#include "core/study/tiles/assemble_map.h"

namespace noonmark {

/// Shadow on a place, from tiles; over districts its sums are added.
struct TiledPlace {
    PlaceKind kind = PlaceKind::other;
    ShadowSums sums;
    double sunlitMinutes = 0;  ///< sum over the receivers of the sunlit minutes of a mean day
    double cellAreaM2 = 1;
};
using PlaceShadows = std::map<std::string, TiledPlace>;  ///< by name

/// The tiles of a map with gross and continuous shadow, or their change.
struct PlaceTiles {
    const TilePlan& plan;
    const TileFiles& files;
    std::size_t firstBand = 0;  ///< of gross shadow; the next is continuous shadow
    double sunlitMinutesPerDay = 0;
};

/// Adds the receivers of the tiles whose centres lie in a place. Reads every tile once that a place touches.
/// Places of which no cell is a receiver are listed with none. Error: a tile that cannot be read;
/// cancelled().
Result<void> addPlaces(PlaceShadows& shadows, const std::vector<Place>& places, const PlaceTiles& tiles,
                       Progress& progress, const std::stop_token& stop);

/// A table (CSV): name, kind, receivers, receiver_area_m2, shadow_area_m2, mean_gross_min, max_gross_min,
/// mean_continuous_min, max_continuous_min. Empty fields where nothing was measured.
std::string formatPlaces(const PlaceShadows& shadows);

}  // namespace noonmark
