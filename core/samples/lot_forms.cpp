#include "core/samples/lot_forms.h"

#include <utility>

namespace noonmark {

namespace {
StreetPolygon rectangle(double west, double south, double east, double north) {
    return cornersOf({west, south, east, north});
}

StreetPolygon mirror(StreetPolygon outline, double width) {
    for (glm::dvec2& point : outline) point.x = width - point.x;
    return {outline.rbegin(), outline.rend()};
}

double builtDepth(LotSize lot, SampleRandom& random) { return lot.depth * random.between(0.6, 0.9); }
}  // namespace

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

Plan insetPlan(LotSize lot, double insetM) {
    return {rectangle(insetM, insetM, lot.width - insetM, lot.depth - insetM)};
}

Plan roundPlan(LotSize lot, double radiusM, int sides) {
    StreetPolygon outline;
    for (int i = 0; i < sides; ++i) {
        const auto [sine, cosine] = sameSineCosine(double(i) / sides);
        outline.emplace_back(lot.width / 2 + radiusM * cosine, lot.depth / 2 + radiusM * sine);
    }
    return {outline};
}

}  // namespace noonmark
