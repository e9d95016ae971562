#include "core/accumulate/kept_horizons.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <optional>
#include <utility>

#include "core/accumulate/blank_field.h"
#include "core/accumulate/horizon/horizon_case.h"
#include "core/accumulate/horizon/kept_tile.h"
#include "core/progress_share.h"
#include "core/stopwatch.h"

namespace noonmark {

namespace {

// Large tiles sweep faster; small ones waste less of what may stay.
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
    return failure("The kept horizons are those of another region", "kept horizons",
                   "Make new ones for this region");
}

// Whether each cell keeps its number; of roofs alone those that come and go are outside of the region.
bool sameCells(const Receivers& before, const Receivers& now, std::span<const std::uint32_t> changed) {
    const auto outside = [](CellKind kind) { return kind == CellKind::outside; };
    return before.flat() == now.flat() && std::ranges::all_of(changed, [&](std::uint32_t cell) {
               return outside(before.kind[cell]) == outside(now.kind[cell]);
           });
}

tl::unexpected<Error> noPeriod() {
    return failure("There is no period yet whose shadow could change", "kept horizons",
                   "Compute a period first");
}

}  // namespace

struct KeptHorizons::Kept {
    KeptHorizonsSettings settings;
    Receivers receivers;
    KeptWalls walls;
    std::vector<KeptTile> tiles;
    std::optional<CountedPeriod> period;  // none before the first one
    ShadowField field;

    Kept(const KeptHorizonsSettings& chosen, Receivers where, KeptWalls standing)
        : settings(chosen), receivers(std::move(where)), walls(std::move(standing)) {
        makeTiles();
    }

    // Numbers that bins may have.
    [[nodiscard]] std::size_t bins() const { return std::size_t(std::ceil(360 / settings.binDeg)) + 1; }

    void makeTiles() {
        tiles.clear();
        for (const TileBox& box :
             tilesOf(receivers.grid, tileSide(receivers.grid, settings.memoryBytes, bins())))
            tiles.emplace_back(receivers, box, bins());
    }

    void countCity() {
        field.cost.seconds.clear();
        field.cost.buildingsUsed = std::uint32_t(walls.buildings());
        field.cost.skipped[cellsUnderBuildings] =
            std::uint64_t(std::ranges::count(receivers.kind, CellKind::building));
    }

    void begin(const SunSteps& sun) {
        period.emplace(sun, settings.binDeg);
        if (field.continuousMin.size() == receivers.grid.size())
            setPeriod(field, receivers, sun);
        else
            field = blankField(receivers, sun);
        field.engine = fmt::format(
            "Kept horizons: the slope of each receiver's horizon in {} azimuth bins of {} deg, every step of "
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

    // What is half done holds nothing that can be trusted.
    Error outOfMemory() {
        for (KeptTile& tile : tiles) tile.drop();
        period.reset();
        return {"There is not enough memory for this study", "kept horizons",
                "Choose a smaller region or larger cells"};
    }

    std::size_t sweep(KeptTile& tile, ShadowCounts counts, Progress& progress, const std::stop_token& stop) {
        std::size_t swept = 0;
        timed("sweep", [&] { swept = tile.retime(receivers, walls, period->binned(), progress, stop); });
        write(tile, counts, stop);
        return swept;
    }

    // Of the period's suns.
    [[nodiscard]] double lowestTan() const {
        double lowest = 1;
        for (const AzimuthBin& bin : period->binned().bins)
            lowest = std::min(lowest, double(steepnessOf(KeptBin::below(bin))));
        return lowest / (1 - lowest);
    }

    /// Takes what is new and returns what changed of it; nothing where no tile stays: they know it already.
    Result<std::optional<WallChange>> become(const City& city, const Receivers& now,
                                             std::span<const std::uint32_t> changed) {
        if (walls.sameGround(city, now) && sameCells(receivers, now, changed))
            return walls.become(city, lowestTan()).map([](WallChange change) {
                return std::optional(std::move(change));
            });
        KeptWalls others = KeptWalls::of(city, now);
        if (const auto able = others.check(lowestTan()); !able) return tl::make_unexpected(able.error());
        walls = std::move(others);
        receivers = now;
        makeTiles();
        return std::optional<WallChange>();
    }

    void change(KeptTile& tile, std::span<const std::uint32_t> cells, const WallChange& change,
                ShadowCounts counts, Progress& progress, const std::stop_token& stop) {
        const bool dropped = tile.bytes() == 0;
        timed("change",
              [&] { tile.change(receivers, cells, walls, change, *period, settings.binDeg, stop); });
        if (dropped)
            sweep(tile, counts, progress, stop);
        else
            write(tile, counts, stop);
    }

    void write(KeptTile& tile, ShadowCounts counts, const std::stop_token& stop) {
        if (stop.stop_requested()) return;
        timed("count", [&] { tile.writeGross(field, stop); });
        if (counts == ShadowCounts::grossAndRuns)
            timed("runs", [&] { tile.writeRuns(period->binned(), period->runs(), field, stop); });
    }

    // Sweeps again what did not stay.
    void writeRuns(KeptTile& tile, Progress& progress, const std::stop_token& stop) {
        if (tile.bytes() == 0)
            sweep(tile, ShadowCounts::grossAndRuns, progress, stop);
        else
            write(tile, ShadowCounts::grossAndRuns, stop);
        keepWithinMemory(tile);
    }

    // Cells that are no receivers any more hold NaN.
    void mask(std::span<const std::uint32_t> changed) {
        for (const std::uint32_t cell : changed)
            if (!isReceiver(receivers.kind[cell]))
                field.grossMin[cell] = field.continuousMin[cell] = std::numeric_limits<float>::quiet_NaN();
    }

    [[nodiscard]] std::uint64_t bytes() const {
        std::uint64_t sum = 0;
        for (const KeptTile& tile : tiles) sum += tile.bytes();
        return sum;
    }

    void keepWithinMemory(KeptTile& latest) {
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

KeptHorizons::KeptHorizons(std::unique_ptr<Kept> kept) : kept_(std::move(kept)) {}
KeptHorizons::KeptHorizons(KeptHorizons&&) noexcept = default;
KeptHorizons& KeptHorizons::operator=(KeptHorizons&&) noexcept = default;
KeptHorizons::~KeptHorizons() = default;

Result<KeptHorizons> KeptHorizons::make(const City& city, const Receivers& receivers,
                                        KeptHorizonsSettings settings) {
    if (const auto able = checkBinWidth(settings.binDeg); !able) return tl::make_unexpected(able.error());
    return KeptHorizons(std::make_unique<Kept>(settings, receivers, KeptWalls::of(city, receivers)));
}

Result<ShadowField> KeptHorizons::retime(const SunSteps& sun, Progress& progress, std::stop_token stop,
                                         ShadowCounts counts) try {
    if (const auto able = checkHorizonDays(sun); !able) return tl::make_unexpected(able.error());
    kept_->begin(sun);
    if (const auto able = kept_->walls.check(kept_->lowestTan()); !able) {
        kept_->period.reset();
        return tl::make_unexpected(able.error());
    }
    std::size_t swept = 0;
    for (std::size_t i = 0; i < kept_->tiles.size() && !stop.stop_requested(); ++i) {
        ProgressShare ofTile(progress, i, kept_->tiles.size());
        swept += kept_->sweep(kept_->tiles[i], counts, ofTile, stop);
        kept_->keepWithinMemory(kept_->tiles[i]);
    }
    progress.report(1, "sweeping horizons");
    kept_->field.cost.skipped["azimuth bins kept from before (bins x tiles)"] =
        kept_->tiles.size() * kept_->period->binned().bins.size() - swept;
    return kept_->result(counts, stop);
} catch (const std::bad_alloc&) {
    return tl::make_unexpected(kept_->outOfMemory());
}

Result<ShadowField> KeptHorizons::change(const City& city, const Receivers& receivers, Progress& progress,
                                         std::stop_token stop, ShadowCounts counts) try {
    if (!kept_->period) return noPeriod();
    if (const auto same = checkSame(kept_->receivers, receivers); !same)
        return tl::make_unexpected(same.error());
    const std::vector<std::uint32_t> cells = changedReceivers(kept_->receivers, receivers);
    const auto change = kept_->become(city, receivers, cells);
    if (!change) return tl::make_unexpected(change.error());
    kept_->receivers = receivers;
    kept_->countCity();
    const WallChange none;
    const std::span<const std::uint32_t> cellsOfTiles =
        *change ? std::span(cells) : std::span(cells).first(0);
    for (std::size_t i = 0; i < kept_->tiles.size(); ++i) {
        ProgressShare ofTile(progress, i, kept_->tiles.size());
        kept_->change(kept_->tiles[i], cellsOfTiles, *change ? **change : none, counts, ofTile, stop);
        kept_->keepWithinMemory(kept_->tiles[i]);
    }
    kept_->mask(cells);
    progress.report(1, "sweeping horizons");
    return kept_->result(counts, stop);
} catch (const std::bad_alloc&) {
    return tl::make_unexpected(kept_->outOfMemory());
}

Result<ShadowField> KeptHorizons::withRuns(Progress& progress, std::stop_token stop) try {
    if (!kept_->period) return noPeriod();
    for (std::size_t i = 0; i < kept_->tiles.size(); ++i) {
        ProgressShare ofTile(progress, i, kept_->tiles.size());
        kept_->writeRuns(kept_->tiles[i], ofTile, stop);
    }
    progress.report(1, "sweeping horizons");
    return kept_->result(ShadowCounts::grossAndRuns, stop);
} catch (const std::bad_alloc&) {
    return tl::make_unexpected(kept_->outOfMemory());
}

std::uint64_t KeptHorizons::bytes() const { return kept_->bytes(); }

}  // namespace noonmark
