#include "scenarios/project/ring_json.h"

#include <stdexcept>

namespace noonmark {

using Json = nlohmann::ordered_json;

Json ringJson(const Ring& ring) {
    Json json = Json::array();
    for (const glm::vec2 point : ring) json.push_back({point.x, point.y});
    return json;
}

Ring ringOf(const Json& json) {
    Ring ring;
    for (const Json& point : json) ring.emplace_back(point.at(0).get<float>(), point.at(1).get<float>());
    if (ring.size() < 3) throw std::invalid_argument("a ring of fewer than three points");
    return ring;
}

}  // namespace noonmark
