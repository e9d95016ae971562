#include "core/city/city.h"

#include <algorithm>

namespace noonmark {

std::string_view nameOf(HeightSource source) {
    switch (source) {
        case HeightSource::measured:
            return "measured";
        case HeightSource::levels:
            return "levels";
        case HeightSource::assumed:
            return "assumed";
        case HeightSource::mesh:
            return "mesh";
        case HeightSource::designed:
            return "designed";
        case HeightSource::madeUp:
            return "made up";
    }
    return "unknown";
}

std::optional<HeightSource> parseHeightSource(std::string_view name) {
    const auto* const found =
        std::ranges::find(heightSources, name, [](HeightSource source) { return nameOf(source); });
    if (found == heightSources.end()) return std::nullopt;
    return *found;
}

Box2 bounds(const Building& building) {
    Box2 box;
    for (const Part& part : building.parts) box.add(bounds(part.footprint));
    return box;
}

float topM(const Building& building) {
    float top = -1e30F;
    for (const Part& part : building.parts) top = std::max(top, part.topM);
    return top;
}

Box2 bounds(const City& city) {
    Box2 box;
    for (const auto& building : city.buildings) box.add(bounds(*building));
    return box;
}

float groundAt(const City& city, glm::dvec2 point) {
    return city.terrain ? elevationAt(*city.terrain, point) : 0.0F;
}

}  // namespace noonmark
