#include "app/gui/tools/live/facade_sunlight.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/receivers/wall_faces.h"

namespace noonmark {

namespace {

/// The city with the shape, and the buildings whose facades are measured.
struct FacadeScene {
    City city;
    std::vector<std::uint32_t> measured;
};

template <class Keeps>
FacadeScene makeScene(const FacadeQuestion& question, Keeps keeps) {
    FacadeScene scene{.city = {.frame = question.rest->frame, .terrain = question.rest->terrain}};
    const auto add = [&](const std::shared_ptr<const Building>& building, bool measured) {
        if (measured) scene.measured.push_back(std::uint32_t(scene.city.buildings.size()));
        scene.city.buildings.push_back(building);
    };
    for (const auto& building : question.rest->buildings) {
        const bool chosen = std::ranges::find(question.neighbours, building) != question.neighbours.end();
        if (chosen || keeps(*building)) add(building, chosen);
    }
    for (const auto& building : question.shape) add(building, true);
    return scene;
}

double wallAreaM2(const FacadeScene& scene) {
    double area = 0;
    for (const std::uint32_t index : scene.measured)
        for (const Part& part : scene.city.buildings[index]->parts)
            for (const WallFace& face : findWallFaces(part)) area += face.lengthM * (face.highM - face.lowM);
    return area;
}

FacadeSettings coarsened(FacadeSettings facades, double areaM2, std::size_t points) {
    const double times = std::sqrt(areaM2 / (facades.bayM * facades.storeyM) / double(points));
    if (times <= 1) return facades;
    facades.bayM = std::min(facades.bayM * times, FacadeSettings::maxM);
    facades.storeyM = std::min(facades.storeyM * times, FacadeSettings::maxM);
    facades.aboveFloorM = facades.storeyM / 2;
    return facades;
}

OwnStoreys scaled(OwnStoreys storeys, double times) {
    for (auto& [id, metres] : storeys) metres = std::min(metres * times, FacadeSettings::maxM);
    return storeys;
}

Result<FacadeAnswer> measure(FacadeScene scene, const FacadeSettings& facades, const OwnStoreys& storeys,
                             const SunSteps& sun, Progress& progress, const std::stop_token& stop) {
    ElementStudy study;
    study.city = std::move(scene.city);
    auto receivers = placeOnFacades(study.city, scene.measured, facades, stop, storeys);
    if (!receivers) return tl::make_unexpected(receivers.error());
    study.receivers = *std::move(receivers);
    study.sun = sun;
    auto minutes = sweepPoints(study.city, study.receivers.points, sun, progress, stop,
                               {.runs = true, .decidesRuns = false});
    if (!minutes) return tl::make_unexpected(minutes.error());
    study.minutes = *std::move(minutes);
    return FacadeAnswer{.map = makeElementMap(study),
                        .facades = facades,
                        .buildSeconds = study.minutes.cost.seconds["build"],
                        .sweepSeconds = study.minutes.cost.seconds["sweep"]};
}

/// Whether a building counts while the shape moves.
class NearShape {
public:
    explicit NearShape(const FacadeQuestion& question) {
        for (const auto* list : {&question.shape, &question.neighbours})
            for (const auto& building : *list) add(*building);
    }
    bool operator()(const Building& building) const {
        const Box2 box = bounds(building);
        const glm::vec2 gap = glm::max(glm::max(box.low - box_.high, box_.low - box.high), glm::vec2(0));
        const double distance = double(glm::length(gap));
        static const double tangent = std::tan(Degrees{nearHorizonDeg}.radians().value);
        return distance < nearM || double(topM(building)) - lowM_ > tangent * distance;
    }

private:
    void add(const Building& building) {
        box_.add(bounds(building));
        for (const Part& part : building.parts) lowM_ = std::min(lowM_, double(part.bottomM));
    }
    Box2 box_;
    double lowM_ = 1e30;
};

}  // namespace

Result<FacadeAnswer> measureFacades(const FacadeQuestion& question, Progress& progress,
                                    const std::stop_token& stop) {
    return measure(makeScene(question, [](const Building&) { return true; }), question.facades,
                   question.storeys, *question.sun, progress, stop);
}

Result<FacadeAnswer> measureFacadesCoarsely(const FacadeQuestion& question, std::size_t points,
                                            Progress& progress, const std::stop_token& stop) {
    FacadeScene scene = makeScene(question, NearShape(question));
    const FacadeSettings facades = coarsened(question.facades, wallAreaM2(scene), points);
    const OwnStoreys storeys = scaled(question.storeys, facades.storeyM / question.facades.storeyM);
    return measure(std::move(scene), facades, storeys, *question.sun, progress, stop)
        .map([](FacadeAnswer answer) {
            answer.coarse = true;
            return answer;
        });
}

}  // namespace noonmark
