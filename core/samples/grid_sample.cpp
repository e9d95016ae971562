#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/samples/lot_building.h"
#include "core/samples/sample_city.h"

namespace noonmark {

namespace {

constexpr double avenueM = 30;
constexpr double streetM = 18;
constexpr double blockWidthM = 274;
constexpr double blockDepthM = 80;
constexpr double columnM = blockWidthM + avenueM;
constexpr double rowM = blockDepthM + streetM;
constexpr double longerThanWide = 2.5;
constexpr double lotsPerBlock = 36;

/// Number of blocks side by side, and approximate number of rows.
struct Extent {
    int columns;
    double lengthM;
};

Extent extentFor(int buildings) {
    const double blocks = buildings / lotsPerBlock;
    const double columns = std::sqrt(blocks * rowM / (columnM * longerThanWide));
    const int whole = std::max(1, int(std::lround(columns)));
    return {whole, std::ceil(blocks / whole) * rowM};
}

// 1 in the middle of a quarter of towers, decreasing to 0 away from it.
double nearness(glm::dvec2 place, double northM, double radiusM) {
    const double north = place.y - northM;
    const double share = (place.x * place.x + north * north) / (radiusM * radiusM);
    return 1 / ((1 + share) * (1 + share));
}

double medianHeight(glm::dvec2 place, double lengthM) {
    const double midtown = nearness(place, 0.1 * lengthM, 300 + 0.08 * lengthM);
    const double downtown = nearness(place, -0.4 * lengthM, 200 + 0.06 * lengthM);
    return 14 * (1 + 4.5 * midtown + 4 * downtown);
}

BlockSettings blockSettings(const GridSampleSettings& settings, const Extent& extent) {
    BlockSettings block;
    block.medianHeightM = [lengthM = extent.lengthM](glm::dvec2 place) {
        return medianHeight(place, lengthM);
    };
    block.roundness = settings.roundness;
    block.avenues = {SkewedAvenue{.through = {0, 0}, .eastPerNorth = -0.27, .widthM = 28}};
    return block;
}

StreetBox blockAt(int column, int row, int columns) {
    const double west = (column - columns / 2.0) * columnM + avenueM / 2;
    const double south = (row - 0.5) * rowM + streetM / 2;
    return {west, south, west + blockWidthM, south + blockDepthM};
}

// Rows from the middle outwards: 0, 1, -1, 2, -2, ...
int rowNumber(int i) { return i % 2 == 1 ? (i + 1) / 2 : -i / 2; }

void add(City& city, Building building) {
    building.sourceId = fmt::format("lot {}", city.buildings.size() + 1);
    city.buildings.push_back(std::make_shared<const Building>(std::move(building)));
}

void addRow(City& city, const GridSampleSettings& settings, const Extent& extent, int row) {
    const BlockSettings block = blockSettings(settings, extent);
    for (int column = 0; column < extent.columns; ++column) {
        SampleRandom random(settings.seed, column, row);
        for (Building& building : buildOnLots(blockAt(column, row, extent.columns), block, {}, random)) {
            if (int(city.buildings.size()) == settings.buildings) return;
            add(city, std::move(building));
        }
    }
}

Result<void> validate(const GridSampleSettings& settings) {
    const auto refuse = [](std::string what, const char* where, const char* advice) {
        return failure(std::move(what), where, advice);
    };
    if (settings.buildings < 100 || settings.buildings > 50000)
        return refuse(fmt::format("{} buildings are out of range", settings.buildings), "sample grid",
                      "Choose 100 to 50,000");
    if (settings.roundness < 0 || settings.roundness > 64)
        return refuse(fmt::format("A roundness of {} is out of range", settings.roundness), "sample grid",
                      "Choose 0 to 64");
    const auto [lonDeg, latDeg] = settings.origin;
    if (!(std::abs(lonDeg) <= 180) || !(std::abs(latDeg) <= 90))
        return refuse(fmt::format("{}, {} is not a place on the globe", lonDeg, latDeg), "sample grid",
                      "Give a longitude of -180 to 180 and a latitude of -90 to 90 degrees");
    return {};
}

}  // namespace

Result<City> makeGridSample(const GridSampleSettings& settings) {
    if (const auto good = validate(settings); !good) return tl::make_unexpected(good.error());
    City city;
    city.frame = Frame(settings.origin);
    const Extent extent = extentFor(settings.buildings);
    for (int i = 0; int(city.buildings.size()) < settings.buildings; ++i)
        addRow(city, settings, extent, rowNumber(i));
    return city;
}

}  // namespace noonmark
