#include "scenarios/project/ground_picture.h"

#include <nlohmann/json.hpp>

#include "core/city/map_context.h"
#include "scenarios/project/project.h"

namespace noonmark {

std::string formatText(const GroundPictureFile& picture) {
    return nlohmann::ordered_json{{"path", picture.path.string()},
                                  {"sha256", picture.sha256},
                                  {"attribution", picture.attribution},
                                  {"opacity", picture.opacity},
                                  {"shown", picture.shown}}
        .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::optional<GroundPictureFile> parseGroundPicture(const std::string& text) try {
    const auto json = nlohmann::json::parse(text);
    GroundPictureFile picture{json.at("path").get<std::string>(), json.at("sha256"), json.at("attribution"),
                              json.at("opacity"), json.at("shown")};
    const bool sound = !picture.path.empty() && picture.opacity >= 0 && picture.opacity <= 1;
    return sound ? std::optional(picture) : std::nullopt;
} catch (const nlohmann::json::exception&) {
    return std::nullopt;
}

Project withGroundPicture(Project project, std::optional<GroundPictureFile> file,
                          std::shared_ptr<const GroundRaster> raster) {
    auto context =
        std::make_shared<MapContext>(project.city->context ? *project.city->context : MapContext{});
    const bool drawn = file && file->shown && raster;
    context->picture =
        drawn ? std::optional(ContextPicture{std::move(raster), file->opacity, file->attribution})
              : std::nullopt;
    City city = *project.city;
    city.context = context->empty() ? nullptr : std::move(context);
    project.city = std::make_shared<const City>(std::move(city));
    project.groundPicture = std::move(file);
    return project;
}

}  // namespace noonmark
