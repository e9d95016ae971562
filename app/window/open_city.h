#pragma once

#include "app/input/load_city.h"
#include "render/city_arrays.h"
#include "render/scene_picker.h"

namespace noonmark {

/// A city ready to be shown: read, meshed and searchable by rays.
struct OpenCity {
    LoadedCity loaded;
    CityArrays arrays;
    ScenePicker picker;
    [[nodiscard]] const City& city() const { return loaded.read.city; }
};

/// Meshes a city and builds what rays search it with: for a job.
Result<OpenCity> shownCity(LoadedCity loaded, Progress& progress, const std::stop_token& stop);

/// Settings to begin with: first region, the time zone nearest to the city, cells of 2 m, the engine picked
/// by itself.
StudySettings firstSettings(const LoadedCity& loaded);

/// A study over a city that was read from files, with the files' hashes and warnings.
Result<Study> studyOf(const LoadedCity& loaded, const StudySettings& settings, Progress& progress,
                      std::stop_token stop);

}  // namespace noonmark
