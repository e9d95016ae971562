#pragma once

#include "core/study/by_place/sun_by_place.h"
#include "core/study/tiles/places_of_tiles.h"
#include "core/study/tiles/tile_measure.h"

namespace noonmark {

/// Sun by place as what the tiles of a study give.
struct ByPlaceRequest : PlacesRequest {
    SunByPlaceSettings settings;      ///< its study is that of the tiles
    std::vector<std::string> cities;  ///< their names, the baseline first

    /// Identifies the request.
    [[nodiscard]] std::string key() const;
};

/// The sun of the places of each tile, as by compareSunByPlace() for these places under the sun of the whole
/// study: the lines of by_place_lines.h. Holds references, which must outlive it.
class ByPlaceMeasure : public TileMeasure {
public:
    /// `cities`: as many as the request names. `places` are in their frame.
    ByPlaceMeasure(std::vector<const City*> cities, const PlacesOfTiles& places,
                   const ByPlaceRequest& request, const TileQuestion& question, const EngineList& engines);

    [[nodiscard]] std::vector<TileMap> maps() const override { return {}; }
    Result<TileAnswer> measure(const Grid& tile, Progress& progress, const std::stop_token& stop) override;

private:
    std::vector<const City*> cities_;
    const PlacesOfTiles& places_;
    const ByPlaceRequest& request_;
    TileQuestion question_;
    const EngineList& engines_;
};

}  // namespace noonmark
