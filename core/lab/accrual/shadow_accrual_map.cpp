#include "core/lab/accrual/shadow_accrual_map.h"

#include <fmt/format.h>

#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/depths/slice_stack.h"
#include "core/engines/projected/counting/receiver_count.h"

namespace noonmark {

namespace {

class AccrualScene final : public IntervalScene {
public:
    AccrualScene(CasterFaces faces, const Receivers& receivers, const AccrualSettings& settings)
        : faces_(std::move(faces)),
          settings_(settings),
          cellM_(receivers.grid.cellM),
          frame_(makeGroundFrame(receivers.grid, settings.mapSize, settings.texelsOnCells)),
          placed_(frame_.placed(faces_.points)),
          count_(receivers),
          lookup_(receivers, frame_, settings.biasM),
          slices_(frame_.columns, frame_.rows) {}

    Result<void> shade(const SunInterval& interval, std::span<ShadowMask> masks,
                       std::stop_token stop) override {
        return tried(interval, masks, stop, nullptr);
    }

    Result<void> shadeWatched(const SunInterval& interval, std::span<ShadowMask> masks, std::stop_token stop,
                              const MaskWatcher& watcher) override {
        return tried(interval, masks, stop, &watcher);
    }

    [[nodiscard]] Cost cost() const override { return cost_; }
    void startWith(Cost cost) { cost_ = std::move(cost); }

private:
    Result<void> tried(const SunInterval& interval, std::span<ShadowMask> masks, const std::stop_token& stop,
                       const MaskWatcher* watcher) {
        if (auto ok = checkSteps(interval.steps); !ok) return ok;
        const OutOfMemory lack{fmt::format("maps of {} x {} texels", frame_.columns, frame_.rows), "map size",
                               "Choose a smaller map"};
        return guardMemory(lack, [&] { return shaded(interval, masks, stop, watcher); });
    }

    Result<void> shaded(const SunInterval& interval, std::span<ShadowMask> masks, const std::stop_token& stop,
                        const MaskWatcher* watcher) {
        const Stopwatch place;
        const IntervalCasters casters =
            placeCasters(faces_, placed_, frame_, interval, settings_.side, extent());
        countSkipped(casters);
        cost_.seconds["place"] += place.seconds();
        const Stopwatch draw;
        slices_.shade(
            casters, frame_, interval, settings_.side,
            [this](const DepthSlice& slice, int, std::span<std::uint64_t> bits) {
                lookup_.look(slice, bits);
            },
            masks, stop, watcher);
        if (stop.stop_requested()) return cancelled();
        cost_.seconds["draw"] += draw.seconds();
        return {};
    }

    // Converts metres on the plane to cells of the grid.
    [[nodiscard]] ReceiverExtent extent() const {
        return {double(settings_.biasM), [this](glm::dvec2 low, glm::dvec2 high) {
                    return count_.any(low / cellM_ - 1.0, high / cellM_);
                }};
    }

    void countSkipped(const IntervalCasters& casters) {
        cost_.skipped["faces on the lit side of solids, or on the ground"] += casters.turnedOther;
        cost_.skipped["faces whose shadow meets no receiver"] += casters.outOfReach;
    }

    CasterFaces faces_;
    AccrualSettings settings_;
    double cellM_;
    MapFrame frame_;
    std::vector<glm::dvec3> placed_;
    ReceiverCount count_;
    GroundLookup lookup_;
    SliceStack slices_;
    Cost cost_;
};

}  // namespace

ShadowAccrualMap::ShadowAccrualMap(AccrualSettings settings) : settings_(settings) {}

Result<std::shared_ptr<const ShadowAccrualMap>> ShadowAccrualMap::make(const AccrualSettings& settings) {
    if (const auto ok = check(settings); !ok) return tl::make_unexpected(ok.error());
    return std::shared_ptr<const ShadowAccrualMap>(new ShadowAccrualMap(settings));
}

Result<std::unique_ptr<IntervalScene>> ShadowAccrualMap::prepare(const City& city, const Receivers& receivers,
                                                                 const SunSteps& directions,
                                                                 std::stop_token stop) const {
    Cost cost;
    const std::vector<std::uint32_t> used = findBuildingsInReach(city, receivers, directions, cost);
    CasterFaces faces = makeCasterFaces(city, used, stop);
    if (stop.stop_requested()) return cancelled();
    auto scene = std::make_unique<AccrualScene>(std::move(faces), receivers, settings_);
    scene->startWith(std::move(cost));
    return scene;
}

std::string ShadowAccrualMap::describe() const {
    return fmt::format("Shadow accrual map, {} texels a side{}, bias {:g} m, on the processor",
                       settings_.mapSize, settings_.texelsOnCells ? " at most, on cells" : "",
                       settings_.biasM);
}

}  // namespace noonmark
