#include "app/window/open_city.h"

#include "app/input/all_engines.h"
#include "app/window/zone_guess.h"

namespace noonmark {

Result<OpenCity> shownCity(LoadedCity loaded, Progress& progress, const std::stop_token& stop) {
    progress.report(0.9, "building the view");
    OpenCity open{std::move(loaded), {}, {}};
    open.arrays = arraysOf(open.city());
    if (stop.stop_requested()) return cancelled();
    auto scene = RayScene::over(open.city(), stop);
    if (!scene) return tl::make_unexpected(scene.error());
    open.picker = ScenePicker(open.city(), *std::move(scene));
    return open;
}

StudySettings firstSettings(const LoadedCity& loaded) {
    StudySettings settings;
    settings.region = firstRegion(loaded);
    settings.receivers.cellM = 2;
    settings.period.zone = zoneNear(loaded.read.city.frame.origin()).toStdString();
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
