#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/places/read_places.h"
#include "core/receivers/tile_plan.h"
#include "core/study/place_study.h"
#include "core/study/tiles/tile_runner.h"

namespace noonmark {

/// Places that the tiles of a study measure.
struct PlacesRequest {
    std::filesystem::path places;  ///< a file of places, read for each district in its own frame
    PlaceSettings reading{};
    std::string placesHash{};  ///< SHA-256 of the file
    std::vector<Place> own{};  ///< of a project, in its frame; the file is then the project, and not read

    /// Identifies which places they are.
    [[nodiscard]] std::string key() const;
};

/// The places of a request in the frame of a district. Errors of readPlaces().
Result<std::vector<Place>> readPlaces(const PlacesRequest& request, const Frame& frame, Progress& progress,
                                      const std::stop_token& stop);

/// Places by the tile that measures them.
class PlacesOfTiles {
public:
    /// A place belongs to the tile that the middle of its bounding box lies in, and is measured there, whole.
    /// Places whose middle lies in no tile are left out.
    PlacesOfTiles(std::vector<Place> places, const TilePlan& plan);

    [[nodiscard]] const std::vector<Place>& of(std::size_t tile) const { return byTile_.at(tile); }
    /// The same by the cells of the tile.
    [[nodiscard]] const std::vector<Place>& in(const Grid& tile) const;
    /// Around the places of a tile; empty without any.
    [[nodiscard]] Box2 boxOf(std::size_t tile) const;

private:
    TilePlan plan_;
    std::vector<std::vector<Place>> byTile_;
};

/// Timelines of places as what the tiles of a study give.
struct TimelineRequest : PlacesRequest {
    bool allSteps = false;  ///< also state the steps of each day, where there are several
    TimelineLabels labels;  ///< `to` is empty where there is one city

    /// Identifies the request.
    [[nodiscard]] std::string key() const;
};

/// The timelines of the places of each tile, as by runPlaceStudy() for these places: a line of JSON for each
/// place, as timelineJson(). Longest stays are included. Holds references, which must outlive it.
class TimelineMeasure : public TileMeasure {
public:
    /// `scenario`: null for the baseline alone. `places` are in the frame of the cities.
    TimelineMeasure(const City& baseline, const City* scenario, const PlacesOfTiles& places,
                    const TimelineRequest& request, const TileQuestion& question);

    [[nodiscard]] std::vector<TileMap> maps() const override { return {}; }
    Result<TileAnswer> measure(const Grid& tile, Progress& progress, const std::stop_token& stop) override;

private:
    const City& baseline_;
    const City* scenario_;
    const PlacesOfTiles& places_;
    const TimelineRequest& request_;
    TileQuestion question_;
};

}  // namespace noonmark
