#include "core/samples/lot_building.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace noonmark {

namespace {
// The finaliser of MurmurHash3 (Austin Appleby): neighbouring inputs give unrelated outputs.
std::uint32_t scrambled(std::uint32_t h) {
    h = (h ^ (h >> 16U)) * 0x85EBCA6BU;
    h = (h ^ (h >> 13U)) * 0xC2B2AE35U;
    return h ^ (h >> 16U);
}

std::uint32_t streamSeed(std::uint32_t seed, int column, int row) {
    return scrambled(scrambled(scrambled(seed) + std::uint32_t(column)) + std::uint32_t(row));
}
}  // namespace

SampleRandom::SampleRandom(std::uint32_t seed, int column, int row)
    : engine_(streamSeed(seed, column, row)) {}

double SampleRandom::uniform() { return double(engine_()) * 0x1p-32; }

double SampleRandom::logNormal(double median, double sigma) {
    double normal = -6;
    for (int i = 0; i < 12; ++i) normal += uniform();
    return median * portableExp(sigma * normal);
}

double portableExp(double x) {
    constexpr int halvings = 10;
    const double small = x / (1 << halvings);
    double sum = 1;
    for (int i = 8; i > 0; --i) sum = 1 + sum * small / i;
    for (int i = 0; i < halvings; ++i) sum *= sum;
    return sum;
}

SineCosine portableSineCosine(double turns) {
    // Taylor's series for an eighth of the angle, then doubled three times.
    const double angle = turns * std::numbers::pi / 4;
    double sine = 1, cosine = 1;
    for (int i = 18; i > 1; i -= 2) {
        sine = 1 - sine * angle * angle / (i * (i + 1));
        cosine = 1 - cosine * angle * angle / (i * (i - 1));
    }
    sine *= angle;
    for (int i = 0; i < 3; ++i) {
        const double doubled = 2 * sine * cosine;
        cosine = 1 - 2 * sine * sine;
        sine = doubled;
    }
    return {sine, cosine};
}

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
