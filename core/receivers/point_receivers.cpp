#include "core/receivers/point_receivers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/receivers/points/solid_parts.h"

namespace noonmark {

namespace {

/// Places the receivers of one building after the other.
class FacadePlacer {
public:
    FacadePlacer(const City& city, const FacadeSettings& settings, const OwnStoreys& own)
        : city_(city), settings_(settings), own_(own), solids_(city) {}

    void addBuilding(std::uint32_t index) {
        storeyM_ = findStoreyM(*city_.buildings[index], settings_, own_);
        aboveFloorM_ = std::min(settings_.aboveFloorM, storeyM_);
        std::vector<WallFace> faces;
        for (const Part& part : city_.buildings[index]->parts)
            for (WallFace& face : findWallFaces(part)) faces.push_back(std::move(face));
        if (faces.empty()) return;
        const double lowest = std::ranges::min_element(faces, {}, &WallFace::lowM)->lowM;
        for (std::size_t wall = 0; wall < faces.size(); ++wall) addWall(faces[wall], lowest, index, wall);
    }

    [[nodiscard]] const PointReceivers& placed() const { return placed_; }
    PointReceivers take() { return std::move(placed_); }

private:
    void addWall(const WallFace& face, double lowest, std::uint32_t building, std::size_t wall) {
        const int bays = std::max(1, int(std::lround(face.lengthM / settings_.bayM)));
        const double first = lowest + aboveFloorM_;
        const int floor = std::max(0, int(std::ceil((face.lowM - first) / storeyM_)));
        for (int storey = floor; first + storey * storeyM_ < face.highM; ++storey)
            for (int bay = 0; bay < bays; ++bay) {
                const glm::dvec2 place{(bay + 0.5) * face.lengthM / bays, first + storey * storeyM_};
                if (face.covers(place) && isOpen(face, place))
                    addPoint(face, place,
                             {.id = idOf(building, wall, storey, bay),
                              .kind = ElementKind::facade,
                              .building = building,
                              .floor = storey},
                             paneOf(face, face.lengthM / bays, place.y));
            }
    }

    // The part of the wall between the floors and the sides of the bay.
    [[nodiscard]] PaneSize paneOf(const WallFace& face, double widthM, double heightM) const {
        const double floorM = heightM - aboveFloorM_;
        return {{-widthM / 2, std::max(face.lowM, floorM) - heightM},
                {widthM / 2, std::min(face.highM, floorM + storeyM_) - heightM}};
    }

    [[nodiscard]] bool isOpen(const WallFace& face, glm::dvec2 place) const {
        constexpr double inFrontM = 0.05;
        const glm::dvec2 front = face.start + place.x * face.along + inFrontM * face.normal();
        return place.y > double(groundAt(city_, front)) && !solids_.isSolid({front, place.y});
    }

    void addPoint(const WallFace& face, glm::dvec2 place, PointElement element, PaneSize pane) {
        placed_.points.positions.emplace_back(glm::dvec3(face.start + place.x * face.along, place.y));
        placed_.points.normals.emplace_back(glm::dvec3(face.normal(), 0));
        placed_.elements.push_back(std::move(element));
        placed_.panes.push_back(pane);
    }

    [[nodiscard]] std::string idOf(std::uint32_t building, std::size_t wall, int storey, int bay) const {
        return fmt::format("{} wall {} floor {} bay {}", city_.buildings[building]->sourceId, wall, storey,
                           bay);
    }

    const City& city_;
    const FacadeSettings& settings_;
    const OwnStoreys& own_;
    double storeyM_ = 0, aboveFloorM_ = 0;  // of the building that is being added
    SolidParts solids_;
    PointReceivers placed_;
};

Result<void> checkFacades(const FacadeSettings& settings) {
    const auto inRange = [](double metres) {
        return metres >= FacadeSettings::minM && metres <= FacadeSettings::maxM;
    };
    if (!inRange(settings.bayM) || !inRange(settings.storeyM))
        return failure("The bays or storeys of facades are out of range", "facades", "Give 0.25 to 50 m");
    if (!(settings.aboveFloorM >= 0 && settings.aboveFloorM <= settings.storeyM))
        return failure("The receivers of facades are not within their storey", "facades",
                       "Give a height above the floor from 0 to the height of a storey");
    return {};
}

}  // namespace

std::string_view nameOf(ElementKind kind) {
    switch (kind) {
        case ElementKind::facade:
            return "facade";
        case ElementKind::window:
            return "window";
        case ElementKind::plane:
            return "plane";
        case ElementKind::point:
            return "point";
    }
    return "point";
}

double findStoreyM(const Building& building, const FacadeSettings& settings, const OwnStoreys& own) {
    const auto found = own.find(building.sourceId);
    return found == own.end() ? settings.storeyM : found->second;
}

Result<PointReceivers> placeOnFacades(const City& city, std::span<const std::uint32_t> buildings,
                                      const FacadeSettings& settings, const std::stop_token& stop,
                                      const OwnStoreys& own) {
    if (const auto ok = checkFacades(settings); !ok) return tl::make_unexpected(ok.error());
    FacadePlacer placer(city, settings, own);
    for (const std::uint32_t building : buildings) {
        if (stop.stop_requested()) return cancelled();
        if (building >= city.buildings.size())
            return failure(fmt::format("There is no building {}", building), "facades",
                           "Choose buildings of the city");
        placer.addBuilding(building);
        if (placer.placed().size() > maxReceivers)
            return failure("There are too many receivers on facades", "facades",
                           "Choose fewer buildings, or wider bays and higher storeys");
    }
    return placer.take();
}

std::vector<std::uint32_t> findBuildingsIn(const City& city, const Region& region) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t index = 0; index < city.buildings.size(); ++index) {
        const Box2 box = bounds(*city.buildings[index]);
        const glm::dvec2 middle = (glm::dvec2(box.low) + glm::dvec2(box.high)) / 2.0;
        if (std::ranges::any_of(region.polygons, [&](const Footprint& p) { return contains(p, middle); }))
            found.push_back(index);
    }
    return found;
}

}  // namespace noonmark
