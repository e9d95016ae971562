#include "core/accumulate/shadow_accrual_map.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <new>

#include "core/accumulate/accrual/ground_lookup.h"
#include "core/accumulate/accrual/interval_casters.h"
#include "core/accumulate/accrual/mask_transpose.h"
#include "core/accumulate/projected/step_filler.h"
#include "core/accumulate/reach.h"
#include "core/stopwatch.h"

namespace noonmark {

namespace {

/// What a thread draws with.
struct Easel {
    explicit Easel(const MapFrame& frame) : slice(frame.columns, frame.rows) {}
    DepthSlice slice;
    SliceDrawer drawer;
};

std::vector<glm::dvec3> placedIn(const MapFrame& frame, const std::vector<glm::vec3>& points) {
    std::vector<glm::dvec3> placed;
    placed.reserve(points.size());
    for (const glm::vec3 point : points) placed.push_back(frame.placed(point));
    return placed;
}

class AccrualScene final : public IntervalScene {
public:
    AccrualScene(CasterFaces faces, const Receivers& receivers, const AccrualSettings& settings)
        : faces_(std::move(faces)),
          settings_(settings),
          cellM_(receivers.grid.cellM),
          frame_(groundFrame(receivers.grid, settings.mapSize, settings.texelsOnCells)),
          placed_(placedIn(frame_, faces_.points)),
          count_(receivers),
          lookup_(receivers, frame_, settings.biasM),
          easels_([this] { return Easel(frame_); }) {}

    Result<void> shade(const SunInterval& interval, std::span<ShadowMask> masks,
                       std::stop_token stop) override {
        if (auto ok = checkSteps(interval.steps); !ok) return ok;
        try {
            return shaded(interval, masks, stop);
        } catch (const std::bad_alloc&) {
            return failure(fmt::format("There is not enough memory for maps of {} x {} texels",
                                       frame_.columns, frame_.rows),
                           "map size", "Choose a smaller map");
        }
    }

    [[nodiscard]] Cost cost() const override { return cost_; }
    void startWith(Cost cost) { cost_ = std::move(cost); }

private:
    Result<void> shaded(const SunInterval& interval, std::span<ShadowMask> masks,
                        const std::stop_token& stop) {
        const Stopwatch place;
        const IntervalCasters casters =
            castersOf(faces_, placed_, frame_, interval, settings_.side, extent());
        countSkipped(casters);
        cost_.seconds["place"] += place.seconds();
        const Stopwatch draw;
        drawSlices(casters, interval, stop);
        if (stop.stop_requested()) return cancelled();
        takeMasks(interval.steps, masks);
        cost_.seconds["draw"] += draw.seconds();
        return {};
    }

    // The grid's cells from metres of its plane.
    [[nodiscard]] ReceiverExtent extent() const {
        return {double(settings_.biasM), [this](glm::dvec2 low, glm::dvec2 high) {
                    return count_.any(low / cellM_ - 1.0, high / cellM_);
                }};
    }

    void countSkipped(const IntervalCasters& casters) {
        cost_.skipped["faces on the lit side of solids, or on the ground"] += casters.turnedOther;
        cost_.skipped["faces whose shadow meets no receiver"] += casters.outOfReach;
    }

    void drawSlices(const IntervalCasters& casters, const SunInterval& interval,
                    const std::stop_token& stop) {
        shaded_.assign(std::size_t(interval.steps) * lookup_.words(), 0);
        tbb::parallel_for(tbb::blocked_range<int>(0, interval.steps, 1), [&](const auto& range) {
            Easel& easel = easels_.local();
            for (int step = range.begin(); step < range.end() && !stop.stop_requested(); ++step) {
                easel.drawer.draw(casters, frame_, frame_.shearOf(interval.at(step)), settings_.side,
                                  easel.slice);
                lookup_.look(easel.slice, std::span(shaded_).subspan(std::size_t(step) * lookup_.words(),
                                                                     lookup_.words()));
            }
        });
    }

    void takeMasks(int steps, std::span<ShadowMask> masks) const {
        const std::size_t words = lookup_.words();
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, words, 256), [&](const auto& range) {
            for (std::size_t word = range.begin(); word < range.end(); ++word) {
                std::array<std::uint64_t, 64> bits{};
                for (std::size_t step = 0; step < std::size_t(steps); ++step)
                    bits[step] = shaded_[step * words + word];
                transpose(bits);
                const std::size_t first = word * 64;
                std::copy_n(bits.begin(), std::min<std::size_t>(64, masks.size() - first),
                            masks.begin() + std::ptrdiff_t(first));
            }
        });
    }

    CasterFaces faces_;
    AccrualSettings settings_;
    double cellM_;
    MapFrame frame_;
    std::vector<glm::dvec3> placed_;
    ReceiverCount count_;
    GroundLookup lookup_;
    tbb::enumerable_thread_specific<Easel> easels_;
    std::vector<std::uint64_t> shaded_;  // steps x words: bits of the receivers at each step
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
    if (city.terrain || !receivers.flat())
        return failure("This engine's shadow accrual map lies on flat ground, and this city has terrain",
                       "engine", "Choose the ray reference");
    const std::vector<std::uint32_t> used = buildingsInReach(city, receivers, directions);
    CasterFaces faces = casterFaces(city, used, stop);
    if (stop.stop_requested()) return cancelled();
    auto scene = std::make_unique<AccrualScene>(std::move(faces), receivers, settings_);
    Cost cost;
    cost.buildingsUsed = std::uint32_t(used.size());
    cost.skipped["buildings whose shadow cannot reach a receiver"] = city.buildings.size() - used.size();
    scene->startWith(std::move(cost));
    return scene;
}

std::string ShadowAccrualMap::describe() const {
    return fmt::format("Shadow accrual map, {} texels a side{}, bias {:g} m, on the processor",
                       settings_.mapSize, settings_.texelsOnCells ? " at most, on cells" : "",
                       settings_.biasM);
}

}  // namespace noonmark
