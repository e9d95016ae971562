#include "core/samples/lot_building.h"

#include <algorithm>
#include <utility>

#include "core/city/footprints/repair_footprint.h"
#include "core/samples/lot_forms.h"

namespace noonmark {

namespace {

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

}  // namespace noonmark
