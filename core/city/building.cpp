#include "core/city/building.h"

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
    const auto* const found = std::ranges::find(heightSources, name, nameOf);
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

}  // namespace noonmark
