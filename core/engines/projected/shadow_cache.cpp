#include "core/engines/projected/shadow_cache.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>

#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/describe/text.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/common/changed_buildings.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/projected/casters/shadow_casters.h"
#include "core/engines/projected/counting/cached_band.h"
#include "core/engines/projected/projected_shadows.h"

namespace noonmark {

namespace {

CachedPeriod periodOf(const SunSteps& sun, double cellM) {
    CachedPeriod period{sun.steps.size(), computeOffsetsByEight(sun, cellM), {}, findRunStarts(sun)};
    if (!sun.steps.empty()) period.whole = computeOffsets(sun, cellM, 0, sun.steps.size());
    return period;
}

Box2 computeBox(const Grid& grid) {
    Box2 box;
    box.add(glm::vec2(grid.centre(0, 0)));
    box.add(glm::vec2(grid.centre(grid.columns - 1, grid.rows - 1)));
    return box;
}

// Calls `row(first)` with the first cell of each row in which the two lists of cell kinds differ.
void forRowsThatDiffer(const std::vector<CellKind>& a, const std::vector<CellKind>& b, const Grid& grid,
                       const auto& row) {
    const auto columns = std::size_t(grid.columns);
    for (std::size_t first = 0; first < a.size(); first += columns)
        if (std::memcmp(&a[first], &b[first], columns * sizeof(CellKind)) != 0) row(first);
}

bool sameRegion(const std::vector<CellKind>& before, const Receivers& now, const Grid& grid) {
    if (!(grid == now.grid)) return false;
    bool same = true;
    forRowsThatDiffer(before, now.kind, grid, [&](std::size_t first) {
        for (std::size_t cell = first; cell < first + std::size_t(grid.columns); ++cell)
            same &= (before[cell] == CellKind::outside) == (now.kind[cell] == CellKind::outside);
    });
    return same;
}

Error tooMuch(const Grid& grid, std::size_t steps, const ShadowCacheSettings& settings) {
    return {fmt::format("The shadows of {} steps over {} x {} cells need more than {:.0f} MB to be kept",
                        steps, grid.columns, grid.rows, double(settings.memoryBytes) * 1e-6),
            "cached shadows", "Choose a smaller region, larger cells, fewer days or a longer step"};
}

}  // namespace

struct ShadowCache::State {
    ShadowCacheSettings settings;
    SunSteps sun;
    CachedPeriod period;
    ShadowReach reach;
    std::vector<CellKind> kinds;
    Buildings buildings;
    std::vector<CachedBand> bands;
    ShadowField field;
    CacheMemory memory;
    bool whole = false;  ///< the bands hold the shadow of `buildings`

    State(const Receivers& receivers, const SunSteps& steps, const ShadowCacheSettings& chosen)
        : settings(chosen),
          sun(steps),
          period(periodOf(steps, receivers.grid.cellM)),
          reach(steps),
          kinds(receivers.kind),
          field(makeBlankField(receivers, steps)) {
        memory.maximum = chosen.memoryBytes;
        field.engine =
            "Cached shadows: each building's shadow filled as polygons at every step and cached, exact on "
            "flat "
            "ground";
    }

    void begin() {
        whole = false;
        buildings.clear();
        drop();
        for (int row = 0; row < field.grid.rows; row += CachedBand::rows)
            bands.emplace_back(field.grid, row, period.throws.size());
        for (CachedBand& band : bands) band.markAll();
        field.cost.buildingsUsed = 0;
    }

    void drop() {
        bands.clear();
        memory.used = 0;
    }

    // The buildings whose shadow can fall on the grid.
    Buildings reaching(Buildings some) const {
        const Box2 box = computeBox(field.grid);
        std::erase_if(some, [&](const auto& building) {
            return !reach.touches(bounds(*building), double(topM(*building)), box);
        });
        return some;
    }

    // Marks new receivers for counting, and sets cells that are no longer receivers to NaN.
    void remask(const std::vector<CellKind>& now) {
        const auto columns = std::size_t(field.grid.columns);
        forRowsThatDiffer(kinds, now, field.grid, [&](std::size_t first) {
            for (std::size_t cell = first; cell < first + columns; ++cell)
                if (kinds[cell] != now[cell]) remask(cell, now[cell]);
        });
    }

    void remask(std::size_t cell, CellKind now) {
        recount(cellsUnderBuildings, CellKind::building, kinds[cell], now);
        recount(cellsOnWater, CellKind::water, kinds[cell], now);
        kinds[cell] = now;
        const int column = int(cell % std::size_t(field.grid.columns)),
                  row = int(cell / std::size_t(field.grid.columns));
        if (now == CellKind::ground)
            bands[std::size_t(row / CachedBand::rows)].mark(column, row);
        else
            field.grossMin[cell] = field.continuousMin[cell] = std::numeric_limits<float>::quiet_NaN();
    }

    void recount(const char* reason, CellKind kind, CellKind before, CellKind now) {
        if ((before == kind) != (now == kind))
            field.cost.skipped[reason] += std::uint64_t(now == kind) - std::uint64_t(before == kind);
    }

    Result<void> changeTo(const Buildings& now, Progress& progress, const std::stop_token& stop) {
        const Stopwatch watch;
        const ChangedBuildings changed = findChangedBuildings(buildings, now);
        const BuildingCasters removed(reaching(changed.removed), field.grid),
            added(reaching(changed.added), field.grid);
        if (const auto done = change(removed, added, progress, stop); !done) return done;
        updateBuildings(buildings, now, changed.first);
        field.cost.seconds["fill and count"] = watch.seconds();
        field.cost.buildingsUsed += std::uint32_t(added.buildings()) - std::uint32_t(removed.buildings());
        return {};
    }

    // A partial result is invalid.
    Result<void> change(const BuildingCasters& removed, const BuildingCasters& added, Progress& progress,
                        const std::stop_token& stop) {
        whole = false;
        std::atomic<std::size_t> done{0};
        tbb::parallel_for(std::size_t{0}, bands.size(), [&](std::size_t i) {
            bands[i].change(removed, added, period, memory, stop);
            if (stop.stop_requested() || memory.exceeded()) return;
            bands[i].recount(period, kinds, field);
            progress.report(double(++done) / double(bands.size()), NM_TEXT("filling shadows"));
        });
        if (stop.stop_requested()) return cancelled();
        if (memory.exceeded()) return tl::make_unexpected(tooMuch(field.grid, period.steps, settings));
        whole = true;
        return {};
    }

    Result<void> follow(const City& city, const Receivers& receivers, Progress& progress,
                        const std::stop_token& stop) {
        const auto work = [&] {
            if (!whole) begin();
            remask(receivers.kind);
            return changeTo(city.buildings, progress, stop);
        };
        auto done = guardMemory({.where = "cached shadows"}, work, [this] { whole = false; });
        if (!done) drop();
        return done;
    }
};

ShadowCache::ShadowCache(std::unique_ptr<State> cached) : state_(std::move(cached)) {}
ShadowCache::ShadowCache(ShadowCache&&) noexcept = default;
ShadowCache& ShadowCache::operator=(ShadowCache&&) noexcept = default;
ShadowCache::~ShadowCache() = default;

Result<ShadowCache> ShadowCache::make(const City& city, const Receivers& receivers, const SunSteps& sun,
                                      Progress& progress, const std::stop_token& stop,
                                      ShadowCacheSettings settings) {
    if (const auto able = checkGround(city, receivers, ProjectedShadows::able, "The shadow cache"); !able)
        return tl::make_unexpected(able.error());
    const std::uint64_t oneRaster = BitLayout(receivers.grid).words() * sizeof(std::uint64_t);
    if (oneRaster * sun.steps.size() > settings.memoryBytes)
        return tl::make_unexpected(tooMuch(receivers.grid, sun.steps.size(), settings));
    ShadowCache made(std::make_unique<State>(receivers, sun, settings));
    if (const auto done = made.state_->follow(city, receivers, progress, stop); !done)
        return tl::make_unexpected(done.error());
    return made;
}

Result<void> ShadowCache::change(const City& city, const Receivers& receivers, Progress& progress,
                                 const std::stop_token& stop) {
    if (!sameRegion(state_->kinds, receivers, state_->field.grid))
        return failure("The cached shadows are those of another region", "cached shadows",
                       "Make new ones for this region");
    if (const auto able = checkGround(city, receivers, ProjectedShadows::able, "The shadow cache"); !able)
        return able;
    return state_->follow(city, receivers, progress, stop);
}

const ShadowField& ShadowCache::field() const { return state_->field; }
std::uint64_t ShadowCache::bytes() const { return state_->memory.used; }

}  // namespace noonmark
