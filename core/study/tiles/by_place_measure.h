#pragma once

#include <string>
#include <vector>

#include "core/study/by_place/sun_by_place.h"
#include "core/study/tiles/tile_runner.h"
#include "core/study/tiles/timeline_measure.h"

namespace noonmark {

/// What a tile knows of one city besides its places.
struct SunOfTile {
    std::string engine;
    std::string treesHow;  ///< empty: no tree reaches a place
    std::optional<SampledError> error;
    std::vector<std::optional<SampledError>> dateErrors;
    std::vector<ShownError> errors;
    Warnings warnings;
};

/// The first line of a tile's file.
struct TileLine {
    std::vector<SunOfTile> cities;  ///< the baseline first
    double seconds = 0;
};

/// Each of the others.
struct PlaceLine {
    std::string name;
    std::vector<SunOfPlace> sun;     ///< in each city, without its cells
    std::vector<SunChange> changes;  ///< of each city but the baseline
    /// With trees of one column, likewise.
    struct WithTrees {
        TreeColumns column;
        std::vector<SunOfPlace> sun;
        std::vector<SunChange> changes;
    };
    std::vector<WithTrees> withTrees;  ///< none: no tree reaches a place of the tile
};

/// A line of JSON for the tile, and one for each place. Numbers are read back to the last bit.
std::string formatLines(const SunOfCities& sun);

/// Throws exceptions of nlohmann for a line of another structure.
TileLine parseTileLine(const std::string& line);
PlaceLine parsePlaceLine(const std::string& line);

/// Sun by place as what the tiles of a study give.
struct ByPlaceRequest : PlacesRequest {
    SunByPlaceSettings settings;      ///< its study is that of the tiles
    std::vector<std::string> cities;  ///< their names, the baseline first

    /// Identifies the request.
    [[nodiscard]] std::string key() const;
};

/// The sun of the places of each tile, as by compareSunByPlace() for these places under the sun of the whole
/// study: a TileLine, and a PlaceLine for each place. Holds references, which must outlive it.
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
