#include "core/study/by_place/place_parts.h"

#include "core/city/footprints/plan_overlay.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

constexpr double besideM = 2;  // as far apart as a path between a lawn and its park

bool isGround(const Place& place) {
    return place.kind != PlaceKind::street && place.kind != PlaceKind::facade &&
           place.kind != PlaceKind::stainedGlass;
}

/// How much of a part belongs to a whole: above 1 where it holds more than half, else the share of its
/// outline along it.
double weigh(const Place& part, const Place& whole) {
    const double held = computeSharedArea(part.polygons, whole.polygons) / area(part);
    if (held > 0.5) return 1 + held;
    const double along = computeShareBeside(part.polygons, whole.polygons, besideM);
    return along > 0.2 ? along : 0;
}

}  // namespace

std::vector<std::optional<std::size_t>> findWholes(const std::vector<Place>& places,
                                                   const std::stop_token& stop) {
    std::vector<std::size_t> parts, wholes;
    std::vector<Box2> wide, boxes;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!isGround(places[i])) continue;
        const Box2 box = bounds(places[i]);
        const glm::vec2 margin{float(besideM)};
        const bool isNamed = hasOwnName(places[i]);
        (isNamed ? wholes : parts).push_back(i);
        (isNamed ? boxes : wide).push_back(isNamed ? box : Box2{box.low - margin, box.high + margin});
    }
    std::vector<std::optional<std::size_t>> found(places.size());
    std::vector<double> most(places.size(), 0);
    for (const auto& [a, b] : findMeetingBoxes(wide, boxes)) {
        if (stop.stop_requested()) break;
        const std::size_t part = parts[a], whole = wholes[b];
        const double weight = weigh(places[part], places[whole]);
        if (weight <= most[part]) continue;
        most[part] = weight;
        found[part] = whole;
    }
    return found;
}

}  // namespace noonmark
