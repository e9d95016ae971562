#pragma once

#include "app/gui/session/study/zone_guess.h"
#include "app/input/load_city.h"
#include "render/scene/city_arrays.h"
#include "render/view/scene_picker.h"

namespace noonmark {

/// A city ready for display: read, meshed and prepared for picking.
struct OpenCity {
    LoadedCity loaded;
    /// Arrays for the view: of this city, or of another that shares most of its buildings (differenceOf).
    std::shared_ptr<const CityArrays> arrays;
    ScenePicker picker;
    [[nodiscard]] const City& city() const { return loaded.read.city; }
};

/// Meshes a city and builds its picker; use it in a job. `drawn`: arrays of a city that shares most of its
/// buildings, such as the one before an edit, which are then reused. Null: none.
Result<OpenCity> shownCity(LoadedCity loaded, std::shared_ptr<const CityArrays> drawn, Progress& progress,
                           const std::stop_token& stop);

/// Initial settings: the first region, the guessed time zone, cells of 2 m, the automatic engine.
StudySettings firstSettings(const LoadedCity& loaded, const ZoneGuess& zone);

/// Runs a study of a city read from files, and adds the files' hashes and warnings.
Result<Study> studyOf(const LoadedCity& loaded, const StudySettings& settings, Progress& progress,
                      std::stop_token stop);

}  // namespace noonmark
