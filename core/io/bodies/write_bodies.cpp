#include "core/io/bodies/write_bodies.h"

#include <fmt/format.h>
#include <unordered_set>

#include "core/geo/frame.h"
#include "core/io/shadows/ogr_drawing.h"

namespace noonmark {

namespace {

// Two buildings may have the same name.
std::string nameOf(const Building& building, std::unordered_set<std::string>& taken) {
    const std::string own = !building.name.empty()       ? building.name
                            : !building.sourceId.empty() ? building.sourceId
                                                         : std::string("building");
    std::string name = own;
    for (int copy = 2; !taken.insert(name).second; ++copy) name = fmt::format("{} ({})", own, copy);
    return name;
}

// Local z is lower than the elevation by the earth's drop where there is terrain.
glm::dvec3 placeVertex(glm::dvec3 local, const City& city, const OgrDrawing& drawing) {
    const glm::dvec2 place(local);
    const double dropM = city.terrain ? earthDropM(place) : 0;
    return {drawing.place(place), local.z + city.frame.originElevationM() + dropM};
}

void addPart(const Part& part, const City& city, const OgrDrawing& drawing, Body& body) {
    const TriangleMesh mesh = meshOf(part);
    const auto first = glm::uvec3(unsigned(body.vertices.size()));
    for (const glm::vec3 vertex : mesh.vertices)
        body.vertices.push_back(placeVertex(glm::dvec3(vertex), city, drawing));
    for (const glm::uvec3 triangle : mesh.triangles) body.triangles.push_back(triangle + first);
}

}  // namespace

Result<BodySet> collectBodies(const City& city, DrawingPlane plane,
                              const std::function<bool(const Building&)>& isProposed) {
    const auto drawing = OgrDrawing::inPlane(city.frame, plane);
    if (!drawing) return tl::make_unexpected(drawing.error());
    auto words = describePlane(city.frame, plane);
    if (!words) return tl::make_unexpected(words.error());
    BodySet set{{}, *words + "; heights above the datum of the city's data"};
    std::unordered_set<std::string> names;
    for (const auto& building : city.buildings) {
        Body body{.name = nameOf(*building, names), .isProposed = isProposed(*building)};
        for (const Part& part : building->parts) addPart(part, city, *drawing, body);
        set.bodies.push_back(std::move(body));
    }
    return set;
}

}  // namespace noonmark
