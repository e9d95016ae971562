#include "core/samples/block_buildings.h"

#include <algorithm>
#include <utility>

namespace noonmark {

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
