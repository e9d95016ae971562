#include "core/city/settle_parts.h"

#include <algorithm>

#include "core/city/footprints/shared_area.h"
#include "core/city/meshes/mesh_outline.h"

namespace noonmark {

namespace {

constexpr float sameHeightM = 0.01F;

bool meet(const Box2& a, const Box2& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

using Parts = std::vector<const Part*>;

Parts carriersOf(const Part& part, const Parts& standing, float reachM) {
    Parts carriers;
    const Box2 box = bounds(part.footprint);
    for (const Part* lower : standing)
        if (lower->topM >= part.bottomM - reachM && meet(box, bounds(lower->footprint)))
            carriers.push_back(lower);
    return carriers;
}

bool isCarried(const Part& part, const Parts& carriers) {
    if (carriers.empty()) return false;
    std::vector<Footprint> footprints;
    for (const Part* carrier : carriers) footprints.push_back(carrier->footprint);
    constexpr double roundingM2 = 1e-4;
    const double openM2 = std::max(0.5, 0.05 * area(part.footprint));
    const OutsideArea outside = boundAreaOutside({part.footprint}, footprints);
    if (outside.maxM2 < openM2 - roundingM2) return true;
    if (outside.minM2 > openM2 + roundingM2) return false;
    return computeAreaOutside(part.footprint, footprints) <= openM2;
}

float lowestTop(const Parts& carriers) {
    return (*std::ranges::min_element(carriers, {}, [](const Part* part) { return part->topM; }))->topM;
}

void lower(Part& part, float bottomM, Warnings& warnings) {
    part.bottomM = bottomM;
    warnings.push_back({WarningKind::repaired, "a low gap under a raised part was closed", part.sourceId});
}

void settle(Part& part, const Parts& standing, const SettleRules& rules, Warnings& warnings) {
    if (part.bottomM <= rules.groundM + sameHeightM) return;
    if (isCarried(part, carriersOf(part, standing, sameHeightM))) return;
    const Parts near = carriersOf(part, standing, rules.carryGapM);
    if (isCarried(part, near)) return lower(part, std::min(part.bottomM, lowestTop(near)), warnings);
    if (part.bottomM <= rules.groundM + rules.groundGapM) return lower(part, rules.groundM, warnings);
    part.isOverhanging = true;
}

}  // namespace

void settleParts(std::vector<Part>& parts, const SettleRules& rules, Warnings& warnings) {
    std::vector<Part*> upward;
    for (Part& part : parts)
        if (!part.isOverhanging) upward.push_back(&part);
    std::ranges::stable_sort(upward, {}, [](const Part* part) { return part->bottomM; });
    Parts standing;
    for (Part* part : upward) {
        settle(*part, standing, rules, warnings);
        if (!part->isOverhanging) standing.push_back(part);
    }
}

}  // namespace noonmark
