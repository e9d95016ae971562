#include "core/measures/places/place_receivers.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/stop_scope.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/measures/places/place_sums.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

Region regionOfAll(std::span<const Place> places) {
    Region region{"places", {}};
    for (const Place& place : places)
        region.polygons.insert(region.polygons.end(), place.polygons.begin(), place.polygons.end());
    return region;
}

// From multiples of blocks on, in which engines compute: so they find the same, to the last bit, whichever
// places are measured together.
Grid alignToBlocks(const Grid& grid) {
    constexpr int side = ReceiverBlocks::side;
    const auto padding = [&](double edgeM) {
        const auto cells = std::llround(edgeM / grid.cellM);
        return int((cells % side + side) % side);
    };
    const int west = padding(grid.westM), south = padding(grid.southM);
    return {grid.westM - west * grid.cellM, grid.southM - south * grid.cellM, grid.cellM, grid.columns + west,
            grid.rows + south};
}

// Leaves out the cells of `from` that are no receivers in `other`.
void keepCommon(Receivers& from, const Receivers& other) {
    std::erase_if(from.cells, [&](std::uint32_t cell) {
        const bool removed = !isReceiver(other.kind[cell]);
        if (removed) from.kind[cell] = other.kind[cell];
        return removed;
    });
}

/// The squares of the cells that any place touches, as one rectangle a run.
Region regionOfCells(const std::vector<std::vector<CellPart>>& parts, const Grid& grid) {
    std::vector<std::uint32_t> cells;
    for (const auto& ofPlace : parts)
        for (const CellPart& part : ofPlace) cells.push_back(part.cell);
    std::ranges::sort(cells);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    Region region{"places", {}};
    const auto columns = std::uint32_t(grid.columns);
    for (std::size_t i = 0, end = 0; i < cells.size(); i = end) {
        for (end = i + 1;
             end < cells.size() && cells[end] == cells[end - 1] + 1 && cells[end] % columns != 0;)
            ++end;
        const double west = grid.westM + double(cells[i] % columns) * grid.cellM,
                     south = grid.southM + double(cells[i] / columns) * grid.cellM;
        const auto x0 = float(west), y0 = float(south), x1 = float(west + double(end - i) * grid.cellM),
                   y1 = float(south + grid.cellM);
        region.polygons.push_back({{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}});
    }
    return region;
}

/// The cells of one place, bit by bit.
class PlaceCells {
public:
    /// `place`: its polygons.
    PlaceCells(const std::vector<CellPart>& parts, const Receivers& receivers,
               const std::vector<Footprint>& place)
        : receivers_(receivers) {
        for (const CellPart& part : parts)
            if (isReceiver(receivers.kind[part.cell])) cells_.push_back(part.cell);
        shares_.resize(cells_.size());
        for (const CellPart& part : parts)
            if (const auto bit = bitFor(part.cell)) shares_[*bit] += part.share;
        const std::vector<std::uint32_t> centred = collectCells(place, receivers.grid);
        for (const std::uint32_t cell : cells_) beside_.push_back(!std::ranges::binary_search(centred, cell));
        const bool anyCentre = std::ranges::find(beside_, false) != beside_.end();
        if (!anyCentre)
            beside_.assign(cells_.size(), false);  // a narrow place: the nearest centres stand for it
    }

    [[nodiscard]] std::vector<CellSpan> spans() const {
        std::vector<CellSpan> spans;
        for (const std::uint32_t cell : cells_) {
            const auto at = std::ranges::lower_bound(receivers_.cells, cell) - receivers_.cells.begin();
            if (!spans.empty() && spans.back().first + spans.back().count == std::uint32_t(at))
                ++spans.back().count;
            else
                spans.push_back({std::uint32_t(at), 1});
        }
        return spans;
    }

    [[nodiscard]] std::vector<WeightedCell> uneven() const {
        constexpr double rounding = 1e-6;
        std::vector<WeightedCell> cells;
        for (std::uint32_t bit = 0; bit < shares_.size(); ++bit)
            if (beside_[bit] || std::abs(shares_[bit] - 1) > rounding)
                cells.push_back({bit, shares_[bit] - 1, beside_[bit]});
        return cells;
    }

    [[nodiscard]] std::vector<NeighbourCells> neighbours() const {
        std::vector<NeighbourCells> pairs;
        const auto columns = std::uint32_t(receivers_.grid.columns);
        for (std::uint32_t bit = 0; bit < cells_.size(); ++bit) {
            const std::uint32_t cell = cells_[bit];
            if (bit + 1 < cells_.size() && cells_[bit + 1] == cell + 1 && (cell + 1) % columns != 0)
                addPair(pairs, bit, bit + 1);
        }
        for (std::uint32_t bit = 0; bit < cells_.size(); ++bit)
            if (const auto north = bitOf(std::int64_t(cells_[bit]) + columns)) addPair(pairs, bit, *north);
        return pairs;
    }

private:
    static void addPair(std::vector<NeighbourCells>& pairs, std::uint32_t first, std::uint32_t second) {
        if (!pairs.empty()) {
            NeighbourCells& last = pairs.back();
            if (first == last.first + last.count && second == last.second + last.count) {
                ++last.count;
                return;
            }
        }
        pairs.push_back({first, second, 1});
    }

    [[nodiscard]] std::optional<std::uint32_t> bitOf(std::int64_t cell) const {
        const auto found = std::ranges::lower_bound(cells_, cell);
        if (found == cells_.end() || std::int64_t(*found) != cell) return std::nullopt;
        return std::uint32_t(found - cells_.begin());
    }

    /// The cell's own bit, or that of the cell beside it, then of one at its corner.
    [[nodiscard]] std::optional<std::uint32_t> bitFor(std::uint32_t cell) const {
        const int columns = receivers_.grid.columns, column = int(cell % std::uint32_t(columns));
        static constexpr std::array<std::array<int, 2>, 9> beside{
            {{0, 0}, {0, -1}, {-1, 0}, {1, 0}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
        for (const auto& [east, north] : beside) {
            if (column + east < 0 || column + east >= columns) continue;
            if (const auto bit = bitOf(std::int64_t(cell) + std::int64_t(north) * columns + east)) return bit;
        }
        return std::nullopt;
    }

    const Receivers& receivers_;
    std::vector<std::uint32_t> cells_;
    std::vector<double> shares_;
    std::vector<bool> beside_;  // whether the centre lies beside the place
};

void orBits(std::span<std::uint64_t> words, std::size_t bit, std::uint64_t bits) {
    const std::size_t word = bit / 64, shift = bit % 64;
    words[word] |= bits << shift;
    if (shift != 0 && bits >> (64 - shift) != 0) words[word + 1] |= bits >> (64 - shift);
}

/// The open ground of each place, cell by cell.
std::vector<std::vector<CellPart>> listOpenParts(std::span<const City* const> cities,
                                                 std::span<const Place> places, const Grid& grid,
                                                 const std::stop_token& stop) {
    const auto built = findBuiltGround(cities, places);
    std::vector<std::vector<CellPart>> parts(places.size());
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
        const StopScope scope(stop);
        if (!stop.stop_requested()) parts[i] = listCellParts(findOpenGround(places[i], built[i]), grid);
    });
    return parts;
}

std::size_t countOf(std::span<const CellSpan> spans) {
    std::size_t count = 0;
    for (const CellSpan& span : spans) count += span.count;
    return count;
}

}  // namespace

std::size_t PlaceReceivers::cellCount(std::size_t place) const { return countOf(cellsOf[place]); }

std::uint32_t PlaceReceivers::receiverOf(std::size_t place, std::size_t cell) const {
    for (const CellSpan& span : cellsOf[place]) {
        if (cell < span.count) return span.first + std::uint32_t(cell);
        cell -= span.count;
    }
    return std::numeric_limits<std::uint32_t>::max();
}

Result<Receivers> placeCommonReceivers(std::span<const City* const> cities, const Region& region,
                                       const Grid& grid, const std::stop_token& stop) {
    auto common = placeReceiversInPart(*cities.front(), region, grid, stop, WaterCells::ground);
    for (const City* city : cities.subspan(1)) {
        if (!common) return common;
        const auto other = placeReceiversInPart(*city, region, grid, stop, WaterCells::ground);
        if (!other) return other;
        keepCommon(*common, *other);
    }
    return common;
}

Result<PlaceReceivers> placeReceiversOnPlaces(std::span<const City* const> cities,
                                              std::span<const Place> places, const ReceiverSettings& settings,
                                              const std::stop_token& stop) {
    if (places.empty()) return failure("There is no place to measure", "places", "Read or draw places first");
    const auto grid = gridOver(regionOfAll(places), settings).map(alignToBlocks);
    if (!grid) return tl::make_unexpected(grid.error());
    const auto parts = listOpenParts(cities, places, *grid, stop);
    if (stop.stop_requested()) return cancelled();
    const Region touched = regionOfCells(parts, *grid);
    auto common = placeCommonReceivers(cities, touched, *grid, stop);
    if (!common) return tl::make_unexpected(common.error());
    PlaceReceivers placed{.receivers = *std::move(common)};
    placed.cellsOf.resize(places.size());
    placed.unevenOf.resize(places.size());
    placed.neighboursOf.resize(places.size());
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
        if (stop.stop_requested()) return;
        const PlaceCells cells(parts[i], placed.receivers, places[i].polygons);
        placed.cellsOf[i] = cells.spans();
        placed.unevenOf[i] = cells.uneven();
        placed.neighboursOf[i] = cells.neighbours();
    });
    if (stop.stop_requested()) return cancelled();
    return placed;
}

void chooseReceivers(const StepMasks& all, std::span<const CellSpan> spans, StepMasks& chosen) {
    chosen.receivers = countOf(spans);
    chosen.steps = all.steps;
    chosen.words.assign(chosen.steps * chosen.wordsPerStep(), 0);
    for (std::size_t step = 0; step < all.steps; ++step) {
        const auto from = all.at(step);
        const auto to = chosen.at(step);
        std::size_t bit = 0;
        for (const CellSpan& span : spans)
            for (std::uint32_t done = 0; done < span.count; done += 64) {
                const std::uint32_t left = std::min(64U, span.count - done);
                orBits(to, bit, bitsAt(from, span.first + done) & ~std::uint64_t{0} >> (64 - left));
                bit += left;
            }
    }
}

}  // namespace noonmark
