#include "core/engines/horizon/cache/horizon_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/describe/text.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/horizon/cache/cached_tile.h"
#include "core/engines/horizon/horizon_sweep.h"

namespace noonmark {

namespace {

// Large tiles are swept faster; small ones make better use of limited memory.
int tileSide(const Grid& grid, std::uint64_t memoryBytes, std::size_t bins) {
    int side = 1024;
    const auto bytes = [&] {
        return std::uint64_t(std::min(side, grid.columns)) * std::uint64_t(std::min(side, grid.rows)) * bins *
               sizeof(HorizonCode);
    };
    while (side > 128 && bytes() > memoryBytes) side /= 2;
    return side;
}

Result<void> checkSame(const Receivers& before, const Receivers& now) {
    if (before.grid == now.grid) return {};
    return failure("The cached horizons are those of another region", "cached horizons",
                   "Make new ones for this region");
}

// Whether each cell keeps its number. If only roofs are receivers, cells without a roof count as outside the
// region, so numbers change with the roofs.
bool sameCells(const Receivers& before, const Receivers& now, std::span<const std::uint32_t> changed) {
    const auto outside = [](CellKind kind) { return kind == CellKind::outside; };
    return before.flat() == now.flat() && std::ranges::all_of(changed, [&](std::uint32_t cell) {
               return outside(before.kind[cell]) == outside(now.kind[cell]);
           });
}

tl::unexpected<Error> noPeriod() {
    return failure("There is no period yet whose shadow could change", "cached horizons",
                   "Compute a period first");
}

}  // namespace

struct HorizonCache::State {
    HorizonCacheSettings settings;
    Receivers receivers;
    WallCache walls;
    std::vector<CachedTile> tiles;
    std::optional<CountedPeriod> period;  // empty before the first period
    ShadowField field;

    State(const HorizonCacheSettings& chosen, Receivers where, WallCache standing)
        : settings(chosen), receivers(std::move(where)), walls(std::move(standing)) {
        makeTiles();
    }

    // Number of possible bin numbers.
    [[nodiscard]] std::size_t bins() const { return std::size_t(std::ceil(360 / settings.binDeg)) + 1; }

    void makeTiles() {
        tiles.clear();
        for (const TileBox& box :
             splitIntoTiles(receivers.grid, tileSide(receivers.grid, settings.memoryBytes, bins())))
            tiles.emplace_back(receivers, box, bins());
    }

    void countCity() {
        field.cost.seconds.clear();
        field.cost.buildingsUsed = std::uint32_t(walls.buildings());
        countSkippedCells(field.cost, receivers);
    }

    void begin(const SunSteps& sun) {
        period.emplace(sun, settings.binDeg);
        if (field.continuousMin.size() == receivers.grid.size())
            setPeriod(field, receivers, sun);
        else
            field = makeBlankField(receivers, sun);
        field.engine = fmt::format(
            "Cached horizons: the slope of each receiver's horizon in {} azimuth bins of {} deg, every step "
            "of "
            "every day counted",
            period->binned().bins.size(), settings.binDeg);
        field.cost.buildingsUsed = std::uint32_t(walls.buildings());
    }

    template <class Work>
    void timed(const char* stage, Work&& work) {
        const Stopwatch watch;
        work();
        field.cost.seconds[stage] += watch.seconds();
    }

    // Partial results are invalid, so everything is dropped.
    Result<ShadowField> guarded(const auto& work) {
        return guardMemory({.where = "cached horizons"}, work, [this] {
            for (CachedTile& tile : tiles) tile.drop();
            period.reset();
        });
    }

    std::size_t sweep(CachedTile& tile, ShadowCounts counts, Progress& progress,
                      const std::stop_token& stop) {
        std::size_t swept = 0;
        timed("sweep",
              [&] { swept = tile.computePeriod(receivers, walls, period->binned(), progress, stop); });
        write(tile, counts, stop);
        return swept;
    }

    // Of the period's suns.
    [[nodiscard]] double lowestTan() const {
        double lowest = 1;
        for (const AzimuthBin& bin : period->binned().bins)
            lowest = std::min(lowest, double(toSteepness(CachedBin::below(bin))));
        return lowest / (1 - lowest);
    }

    /// Updates the occluders and returns the change; nothing if the tiles had to be rebuilt, since new tiles
    /// include it.
    Result<std::optional<WallChange>> update(const City& city, const Receivers& now,
                                             std::span<const std::uint32_t> changed) {
        if (walls.sameGround(city, now) && sameCells(receivers, now, changed))
            return walls.update(city, lowestTan()).map([](WallChange change) {
                return std::optional(std::move(change));
            });
        WallCache others = WallCache::of(city, now);
        if (const auto able = others.check(lowestTan()); !able) return tl::make_unexpected(able.error());
        walls = std::move(others);
        receivers = now;
        makeTiles();
        return std::optional<WallChange>();
    }

    void change(CachedTile& tile, std::span<const std::uint32_t> cells, const WallChange& change,
                ShadowCounts counts, Progress& progress, const std::stop_token& stop) {
        const bool dropped = tile.bytes() == 0;
        timed("change",
              [&] { tile.change(receivers, cells, walls, change, *period, settings.binDeg, stop); });
        if (dropped)
            sweep(tile, counts, progress, stop);
        else
            write(tile, counts, stop);
    }

    void write(CachedTile& tile, ShadowCounts counts, const std::stop_token& stop) {
        if (stop.stop_requested()) return;
        timed("count", [&] { tile.writeGross(field, stop); });
        if (counts == ShadowCounts::grossAndRuns)
            timed("runs", [&] { tile.writeRuns(period->binned(), period->runs(), field, stop); });
    }

    // Sweeps tiles again that are not cached.
    void writeRuns(CachedTile& tile, Progress& progress, const std::stop_token& stop) {
        if (tile.bytes() == 0)
            sweep(tile, ShadowCounts::grossAndRuns, progress, stop);
        else
            write(tile, ShadowCounts::grossAndRuns, stop);
        keepWithinMemory(tile);
    }

    // Cells that are no longer receivers hold NaN.
    void mask(std::span<const std::uint32_t> changed) {
        for (const std::uint32_t cell : changed)
            if (!isReceiver(receivers.kind[cell]))
                field.grossMin[cell] = field.continuousMin[cell] = std::numeric_limits<float>::quiet_NaN();
    }

    [[nodiscard]] std::uint64_t bytes() const {
        std::uint64_t sum = 0;
        for (const CachedTile& tile : tiles) sum += tile.bytes();
        return sum;
    }

    void keepWithinMemory(CachedTile& latest) {
        if (bytes() > settings.memoryBytes) latest.dropPages();
        if (bytes() > settings.memoryBytes) latest.drop();
    }

    Result<ShadowField> result(ShadowCounts counts, const std::stop_token& stop) {
        if (stop.stop_requested()) {
            period.reset();
            return cancelled();
        }
        if (counts == ShadowCounts::grossAndRuns) return field;
        auto runs = std::exchange(field.continuousMin, {});
        ShadowField gross = field;
        field.continuousMin = std::move(runs);
        gross.continuousMin.assign(gross.grossMin.size(), std::numeric_limits<float>::quiet_NaN());
        return gross;
    }
};

HorizonCache::HorizonCache(std::unique_ptr<State> cached) : state_(std::move(cached)) {}
HorizonCache::HorizonCache(HorizonCache&&) noexcept = default;
HorizonCache& HorizonCache::operator=(HorizonCache&&) noexcept = default;
HorizonCache::~HorizonCache() = default;

Result<HorizonCache> HorizonCache::make(const City& city, const Receivers& receivers,
                                        HorizonCacheSettings settings) {
    if (const auto able = checkBinWidth(settings.binDeg); !able) return tl::make_unexpected(able.error());
    return HorizonCache(std::make_unique<State>(settings, receivers, WallCache::of(city, receivers)));
}

Result<ShadowField> HorizonCache::computePeriod(const SunSteps& sun, Progress& progress, std::stop_token stop,
                                                ShadowCounts counts) {
    return state_->guarded([&]() -> Result<ShadowField> {
        if (const auto able = checkHorizonDays(sun); !able) return tl::make_unexpected(able.error());
        state_->begin(sun);
        if (const auto able = state_->walls.check(state_->lowestTan()); !able) {
            state_->period.reset();
            return tl::make_unexpected(able.error());
        }
        std::size_t swept = 0;
        for (std::size_t i = 0; i < state_->tiles.size() && !stop.stop_requested(); ++i) {
            ProgressShare ofTile(progress, i, state_->tiles.size());
            swept += state_->sweep(state_->tiles[i], counts, ofTile, stop);
            state_->keepWithinMemory(state_->tiles[i]);
        }
        progress.report(1, NM_TEXT("sweeping horizons"));
        state_->field.cost.skipped["azimuth bins in the cache (bins x tiles)"] =
            state_->tiles.size() * state_->period->binned().bins.size() - swept;
        return state_->result(counts, stop);
    });
}

Result<ShadowField> HorizonCache::change(const City& city, const Receivers& receivers, Progress& progress,
                                         std::stop_token stop, ShadowCounts counts) {
    return state_->guarded([&]() -> Result<ShadowField> {
        if (!state_->period) return noPeriod();
        if (const auto same = checkSame(state_->receivers, receivers); !same)
            return tl::make_unexpected(same.error());
        const std::vector<std::uint32_t> cells = findChangedReceivers(state_->receivers, receivers);
        const auto change = state_->update(city, receivers, cells);
        if (!change) return tl::make_unexpected(change.error());
        state_->receivers = receivers;
        state_->countCity();
        const WallChange none;
        const std::span<const std::uint32_t> cellsOfTiles =
            *change ? std::span(cells) : std::span(cells).first(0);
        for (std::size_t i = 0; i < state_->tiles.size(); ++i) {
            ProgressShare ofTile(progress, i, state_->tiles.size());
            state_->change(state_->tiles[i], cellsOfTiles, *change ? **change : none, counts, ofTile, stop);
            state_->keepWithinMemory(state_->tiles[i]);
        }
        state_->mask(cells);
        progress.report(1, NM_TEXT("sweeping horizons"));
        return state_->result(counts, stop);
    });
}

Result<ShadowField> HorizonCache::withRuns(Progress& progress, std::stop_token stop) {
    return state_->guarded([&]() -> Result<ShadowField> {
        if (!state_->period) return noPeriod();
        for (std::size_t i = 0; i < state_->tiles.size(); ++i) {
            ProgressShare ofTile(progress, i, state_->tiles.size());
            state_->writeRuns(state_->tiles[i], ofTile, stop);
        }
        progress.report(1, NM_TEXT("sweeping horizons"));
        return state_->result(ShadowCounts::grossAndRuns, stop);
    });
}

std::uint64_t HorizonCache::bytes() const { return state_->bytes(); }

}  // namespace noonmark
