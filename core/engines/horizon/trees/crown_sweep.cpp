#include "core/engines/horizon/trees/crown_sweep.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "core/engines/api/tree_shade.h"
#include "core/engines/horizon/trees/crown_runs.h"

namespace noonmark {

namespace {

constexpr std::size_t side = ReceiverBlocks::side;

struct LeafySun {
    HorizonCode code;
    bool inLeaf;
    std::uint16_t set;
    std::uint32_t bin;
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
    levels.meanCode[i] = toSunCode(std::tan(angle));
    setWeights(suns, i, levels);
}

using BinAndSet = std::pair<std::uint32_t, std::uint16_t>;

BinAndSet binAndSetOf(const LeafySun& sun) { return {sun.bin, sun.set}; }

// Bins and months have their suns of one level at few altitudes: they count from where their own begin.
void addWeightsOfSets(std::vector<LeafySun> suns, std::size_t level,
                      std::map<BinAndSet, CrownLevels>& ofSets) {
    std::ranges::stable_sort(suns, {}, binAndSetOf);
    for (std::size_t first = 0, end = 0; first < suns.size(); first = end) {
        while (end < suns.size() && binAndSetOf(suns[end]) == binAndSetOf(suns[first])) ++end;
        setWeights(std::span(suns).subspan(first, end - first), level, ofSets[binAndSetOf(suns[first])]);
    }
}

/// The levels of a group, and the same by bin and set.
struct LevelsOfGroup {
    CrownLevels all;
    std::map<BinAndSet, CrownLevels> ofSets;
};

// By equal numbers of suns, but for the first and last; suns of one code stay together. Levels of
// neighbouring groups begin at different shares of their suns, by the golden ratio, because crowns have edges
// at the same altitude in many groups: errors at equal levels would add up instead of cancelling out.
LevelsOfGroup splitIntoLevels(std::size_t group, std::vector<LeafySun> suns) {
    constexpr double goldenRatio = 0.6180339887498949;
    std::ranges::sort(suns, {}, &LeafySun::code);
    LevelsOfGroup split;
    const double size = std::max(1.0, double(suns.size()) / double(CrownSweep::maxLevels - 1));
    const double share = double(group + 1) * goldenRatio;
    double limit = size * (share - std::floor(share));
    for (std::size_t first = 0; first < suns.size(); limit += size) {
        const bool last = split.all.count + 1 == CrownSweep::maxLevels;
        std::size_t end = last ? suns.size() : std::min(std::size_t(std::lround(limit)), suns.size());
        if (end <= first) continue;
        while (end < suns.size() && suns[end].code == suns[end - 1].code) ++end;
        const std::span<const LeafySun> own = std::span(suns).subspan(first, end - first);
        addLevel(own, split.all);
        addWeightsOfSets({own.begin(), own.end()}, split.all.count - 1, split.ofSets);
        first = end;
    }
    return split;
}

// Of each bin: neighbours whose mean azimuths lie within `widestDeg` of the first of them. Bins of no more
// suns than levels, as those of single days, stay alone: each of their suns sees crowns from its own azimuth.
std::vector<std::uint32_t> groupBins(const BinnedSun& binned, double widestDeg) {
    constexpr std::size_t maxInGroup = 5;
    const double minCosine = std::cos(widestDeg * std::numbers::pi / 180);
    std::vector<std::uint32_t> groupOfBin;
    std::uint32_t group = 0;
    for (std::size_t bin = 0, first = 0; bin < binned.bins.size(); ++bin) {
        const AzimuthBin &own = binned.bins[bin], &one = binned.bins[first];
        const bool hasFew = std::min(own.suns.size(), one.suns.size()) <= CrownSweep::maxLevels;
        const bool isNear = glm::dot(own.away, one.away) >= minCosine && !hasFew;
        if (bin > 0 && (!isNear || bin - first >= maxInGroup)) {
            first = bin;
            ++group;
        }
        groupOfBin.push_back(group);
    }
    return groupOfBin;
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
                       const Grid& grid, double datumM, double groupDeg)
    : groupOfBin_(groupBins(binned, groupDeg)),
      levelsOfSets_(binned.bins.size()),
      cellM_(grid.cellM),
      steps_(binned.places.size()),
      sets_(sets.names.size()) {
    std::vector<std::vector<LeafySun>> suns(groupOfBin_.empty() ? 0 : groupOfBin_.back() + 1);
    for (std::size_t step = 0; step < binned.places.size(); ++step) {
        const StepPlace& place = binned.places[step];
        suns[groupOfBin_[place.bin]].push_back(
            {place.sun, scene.inLeaf[step] != 0, sets.ofStep[step], place.bin});
    }
    groups_.resize(suns.size());
    for (std::size_t bin = 0; bin < binned.bins.size(); ++bin)
        groups_[groupOfBin_[bin]].away += binned.bins[bin].away * double(binned.bins[bin].suns.size());
    for (std::size_t group = 0; group < suns.size(); ++group) {
        LevelsOfGroup split = splitIntoLevels(group, std::move(suns[group]));
        groups_[group] = {split.all, glm::normalize(groups_[group].away)};
        for (const auto& [of, levels] : split.ofSets) levelsOfSets_[of.first].push_back({of.second, levels});
    }
    for (const Crown& crown : scene.crowns) {
        places_.emplace_back(crown.x - grid.westM, crown.y - grid.southM);
        crowns_.push_back(shapeOf(crown, datumM));
        widestM_ = std::max(widestM_, crowns_.back().radiusM);
        highestM_ = std::max(highestM_, crowns_.back().topM);
    }
}

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
    firstGroup_ = sweep.groupOf(first);
    group_ = block_ = none;
    squares_.resize(sweep.groupOf(end - 1) + 1 - firstGroup_);
    for (std::size_t i = 0; i < squares_.size(); ++i) place(sweep, firstGroup_ + i, squares_[i]);
}

// A counting sort, which leaves crowns of a square in their order, so that sums do not depend on threads.
void CrownBatch::place(const CrownSweep& sweep, std::size_t group, Squares& squares) {
    const glm::dvec2 away = sweep.away(group), right(-away.y, away.x);
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
                     const HorizonCode* codes, bool swapped, const BlockGround& ground, CrownSums& sums,
                     CrownMarks* marks) {
    if (group_ != sweep_->groupOf(bin) || block_ != blockIndex)
        beginBlock(bin, blockIndex, blocks, swapped, ground);
    if (codes == nullptr) codes = levelHorizons().data();
    Wanted wanted;
    if (findWanted(codes, blocks.masks(blockIndex, swapped), wanted)) computeShares(wanted);
    if (std::ranges::any_of(shares_.touched, [](std::uint16_t levels) { return levels != 0; })) {
        for (const CrownLevelsOfSet& of : sweep_->levelsOfSets(bin)) {
            CrownSums::Block& block = sums.at(of.set, blockIndex, swapped);
            weighBlock(of.levels, shares_, codes, sums.fractions(), block.evergreen, block.seasonal);
            for (const HiddenGap& gap : gaps_) takeGap(gap, of.levels, swapped, sums.fractions(), block);
        }
        if (marks != nullptr) mark(bin, blockIndex, swapped, *marks);
    }
    gaps_.clear();
}

void CrownBatch::beginBlock(std::size_t bin, std::size_t blockIndex, const ReceiverBlocks& blocks,
                            bool swapped, const BlockGround& ground) {
    group_ = sweep_->groupOf(bin);
    block_ = blockIndex;
    view_ = viewOf(bin, blocks.blocks()[blockIndex], swapped);
    setGround(view_, ground, blocks.masks(blockIndex, swapped));
    computed_.fill(0);
    std::ranges::fill(shares_.touched, std::uint16_t{0});
}

// Levels that some cell sees, and that no bin of the group before has asked for. False: none.
bool CrownBatch::findWanted(const HorizonCode* codes, const ReceiverBlocks::Masks& receivers,
                            Wanted& wanted) const {
    findVisibleLevels(*view_.levels, codes, receivers, wanted.levels.data());
    unsigned some = 0;
    for (std::size_t row = 0; row < side; ++row) {
        wanted.levels[row] = std::uint16_t(wanted.levels[row] & ~computed_[row]);
        some |= wanted.levels[row];
    }
    if (some != 0) wanted.lowestTan = view_.levels->tan[std::countr_zero(some)];
    return some != 0;
}

void CrownBatch::computeShares(const Wanted& wanted) {
    addCrowns(squares_[group_ - firstGroup_], wanted);
    toShares(*view_.levels, wanted.levels.data(), shares_);
    for (std::size_t row = 0; row < side; ++row)
        computed_[row] = std::uint16_t(computed_[row] | wanted.levels[row]);
}

void CrownBatch::mark(std::size_t bin, std::size_t blockIndex, bool swapped, CrownMarks& marks) const {
    CrownMarks::Block block;
    block.anyInLeaf = findDark(*view_.levels, shares_, computed_.data(), float(TreeShade::defaultShadedFrom),
                               block.inLeaf, block.bare, block.anyBare);
    if (block.anyInLeaf || block.anyBare) marks.set(bin, blockIndex, swapped, block);
}

CrownBatch::BlockView CrownBatch::viewOf(std::size_t bin, const ReceiverBlocks::Block& block,
                                         bool swapped) const {
    const glm::dvec2 away = sweep_->away(sweep_->groupOf(bin)), right(-away.y, away.x);
    const double cellM = sweep_->cellM();
    const glm::dvec2 first(cellM * (block.column + 0.5), cellM * (block.row + 0.5));
    const glm::dvec2 toNextCell = swapped ? glm::dvec2(0, cellM) : glm::dvec2(cellM, 0);
    const glm::dvec2 toNextRow = swapped ? glm::dvec2(cellM, 0) : glm::dvec2(0, cellM);
    BlockView view{.levels = &sweep_->levels(bin)};
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

void CrownBatch::addCrowns(const Squares& squares, const Wanted& wanted) {
    const float widest = sweep_->widestM();
    const float reachM = std::max(0.0F, sweep_->highestM() - view_.ground.lowestM) / wanted.lowestTan;
    const auto bandAt = [&](float aside) {
        return int(std::floor((aside - squares.lowestAside) * squares.perM));
    };
    const int first = std::max(0, bandAt(view_.lowAside - widest));
    const int last = std::min(squares.bands - 1, bandAt(view_.highAside + widest));
    for (int band = first; band <= last; ++band)
        for (const PlacedCrown& crown :
             squares.find(band, view_.lowAhead - widest, view_.highAhead + widest + reachM))
            addCrown(crown, wanted);
}

void CrownBatch::addCrown(const PlacedCrown& placed, const Wanted& wanted) {
    const CrownOnBlock& crown = sweep_->crowns()[placed.crown];
    const float r = crown.radiusM, overM = crown.topM - view_.ground.lowestM;
    if (placed.aside - view_.highAside >= r || placed.aside - view_.lowAside <= -r || overM <= 0) return;
    if (placed.ahead - view_.lowAhead <= -r) return;
    if ((placed.ahead - view_.highAhead - r) * wanted.lowestTan >= overM) return;
    CrownOnBlock on = crown;
    on.distance = placed.ahead - view_.ahead;
    on.distancePerRow = -view_.aheadPerRow;
    on.distancePerCell = -view_.aheadPerCell;
    on.aside = placed.aside - view_.aside;
    on.asidePerRow = -view_.asidePerRow;
    on.asidePerCell = -view_.asidePerCell;
    addCrownToBlock(on, *view_.levels, view_.ground, wanted.levels.data(), shares_);
}

// Suns that an overhang hides are not the crowns'.
void CrownBatch::takeGap(const HiddenGap& gap, const CrownLevels& levels, bool swapped, float fractions,
                         CrownSums::Block& sums) const {
    const std::size_t across = gap.cell % side, down = gap.cell / side;
    const std::size_t row = swapped ? across : down, cell = swapped ? down : across;
    float evergreen = 0, seasonal = 0;
    for (unsigned bits = shares_.touched[row] & levels.weighed; bits != 0; bits &= bits - 1) {
        const auto i = std::size_t(std::countr_zero(bits));
        const auto above = [&](HorizonCode code) {
            return std::clamp((levels.belowCode[i] - float(code)) * levels.perCode[i], 0.0F, 1.0F);
        };
        const float hidden = above(gap.low) - above(gap.high);
        if (hidden <= 0) continue;
        const float taken = shares_.inLeaf[row][i][cell];
        evergreen += hidden * (levels.inLeaf[i] + levels.bare[i]) * taken;
        seasonal += hidden * levels.inLeaf[i] * taken;
        if (levels.bare[i] > 0) seasonal += hidden * levels.bare[i] * shares_.bare[row][i][cell];
    }
    sums.evergreen[row * side + cell] -= std::int32_t(std::lround(evergreen * fractions));
    sums.seasonal[row * side + cell] -= std::int32_t(std::lround(seasonal * fractions));
}

}  // namespace noonmark
