#include "core/measures/outlines/moment_outlines.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <cstddef>
#include <functional>
#include <glm/common.hpp>
#include <iterator>
#include <limits>

#include "core/city/footprints/triangulate.h"
#include "core/city/meshes/mesh_topology.h"
#include "core/city/terrain/building_ground.h"
#include "core/describe/text.h"
#include "core/engines/common/changed_buildings.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/projected/casters/shadow_casters.h"
#include "core/engines/ray/ray_reference.h"
#include "core/measures/places/place_receivers.h"
#include "core/receivers/band_polygons.h"
#include "core/receivers/roof_receivers.h"

namespace noonmark {

namespace {

// The part where `sign` x (coordinate `axis` - `at`) <= 0.
ConvexPolygon clipAt(const ConvexPolygon& polygon, int axis, double at, double sign) {
    ConvexPolygon clipped;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double beyondA = sign * (a[axis] - at), beyondB = sign * (b[axis] - at);
        if (beyondA <= 0) clipped.push_back(a);
        if ((beyondA < 0 && beyondB > 0) || (beyondA > 0 && beyondB < 0)) {
            glm::dvec2 crossing = a + (b - a) * (beyondA / (beyondA - beyondB));
            crossing[axis] = at;
            clipped.push_back(crossing);
        }
    }
    return clipped;
}

double twiceAreaOf(const ConvexPolygon& polygon) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const glm::dvec2 u = polygon[i] - polygon[0], v = polygon[i + 1] - polygon[0];
        sum += u.x * v.y - u.y * v.x;
    }
    return sum;
}

/// A polygon that may contain others.
class Container {
public:
    explicit Container(const ConvexPolygon& polygon)
        : polygon_(&polygon), low_(polygon[0]), high_(polygon[0]) {
        for (const glm::dvec2 point : polygon) {
            low_ = glm::min(low_, point);
            high_ = glm::max(high_, point);
        }
    }
    [[nodiscard]] bool contains(const Container& other) const {
        return low_.x <= other.low_.x && low_.y <= other.low_.y && high_.x >= other.high_.x &&
               high_.y >= other.high_.y &&
               std::ranges::all_of(*other.polygon_, [&](glm::dvec2 point) { return isInside(point); });
    }

    [[nodiscard]] const ConvexPolygon& polygon() const { return *polygon_; }

private:
    [[nodiscard]] bool isInside(glm::dvec2 point) const {
        for (std::size_t i = 0, j = polygon_->size() - 1; i < polygon_->size(); j = i++) {
            const glm::dvec2 along = (*polygon_)[i] - (*polygon_)[j], to = point - (*polygon_)[j];
            if (along.x * to.y - along.y * to.x < 0) return false;
        }
        return true;
    }

    const ConvexPolygon* polygon_;
    glm::dvec2 low_, high_;
};

}  // namespace

void dropContained(std::vector<ConvexPolygon>& polygons) {
    std::ranges::sort(polygons, std::greater{}, twiceAreaOf);
    std::vector<Container> left;
    std::vector<ConvexPolygon> all;
    all.swap(polygons);
    for (ConvexPolygon& polygon : all) {
        const Container candidate(polygon);
        if (std::ranges::none_of(left, [&](const Container& other) { return other.contains(candidate); }))
            left.push_back(candidate);
    }
    for (const Container& container : left) polygons.push_back(container.polygon());
}

ConvexPolygon clipToBox(const ConvexPolygon& polygon, const Box2& box) {
    ConvexPolygon clipped = polygon;
    for (int axis = 0; axis < 2 && !clipped.empty(); ++axis) {
        clipped = clipAt(clipped, axis, double(box.low[axis]), -1);
        clipped = clipAt(clipped, axis, double(box.high[axis]), 1);
    }
    return clipped.size() < 3 ? ConvexPolygon{} : clipped;
}

namespace {

bool overlap(const Box2& a, const Box2& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

void addCover(const Building& building, const Box2& area, std::vector<Footprint>& cover) {
    if (!overlap(bounds(building), area)) return;
    for (const Part& part : building.parts)
        for (Footprint& contact : findGroundContact(part, 0)) cover.push_back(std::move(contact));
}

glm::dvec2 shadowPerMetre(glm::dvec3 towardsSun) { return glm::dvec2(towardsSun) / -towardsSun.z; }

}  // namespace

LevelOutliner::Group LevelOutliner::groupOf(const City& city, const std::vector<std::uint32_t>& indices) {
    Group group;
    for (const std::uint32_t i : indices) {
        group.buildings.push_back(city.buildings[i].get());
        group.boxes.push_back(bounds(*city.buildings[i]));
        group.heightsM.push_back(topM(*city.buildings[i]));
    }
    return group;
}

LevelOutliner::LevelOutliner(const City& baseline, const City* scenario, const Box2& area) : area_(area) {
    std::vector<const City*> cities{&baseline};
    if (scenario != nullptr) cities.push_back(scenario);
    const SharedBuildings shared = findSharedBuildings(cities);
    common_ = groupOf(baseline, shared.common);
    baseline_ = groupOf(baseline, shared.own.front());
    if (scenario != nullptr) scenario_ = groupOf(*scenario, shared.own.back());
    for (const Group* group : {&common_, &baseline_, &scenario_})
        for (const Building* building : group->buildings) addCover(*building, area, cover_);
}

std::vector<ConvexPolygon> LevelOutliner::project(const Group& group, const SunStep& step,
                                                  const std::stop_token& stop) const {
    SunSteps only;
    only.steps = {step};
    const ShadowReach reach(only);
    const glm::dvec2 perMetre = shadowPerMetre(glm::dvec3(step.direction));
    tbb::enumerable_thread_specific<std::vector<ConvexPolygon>> ofThread;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, group.buildings.size(), 64), [&](const auto& range) {
        std::vector<ConvexPolygon>& polygons = ofThread.local();
        for (std::size_t i = range.begin(); i < range.end() && !stop.stop_requested(); ++i)
            if (reach.touches(group.boxes[i], double(group.heightsM[i]), area_))
                projectBuilding(*group.buildings[i], perMetre, polygons);
    });
    std::vector<ConvexPolygon> all;
    for (std::vector<ConvexPolygon>& polygons : ofThread)
        all.insert(all.end(), std::move_iterator(polygons.begin()), std::move_iterator(polygons.end()));
    return all;
}

Result<ShadowOutlines> LevelOutliner::outline(const SunStep& step, Progress& progress,
                                              const std::stop_token& stop) const {
    progress.report(0, NM_TEXT("projecting shadows"));
    const ProjectedShadowPolygons polygons{project(common_, step, stop), project(baseline_, step, stop),
                                           project(scenario_, step, stop)};
    if (stop.stop_requested()) return cancelled();
    return joinShadows(polygons, cover_, area_, progress, stop);
}

namespace {

enum Band : int { baselineBand, incrementalBand, gainedBand, bandCount };

/// The outlines of one step, from the masks of both cities.
class MaskOutlines {
public:
    MaskOutlines(const Receivers& receivers, const StepMasks& baseline, const StepMasks& scenario)
        : receivers_(receivers), baseline_(baseline), scenario_(scenario) {}

    [[nodiscard]] ShadowOutlines trace(std::size_t step) const {
        std::vector<int> shadow(receivers_.grid.size(), noBand), change = shadow;
        for (std::size_t i = 0; i < receivers_.cells.size(); ++i) {
            const bool before = baseline_.shaded(step, i), after = scenario_.shaded(step, i);
            if (before) shadow[receivers_.cells[i]] = baselineBand;
            if (before != after) change[receivers_.cells[i]] = after ? incrementalBand : gainedBand;
        }
        ShadowOutlines outlines;
        outlines.cellM = receivers_.grid.cellM;
        add(std::move(shadow), outlines);
        add(std::move(change), outlines);
        return outlines;
    }

private:
    void add(std::vector<int> bands, ShadowOutlines& outlines) const {
        std::vector<Footprint>* const to[bandCount]{&outlines.baseline, &outlines.incremental,
                                                    &outlines.gained};
        for (BandPolygon& polygon : traceBands(receivers_.grid, std::move(bands)))
            to[polygon.band]->push_back(std::move(polygon.outline));
    }

    const Receivers& receivers_;
    const StepMasks& baseline_;
    const StepMasks& scenario_;
};

SunSteps dayOf(std::span<const SunStep> steps) {
    SunSteps sun;
    sun.steps.assign(steps.begin(), steps.end());
    sun.days.push_back({.first = 0, .count = std::uint32_t(steps.size())});
    return sun;
}

}  // namespace

Result<std::vector<ShadowOutlines>> traceOutlines(const City& baseline, const City* scenario,
                                                  std::span<const SunStep> steps,
                                                  const OutlineSettings& settings, Progress& progress,
                                                  const std::stop_token& stop) {
    std::vector<const City*> cities{&baseline};
    if (scenario != nullptr) cities.push_back(scenario);
    const Region area = makeRegionFromLocalBox(settings.area);
    auto placed = gridOver(area, {settings.cellM}).and_then([&](const Grid& grid) {
        return placeCommonReceivers(cities, area, grid, stop);
    });
    if (!placed) return tl::make_unexpected(placed.error());
    if (settings.planeM) raiseToPlane(*placed, *settings.planeM);
    std::vector<ShadowOutlines> all;
    const auto take = [&](std::size_t, std::span<StepMasks> masks) -> Result<void> {
        const MaskOutlines outlines(*placed, masks.front(), masks.back());
        for (std::size_t step = 0; step < steps.size() && !stop.stop_requested(); ++step)
            all.push_back(outlines.trace(step));
        return stop.stop_requested() ? Result<void>(cancelled()) : Result<void>();
    };
    const auto traced = RayReference().shadeSteps(cities, *placed, dayOf(steps), take, progress, stop);
    if (!traced) return tl::make_unexpected(traced.error());
    return all;
}

namespace {

double crossProduct(glm::dvec2 u, glm::dvec2 v) { return u.x * v.y - u.y * v.x; }

double twiceArea(const ConvexPolygon& ring) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        sum += crossProduct(ring[i] - ring[0], ring[i + 1] - ring[0]);
    return sum;
}

/// Projects the parts of a building along the sun's direction.
class Projector {
public:
    Projector(glm::dvec2 perMetre, std::vector<ConvexPolygon>& to) : perMetre_(perMetre), to_(to) {}

    void addPart(const Part& part) {
        if (part.mesh)
            addMesh(*part.mesh);
        else if (part.topM <= 0)
            return;
        else if (isConvex(part.footprint))
            addSwept(part.footprint.outer, part);
        else if (part.bottomM <= 0)
            addPieces(part);
        else
            addWallsAndUnderside(part);
    }

private:
    // The walls of a prism on the ground cast all of its shadow outside it.
    void addPieces(const Part& part) {
        for (const Ring& piece :
             splitIntoConvexPieces(part.footprint, std::numeric_limits<std::size_t>::max()))
            addSwept(piece, part);
    }

    void addWallsAndUnderside(const Part& part) {
        addWalls(part.footprint.outer, part);
        for (const Ring& hole : part.footprint.holes) addWalls(hole, part);
        const Triangulation under = triangulate(part.footprint);
        for (const glm::uvec3 t : under.triangles)
            addSwept({under.points[t.x], under.points[t.y], under.points[t.z]}, part.bottomM, part.bottomM);
    }

    void addWalls(const Ring& ring, const Part& part) {
        for (std::size_t i = 0; i < ring.size(); ++i) addSwept({ring[i], ring[(i + 1) % ring.size()]}, part);
    }

    void addSwept(const Ring& ring, const Part& part) {
        addSwept(ring, std::max(0.0F, part.bottomM), part.topM);
    }

    // What a convex polygon (or a wall of two points) sweeps from one height to a greater one: edges that
    // face away from the sun are at the upper one's shadow, the others at the lower one's.
    void addSwept(const Ring& ring, double low, double high) {
        const auto isFar = [&](std::size_t i) {
            return crossProduct(perMetre_, glm::dvec2(ring[(i + 1) % ring.size()]) - glm::dvec2(ring[i])) > 0;
        };
        ConvexPolygon swept;
        bool before = isFar(ring.size() - 1);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const bool after = isFar(i);
            swept.push_back(placed(ring[i], before ? high : low));
            if (after != before) swept.push_back(placed(ring[i], after ? high : low));
            before = after;
        }
        add(std::move(swept));
    }

    // Of a closed mesh, the faces that face the sun cast its whole shadow.
    void addMesh(const TriangleMesh& mesh) {
        const bool open = findOpenEdges(mesh) > 0;
        for (const glm::uvec3 t : mesh.triangles) {
            ConvexPolygon face = aboveGround({mesh.vertices[t.x], mesh.vertices[t.y], mesh.vertices[t.z]});
            if (open && twiceArea(face) < 0) std::ranges::reverse(face);
            add(std::move(face));
        }
    }

    // The shadow of the part of a triangle above z = 0.
    [[nodiscard]] ConvexPolygon aboveGround(const std::vector<glm::vec3>& corners) const {
        ConvexPolygon shadow;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec3 a(corners[i]), b(corners[(i + 1) % corners.size()]);
            if (a.z >= 0) shadow.push_back(placed(a, a.z));
            if ((a.z < 0) != (b.z < 0))
                shadow.push_back(glm::dvec2(a) + (glm::dvec2(b) - glm::dvec2(a)) * (a.z / (a.z - b.z)));
        }
        return shadow;
    }

    [[nodiscard]] glm::dvec2 placed(const auto& point, double heightM) const {
        return glm::dvec2(point) + perMetre_ * heightM;
    }

    void add(ConvexPolygon polygon) {
        if (polygon.size() >= 3 && twiceArea(polygon) > 0) to_.push_back(std::move(polygon));
    }

    glm::dvec2 perMetre_;
    std::vector<ConvexPolygon>& to_;
};

}  // namespace

void projectBuilding(const Building& building, glm::dvec2 perMetre, std::vector<ConvexPolygon>& to) {
    Projector projector(perMetre, to);
    for (const Part& part : building.parts) projector.addPart(part);
}

}  // namespace noonmark
