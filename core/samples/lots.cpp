#include "core/samples/lots.h"

#include <algorithm>
#include <utility>

namespace noonmark {

namespace {

double randomWidth(const LotWidths& widths, SampleRandom& random) {
    const double share = random.uniform();
    const double skewed = share * share * share * (1 - widths.preferWide) + share * widths.preferWide;
    return widths.narrowestM + (widths.widestM - widths.narrowestM) * skewed;
}

// The sides of the lots from west to east; every lot keeps its width between the narrowest and the widest.
std::vector<double> sidesAlong(double west, double east, const LotWidths& widths, SampleRandom& random) {
    std::vector<double> sides{west};
    while (east - sides.back() > widths.widestM + widths.narrowestM)
        sides.push_back(sides.back() + randomWidth(widths, random));
    if (east - sides.back() > widths.widestM) sides.push_back((sides.back() + east) / 2);
    sides.push_back(east);
    return sides;
}

void addRow(std::vector<Lot>& lots, const StreetBox& row, bool frontsNorth, const LotWidths& widths,
            SampleRandom& random) {
    const auto sides = sidesAlong(row.west, row.east, widths, random);
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        const StreetBox box{sides[i], row.south, sides[i + 1], row.north};
        lots.push_back({box, frontsNorth, cornersOf(box)});
    }
}

}  // namespace

std::vector<Lot> cutIntoLots(const StreetBox& block, const LotWidths& widths, SampleRandom& random) {
    std::vector<Lot> lots;
    const double middle = block.middle().y;
    addRow(lots, {block.west, block.south, block.east, middle}, false, widths, random);
    addRow(lots, {block.west, middle, block.east, block.north}, true, widths, random);
    return lots;
}

std::vector<Lot> cutBy(const SkewedAvenue& avenue, std::vector<Lot> lots) {
    constexpr double smallestM2 = 60;
    for (Lot& lot : lots) lot.ground = avenue.clipped(lot.ground);
    std::erase_if(lots, [](const Lot& lot) { return computeArea(lot.ground) < smallestM2; });
    return lots;
}

}  // namespace noonmark
