#include "core/engines/horizon/trees/crown_sweep.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>
#include <utility>

namespace noonmark {

namespace {

constexpr float bandM = 16;  // width of a band

struct LeafySun {
    HorizonCode code;
    bool inLeaf;
};

CrownLevel makeLevel(std::span<const LeafySun> suns) {
    CrownLevel level;
    double angles = 0;
    for (const LeafySun& sun : suns) {
        angles += std::atan(toTangent(sun.code));
        (sun.inLeaf ? level.inLeaf : level.bare) += 1;
    }
    level.tan = float(std::tan(angles / double(suns.size())));
    level.secant = std::sqrt(1 + level.tan * level.tan);
    level.belowCode = float(suns.back().code) + 1;
    level.perCode = 1 / (level.belowCode - float(suns.front().code));
    return level;
}

// By equal numbers of suns; suns of one code stay together.
std::vector<CrownLevel> splitIntoLevels(std::vector<LeafySun> suns) {
    std::ranges::sort(suns, {}, &LeafySun::code);
    std::vector<CrownLevel> levels;
    const std::size_t size = (suns.size() + CrownSweep::maxLevels - 1) / CrownSweep::maxLevels;
    for (std::size_t first = 0; first < suns.size();) {
        std::size_t end = std::min(first + size, suns.size());
        while (end < suns.size() && suns[end].code == suns[end - 1].code) ++end;
        levels.push_back(makeLevel(std::span(suns).subspan(first, end - first)));
        first = end;
    }
    return levels;
}

CrownOnRow shapeOf(const Crown& crown, double datumM) {
    const double heightM = crown.topM - crown.bottomM, r = crown.radiusM;
    CrownOnRow row{};
    row.bottomM = float(crown.bottomM - datumM);
    row.topM = row.pivotM = float(crown.topM - datumM);
    row.inLeafPerM = float(crown.leafOnPerM);
    row.barePerM = float(crown.leafOffPerM);
    row.a = 1;
    if (crown.shape == CrownShape::cylinder) row.c = float(-r * r);
    if (crown.shape == CrownShape::cone) row.q = float(-(r * r) / (heightM * heightM));
    if (crown.shape != CrownShape::ellipsoid) return row;
    row.pivotM = float((crown.bottomM + crown.topM) / 2 - datumM);
    row.a = float(1 / (r * r));
    row.q = float(4 / (heightM * heightM));
    row.c = -1;
    return row;
}

const std::array<HorizonCode, ReceiverBlocks::cells>& levelHorizons() {
    static const auto level = [] {
        std::array<HorizonCode, ReceiverBlocks::cells> none{};
        none.fill(noHorizon);
        return none;
    }();
    return level;
}

HorizonCode findLowestCode(const HorizonCode* codes, std::uint16_t receivers) {
    HorizonCode lowest = std::numeric_limits<HorizonCode>::max();
    for (unsigned cell = 0; cell < unsigned(ReceiverBlocks::side); ++cell)
        if ((receivers >> cell & 1U) != 0) lowest = std::min(lowest, codes[cell]);
    return lowest;
}

}  // namespace

CrownSweep::CrownSweep(const CrownScene& scene, const BinnedSun& binned, const Grid& grid, double datumM)
    : crowns_(scene.crowns), levels_(binned.bins.size()), grid_(grid), datumM_(datumM) {
    std::vector<std::vector<LeafySun>> suns(binned.bins.size());
    for (std::size_t step = 0; step < binned.places.size(); ++step)
        suns[binned.places[step].bin].push_back({binned.places[step].sun, scene.inLeaf[step] != 0});
    for (std::size_t bin = 0; bin < suns.size(); ++bin) {
        levels_[bin] = splitIntoLevels(std::move(suns[bin]));
        away_.push_back(binned.bins[bin].away);
    }
    for (const Crown& crown : crowns_) {
        shapes_.push_back(shapeOf(crown, datumM));
        widestM_ = std::max(widestM_, crown.radiusM);
        highestM_ = std::max(highestM_, crown.topM - datumM);
    }
}

/// A block at one bin.
struct CrownBatch::BlockView {
    std::span<const CrownLevel> levels;
    float aside = 0, ahead = 0;  // of its first cell, metres
    float asidePerRow = 0, aheadPerRow = 0, asidePerCell = 0, aheadPerCell = 0;
    const ReceiverBlocks::Masks* masks = nullptr;
    const HorizonCode* codes = nullptr;
    bool swapped = false;
    const CacheLine<float>* groundM = nullptr;
    float lowestTan = 0;              // of the suns that some cell sees
    float lowestM = 0, highestM = 0;  // ground of its cells above the datum
    std::array<std::size_t, rowCells>
        visible{};  // first level of each row that no horizon hides from all cells

    [[nodiscard]] bool isReceiver(std::size_t row, std::size_t cell) const {
        return ((*masks)[row] >> cell & 1U) != 0;
    }
    // Of the values at the corners of the block, which change by so much along its rows and columns.
    [[nodiscard]] static float lowest(float first, float perRow, float perCell) {
        return first + (std::min(0.0F, perRow) + std::min(0.0F, perCell)) * float(rowCells - 1);
    }
    [[nodiscard]] static float highest(float first, float perRow, float perCell) {
        return first + (std::max(0.0F, perRow) + std::max(0.0F, perCell)) * float(rowCells - 1);
    }
};

void CrownBatch::begin(const CrownSweep& sweep, std::size_t first, std::size_t end) {
    sweep_ = &sweep;
    firstBin_ = first;
    bands_.resize(end - first);
    for (std::size_t bin = first; bin < end; ++bin) place(sweep, bin, bands_[bin - first]);
}

// Sorted by all that tells crowns apart, so that sums do not depend on threads.
void CrownBatch::place(const CrownSweep& sweep, std::size_t bin, Bands& bands) {
    const glm::dvec2 away = sweep.away(bin), right(-away.y, away.x);
    const glm::dvec2 corner(sweep.grid().westM, sweep.grid().southM);
    bands.crowns.clear();
    float lowest = std::numeric_limits<float>::max(), highest = -lowest;
    for (std::uint32_t i = 0; i < sweep.crowns().size(); ++i) {
        const glm::dvec2 place = glm::dvec2(sweep.crowns()[i].x, sweep.crowns()[i].y) - corner;
        const PlacedCrown placed{float(glm::dot(place, right)), float(-glm::dot(place, away)), i};
        lowest = std::min(lowest, placed.aside);
        highest = std::max(highest, placed.aside);
        bands.crowns.push_back(placed);
    }
    bands.lowest = lowest;
    const auto bandOf = [&](const PlacedCrown& crown) { return std::size_t((crown.aside - lowest) / bandM); };
    std::ranges::sort(bands.crowns, {}, [&](const PlacedCrown& crown) {
        return std::tuple(bandOf(crown), crown.ahead, crown.crown);
    });
    bands.first.assign(std::size_t((highest - lowest) / bandM) + 2, 0);
    for (const PlacedCrown& crown : bands.crowns) ++bands.first[bandOf(crown) + 1];
    for (std::size_t band = 1; band < bands.first.size(); ++band) bands.first[band] += bands.first[band - 1];
}

void CrownBatch::add(std::size_t bin, std::size_t blockIndex, const ReceiverBlocks& blocks,
                     const HorizonCode* codes, bool swapped, const BlockGround& ground, CrownSums& sums) {
    BlockView view = viewOf(bin, blocks.blocks()[blockIndex], swapped);
    view.masks = &blocks.masks(blockIndex, swapped);
    view.codes = codes == nullptr ? levelHorizons().data() : codes;
    setGround(view, ground);
    if (findVisible(view)) {
        addCrowns(bands_[bin - firstBin_], view);
        for (std::size_t row = 0; row < rowCells; ++row)
            if (touchedFrom_[row] < touchedTo_[row]) countRow(row, blockIndex, view, sums);
    }
    gaps_.clear();
}

CrownBatch::BlockView CrownBatch::viewOf(std::size_t bin, const ReceiverBlocks::Block& block,
                                         bool swapped) const {
    const glm::dvec2 away = sweep_->away(bin), right(-away.y, away.x);
    const double cellM = sweep_->grid().cellM;
    const glm::dvec2 first(cellM * (block.column + 0.5), cellM * (block.row + 0.5));
    const glm::dvec2 toNextCell = swapped ? glm::dvec2(0, cellM) : glm::dvec2(cellM, 0);
    const glm::dvec2 toNextRow = swapped ? glm::dvec2(cellM, 0) : glm::dvec2(0, cellM);
    BlockView view;
    view.levels = sweep_->levels(bin);
    view.aside = float(glm::dot(first, right));
    view.ahead = float(-glm::dot(first, away));
    view.asidePerRow = float(glm::dot(toNextRow, right));
    view.aheadPerRow = float(-glm::dot(toNextRow, away));
    view.asidePerCell = float(glm::dot(toNextCell, right));
    view.aheadPerCell = float(-glm::dot(toNextCell, away));
    view.swapped = swapped;
    return view;
}

void CrownBatch::setGround(BlockView& view, const BlockGround& ground) {
    if (ground.rowsM == nullptr) return;
    view.groundM = ground.rowsM;
    view.lowestM = view.highestM = ground.lowestM;
    for (std::size_t row = 0; row < rowCells; ++row)
        for (std::size_t cell = 0; cell < rowCells; ++cell)
            if (view.isReceiver(row, cell))
                view.highestM = std::max(view.highestM, ground.rowsM[row].values[cell]);
}

// Whether any cell sees a sun.
bool CrownBatch::findVisible(BlockView& view) {
    std::size_t lowestVisible = view.levels.size();
    for (std::size_t row = 0; row < rowCells; ++row) {
        touchedFrom_[row] = touchedTo_[row] = 0;
        const std::uint16_t receivers = (*view.masks)[row];
        const auto lowest = receivers == 0 ? std::numeric_limits<float>::max()
                                           : float(findLowestCode(view.codes + row * rowCells, receivers));
        const auto first = std::ranges::find_if(
            view.levels, [&](const CrownLevel& level) { return level.belowCode > lowest; });
        view.visible[row] = std::size_t(first - view.levels.begin());
        lowestVisible = std::min(lowestVisible, view.visible[row]);
    }
    if (lowestVisible == view.levels.size()) return false;
    view.lowestTan = view.levels[lowestVisible].tan;
    return true;
}

void CrownBatch::addCrowns(const Bands& bands, const BlockView& view) {
    const auto widest = float(sweep_->widestM());
    const float low = BlockView::lowest(view.aside, view.asidePerRow, view.asidePerCell) - widest;
    const float high = BlockView::highest(view.aside, view.asidePerRow, view.asidePerCell) + widest;
    const int bandCount = int(bands.first.size()) - 1;
    const int firstBand = std::max(0, int(std::floor((low - bands.lowest) / bandM)));
    const int lastBand = std::min(bandCount - 1, int(std::floor((high - bands.lowest) / bandM)));
    const float nearest = BlockView::lowest(view.ahead, view.aheadPerRow, view.aheadPerCell) - widest;
    const float reachM = std::max(0.0F, float(sweep_->highestM()) - view.lowestM) / view.lowestTan;
    const float farthest =
        BlockView::highest(view.ahead, view.aheadPerRow, view.aheadPerCell) + widest + reachM;
    for (int band = firstBand; band <= lastBand; ++band) {
        const auto crowns = std::span(bands.crowns)
                                .subspan(bands.first[std::size_t(band)],
                                         bands.first[std::size_t(band) + 1] - bands.first[std::size_t(band)]);
        auto crown = std::ranges::lower_bound(crowns, nearest, {}, &PlacedCrown::ahead);
        for (; crown != crowns.end() && crown->ahead <= farthest; ++crown) addCrown(*crown, view);
    }
}

void CrownBatch::countRow(std::size_t row, std::size_t blockIndex, const BlockView& view, CrownSums& sums) {
    const std::size_t from = touchedFrom_[row], to = touchedTo_[row];
    alignas(64) float evergreen[rowCells], seasonal[rowCells];
    weighRow(view.levels.subspan(from, to - from), inLeaf_[row][from], bare_[row][from],
             view.codes + row * rowCells, evergreen, seasonal);
    for (const HiddenGap& gap : gaps_) {
        const std::size_t gapRow = view.swapped ? gap.cell % rowCells : gap.cell / rowCells;
        const std::size_t cell = view.swapped ? gap.cell / rowCells : gap.cell % rowCells;
        if (gapRow == row) takeGap(gap, row, cell, view, evergreen[cell], seasonal[cell]);
    }
    for (std::size_t cell = 0; cell < rowCells; ++cell)
        if (evergreen[cell] > 0)
            sums.add(blockIndex, view.swapped ? cell * rowCells + row : row * rowCells + cell,
                     evergreen[cell], std::max(0.0F, seasonal[cell]));
}

// Suns that an overhang hides are not the crowns'.
void CrownBatch::takeGap(const HiddenGap& gap, std::size_t row, std::size_t cell, const BlockView& view,
                         float& evergreen, float& seasonal) const {
    for (std::size_t i = touchedFrom_[row]; i < touchedTo_[row]; ++i) {
        const CrownLevel& level = view.levels[i];
        const auto above = [&](HorizonCode code) {
            return std::clamp((level.belowCode - float(code)) * level.perCode, 0.0F, 1.0F);
        };
        const float hidden = above(gap.low) - above(gap.high);
        if (hidden <= 0) continue;
        const float taken = -std::expm1(-inLeaf_[row][i][cell]),
                    takenBare = -std::expm1(-bare_[row][i][cell]);
        evergreen -= hidden * (level.inLeaf + level.bare) * taken;
        seasonal -= hidden * (level.inLeaf * taken + level.bare * takenBare);
    }
}

void CrownBatch::addCrown(const PlacedCrown& placed, const BlockView& view) {
    const Crown& crown = sweep_->crowns()[placed.crown];
    const auto r = float(crown.radiusM);
    const float last = rowCells - 1;
    const float nearest = placed.ahead - BlockView::highest(view.ahead, view.aheadPerRow, view.aheadPerCell);
    const float farthest = placed.ahead - BlockView::lowest(view.ahead, view.aheadPerRow, view.aheadPerCell);
    const float overM = float(crown.topM - sweep_->datumM()) - view.lowestM;
    if (farthest < -r || overM <= 0 || (nearest - r) * view.lowestTan > overM) return;
    for (int row = 0; row < int(rowCells); ++row) {
        const float aside = placed.aside - view.aside - view.asidePerRow * float(row);
        const float other = aside - view.asidePerCell * last;
        if (std::min(aside, other) > r || std::max(aside, other) < -r) continue;
        addToRow(placed.crown, view, row, placed.ahead - view.ahead - view.aheadPerRow * float(row), aside);
    }
}

// At the levels whose rays from some cell of the row may meet the crown.
void CrownBatch::addToRow(std::size_t crown, const BlockView& view, int row, float distance, float aside) {
    CrownOnRow on = sweep_->shape(crown);
    on.distance = distance;
    on.distanceStep = -view.aheadPerCell;
    on.aside = aside;
    on.asideStep = -view.asidePerCell;
    if (view.groundM != nullptr) on.groundM = view.groundM[row].values;
    const auto r = float(sweep_->crowns()[crown].radiusM);
    const float other = distance + on.distanceStep * float(rowCells - 1);
    const float nearest = std::min(distance, other) - r, farthest = std::max(distance, other) + r;
    if (farthest <= 0) return;
    const float steepest =
        nearest > 0 ? (on.topM - view.lowestM) / nearest : std::numeric_limits<float>::max();
    const float flattest = std::max(0.0F, on.bottomM - view.highestM) / farthest;
    std::size_t first = view.visible[std::size_t(row)], end = view.levels.size();
    while (first < end && view.levels[first].tan < flattest) ++first;
    while (end > first && view.levels[end - 1].tan > steepest) --end;
    if (first == end) return;
    touch(row, first, end);
    addCrownToRow(on, view.levels.subspan(first, end - first), inLeaf_[row][first], bare_[row][first]);
}

// Levels count from zero where a crown first comes before them.
void CrownBatch::touch(int row, std::size_t first, std::size_t end) {
    std::size_t &from = touchedFrom_[row], &to = touchedTo_[row];
    const auto clear = [&](std::size_t low, std::size_t high) {
        for (std::size_t level = low; level < high; ++level) {
            std::ranges::fill(inLeaf_[row][level], 0.0F);
            std::ranges::fill(bare_[row][level], 0.0F);
        }
    };
    if (from == to) {
        clear(first, end);
        from = first;
        to = end;
        return;
    }
    if (first < from) clear(first, from);
    if (end > to) clear(to, end);
    from = std::min(from, first);
    to = std::max(to, end);
}

}  // namespace noonmark
