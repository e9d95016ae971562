#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/study/tiles/by_place_measure.h"
#include "core/study/tiles/timeline_measure.h"

namespace noonmark {

/// What a plan of tiles is about if it is not the shadow of a city that tasks read from its files: scenarios
/// of a project. The caller reads them, whole, for the plan and for every task.
struct TileSubject {
    /// Says what is measured of which cities. A part of the hashes of plan and tiles, which otherwise tell
    /// apart only all buildings together.
    std::string key;
    /// With one frame and one terrain; the shadow of all of them counts. The sun is that of the last one.
    std::vector<std::shared_ptr<const City>> cities;
    Region region;      ///< of the study, in their frame
    double fields = 1;  ///< shadow fields that a tile costs
    /// Null: the shadow of the last city. The measure may hold references to the cities.
    std::function<std::unique_ptr<TileMeasure>(const TileQuestion&)> measure;
};

/// What a plan was made for; its tasks get the same.
struct TaskQuestion {
    ReadSettings reading;
    StudySettings settings;                ///< without region
    const TileSubject* subject = nullptr;  ///< null: the files of the plan
    /// Not null: the timelines of places instead, of the last city of the subject, and compared with its
    /// first city if it has two
    const TimelineRequest* timelines = nullptr;
    /// Not null: sun by place instead, of these cities
    const ByPlaceRequest* byPlace = nullptr;

    /// The places that are measured instead of cells; null: cells are.
    [[nodiscard]] const PlacesRequest* places() const {
        return byPlace != nullptr ? static_cast<const PlacesRequest*>(byPlace) : timelines;
    }
};

/// Identifies settings, subject, timelines and sun by place. The region of the settings is not counted.
std::string hashQuestion(const TaskQuestion& question);

}  // namespace noonmark
