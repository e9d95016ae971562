#include "core/accumulate/inverse_accrual_map.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>

#include "core/accumulate/reach.h"
#include "core/accumulate/shadow_claims.h"
#include "core/accumulate/shadow_lines_opencl.h"
#include "core/accumulate/sources/projected_source_finder.h"
#include "core/accumulate/sources/ray_source_finder.h"
#include "core/stopwatch.h"

namespace noonmark {

namespace {

Grid padded(const Grid& grid, int cells) {
    Grid wide = grid;
    wide.westM -= cells * grid.cellM;
    wide.southM -= cells * grid.cellM;
    wide.columns += 2 * cells;
    wide.rows += 2 * cells;
    return wide;
}

class InverseAccrualScene final : public IntervalScene {
public:
    InverseAccrualScene(std::unique_ptr<SourceFinder> finder, std::uint32_t buildingsUsed,
                        const Receivers& receivers, int margin, std::shared_ptr<ShadowLineDrawer> drawer)
        : receivers_(receivers),
          margin_(margin),
          grid_(padded(receivers.grid, margin)),
          finder_(std::move(finder)),
          drawer_(std::move(drawer)),
          masks_(grid_.size()) {
        cost_.buildingsUsed = buildingsUsed;
    }

    Result<void> shade(const SunInterval& interval, std::span<ShadowMask> masks,
                       std::stop_token stop) override {
        findSources(interval, stop);
        if (stop.stop_requested()) return cancelled();
        const Stopwatch watch;
        openReceivers();
        if (const auto drawn = drawer_->draw(grid_, atFirst_, motionForward(interval), masks_, stop); !drawn)
            return drawn;
        if (const auto drawn = drawer_->draw(grid_, atLast_, motionBackward(interval), masks_, stop); !drawn)
            return drawn;
        takeReceivers(interval.steps, masks);
        cost_.seconds["draw"] += watch.seconds();
        return {};
    }

    Result<void> attribute(const SunInterval& interval, std::span<std::uint64_t> cellSteps,
                           std::stop_token stop) override {
        findSources(interval, stop);
        std::vector<bool> wanted(grid_.size());
        for (const std::uint32_t cell : receivers_.cells) wanted[wideCell(cell)] = true;
        claimSteps(grid_, {atFirst_, atLast_, interval}, wanted, cellSteps, stop);
        if (stop.stop_requested()) return cancelled();
        return {};
    }

    [[nodiscard]] Cost cost() const override { return cost_; }

private:
    // An interval often begins where the last one ended: its sources are there already.
    void findSources(const SunInterval& interval, const std::stop_token& stop) {
        const Stopwatch watch;
        if (knownLast_ && *knownLast_ == interval.first)
            std::swap(atFirst_, atLast_);
        else
            find(interval.first, atFirst_, stop);
        find(interval.last, atLast_, stop);
        knownLast_ = interval.last;
        cost_.seconds["trace"] += watch.seconds();
    }

    void find(glm::dvec3 towardsSun, ShadowSources& sources, const std::stop_token& stop) {
        finder_->find(towardsSun, sources, stop);
        cost_.rays += finder_->raysAnInstant();
    }

    // Only receivers' masks are looked at; the others count as full, for a drawer to pass over.
    void openReceivers() {
        std::ranges::fill(masks_, ~ShadowMask{0});
        for (const std::uint32_t cell : receivers_.cells) masks_[wideCell(cell)] = 0;
    }

    // At t1 and at tn the rays know the answer; lines do not.
    void takeReceivers(int steps, std::span<ShadowMask> masks) const {
        const ShadowMask firstBit = 1, lastBit = ShadowMask{1} << (steps - 1);
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, masks.size(), 8192), [&](const auto& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                const std::size_t cell = wideCell(receivers_.cells[i]);
                const ShadowMask known =
                    (atFirst_.heightM[cell] > 0 ? firstBit : 0) | (atLast_.heightM[cell] > 0 ? lastBit : 0);
                masks[i] = (masks_[cell] & ~(firstBit | lastBit)) | known;
            }
        });
    }

    [[nodiscard]] std::size_t wideCell(std::uint32_t cell) const {
        const int columns = receivers_.grid.columns;
        return grid_.index(int(cell) % columns + margin_, int(cell) / columns + margin_);
    }

    const Receivers& receivers_;
    int margin_;
    Grid grid_;
    std::unique_ptr<SourceFinder> finder_;
    std::shared_ptr<ShadowLineDrawer> drawer_;
    ShadowSources atFirst_, atLast_;
    std::optional<glm::dvec3> knownLast_;
    std::vector<ShadowMask> masks_;  // of the wide grid
    Cost cost_;
};

Result<void> check(const InverseAccrualSettings& settings) {
    if (settings.levels < 1 || settings.levels > RayScene::maxLevels)
        return failure(fmt::format("{} source levels are out of range", settings.levels), "levels",
                       "Choose 1 to 8");
    if (!(settings.nearestHitM >= InverseAccrualSettings::lowestNearestHitM &&
          settings.nearestHitM <= InverseAccrualSettings::highestNearestHitM))
        return failure(fmt::format("A nearest hit of {} m is out of range", settings.nearestHitM),
                       "nearest hit", "Choose 0.01 to 10 m");
    if (!(settings.marginM >= 0 && settings.marginM <= 500))
        return failure(fmt::format("A margin of {} m is out of range", settings.marginM), "margin",
                       "Choose 0 to 500 m");
    return {};
}

Result<std::unique_ptr<SourceFinder>> finderOver(const City& city, const std::vector<std::uint32_t>& used,
                                                 const Grid& grid, const InverseAccrualSettings& settings,
                                                 std::stop_token stop) {
    const float nearest = settings.nearestHitM;
    if (settings.sourceFinder == SourceFinderKind::projected)
        return std::make_unique<ProjectedSourceFinder>(surfaceFacets(city, used, grid, nearest), grid,
                                                       settings.levels, nearest);
    auto scene = RayScene::over(city, used, std::move(stop));
    if (!scene) return tl::make_unexpected(scene.error());
    return std::make_unique<RaySourceFinder>(std::move(*scene), grid, settings.levels, nearest);
}

}  // namespace

InverseAccrualMap::InverseAccrualMap(InverseAccrualSettings settings) : settings_(settings) {}

Result<std::shared_ptr<const InverseAccrualMap>> InverseAccrualMap::make(
    const InverseAccrualSettings& settings) {
    if (const auto ok = check(settings); !ok) return tl::make_unexpected(ok.error());
    std::shared_ptr<InverseAccrualMap> engine(new InverseAccrualMap(settings));
    engine->drawer_ = makeShadowLineDrawer();
    if (settings.openClDevice) {
        auto drawer = makeOpenClDrawer(*settings.openClDevice);
        if (!drawer) return tl::make_unexpected(drawer.error());
        engine->drawer_ = std::move(*drawer);
    }
    return engine;
}

Result<std::unique_ptr<IntervalScene>> InverseAccrualMap::prepare(const City& city,
                                                                  const Receivers& receivers,
                                                                  const SunSteps& directions,
                                                                  std::stop_token stop) const {
    if (city.terrain || !receivers.flat())
        return failure("Inverse accrual maps draw shadows on flat ground only, and this city has terrain",
                       "engine", "Choose the ray reference");
    const std::vector<std::uint32_t> used = buildingsInReach(city, receivers, directions);
    const int margin = int(std::ceil(settings_.marginM / receivers.grid.cellM));
    auto finder = finderOver(city, used, padded(receivers.grid, margin), settings_, std::move(stop));
    if (!finder) return tl::make_unexpected(finder.error());
    return std::make_unique<InverseAccrualScene>(std::move(*finder), std::uint32_t(used.size()), receivers,
                                                 margin, drawer_);
}

std::string InverseAccrualMap::describe() const {
    return fmt::format("Inverse accrual map, {} levels, {}", settings_.levels, drawer_->describe());
}

}  // namespace noonmark
