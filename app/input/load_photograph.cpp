#include "app/input/load_photograph.h"

#include "core/base/stop_scope.h"
#include "core/io/pictures/read_ground_raster.h"

namespace noonmark {

Box2 photographBox(const City& city) {
    constexpr float aroundM = 500;
    Box2 box = bounds(city);
    box.low -= aroundM;
    box.high += aroundM;
    return box;
}

Result<Photograph> loadPhotograph(const GroundPictureFile& wanted, const City& city, Progress& progress,
                                  const std::stop_token& stop) {
    const StopScope scope(stop);
    const auto described = describeInputFile(wanted.path);
    if (!described) return tl::make_unexpected(described.error());
    auto raster = readGroundRaster(wanted.path, city.frame, photographBox(city), {}, progress, stop);
    if (!raster) return tl::make_unexpected(raster.error());
    Photograph photograph{wanted, std::make_shared<const GroundRaster>(*std::move(raster))};
    photograph.file.sha256 = described->sha256;
    return photograph;
}

Project withPhotographAtHand(Project project, Warnings& warnings, Progress& progress,
                             const std::stop_token& stop) {
    if (!project.groundPicture || !project.groundPicture->shown) return project;
    const GroundPictureFile file = *project.groundPicture;
    const auto leftOut = [&](const std::string& what) {
        warnings.push_back({WarningKind::leftOut, what, file.path.string()});
    };
    auto loaded = loadPhotograph(file, *project.city, progress, stop);
    if (!loaded) {
        leftOut("the aerial photograph is not drawn: " + loaded.error().what);
        return project;
    }
    if (loaded->file.sha256 != file.sha256) {
        leftOut("the aerial photograph is not drawn: its file has changed; choose it again");
        return project;
    }
    return withGroundPicture(std::move(project), file, std::move(loaded->raster));
}

}  // namespace noonmark
