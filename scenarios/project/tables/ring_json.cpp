#include "scenarios/project/tables/ring_json.h"

#include <stdexcept>

namespace noonmark {

using Json = nlohmann::ordered_json;

Json ringJson(const Ring& ring) {
    Json json = Json::array();
    for (const glm::vec2 point : ring) json.push_back({point.x, point.y});
    return json;
}

Ring parseRing(const Json& json) {
    Ring ring;
    for (const Json& point : json)
        ring.emplace_back(float(numberFrom(point.at(0), placeLimitsM)),
                          float(numberFrom(point.at(1), placeLimitsM)));
    if (ring.size() < 3) throw std::invalid_argument("a ring of fewer than three points");
    return ring;
}

double numberFrom(const Json& json, const NumberLimits& limits) {
    const auto value = json.get<double>();
    if (!isWithin(value, limits)) throw std::invalid_argument("a number is out of range");
    return value;
}

}  // namespace noonmark
