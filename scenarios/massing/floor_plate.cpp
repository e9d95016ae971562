#include "scenarios/massing/floor_plate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_outline.h"
#include "scenarios/edits/placed_building.h"
#include "scenarios/massing/straight_skeleton.h"

namespace noonmark {

namespace {

constexpr int halvings = 40;

Building asBuilding(const Plate& plate) {
    Building building;
    for (const Footprint& piece : plate) building.parts.push_back({.footprint = piece, .topM = 1});
    return building;
}

Plate movePlate(const Plate& plate, Placement placement) {
    const Building building = asBuilding(plate);
    placement.about = findMiddle(building);
    Plate result;
    for (Part& part : placeBuilding(building, placement).parts) result.push_back(std::move(part.footprint));
    return result;
}

// The argument at which the monotonic `areaAt` crosses `areaM2`, by bisection.
template <class AreaAt>
double argumentOf(double areaM2, double low, double high, bool rising, AreaAt&& areaAt) {
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        ((areaAt(middle) < areaM2) == rising ? low : high) = middle;
    }
    return (low + high) / 2;
}

Result<double> wantedArea(const Footprint& lot, const PlateSize& size) {
    const double lotM2 = area(lot);
    if (size.shareOfLot && !(*size.shareOfLot > 0 && *size.shareOfLot <= 1))
        return failure(fmt::format("A floor plate cannot cover {:g} % of the lot", *size.shareOfLot * 100),
                       "floor plate", "Give a share over 0 and up to 100 %");
    const double wanted = size.areaM2.value_or(size.shareOfLot.value_or(1) * lotM2);
    if (wanted > 0 && wanted <= lotM2 * (1 + 1e-9)) return std::min(wanted, lotM2);
    return failure(fmt::format("A floor plate of {:.0f} m2 does not fit the lot", wanted), "floor plate",
                   fmt::format("Give an area over 0 and up to the lot's {:.0f} m2", lotM2));
}

}  // namespace

double computeArea(const Plate& plate) {
    double sum = 0;
    for (const Footprint& piece : plate) sum += area(piece);
    return sum;
}

Result<Plate> makePlate(const Footprint& lot, const PlateSize& size) {
    const auto wanted = wantedArea(lot, size);
    if (!wanted) return tl::make_unexpected(wanted.error());
    if (*wanted >= area(lot) * (1 - 1e-9)) return Plate{lot};
    const auto skeleton = StraightSkeleton::of(lot);
    if (!skeleton) return tl::make_unexpected(skeleton.error());
    const double inset = argumentOf(*wanted, 0, skeleton->deepestM(), false,
                                    [&](double distance) { return computeArea(skeleton->inset(distance)); });
    Plate plate = skeleton->inset(inset);
    if (std::abs(computeArea(plate) - *wanted) <= 0.001 * *wanted) return plate;
    return failure(fmt::format("The lot cannot be inset to a plate of {:.1f} m2", *wanted), "floor plate",
                   "Choose a larger plate");
}

glm::dvec2 findMiddle(const Plate& plate) { return findMiddle(asBuilding(plate)); }

Plate placePlate(const Plate& plate, double scale, double clockwiseDeg) {
    if (scale == 1 && clockwiseDeg == 0) return plate;
    return movePlate(plate, {.scale = scale, .clockwiseDeg = clockwiseDeg});
}

Plate turnPlate(const Plate& plate, double clockwiseDeg) { return placePlate(plate, 1, clockwiseDeg); }

Result<Plate> insetPlate(const Plate& plate, double insetM) {
    Plate left;
    double deepest = 0;
    for (const Footprint& piece : plate) {
        const auto skeleton = StraightSkeleton::of(piece);
        if (!skeleton) return tl::make_unexpected(skeleton.error());
        deepest = std::max(deepest, skeleton->deepestM());
        for (Footprint& inner : skeleton->inset(insetM)) left.push_back(std::move(inner));
    }
    if (!left.empty()) return left;
    return failure(fmt::format("A setback of {:g} m leaves nothing of the floor plate", insetM), "setback",
                   fmt::format("Give less than {:.1f} m", deepest));
}

bool liesOn(const Plate& plate, const Plate& ground) {
    double outside = 0;
    for (const Footprint& piece : plate) outside += computeAreaOutside(piece, ground);
    return outside <= 0.0002 * computeArea(plate) + 0.05;
}

Plate resizePlate(const Plate& plate, const Footprint& lot, double areaM2) {
    const auto at = [&](double scale) {
        const Plate scaled = movePlate(plate, {.scale = scale});
        return scale > 1 ? cutSharedPieces(scaled, {lot}) : scaled;
    };
    const double even = std::sqrt(areaM2 / computeArea(plate));
    if (even <= 1) return at(even);
    // Factor at which the scaled plate covers even the farthest corner of the lot.
    const Box2 lotBox = bounds(lot), box = bounds(plate.front());
    const double reach = 4 * double(glm::length(lotBox.high - lotBox.low) / glm::length(box.high - box.low));
    return at(argumentOf(areaM2, 1, std::max(even, reach) * 10, true,
                         [&](double scale) { return computeArea(at(scale)); }));
}

}  // namespace noonmark
