#include "app/gui/session/study/open_city.h"

#include "app/input/all_engines.h"

namespace noonmark {

namespace {

// If more buildings than this differ from the arrays, new arrays are made: drawing them separately would cost
// at each change.
constexpr std::size_t maxAdded = 1000;

bool serves(const std::shared_ptr<const CityArrays>& drawn, const City& city) {
    return drawn && computeDifference(*drawn, city).added.buildings.size() <= maxAdded;
}

}  // namespace

Result<OpenCity> shownCity(LoadedCity loaded, std::shared_ptr<const CityArrays> drawn, Progress& progress,
                           const std::stop_token& stop) {
    progress.report(0.9, "building the view");
    OpenCity open{std::move(loaded), std::move(drawn), {}};
    if (!serves(open.arrays, open.city()))
        open.arrays = std::make_shared<const CityArrays>(makeArrays(open.city()));
    if (stop.stop_requested()) return cancelled();
    auto scene = RayScene::over(open.city(), stop);
    if (!scene) return tl::make_unexpected(scene.error());
    open.picker = ScenePicker(open.city(), *std::move(scene));
    return open;
}

StudySettings firstSettings(const LoadedCity& loaded, const ZoneGuess& zone) {
    StudySettings settings;
    settings.region = firstRegion(loaded);
    settings.receivers.cellM = 2;
    settings.period.zone = zone.zone.toStdString();
    return settings;
}

Result<Study> studyOf(const LoadedCity& loaded, const StudySettings& settings, Progress& progress,
                      std::stop_token stop) {
    auto study =
        runStudy(loaded.read.city, settings, progress, std::move(stop), enginesWith(settings.engine));
    if (study) addReading(*study, loaded);
    return study;
}

}  // namespace noonmark
