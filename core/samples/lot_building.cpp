#include "core/samples/lot_building.h"

#include <algorithm>
#include <utility>

#include "core/city/footprints/repair_footprint.h"
#include "core/samples/street_axes.h"

namespace noonmark {

namespace {

/// A floor plan on a lot, in the lot's own axes: x along the street, y from the street inwards, metres, both
/// from 0. An outline counter-clockwise, then holes clockwise.
using Plan = std::vector<StreetPolygon>;

struct LotSize {
    double width, depth;
};

StreetPolygon rectangle(double west, double south, double east, double north) {
    return cornersOf({west, south, east, north});
}

StreetPolygon mirror(StreetPolygon outline, double width) {
    for (glm::dvec2& point : outline) point.x = width - point.x;
    return {outline.rbegin(), outline.rend()};
}

double builtDepth(LotSize lot, SampleRandom& random) { return lot.depth * random.between(0.6, 0.9); }

/// Plans that fill the lot's street front from side to side, so that neighbours share party walls. A yard
/// behind them stays free.
Plan rowPlan(LotSize lot, SampleRandom& random) {
    return {rectangle(0, 0, lot.width, builtDepth(lot, random))};
}

Plan lPlan(LotSize lot, SampleRandom& random) {
    const double front = lot.depth * random.between(0.4, 0.6);
    const double wing = lot.width * random.between(0.35, 0.6);
    const double back = lot.depth * random.between(0.8, 0.98);
    StreetPolygon outline{{0, 0}, {lot.width, 0}, {lot.width, front}, {wing, front}, {wing, back}, {0, back}};
    return {random.chance(0.5) ? mirror(std::move(outline), lot.width) : std::move(outline)};
}

Plan uPlan(LotSize lot, SampleRandom& random) {
    const double front = lot.depth * random.between(0.35, 0.55);
    const double back = lot.depth * random.between(0.85, 1);
    const double west = lot.width * random.between(0.25, 0.35);
    const double east = lot.width * random.between(0.65, 0.75);
    return {{{0, 0},
             {lot.width, 0},
             {lot.width, back},
             {east, back},
             {east, front},
             {west, front},
             {west, back},
             {0, back}}};
}

Plan courtPlan(LotSize lot, SampleRandom& random) {
    const double back = lot.depth * random.between(0.9, 1);
    const double sideWing = lot.width * random.between(0.28, 0.36);
    const double depthWing = back * random.between(0.28, 0.36);
    const StreetPolygon court = rectangle(sideWing, depthWing, lot.width - sideWing, back - depthWing);
    return {rectangle(0, 0, lot.width, back), {court.rbegin(), court.rend()}};
}

/// A front that bulges towards the street, with `points` points between its ends.
Plan bowedPlan(LotSize lot, int points, SampleRandom& random) {
    const double bulge = random.between(0.8, 2);
    const double back = builtDepth(lot, random);
    StreetPolygon outline{{0, bulge}};
    for (int i = 1; i <= points; ++i) {
        const double x = double(i) / (points + 1);
        outline.emplace_back(lot.width * x, bulge * (2 * x - 1) * (2 * x - 1));
    }
    for (const glm::dvec2 corner : {glm::dvec2{lot.width, bulge}, {lot.width, back}, {0, back}})
        outline.push_back(corner);
    return {outline};
}

/// A rectangle `insetM` inside another plan's bounds on every side.
Plan insetPlan(LotSize lot, double insetM) {
    return {rectangle(insetM, insetM, lot.width - insetM, lot.depth - insetM)};
}

/// A circle in the middle of the lot, as a polygon with `sides` sides.
Plan roundPlan(LotSize lot, double radiusM, int sides) {
    StreetPolygon outline;
    for (int i = 0; i < sides; ++i) {
        const auto [sine, cosine] = portableSineCosine(double(i) / sides);
        outline.emplace_back(lot.width / 2 + radiusM * cosine, lot.depth / 2 + radiusM * sine);
    }
    return {outline};
}

/// Makes parts of a lot's plans: transforms the lot's axes to the streets' and to the local frame.
class Builder {
public:
    Builder(const Lot& lot, const LotBuildingSettings& settings, const StreetAxes& axes, SampleRandom& random)
        : lot_(lot),
          settings_(settings),
          axes_(axes),
          random_(random),
          size_{lot.box.width(), lot.box.depth()} {}

    std::vector<Part> build() {
        if (!lot_.isWhole())
            buildOnCut();
        else if (settings_.heightM >= towerFromM && size_.width >= 14)
            buildTower();
        else
            buildLow();
        return std::move(parts_);
    }

private:
    static constexpr double towerFromM = 45;
    static constexpr int roundSides = 8;

    void add(const Plan& plan, double bottomM, double topM) {
        Plan placed = plan;
        for (StreetPolygon& ring : placed)
            for (glm::dvec2& point : ring) point = onStreet(point);
        addOnStreet(placed, bottomM, topM);
    }

    void addOnStreet(const Plan& plan, double bottomM, double topM) {
        for (Part& part : makePrism(plan, bottomM, topM, axes_)) parts_.push_back(std::move(part));
    }

    // Lots on the northern side are turned by 180 degrees, which keeps the orientation.
    [[nodiscard]] glm::dvec2 onStreet(glm::dvec2 point) const {
        if (lot_.frontsNorth) return {lot_.box.east - point.x, lot_.box.north - point.y};
        return {lot_.box.west + point.x, lot_.box.south + point.y};
    }

    void buildLow() { add(lowPlan(), 0, settings_.heightM); }

    Plan lowPlan() {
        const double kind = random_.uniform();
        if (kind < 0.16) return bowedPlan(size_, settings_.roundness, random_);
        const bool wide = size_.width >= 16;
        if (wide && kind < 0.4) return courtPlan(size_, random_);
        if (wide && kind < 0.6) return uPlan(size_, random_);
        if (kind < 0.8) return lPlan(size_, random_);
        return rowPlan(size_, random_);
    }

    void buildTower() {
        const double kind = random_.uniform();
        if (kind < 0.35)
            buildTiers();
        else
            buildPodiumAndTower(kind < 0.6);
    }

    void buildPodiumAndTower(bool isRound) {
        const double podiumM = random_.between(12, 25);
        const double insetM = std::min(size_.width, size_.depth) * random_.between(0.08, 0.2);
        const double radiusM = std::min(size_.width, size_.depth) / 2 - insetM;
        add(insetPlan(size_, 0), 0, podiumM);
        add(isRound ? roundPlan(size_, radiusM, roundSides + settings_.roundness) : insetPlan(size_, insetM),
            podiumM, settings_.heightM);
    }

    // The zoning of 1916: higher tiers are set back further.
    void buildTiers() {
        const double stepM = std::min(size_.width, size_.depth) * random_.between(0.08, 0.15);
        const double firstM = settings_.heightM * random_.between(0.35, 0.5);
        const double secondM = settings_.heightM * random_.between(0.65, 0.8);
        add(insetPlan(size_, 0), 0, firstM);
        add(insetPlan(size_, stepM), firstM, secondM);
        add(insetPlan(size_, 2 * stepM), secondM, settings_.heightM);
    }

    // A convex ground, shrunk towards the mean of its corners, stays inside itself.
    void buildOnCut() {
        if (settings_.heightM < towerFromM) return addOnStreet({lot_.ground}, 0, settings_.heightM);
        const double podiumM = random_.between(12, 25);
        glm::dvec2 middle{0, 0};
        for (const glm::dvec2 corner : lot_.ground) middle += corner / double(lot_.ground.size());
        StreetPolygon tower = lot_.ground;
        for (glm::dvec2& corner : tower) corner = middle + (corner - middle) * 0.75;
        addOnStreet({lot_.ground}, 0, podiumM);
        addOnStreet({tower}, podiumM, settings_.heightM);
    }

    const Lot& lot_;
    const LotBuildingSettings& settings_;
    const StreetAxes& axes_;
    SampleRandom& random_;
    LotSize size_;
    std::vector<Part> parts_;
};

Part cutInterval(Footprint footprint, double bottomM, double topM) {
    return {.footprint = std::move(footprint),
            .bottomM = float(bottomM),
            .topM = float(topM),
            .heightSource = HeightSource::madeUp};
}

}  // namespace

std::vector<Part> makePrism(const std::vector<StreetPolygon>& rings, double bottomM, double topM,
                            const StreetAxes& axes) {
    std::vector<RawRing> local = rings;
    for (RawRing& ring : local)
        for (glm::dvec2& point : ring) point = axes.localFromStreet(point);
    std::vector<Part> parts;
    for (Footprint& piece : repairFootprint(local).pieces)
        parts.push_back(cutInterval(std::move(piece), bottomM, topM));
    return parts;
}

Building buildOnLot(const Lot& lot, const LotBuildingSettings& settings, const StreetAxes& axes,
                    SampleRandom& random) {
    Building building;
    building.status = "built";
    building.parts = Builder(lot, settings, axes, random).build();
    return building;
}

namespace {

constexpr double maxSlender = 9;  // height over width

std::vector<Lot> freeLots(const StreetBox& block, const BlockSettings& settings, SampleRandom& random) {
    std::vector<Lot> lots = cutIntoLots(block, settings.widths, random);
    for (const SkewedAvenue& avenue : settings.avenues) lots = cutBy(avenue, std::move(lots));
    std::erase_if(lots, [&](const Lot& lot) {
        return std::any_of(settings.cleared.begin(), settings.cleared.end(),
                           [&](const StreetBox& box) { return box.overlaps(lot.box); });
    });
    return lots;
}

double heightOn(const Lot& lot, const BlockSettings& settings, SampleRandom& random) {
    const double height = random.logNormal(settings.medianHeightM(lot.box.middle()), settings.heightSigma);
    const double highest = std::min(settings.highestM, maxSlender * lot.box.width());
    return std::clamp(height, settings.lowestM, std::max(settings.lowestM, highest));
}

}  // namespace

std::vector<Building> buildOnLots(const StreetBox& block, const BlockSettings& settings,
                                  const StreetAxes& axes, SampleRandom& random) {
    std::vector<Building> buildings;
    for (const Lot& lot : freeLots(block, settings, random)) {
        const LotBuildingSettings one{heightOn(lot, settings, random), settings.roundness};
        Building building = buildOnLot(lot, one, axes, random);
        if (!building.parts.empty()) buildings.push_back(std::move(building));
    }
    return buildings;
}

}  // namespace noonmark
