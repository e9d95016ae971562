#include "core/io/terrain/standing.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_parts.h"
#include "core/geo/frame.h"
#include "core/io/settings/read_settings.h"
#include "core/io/terrain/buildings_on_terrain.h"

namespace noonmark {

namespace {

constexpr double oneHeightM = 0.5;  // bases with no more spread are at one height
constexpr double alikeM = 2;        // gaps with no more spread are alike
constexpr double apartM = 5;
constexpr float passageM = 3.5F;  // least height under a bridge

struct Quartiles {
    double low = 0, middle = 0, high = 0;
    [[nodiscard]] double spread() const { return high - low; }
};

Quartiles computeQuartiles(std::vector<double> values) {
    if (values.empty()) return {};
    std::ranges::sort(values);
    const auto at = [&](double share) {
        return values[std::size_t(double(values.size() - 1) * share + 0.5)];
    };
    return {at(0.25), at(0.5), at(0.75)};
}

bool isMesh(const Building& building) {
    return std::ranges::any_of(building.parts, [](const Part& part) { return part.mesh != nullptr; });
}

double computeArea(const Building& building) {
    double sum = 0;
    for (const Part& part : building.parts) sum += area(part.footprint);
    return sum;
}

double computeShared(const Building& a, const Building& b) {
    double sum = 0;
    for (const Part& one : a.parts)
        for (const Part& other : b.parts) sum += computeSharedArea({one.footprint}, {other.footprint});
    return sum;
}

// The neighbours of a building in plan that are lower than its base, but reach up to it.
struct Below {
    std::vector<std::size_t> lower;
    float lowestM = 1e30F;    // base of the lowest
    bool isOnlyLower = true;  // no neighbour has its base near the building's own, or above it
    std::size_t carrier = 0;
};

class Carriers {
public:
    explicit Carriers(const FilePiece& piece) : piece_(piece) {}

    std::vector<std::size_t> find() const {
        std::vector<Below> below(piece_.buildings.size());
        const std::vector<Box2> boxes = grownBoxes();
        for (const auto& [i, j] : findMeetingBoxes(boxes, boxes))
            if (i != j && piece_.groundM[i] && piece_.groundM[j]) add(below[i], i, j);
        std::vector<std::size_t> carriers(below.size());
        tbb::parallel_for(std::size_t{0}, below.size(), [&](std::size_t i) {
            carriers[i] = isCarried(i, below[i]) ? below[i].carrier : i;
        });
        return carriers;
    }

private:
    std::vector<Box2> grownBoxes() const {
        constexpr float touchM = 0.2F;
        std::vector<Box2> boxes;
        for (const auto& building : piece_.buildings) {
            const Box2 box = bounds(*building);
            boxes.push_back({box.low - touchM, box.high + touchM});
        }
        return boxes;
    }

    void add(Below& below, std::size_t building, std::size_t neighbour) const {
        const float base = *piece_.groundM[building], other = *piece_.groundM[neighbour];
        if (other > base - passageM) below.isOnlyLower = false;
        if (other > base - openAirM || topM(*piece_.buildings[neighbour]) < base - 0.5F) return;
        below.lower.push_back(neighbour);
        if (other >= below.lowestM) return;
        below.lowestM = other;
        below.carrier = neighbour;
    }

    bool isCarried(std::size_t building, const Below& below) const {
        if (below.lower.empty()) return false;
        if (below.isOnlyLower && below.lower.size() >= 2) return true;
        double shared = 0;
        for (const std::size_t other : below.lower)
            shared += computeShared(*piece_.buildings[building], *piece_.buildings[other]);
        return shared > computeArea(*piece_.buildings[building]) / 2;
    }

    const FilePiece& piece_;
};

float findHighestGround(const Building& building, const Terrain& terrain) {
    float highest = -1e30F;
    for (const Part& part : building.parts)
        for (const glm::vec2 corner : part.footprint.outer)
            highest = std::max(highest, elevationAt(terrain, glm::dvec2(corner)));
    return highest;
}

float findBottom(const Building& building) {
    float lowest = 1e30F;
    for (const Part& part : building.parts) lowest = std::min(lowest, part.bottomM);
    return lowest;
}

// A mesh that does not quite reach down to uneven ground is not aloft.
void markOnTerrain(Building& building, const Terrain* terrain) {
    const float bottom = findBottom(building);
    const float highest = terrain != nullptr ? findHighestGround(building, *terrain) : 0;
    const float minimum = bottom > highest + openAirM ? -1e30F : bottom;
    redetectOverhangs(building, [&](glm::dvec2 at) {
        return std::max(minimum, terrain != nullptr ? elevationAt(*terrain, at) : 0);
    });
}

// Bases that follow a ground that varies are elevations of some datum, wherever their zero is.
bool followTheGround(const Quartiles& gap, const Quartiles& base, const Quartiles& ground) {
    const bool vary = base.spread() > oneHeightM && ground.spread() > 2 * oneHeightM;
    return vary && gap.spread() <= ground.spread() / 4;
}

StandRule chooseRule(const Quartiles& gap, const Quartiles& base, const Quartiles& ground, bool fromZero) {
    const bool fits = BaseFit{.gapM = gap.middle}.fits() && BaseFit{.gapM = gap.spread()}.fits();
    if (fits) return StandRule::asStated;
    const bool oneHeight = base.spread() <= oneHeightM;
    if (oneHeight && (ground.spread() > 2 * oneHeightM || fromZero)) return StandRule::setDown;
    if (gap.spread() > std::max(alikeM, ground.spread() / 4)) return StandRule::setDown;
    if (BaseFit{.gapM = gap.middle, .spreadM = gap.spread()}.fits()) return StandRule::asStated;
    return fromZero ? StandRule::setDown : StandRule::shifted;
}

}  // namespace

bool countsFromZero(double baseM) { return baseM >= -20 && baseM <= double(openAirM); }

std::vector<std::size_t> findCarriers(const FilePiece& piece) {
    const bool any =
        std::ranges::any_of(piece.buildings, [](const auto& building) { return isMesh(*building); });
    if (!any || piece.groundM.size() != piece.buildings.size()) return {};
    return Carriers(piece).find();
}

namespace {

// Whether the piece is of meshes that count from their own zero, by the middle half of those that no others
// carry.
bool isFromOwnZero(const FilePiece& piece, const std::vector<std::size_t>& carriers) {
    std::vector<double> bases;
    for (std::size_t i = 0; i < piece.groundM.size(); ++i)
        if (piece.groundM[i] && (carriers.empty() || carriers[i] == i))
            bases.push_back(double(*piece.groundM[i]));
    const Quartiles base = computeQuartiles(std::move(bases));
    return piece.ownZero && countsFromZero(base.low) && countsFromZero(base.high);
}

}  // namespace

std::vector<BasedBuilding> findBasedBuildings(const FilePiece& piece,
                                              const std::vector<std::size_t>& carriers, const Frame& frame) {
    std::vector<BasedBuilding> based;
    if (isFromOwnZero(piece, carriers)) return based;
    const float zero = piece.ownZero ? float(frame.originElevationM()) : 0;
    for (std::size_t i = 0; i < piece.groundM.size(); ++i)
        if (piece.groundM[i] && !piece.buildings[i]->parts.empty() && (carriers.empty() || carriers[i] == i))
            based.push_back({piece.buildings[i].get(), *piece.groundM[i] - zero});
    return based;
}

void markOverhangsOnBases(FilePiece& piece, const std::vector<std::size_t>& carriers) {
    if (!piece.ownZero || isFromOwnZero(piece, carriers)) return;
    tbb::parallel_for(std::size_t{0}, piece.buildings.size(), [&](std::size_t i) {
        const float base = *piece.groundM[carriers.empty() ? i : carriers[i]];
        Building building = *piece.buildings[i];
        redetectOverhangs(building, [&](glm::dvec2) { return base; });
        piece.buildings[i] = std::make_shared<const Building>(std::move(building));
    });
}

void redetectOverhangs(Building& building, const std::function<float(glm::dvec2)>& groundM) {
    if (!isMesh(building)) return;
    for (Part& part : building.parts)
        part.isOverhanging = part.isOverhanging && part.mesh && hasOpenAirBelow(*part.mesh);
    markOverhangs(building.parts, groundM);
}

Standing::Standing(const FilePiece& piece, const std::vector<std::size_t>& carriers, const Frame& frame,
                   const Terrain* terrain, Stand wanted)
    : piece_(piece), carriers_(carriers), terrain_(terrain) {
    if (piece.ownZero) zeroM_ = float(-frame.originElevationM());
    footings_.resize(piece.groundM.size());
    fromZero_ = isFromOwnZero(piece, carriers);
    findGround();
    decide(wanted);
}

bool Standing::hasBase(std::size_t building) const {
    return piece_.groundM[building] && !piece_.buildings[building]->parts.empty();
}

bool Standing::isCarried(std::size_t building) const {
    return !carriers_.empty() && carriers_[building] != building;
}

double Standing::gapOf(std::size_t building) const {
    const Box2 box = bounds(*piece_.buildings[building]);
    const double drop = terrain_ != nullptr ? earthDropM(glm::dvec2(box.low + box.high) / 2.0) : 0;
    return double(*piece_.groundM[building]) + double(zeroM_) - drop - double(lowestM_[building]);
}

void Standing::findGround() {
    lowestM_.resize(footings_.size());
    if (terrain_ == nullptr) return;
    tbb::parallel_for(std::size_t{0}, lowestM_.size(), [&](std::size_t i) {
        if (hasBase(i)) lowestM_[i] = findLowestGround(*piece_.buildings[i], *terrain_);
    });
}

void Standing::decide(Stand wanted) {
    std::vector<double> gaps, bases, grounds;
    for (std::size_t i = 0; i < footings_.size(); ++i) {
        if (!hasBase(i) || isCarried(i)) continue;
        gaps.push_back(gapOf(i));
        bases.push_back(double(*piece_.groundM[i]));
        grounds.push_back(double(lowestM_[i]));
    }
    if (gaps.empty()) return;
    if (terrain_ == nullptr) {
        if (wanted != Stand::absolute) setDown();
        return;
    }
    const Quartiles gap = computeQuartiles(gaps), base = computeQuartiles(bases);
    const Quartiles ground = computeQuartiles(std::move(grounds));
    fromZero_ = fromZero_ && !followTheGround(gap, base, ground);
    fit_ = BaseFit{.buildings = gaps.size(), .gapM = gap.middle, .spreadM = gap.spread()};
    if (wanted == Stand::automatic) fit_->rule = chooseRule(gap, base, ground, fromZero_);
    if (wanted == Stand::terrain) fit_->rule = StandRule::setDown;
    if (fit_->rule == StandRule::setDown) return setDown();
    follow(fit_->rule == StandRule::shifted ? float(-gap.middle) : 0);
    if (wanted == Stand::automatic) setApart();
}

void Standing::follow(float shiftM) {
    for (std::size_t i = 0; i < footings_.size(); ++i)
        if (hasBase(i)) footings_[i] = {zeroM_ + shiftM, *piece_.groundM[i] + zeroM_ + shiftM};
}

void Standing::setApart() {
    const double maximum = std::max(apartM, 3 * fit_->spreadM);
    for (std::size_t i = 0; i < footings_.size(); ++i) {
        if (!hasBase(i) || isCarried(i)) continue;
        const double off = gapOf(i) - fit_->gapM;
        if (std::abs(off) <= maximum) continue;
        const bool stays = off > 0 && isMesh(*piece_.buildings[i]);
        ++(stays ? fit_->aloft : fit_->apart);
        if (!stays) footings_[i] = {lowestM_[i] - *piece_.groundM[i], std::nullopt};
    }
    followCarriers();
}

void Standing::setDown() {
    std::vector<double> bases;
    for (std::size_t i = 0; i < footings_.size(); ++i)
        if (hasBase(i) && !isCarried(i)) bases.push_back(double(*piece_.groundM[i]));
    const Quartiles base = computeQuartiles(bases);
    const auto isAtOne = [&](double one) { return std::abs(one - base.middle) <= oneHeightM; };
    const bool oneHeight = double(std::ranges::count_if(bases, isAtOne)) >= 0.9 * double(bases.size());
    for (std::size_t i = 0; i < footings_.size(); ++i) {
        if (!hasBase(i) || isCarried(i)) continue;
        float plane = *piece_.groundM[i];
        const bool isAloft = isMesh(*piece_.buildings[i]) && double(plane) > base.middle + double(openAirM);
        if (fit_ && isAloft && (fromZero_ || oneHeight)) ++fit_->aloft;
        if (fromZero_)
            plane = 0;
        else if (oneHeight && isAloft)
            plane = float(base.middle);
        footings_[i] = {lowestM_[i] - plane, std::nullopt};
    }
    followCarriers();
}

// What is carried by a building that was set down moves with it.
void Standing::followCarriers() {
    for (std::size_t i = 0; i < footings_.size(); ++i) {
        if (!hasBase(i) || !isCarried(i)) continue;
        std::size_t carrier = carriers_[i];
        while (isCarried(carrier)) carrier = carriers_[carrier];  // each has a lower base than the last
        if (!footings_[carrier].groundM) footings_[i] = footings_[carrier];
        if (fit_) ++fit_->aloft;
    }
}

std::size_t Standing::flattened() const {
    if (terrain_ != nullptr) return 0;
    return std::size_t(std::ranges::count_if(footings_, [](const Footing& one) { return one.liftM != 0; }));
}

std::shared_ptr<const Building> Standing::place(std::size_t i) const {
    const auto& read = piece_.buildings[i];
    const bool based = i < footings_.size() && hasBase(i);
    if (terrain_ == nullptr && (!based || footings_[i].liftM == 0)) return read;
    Building building = *read;
    if (based) lift(building, footings_[i].liftM);
    if (terrain_ != nullptr && (!based || footings_[i].groundM))
        building = standOnTerrain(std::move(building), based ? footings_[i].groundM : std::nullopt, terrain_);
    if (based) markOnTerrain(building, terrain_);
    return std::make_shared<const Building>(std::move(building));
}

Warnings describeStanding(const BaseFit& fit, bool asked) {
    Warnings warnings;
    const std::string leave = fmt::format(" ({} leaves them)", readOption("stand", "absolute"));
    if (!asked && fit.rule == StandRule::shifted)
        warnings.push_back({WarningKind::assumed,
                            "the bases of its buildings lie off the terrain by one height: all were shifted "
                            "onto it" +
                                leave,
                            describe(fit)});
    if (!asked && fit.rule == StandRule::setDown)
        warnings.push_back(
            {WarningKind::assumed,
             "the bases of its buildings do not follow the terrain: each was set down on it" + leave,
             describe(fit)});
    if (fit.apart > 0)
        warnings.push_back({WarningKind::assumed,
                            "buildings whose base is far from the terrain, unlike the others', were set down "
                            "on it" +
                                leave,
                            fmt::format("{} of {}", fit.apart, fit.file)});
    return warnings;
}

}  // namespace noonmark
