#include "core/study/region_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/geo/longitude.h"

namespace noonmark {

namespace {

constexpr double toleranceDeg = 1e-7;  // 1 cm of latitude

struct LonLatBox {
    LonLat low{1e9, 1e9};
    LonLat high{-1e9, -1e9};

    void add(LonLat place) {
        low = {std::min(low.lonDeg, place.lonDeg), std::min(low.latDeg, place.latDeg)};
        high = {std::max(high.lonDeg, place.lonDeg), std::max(high.latDeg, place.latDeg)};
    }
    [[nodiscard]] bool onSide(LonLat place) const {
        const auto near = [](double a, double b) { return std::abs(a - b) < toleranceDeg; };
        return near(place.lonDeg, low.lonDeg) || near(place.lonDeg, high.lonDeg) ||
               near(place.latDeg, low.latDeg) || near(place.latDeg, high.latDeg);
    }
};

/// Twice the signed area of the ring, square degrees.
double doubleArea(const std::vector<LonLat>& ring) {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const LonLat a = ring[i];
        const LonLat b = ring[(i + 1) % ring.size()];
        sum += (a.lonDeg - ring[0].lonDeg) * (b.latDeg - ring[0].latDeg) -
               (b.lonDeg - ring[0].lonDeg) * (a.latDeg - ring[0].latDeg);
    }
    return sum;
}

// Longitudes run on across the antimeridian: 179.9, 180.1.
std::vector<LonLat> lonLatOf(const Ring& ring, const Frame& frame) {
    std::vector<LonLat> places;
    places.reserve(ring.size());
    for (const glm::vec2 point : ring) {
        const LonLat place = frame.lonLatFromLocal(glm::dvec2(point));
        places.push_back({longitudeNear(place.lonDeg, frame.origin().lonDeg), place.latDeg});
    }
    return places;
}

/// 7 decimals, 1 cm, without the zeros at the end.
std::string degreesText(double degrees) {
    const double rounded = std::round(degrees * 1e7) / 1e7;
    return fmt::format("{}", rounded == 0 ? 0.0 : rounded);
}

nlohmann::ordered_json ringJson(const Ring& ring, const Frame& frame) {
    auto json = nlohmann::ordered_json::array();
    const auto rounded = [](double degrees) { return std::round(degrees * 1e9) / 1e9; };
    for (const LonLat place : lonLatOf(ring, frame))
        json.push_back({rounded(place.lonDeg), rounded(place.latDeg)});
    if (!json.empty()) json.push_back(json.front());
    return json;
}

nlohmann::ordered_json polygonJson(const Footprint& polygon, const Frame& frame) {
    auto json = nlohmann::ordered_json::array({ringJson(polygon.outer, frame)});
    for (const Ring& hole : polygon.holes) json.push_back(ringJson(hole, frame));
    return json;
}

}  // namespace

std::optional<std::string> boxTextOf(const Region& region, const Frame& frame) {
    if (region.polygons.size() != 1 || !region.polygons[0].holes.empty()) return std::nullopt;
    const std::vector<LonLat> ring = lonLatOf(region.polygons[0].outer, frame);
    LonLatBox box;
    for (const LonLat place : ring) box.add(place);
    if (!std::ranges::all_of(ring, [&](LonLat place) { return box.onSide(place); })) return std::nullopt;
    // A ring along the sides that cuts no corner has the area of the box.
    const double lon = box.high.lonDeg - box.low.lonDeg;
    const double lat = box.high.latDeg - box.low.latDeg;
    if (std::abs(std::abs(doubleArea(ring)) / 2 - lon * lat) > 2 * toleranceDeg * (lon + lat))
        return std::nullopt;
    return fmt::format("{},{},{},{}", degreesText(usualLongitude(box.low.lonDeg)),
                       degreesText(box.low.latDeg), degreesText(usualLongitude(box.high.lonDeg)),
                       degreesText(box.high.latDeg));
}

std::string regionGeoJson(const Region& region, const Frame& frame) {
    auto polygons = nlohmann::ordered_json::array();
    for (const Footprint& polygon : region.polygons) polygons.push_back(polygonJson(polygon, frame));
    nlohmann::ordered_json json;
    json["type"] = "Feature";
    json["properties"] = {{"name", region.name}};
    json["geometry"] = {{"type", "MultiPolygon"}, {"coordinates", polygons}};
    return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace noonmark
