#include "render/lab/gl_shadow_maps.h"

#include <fmt/format.h>
#include <algorithm>

#include "core/base/progress.h"
#include "core/describe/text.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/projected/counting/receiver_count.h"
#include "core/lab/graph/graph_engine.h"
#include "render/lab/depth_maps.h"

namespace noonmark {

namespace {

SurfacePoints cellsOf(const Receivers& receivers) {
    SurfacePoints points;
    for (const std::uint32_t cell : receivers.cells) points.positions.push_back(receivers.position(cell));
    points.normals.assign(points.positions.size(), {0, 0, 1});
    return points;
}

// Software OpenGL takes seconds for the maps of an hour and cannot be interrupted within a draw.
constexpr int layersInSoftware = 4;

int layersADraw(GlPasses passes, const GlLimits& limits, int steps) {
    if (passes == GlPasses::oneAStep) return 1;
    return limits.software ? std::min(steps, layersInSoftware) : steps;
}

class GlScene final : public IntervalScene {
public:
    GlScene(CasterFaces faces, const Receivers& receivers, const AccrualSettings& settings, GlPasses passes,
            std::shared_ptr<const GlContext> context, Cost cost)
        : context_(std::move(context)),
          faces_(std::move(faces)),
          settings_(settings),
          passes_(passes),
          cellM_(receivers.grid.cellM),
          frame_(makeGroundFrame(receivers.grid, settings.mapSize, settings.texelsOnCells)),
          placed_(frame_.placed(faces_.points)),
          count_(receivers),
          receivers_(placeSurface(cellsOf(receivers), frame_)),
          cost_(std::move(cost)) {}

    ~GlScene() override {
        const GlContext::Current current(*context_);
        maps_.reset();
    }

    Result<void> shade(const SunInterval& interval, std::span<ShadowMask> masks,
                       std::stop_token stop) override {
        return shadeWatched(interval, masks, std::move(stop), {[] { return false; }, {}});
    }

    Result<void> shadeWatched(const SunInterval& interval, std::span<ShadowMask> masks, std::stop_token stop,
                              const MaskWatcher& watcher) override {
        if (auto ok = checkSteps(interval.steps); !ok) return ok;
        const Stopwatch place;
        const IntervalCasters casters =
            placeCasters(faces_, placed_, frame_, interval, settings_.side, extent());
        cost_.skipped["faces on the lit side of solids, or on the ground"] += casters.turnedOther;
        cost_.skipped["faces whose shadow meets no receiver"] += casters.outOfReach;
        cost_.seconds["place"] += place.seconds();
        const Stopwatch draw;
        const GlContext::Current current(*context_);
        if (auto ok = shadeOnDevice(casters, interval, masks, stop, watcher); !ok) return ok;
        cost_.seconds["draw"] += draw.seconds();
        return {};
    }

    [[nodiscard]] Cost cost() const override { return cost_; }

private:
    [[nodiscard]] ReceiverExtent extent() const {
        return {double(settings_.biasM), [this](glm::dvec2 low, glm::dvec2 high) {
                    return count_.any(low / cellM_ - 1.0, high / cellM_);
                }};
    }

    Result<void> shadeOnDevice(const IntervalCasters& casters, const SunInterval& interval,
                               std::span<ShadowMask> masks, const std::stop_token& stop,
                               const MaskWatcher& watcher) {
        const int layers = layersADraw(passes_, context_->limits(), interval.steps);
        if (auto ok = prepareMaps(layers); !ok) return ok;
        maps_->take(casters, interval);
        for (int step = 0; step < interval.steps; step += layers) {
            if (stop.stop_requested()) return cancelled();
            const int count = std::min(layers, interval.steps - step);
            maps_->draw(step, count);
            maps_->lookUp(step, count);
            if (context_->limits().software) maps_->wait();
            if (step + count == interval.steps || !watcher.wants()) continue;
            if (auto ok = maps_->read(masks); !ok) return ok;
            watcher.show(step + count);
        }
        return maps_->read(masks);
    }

    Result<void> prepareMaps(int layers) {
        if (maps_ && layers <= layers_) return {};
        maps_.reset();
        auto maps = DepthMaps::make(context_->limits(), frame_.columns, frame_.rows, layers);
        if (!maps) return tl::make_unexpected(maps.error());
        maps_ = std::move(*maps);
        layers_ = layers;
        maps_->take(frame_, receivers_, settings_);
        return {};
    }

    std::shared_ptr<const GlContext> context_;
    CasterFaces faces_;
    AccrualSettings settings_;
    GlPasses passes_;
    double cellM_;
    MapFrame frame_;
    std::vector<glm::dvec3> placed_;
    ReceiverCount count_;
    PlacedSurface receivers_;
    std::unique_ptr<DepthMaps> maps_;
    int layers_ = 0;
    Cost cost_;
};

}  // namespace

GlShadowMaps::GlShadowMaps(GlPasses passes, const AccrualSettings& settings,
                           std::shared_ptr<const GlContext> context)
    : passes_(passes), settings_(settings), context_(std::move(context)) {}

Result<std::shared_ptr<const GlShadowMaps>> GlShadowMaps::make(GlPasses passes,
                                                               const AccrualSettings& settings) {
    if (const auto ok = check(settings); !ok) return tl::make_unexpected(ok.error());
    auto context = GlContext::make();
    if (!context) return tl::make_unexpected(context.error());
    const int maximum = std::min((*context)->limits().mapSize, AccrualSettings::maxMapSize);
    if (settings.mapSize > maximum)
        return failure(
            fmt::format("A shadow map of {} texels a side is larger than the graphics device allows",
                        settings.mapSize),
            "map size", fmt::format("Choose {} to {} texels", AccrualSettings::minMapSize, maximum));
    return std::shared_ptr<const GlShadowMaps>(new GlShadowMaps(passes, settings, std::move(*context)));
}

Result<std::unique_ptr<IntervalScene>> GlShadowMaps::prepare(const City& city, const Receivers& receivers,
                                                             const SunSteps& directions,
                                                             std::stop_token stop) const {
    Cost cost;
    const std::vector<std::uint32_t> used = findBuildingsInReach(city, receivers, directions, cost);
    CasterFaces faces = makeCasterFaces(city, used, stop);
    if (stop.stop_requested()) return cancelled();
    return std::make_unique<GlScene>(std::move(faces), receivers, settings_, passes_, context_,
                                     std::move(cost));
}

std::string GlShadowMaps::describe() const {
    return fmt::format("{} in OpenGL, {} texels a side{}, bias {:g} m, {}",
                       passes_ == GlPasses::oneAStep ? "Shadow map a step" : "Shadow accrual map",
                       settings_.mapSize, settings_.texelsOnCells ? " at most, on cells" : "",
                       settings_.biasM, limits().device);
}

namespace {

EngineEntry mapsOf(EngineInfo info, GlPasses passes, const GlLimits& limits) {
    info.bytesPerCell = accrualBytesPerCell;
    EngineEntry entry =
        engineOf(std::move(info), throughGraph(accrualFields()),
                 [passes](const ThroughGraph<AccrualSettings>& settings) -> Result<std::unique_ptr<Engine>> {
                     const auto maps = GlShadowMaps::make(passes, settings.own);
                     if (!maps) return tl::make_unexpected(maps.error());
                     return std::make_unique<GraphEngine>(*maps, settings.graph);
                 });
    ValueRange& sizes = *std::ranges::find(entry.info.options, "map", &Field::key)->range;
    sizes.max = std::min(sizes.max, double(limits.mapSize));
    return entry;
}

EngineList findEngines() {
    const auto context = GlContext::make();
    if (!context) return {};
    const GlLimits& limits = (*context)->limits();
    return {
        mapsOf({"shadow-map-gl", NM_TEXT("Shadow maps (OpenGL)"),
                NM_TEXT(
                    "Draws one depth map per step and tests every cell against it: the method that the paper "
                    "compares accrual maps with")},
               GlPasses::oneAStep, limits),
        mapsOf({"sam-gl", NM_TEXT("Shadow accrual map (OpenGL)"),
                NM_TEXT("One draw on the graphics device fills the depth maps of all steps of an hour")},
               GlPasses::oneAnInterval, limits)};
}

}  // namespace

const EngineList& glEngines() {
    static const EngineList engines = findEngines();
    return engines;
}

}  // namespace noonmark
