#include "core/lab/accrual/surface_accrual.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/depths/slice_stack.h"
#include "core/lab/graph/graph_engine.h"

namespace noonmark {

namespace {

// Represents the points as a row of cells, because the direction graph needs only their number.
Receivers rowOf(std::size_t points) {
    Receivers receivers;
    receivers.grid = {0, 0, 1, int(points), 1};
    receivers.kind.assign(points, CellKind::ground);
    for (std::size_t i = 0; i < points; ++i) receivers.cells.push_back(std::uint32_t(i));
    return receivers;
}

std::vector<std::uint32_t> inReach(const City& city, const SurfacePoints& points, const SunSteps& sun) {
    Box2 box;
    float lowest = std::numeric_limits<float>::max();
    for (const glm::vec3 point : points.positions) {
        box.add(glm::vec2(point));
        lowest = std::min(lowest, point.z);
    }
    const ShadowReach reach(sun);
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < city.buildings.size(); ++i)
        if (reach.touches(bounds(*city.buildings[i]), double(topM(*city.buildings[i])) - double(lowest), box))
            indices.push_back(i);
    return indices;
}

class SurfaceScene final : public IntervalScene {
public:
    SurfaceScene(CasterFaces faces, const SurfacePoints& points, const AccrualSettings& settings, Cost cost)
        : faces_(std::move(faces)),
          points_(points),
          settings_(settings),
          slices_(settings.mapSize, settings.mapSize),
          cost_(std::move(cost)) {}

    Result<void> shade(const SunInterval& interval, std::span<ShadowMask> masks,
                       std::stop_token stop) override {
        return shaded(interval, masks, stop, nullptr);
    }

    Result<void> shadeWatched(const SunInterval& interval, std::span<ShadowMask> masks, std::stop_token stop,
                              const MaskWatcher& watcher) override {
        return shaded(interval, masks, stop, &watcher);
    }

    [[nodiscard]] Cost cost() const override { return cost_; }

private:
    Result<void> shaded(const SunInterval& interval, std::span<ShadowMask> masks, const std::stop_token& stop,
                        const MaskWatcher* watcher) {
        if (auto ok = checkSteps(interval.steps); !ok) return ok;
        const Stopwatch place;
        const MapFrame frame = makeSurfaceFrame(points_, interval, settings_.mapSize, settings_.warp);
        const SurfaceLookup lookup(placeSurface(points_, frame), frame, settings_);
        const IntervalCasters casters = placeCasters(faces_, frame.placed(faces_.points), frame, interval,
                                                     settings_.side, {double(lookup.surface().lowestW), {}});
        cost_.skipped["faces on the side of solids that is not drawn"] += casters.turnedOther;
        cost_.skipped["faces whose shadow meets no receiver"] += casters.outOfReach;
        cost_.seconds["place"] += place.seconds();
        const Stopwatch draw;
        slices_.shade(
            casters, frame, interval, settings_.side,
            [&](const DepthSlice& slice, int step, std::span<std::uint64_t> bits) {
                lookup.look(slice, interval.at(step), bits);
            },
            masks, stop, watcher);
        cost_.seconds["draw"] += draw.seconds();
        if (stop.stop_requested()) return cancelled();
        return {};
    }

    CasterFaces faces_;
    const SurfacePoints& points_;
    AccrualSettings settings_;
    SliceStack slices_;
    Cost cost_;
};

/// Interval scenes for one set of points.
class SurfaceIntervals final : public IntervalEngine {
public:
    SurfaceIntervals(const SurfacePoints& points, const AccrualSettings& settings)
        : points_(points), settings_(settings) {}

    [[nodiscard]] Result<std::unique_ptr<IntervalScene>> prepare(const City& city, const Receivers&,
                                                                 const SunSteps& directions,
                                                                 std::stop_token stop) const override {
        const std::vector<std::uint32_t> used = inReach(city, points_, directions);
        CasterFaces faces = makeCasterFaces(city, used, stop);
        if (stop.stop_requested()) return cancelled();
        Cost cost;
        countInReach(cost, used.size(), city.buildings.size());
        return std::make_unique<SurfaceScene>(std::move(faces), points_, settings_, std::move(cost));
    }

    [[nodiscard]] std::string_view name() const override { return "Shadow accrual map"; }
    [[nodiscard]] std::string describe() const override {
        return fmt::format(
            "Shadow accrual map on surfaces, {} texels a side{}, bias {:g} m, on the processor",
            settings_.mapSize, settings_.warp && points_.eye ? ", warped" : "", settings_.biasM);
    }

private:
    const SurfacePoints& points_;
    AccrualSettings settings_;
};

void take(ShadowField&& field, SurfaceShadow& shadow) {
    shadow.grossMin = std::move(field.grossMin);
    shadow.continuousMin = std::move(field.continuousMin);
    shadow.cost = std::move(field.cost);
    shadow.engine = std::move(field.engine);
}

}  // namespace

SurfaceAccrual::SurfaceAccrual(const AccrualSettings& settings, const DirectionGraphSettings& graph)
    : settings_(settings), graph_(graph) {}

Result<std::unique_ptr<SurfaceAccrual>> SurfaceAccrual::make(const AccrualSettings& settings,
                                                             const DirectionGraphSettings& graph) {
    if (const auto ok = check(settings); !ok) return tl::make_unexpected(ok.error());
    return std::unique_ptr<SurfaceAccrual>(new SurfaceAccrual(settings, graph));
}

Result<SurfaceShadow> SurfaceAccrual::accumulate(const City& city, const SurfacePoints& points,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop) const {
    return accumulate(city, points, sun, progress, std::move(stop), {});
}

Result<SurfaceShadow> SurfaceAccrual::accumulate(const City& city, const SurfacePoints& points,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop, const StepMemory& memory) const {
    auto shadow = makeBlankSurfaceShadow(points, sun);
    if (!shadow || points.size() == 0) return shadow;
    const OutOfMemory lack{"this view", "shadow accrual map", "Choose a smaller view or a smaller map"};
    return guardMemory(lack, [&]() -> Result<SurfaceShadow> {
        const GraphEngine graph(std::make_shared<SurfaceIntervals>(points, settings_), graph_);
        auto field = graph.accumulate(city, rowOf(points.size()), sun, progress, std::move(stop), memory);
        if (!field) return tl::make_unexpected(field.error());
        take(std::move(*field), *shadow);
        return std::move(*shadow);
    });
}

}  // namespace noonmark
