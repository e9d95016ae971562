#pragma once

#include "core/study/text/timeline_text.h"
#include "core/study/tiles/places_of_tiles.h"
#include "core/study/tiles/tile_measure.h"

namespace noonmark {

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
