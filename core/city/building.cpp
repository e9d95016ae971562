#include "core/city/building.h"

#include <algorithm>

namespace noonmark {

std::string_view nameOf(HeightSource source) {
    switch (source) {
        case HeightSource::measured: return "measured";
        case HeightSource::levels: return "levels";
        case HeightSource::assumed: return "assumed";
        case HeightSource::mesh: return "mesh";
    }
    return "unknown";
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
