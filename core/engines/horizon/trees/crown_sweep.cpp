#include "core/engines/horizon/trees/crown_sweep.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>

namespace noonmark {

namespace {

constexpr std::size_t side = ReceiverBlocks::side;

struct LeafySun {
    HorizonCode code;
    bool inLeaf;
    std::uint16_t set;
};

// `suns`: of the level, ascending.
void setWeights(std::span<const LeafySun> suns, std::size_t level, CrownLevels& levels) {
    for (const LeafySun& sun : suns) (sun.inLeaf ? levels.inLeaf : levels.bare)[level] += 1;
    levels.belowCode[level] = float(suns.back().code) + 1;
    levels.perCode[level] = 1 / (levels.belowCode[level] - float(suns.front().code));
    levels.weighed = std::uint16_t(levels.weighed | 1U << level);
}

void addLevel(std::span<const LeafySun> suns, CrownLevels& levels) {
    const std::size_t i = levels.count++;
    double angles = 0;
    for (const LeafySun& sun : suns) angles += std::atan(toTangent(sun.code));
    const double angle = angles / double(suns.size());
    levels.tan[i] = float(std::tan(angle));
    levels.perTan[i] = float(1 / std::tan(angle));
    levels.secant[i] = float(1 / std::cos(angle));
    setWeights(suns, i, levels);
}

// Months have their suns of one azimuth at few altitudes: those of each level count from where its own begin.
void addWeightsOfSets(std::vector<LeafySun> suns, std::size_t level,
                      std::map<std::size_t, CrownLevels>& ofSets) {
    std::ranges::stable_sort(suns, {}, &LeafySun::set);
    for (std::size_t first = 0, end = 0; first < suns.size(); first = end) {
        while (end < suns.size() && suns[end].set == suns[first].set) ++end;
        setWeights(std::span(suns).subspan(first, end - first), level, ofSets[suns[first].set]);
    }
}

/// The levels of a bin, and the same by set.
struct LevelsOfBin {
    CrownLevels all;
    std::vector<CrownLevelsOfSet> ofSets;
};

// By equal numbers of suns, but for the first and last; suns of one code stay together. Levels of
// neighbouring bins begin at different shares of their suns, by the golden ratio, because crowns have edges
// at the same altitude in many bins: errors at equal levels would add up instead of cancelling out.
LevelsOfBin splitIntoLevels(std::size_t bin, std::vector<LeafySun> suns) {
    constexpr double goldenRatio = 0.6180339887498949;
    std::ranges::sort(suns, {}, &LeafySun::code);
    CrownLevels levels;
    std::map<std::size_t, CrownLevels> ofSets;
    const double size = std::max(1.0, double(suns.size()) / double(CrownSweep::maxLevels - 1));
    const double share = double(bin + 1) * goldenRatio;
    double limit = size * (share - std::floor(share));
    for (std::size_t first = 0; first < suns.size(); limit += size) {
        const bool last = levels.count + 1 == CrownSweep::maxLevels;
        std::size_t end = last ? suns.size() : std::min(std::size_t(std::lround(limit)), suns.size());
        if (end <= first) continue;
        while (end < suns.size() && suns[end].code == suns[end - 1].code) ++end;
        const std::span<const LeafySun> own = std::span(suns).subspan(first, end - first);
        addLevel(own, levels);
        addWeightsOfSets({own.begin(), own.end()}, levels.count - 1, ofSets);
        first = end;
    }
    LevelsOfBin split{levels, {}};
    for (const auto& [set, own] : ofSets) split.ofSets.push_back({set, own});
    return split;
}

CrownOnBlock shapeOf(const Crown& crown, double datumM) {
    return {.bottomM = float(crown.bottomM - datumM),
            .topM = float(crown.topM - datumM),
            .radiusM = float(crown.radiusM),
            .inLeafPerM = float(crown.leafOnPerM),
            .barePerM = float(crown.leafOffPerM),
            .shape = crown.shape};
}

const std::array<HorizonCode, ReceiverBlocks::cells>& levelHorizons() {
    static const auto level = [] {
        std::array<HorizonCode, ReceiverBlocks::cells> none{};
        none.fill(noHorizon);
        return none;
    }();
    return level;
}

}  // namespace

void CrownSums::begin(std::size_t sets, std::size_t blocks, std::size_t steps) {
    constexpr double finest = 4096;
    const double maximum = double(std::numeric_limits<std::int32_t>::max()) / double(steps + 1);
    fractions_ = float(std::min(finest, std::exp2(std::floor(std::log2(maximum)))));
    blocksOfSet_ = blocks;
    blocks_.assign(2 * sets * blocks, {});
}

CrownSums::Steps CrownSums::steps(std::size_t set, std::size_t block, std::size_t cell) const {
    const std::size_t first = 2 * (set * blocksOfSet_ + block);
    const Block &straight = blocks_[first], &swapped = blocks_[first + 1];
    const std::size_t other = cell % side * side + cell / side;
    const auto sum = [&](std::int32_t a, std::int32_t b) {
        return (double(a) + double(b)) / double(fractions_);
    };
    return {sum(straight.evergreen[cell], swapped.evergreen[other]),
            sum(straight.seasonal[cell], swapped.seasonal[other])};
}

CrownSweep::CrownSweep(const CrownScene& scene, const BinnedSun& binned, const StepSets& sets,
                       const Grid& grid, double datumM)
    : cellM_(grid.cellM), steps_(binned.places.size()), sets_(sets.names.size()) {
    std::vector<std::vector<LeafySun>> suns(binned.bins.size());
    for (std::size_t step = 0; step < binned.places.size(); ++step)
        suns[binned.places[step].bin].push_back(
            {binned.places[step].sun, scene.inLeaf[step] != 0, sets.ofStep[step]});
    for (std::size_t bin = 0; bin < suns.size(); ++bin) {
        LevelsOfBin split = splitIntoLevels(bin, std::move(suns[bin]));
        levels_.push_back(split.all);
        levelsOfSets_.push_back(std::move(split.ofSets));
        away_.push_back(binned.bins[bin].away);
    }
    for (const Crown& crown : scene.crowns) {
        places_.emplace_back(crown.x - grid.westM, crown.y - grid.southM);
        crowns_.push_back(shapeOf(crown, datumM));
        widestM_ = std::max(widestM_, crowns_.back().radiusM);
        highestM_ = std::max(highestM_, crowns_.back().topM);
    }
}

/// A block at one bin.
struct CrownBatch::BlockView {
    const CrownLevels& levels;
    float aside = 0, ahead = 0;  // of its first cell, metres
    float asidePerRow = 0, aheadPerRow = 0, asidePerCell = 0, aheadPerCell = 0;
    float lowAside = 0, highAside = 0, lowAhead = 0, highAhead = 0;  // of its cells
    bool swapped = false;
    CrownGround ground;
    float lowestTan = 0;                        // of the levels that some cell sees
    std::array<std::uint16_t, side> visible{};  // levels that some cell of each row sees, as bits
};

std::size_t CrownBatch::Squares::at(const PlacedCrown& crown) const {
    const auto band = std::size_t((crown.aside - lowestAside) * perM);
    return band * std::size_t(inBand) + std::size_t((crown.ahead - lowestAhead) * perM);
}

// May return more than those between the two.
std::span<const CrownBatch::PlacedCrown> CrownBatch::Squares::find(int band, float nearest,
                                                                   float farthest) const {
    const float from = std::max(0.0F, (nearest - lowestAhead) * perM), to = (farthest - lowestAhead) * perM;
    if (to < 0 || from >= float(inBand)) return {};
    const auto last = std::size_t(std::min(float(inBand - 1), to));
    const std::size_t row = std::size_t(band) * std::size_t(inBand);
    const std::uint32_t begin = first[row + std::size_t(from)], end = first[row + last + 1];
    return std::span(crowns).subspan(begin, end - begin);
}

void CrownBatch::begin(const CrownSweep& sweep, std::size_t first, std::size_t end) {
    sweep_ = &sweep;
    firstBin_ = first;
    squares_.resize(end - first);
    for (std::size_t bin = first; bin < end; ++bin) place(sweep, bin, squares_[bin - first]);
}

// A counting sort, which leaves crowns of a square in their order, so that sums do not depend on threads.
void CrownBatch::place(const CrownSweep& sweep, std::size_t bin, Squares& squares) {
    const glm::dvec2 away = sweep.away(bin), right(-away.y, away.x);
    glm::vec2 low(std::numeric_limits<float>::max()), high(-low);
    unsorted_.clear();
    for (std::uint32_t i = 0; i < sweep.places().size(); ++i) {
        const glm::vec2 at(glm::dot(sweep.places()[i], right), -glm::dot(sweep.places()[i], away));
        unsorted_.push_back({at.x, at.y, i});
        low = glm::vec2(std::min(low.x, at.x), std::min(low.y, at.y));
        high = glm::vec2(std::max(high.x, at.x), std::max(high.y, at.y));
    }
    constexpr float narrowestM = 16;
    const glm::vec2 extent = high - low;
    const float sideM = std::max(narrowestM, std::sqrt(extent.x * extent.y / float(4 * unsorted_.size())));
    squares.lowestAside = low.x;
    squares.lowestAhead = low.y;
    squares.perM = 1 / sideM;
    squares.bands = int(extent.x * squares.perM) + 1;
    squares.inBand = int(extent.y * squares.perM) + 1;
    squares.first.assign(std::size_t(squares.bands) * std::size_t(squares.inBand) + 2, 0);
    for (const PlacedCrown& crown : unsorted_) ++squares.first[squares.at(crown) + 2];
    for (std::size_t i = 2; i < squares.first.size(); ++i) squares.first[i] += squares.first[i - 1];
    squares.crowns.resize(unsorted_.size());
    for (const PlacedCrown& crown : unsorted_) squares.crowns[squares.first[squares.at(crown) + 1]++] = crown;
}

void CrownBatch::add(std::size_t bin, std::size_t blockIndex, const ReceiverBlocks& blocks,
                     const HorizonCode* codes, bool swapped, const BlockGround& ground, CrownSums& sums) {
    const ReceiverBlocks::Masks& receivers = blocks.masks(blockIndex, swapped);
    BlockView view = viewOf(bin, blocks.blocks()[blockIndex], swapped);
    if (codes == nullptr) codes = levelHorizons().data();
    setGround(view, ground, receivers);
    if (findVisible(view, codes, receivers) && addCrowns(squares_[bin - firstBin_], view)) {
        for (const CrownLevelsOfSet& of : sweep_->levelsOfSets(bin)) {
            CrownSums::Block& block = sums.at(of.set, blockIndex, swapped);
            weighBlock(of.levels, depths_, codes, sums.fractions(), block.evergreen, block.seasonal);
            for (const HiddenGap& gap : gaps_) takeGap(gap, of.levels, swapped, sums.fractions(), block);
        }
        std::ranges::fill(depths_.touched, std::uint16_t{0});
    }
    gaps_.clear();
}

CrownBatch::BlockView CrownBatch::viewOf(std::size_t bin, const ReceiverBlocks::Block& block,
                                         bool swapped) const {
    const glm::dvec2 away = sweep_->away(bin), right(-away.y, away.x);
    const double cellM = sweep_->cellM();
    const glm::dvec2 first(cellM * (block.column + 0.5), cellM * (block.row + 0.5));
    const glm::dvec2 toNextCell = swapped ? glm::dvec2(0, cellM) : glm::dvec2(cellM, 0);
    const glm::dvec2 toNextRow = swapped ? glm::dvec2(cellM, 0) : glm::dvec2(0, cellM);
    BlockView view{.levels = sweep_->levels(bin)};
    view.aside = float(glm::dot(first, right));
    view.ahead = float(-glm::dot(first, away));
    view.asidePerRow = float(glm::dot(toNextRow, right));
    view.aheadPerRow = float(-glm::dot(toNextRow, away));
    view.asidePerCell = float(glm::dot(toNextCell, right));
    view.aheadPerCell = float(-glm::dot(toNextCell, away));
    const auto low = [](float at, float perRow, float perCell) {
        return at + (std::min(0.0F, perRow) + std::min(0.0F, perCell)) * float(side - 1);
    };
    view.lowAside = low(view.aside, view.asidePerRow, view.asidePerCell);
    view.highAside = -low(-view.aside, -view.asidePerRow, -view.asidePerCell);
    view.lowAhead = low(view.ahead, view.aheadPerRow, view.aheadPerCell);
    view.highAhead = -low(-view.ahead, -view.aheadPerRow, -view.aheadPerCell);
    view.swapped = swapped;
    return view;
}

void CrownBatch::setGround(BlockView& view, const BlockGround& ground,
                           const ReceiverBlocks::Masks& receivers) {
    if (ground.rowsM == nullptr) return;
    view.ground = {ground.rowsM, ground.lowestM, ground.lowestM};
    for (std::size_t row = 0; row < side; ++row)
        for (std::size_t cell = 0; cell < side; ++cell)
            if ((receivers[row] >> cell & 1U) != 0)
                view.ground.highestM = std::max(view.ground.highestM, ground.rowsM[row].values[cell]);
}

// Whether any cell sees a sun.
bool CrownBatch::findVisible(BlockView& view, const HorizonCode* codes,
                             const ReceiverBlocks::Masks& receivers) {
    findVisibleLevels(view.levels, codes, receivers, view.visible.data());
    unsigned some = 0;
    for (const std::uint16_t levels : view.visible) some |= levels;
    if (some == 0) return false;
    view.lowestTan = view.levels.tan[std::countr_zero(some)];
    return true;
}

// Whether any stands before the block.
bool CrownBatch::addCrowns(const Squares& squares, const BlockView& view) {
    const float widest = sweep_->widestM();
    const float reachM = std::max(0.0F, sweep_->highestM() - view.ground.lowestM) / view.lowestTan;
    const auto bandAt = [&](float aside) {
        return int(std::floor((aside - squares.lowestAside) * squares.perM));
    };
    const int first = std::max(0, bandAt(view.lowAside - widest));
    const int last = std::min(squares.bands - 1, bandAt(view.highAside + widest));
    bool any = false;
    for (int band = first; band <= last; ++band)
        for (const PlacedCrown& crown :
             squares.find(band, view.lowAhead - widest, view.highAhead + widest + reachM))
            any = addCrown(crown, view) || any;
    return any;
}

bool CrownBatch::addCrown(const PlacedCrown& placed, const BlockView& view) {
    const CrownOnBlock& crown = sweep_->crowns()[placed.crown];
    const float r = crown.radiusM, overM = crown.topM - view.ground.lowestM;
    if (placed.aside - view.highAside >= r || placed.aside - view.lowAside <= -r || overM <= 0) return false;
    if (placed.ahead - view.lowAhead <= -r) return false;
    if ((placed.ahead - view.highAhead - r) * view.lowestTan >= overM) return false;
    CrownOnBlock on = crown;
    on.distance = placed.ahead - view.ahead;
    on.distancePerRow = -view.aheadPerRow;
    on.distancePerCell = -view.aheadPerCell;
    on.aside = placed.aside - view.aside;
    on.asidePerRow = -view.asidePerRow;
    on.asidePerCell = -view.asidePerCell;
    addCrownToBlock(on, view.levels, view.ground, view.visible.data(), depths_);
    return true;
}

// Suns that an overhang hides are not the crowns'.
void CrownBatch::takeGap(const HiddenGap& gap, const CrownLevels& levels, bool swapped, float fractions,
                         CrownSums::Block& sums) const {
    const std::size_t across = gap.cell % side, down = gap.cell / side;
    const std::size_t row = swapped ? across : down, cell = swapped ? down : across;
    float evergreen = 0, seasonal = 0;
    for (unsigned bits = depths_.touched[row] & levels.weighed; bits != 0; bits &= bits - 1) {
        const auto i = std::size_t(std::countr_zero(bits));
        const auto above = [&](HorizonCode code) {
            return std::clamp((levels.belowCode[i] - float(code)) * levels.perCode[i], 0.0F, 1.0F);
        };
        const float hidden = above(gap.low) - above(gap.high);
        if (hidden <= 0) continue;
        const float taken = -std::expm1(-depths_.inLeaf[row][i][cell]);
        evergreen += hidden * (levels.inLeaf[i] + levels.bare[i]) * taken;
        seasonal += hidden * levels.inLeaf[i] * taken;
        if (levels.bare[i] > 0) seasonal -= hidden * levels.bare[i] * std::expm1(-depths_.bare[row][i][cell]);
    }
    sums.evergreen[row * side + cell] -= std::int32_t(evergreen * fractions + 0.5F);
    sums.seasonal[row * side + cell] -= std::int32_t(seasonal * fractions + 0.5F);
}

}  // namespace noonmark
