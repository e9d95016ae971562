#include "core/receivers/points/facade_elevations.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "core/receivers/points/solid_parts.h"

namespace noonmark {

namespace {

constexpr double sideDeg = 15;       // walls and windows of one side
constexpr double onFaceM = 0.6;      // a window belongs to a wall that is at most so far away
constexpr double inFrontOfM = 0.75;  // a wall that is nearer by this covers what is behind it
constexpr int maxLayers = 12;

double azimuthDegOf(glm::dvec2 normal) {
    const double azimuth = std::atan2(normal.x, normal.y) * 180 / std::numbers::pi;
    return azimuth < 0 ? azimuth + 360 : azimuth;
}

bool isOfSide(glm::dvec2 side, glm::dvec2 normal) {
    return std::abs(std::remainder(azimuthDegOf(side) - azimuthDegOf(normal), 360)) <= sideDeg;
}

glm::dvec2 levelNormal(const ElevationPane& pane) { return glm::normalize(glm::dvec2(pane.normal)); }

/// A wall, and its depth in a side.
struct SideFace {
    const WallFace* face = nullptr;
    double depthM = 0;
};

/// A window and where it is in a side.
struct SideGlazing {
    ElevationGlazing drawn;
    glm::dvec3 middle{};
    double depthM = 0;
    std::optional<std::size_t> face{};  // that it is on
};

/// One side of a building: its walls from back to front, and its windows.
class Side {
public:
    Side(glm::dvec2 normal, const std::vector<WallFace>& walls, double floorM)
        : normal_(normal), along_(-normal.y, normal.x), floorM_(floorM) {
        for (const WallFace& wall : walls)
            if (isOfSide(normal_, wall.normal()))
                faces_.push_back({&wall, glm::dot(wall.start + wall.along * (wall.lengthM / 2), normal_)});
        std::ranges::sort(faces_, {}, &SideFace::depthM);
    }

    void add(std::size_t index, const ElevationPane& pane) {
        const PaneAxes axes = findPaneAxes(pane.normal);
        SideGlazing window{{index, glm::dvec2(1e30), glm::dvec2(-1e30)},
                           pane.middle,
                           glm::dot(glm::dvec2(pane.middle), normal_)};
        for (const double x : {pane.size.low.x, pane.size.high.x})
            for (const double y : {pane.size.low.y, pane.size.high.y}) {
                const glm::dvec2 place = placeOf(pane.middle + x * axes.along + y * axes.up);
                window.drawn.low = glm::min(window.drawn.low, place);
                window.drawn.high = glm::max(window.drawn.high, place);
            }
        window.face = faceOf(window);
        windows_.push_back(window);
    }

    [[nodiscard]] std::vector<FacadeElevation> draw() const {
        std::vector<FacadeElevation> layers;
        std::vector<bool> isShown(faces_.size(), true);
        std::vector<const SideGlazing*> left;
        for (const SideGlazing& window : windows_) left.push_back(&window);
        bool onlyTheirWalls = false;  // the walls of the windows that are left
        bool coverEachOther = false;  // walls that cross, as those of a twisted tower
        while (!left.empty()) {
            const bool isLast = int(layers.size()) + 1 == maxLayers || coverEachOther;
            std::vector<const SideGlazing*> covered;
            FacadeElevation layer = drawLayer(isShown, left, isLast, covered);
            // Nearer walls may cover all: then the windows are seen only without them.
            if (!layer.windows.empty()) layers.push_back(std::move(layer));
            coverEachOther = onlyTheirWalls && covered.size() == left.size();
            onlyTheirWalls = true;
            isShown.assign(faces_.size(), false);
            for (const SideGlazing* window : covered)
                if (window->face) isShown[*window->face] = true;
            left = std::move(covered);
        }
        for (std::size_t i = 0; i < layers.size(); ++i)
            layers[i].layer = int(i) + 1, layers[i].layers = int(layers.size());
        return layers;
    }

private:
    [[nodiscard]] glm::dvec2 placeOf(glm::dvec3 place) const {
        return {glm::dot(glm::dvec2(place), along_), place.z};
    }

    /// Whether a wall covers that place as seen from this side.
    [[nodiscard]] bool covers(const SideFace& face, glm::dvec3 place) const {
        const WallFace& wall = *face.face;
        const double turned = glm::dot(wall.along, along_);  // above 0.96
        const double along = (glm::dot(glm::dvec2(place) - wall.start, along_)) / turned;
        return wall.covers({along, place.z});
    }

    [[nodiscard]] std::optional<std::size_t> faceOf(const SideGlazing& window) const {
        std::optional<std::size_t> nearest;
        double distance = onFaceM;
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            const WallFace& wall = *faces_[i].face;
            const double away = std::abs(glm::dot(glm::dvec2(window.middle) - wall.start, wall.normal()));
            if (away > distance || !covers(faces_[i], window.middle)) continue;
            nearest = i, distance = away;
        }
        return nearest;
    }

    [[nodiscard]] bool isCovered(const SideGlazing& window, const std::vector<bool>& isShown) const {
        for (std::size_t i = faces_.size(); i-- > 0;) {
            if (faces_[i].depthM <= window.depthM + inFrontOfM) return false;
            if (isShown[i] && i != window.face && covers(faces_[i], window.middle)) return true;
        }
        return false;
    }

    [[nodiscard]] ElevationFace drawFace(const SideFace& face) const {
        const WallFace& wall = *face.face;
        const double first = glm::dot(wall.start, along_), turned = glm::dot(wall.along, along_);
        ElevationFace drawn{face.depthM, {}};
        for (const auto& triangle : wall.triangles) {
            auto& polygon = drawn.polygons.emplace_back();
            for (const glm::dvec2 corner : triangle)
                polygon.emplace_back(first + corner.x * turned, corner.y);
        }
        if (wall.triangles.empty()) {
            const double last = first + wall.lengthM * turned;
            drawn.polygons = {
                {{first, wall.lowM}, {last, wall.lowM}, {last, wall.highM}, {first, wall.highM}}};
        }
        return drawn;
    }

    [[nodiscard]] FacadeElevation drawLayer(const std::vector<bool>& isShown,
                                            const std::vector<const SideGlazing*>& windows, bool takesAll,
                                            std::vector<const SideGlazing*>& covered) const {
        FacadeElevation layer{.normal = normal_, .low = glm::dvec2(1e30), .high = glm::dvec2(-1e30)};
        layer.floorM = floorM_;
        const auto grow = [&](glm::dvec2 place) {
            layer.low = glm::min(layer.low, place);
            layer.high = glm::max(layer.high, place);
        };
        for (std::size_t i = 0; i < faces_.size(); ++i)
            if (isShown[i]) layer.faces.push_back(drawFace(faces_[i]));
        for (const ElevationFace& face : layer.faces)
            for (const auto& polygon : face.polygons) std::ranges::for_each(polygon, grow);
        for (const SideGlazing* window : windows) {
            if (!takesAll && isCovered(*window, isShown)) {
                covered.push_back(window);
                continue;
            }
            layer.windows.push_back(window->drawn);
            grow(window->drawn.low), grow(window->drawn.high);
        }
        return layer;
    }

    glm::dvec2 normal_, along_;
    double floorM_;
    std::vector<SideFace> faces_;
    std::vector<SideGlazing> windows_;
};

/// The direction of most of these panes, to a degree.
glm::dvec2 commonDirection(std::span<const ElevationPane> panes, const std::vector<std::size_t>& indices) {
    std::map<long, std::pair<std::size_t, std::size_t>> counts;  // by degree: how many, and the first
    for (const std::size_t index : indices) {
        const long degree = std::lround(azimuthDegOf(levelNormal(panes[index]))) % 360;
        ++counts.try_emplace(degree, 0, index).first->second.first;
    }
    const auto maximum =
        std::ranges::max_element(counts, {}, [](const auto& count) { return count.second.first; });
    return levelNormal(panes[maximum->second.second]);
}

}  // namespace

std::vector<FacadeElevation> drawElevations(const Building* building, std::span<const ElevationPane> panes) {
    std::vector<WallFace> walls;
    double floorM = std::numeric_limits<double>::max();
    if (building != nullptr)
        for (const Part& part : building->parts)
            for (WallFace& wall : findWallFaces(part)) walls.push_back(std::move(wall));
    for (const WallFace& wall : walls) floorM = std::min(floorM, wall.lowM);
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < panes.size(); ++i) {
        if (walls.empty()) floorM = std::min(floorM, panes[i].middle.z + panes[i].size.low.y);
        if (hasElevation(panes[i])) left.push_back(i);
    }
    std::vector<FacadeElevation> all;
    while (!left.empty()) {
        const glm::dvec2 normal = commonDirection(panes, left);
        Side side(normal, walls, floorM);
        std::erase_if(left, [&](std::size_t index) {
            if (!isOfSide(normal, levelNormal(panes[index]))) return false;
            side.add(index, panes[index]);
            return true;
        });
        for (FacadeElevation& layer : side.draw()) all.push_back(std::move(layer));
    }
    std::ranges::stable_sort(
        all, {}, [](const FacadeElevation& one) { return std::lround(azimuthDegOf(one.normal)) % 360; });
    return all;
}

}  // namespace noonmark
