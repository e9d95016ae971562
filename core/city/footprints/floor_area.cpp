#include "core/city/footprints/floor_area.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_section.h"

namespace noonmark {

namespace {

constexpr double aboveFloorM = 0.01;

struct Storey {
    double floorM, middleM;  // local z
};

Storey storeyAt(int number, double groundM, double storeyHeightM) {
    return {groundM + number * storeyHeightM, groundM + (number + 0.5) * storeyHeightM};
}

std::vector<const Part*> partsThrough(const Building& building, double heightM) {
    std::vector<const Part*> parts;
    for (const Part& part : building.parts)
        if (double(part.bottomM) <= heightM && heightM < double(part.topM)) parts.push_back(&part);
    return parts;
}

struct Floor {
    std::vector<Footprint> pieces;
    bool estimated = false;
};

Floor floorOf(const std::vector<const Part*>& parts, double floorM) {
    Floor floor;
    for (const Part* part : parts) {
        if (!part->mesh) {
            floor.pieces.push_back(part->footprint);
            continue;
        }
        MeshSection section = cutSection(*part->mesh, std::max(floorM, double(part->bottomM)) + aboveFloorM);
        std::ranges::move(section.pieces, std::back_inserter(floor.pieces));
        floor.estimated = floor.estimated || section.estimated;
    }
    if (parts.size() > 1) floor.pieces = computeUnion(floor.pieces);
    return floor;
}

double computeArea(const std::vector<Footprint>& pieces) {
    double sum = 0;
    for (const Footprint& piece : pieces) sum += area(piece);
    return sum;
}

bool arePrisms(const std::vector<const Part*>& parts) {
    return std::ranges::all_of(parts, [](const Part* part) { return !part->mesh; });
}

int storeysOf(const Building& building, double groundM, double storeyHeightM) {
    constexpr double most = 10'000;
    const double storeys = (double(topM(building)) - groundM) / storeyHeightM;
    return storeys > 0 ? int(std::min(most, std::ceil(storeys))) : 0;
}

}  // namespace

FloorArea computeFloorArea(const Building& building, double groundM, double storeyHeightM) {
    FloorArea all;
    std::vector<const Part*> before;
    double areaM2 = 0;
    for (int i = 0; i < storeysOf(building, groundM, storeyHeightM); ++i) {
        const Storey storey = storeyAt(i, groundM, storeyHeightM);
        const std::vector<const Part*> parts = partsThrough(building, storey.middleM);
        bool estimated = false;
        if (parts != before || !arePrisms(parts)) {
            const Floor floor = floorOf(parts, storey.floorM);
            areaM2 = computeArea(floor.pieces);
            estimated = floor.estimated;
        }
        before = parts;
        all.grossM2 += areaM2;
        all.storeys += areaM2 > 0 ? 1 : 0;
        all.estimatedStoreys += areaM2 > 0 && estimated ? 1 : 0;
    }
    return all;
}

std::vector<Footprint> findGroundFloor(const Building& building, double groundM, double storeyHeightM) {
    const Storey storey = storeyAt(0, groundM, storeyHeightM);
    return floorOf(partsThrough(building, storey.middleM), storey.floorM).pieces;
}

}  // namespace noonmark
