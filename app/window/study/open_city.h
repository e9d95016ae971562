#pragma once

#include "app/input/load_city.h"
#include "app/window/frame/zone_guess.h"
#include "render/scene/city_arrays.h"
#include "render/view/scene_picker.h"

namespace noonmark {

/// A city ready to be shown: read, meshed and searchable by rays.
struct OpenCity {
    LoadedCity loaded;
    /// For the view. Of this city, or of another that shares most of its buildings with it (differenceOf).
    std::shared_ptr<const CityArrays> arrays;
    ScenePicker picker;
    [[nodiscard]] const City& city() const { return loaded.read.city; }
};

/// Meshes a city and builds what rays search it with: for a job. `drawn`: arrays of a city that shares most
/// of its buildings, as one that was edited does: then they are not made again. Null: none.
Result<OpenCity> shownCity(LoadedCity loaded, std::shared_ptr<const CityArrays> drawn, Progress& progress,
                           const std::stop_token& stop);

/// Settings to begin with: first region, the time zone that was guessed, cells of 2 m, the engine picked by
/// itself.
StudySettings firstSettings(const LoadedCity& loaded, const ZoneGuess& zone);

/// A study over a city that was read from files, with the files' hashes and warnings.
Result<Study> studyOf(const LoadedCity& loaded, const StudySettings& settings, Progress& progress,
                      std::stop_token stop);

}  // namespace noonmark
