#include "core/study/text/region_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/geo/lon_lat.h"

namespace noonmark {

namespace {

struct StatedBox {
    LonLat low{1e9, 1e9};
    LonLat high{-1e9, -1e9};

    void add(LonLat place) {
        low = {std::min(low.lonDeg, place.lonDeg), std::min(low.latDeg, place.latDeg)};
        high = {std::max(high.lonDeg, place.lonDeg), std::max(high.latDeg, place.latDeg)};
    }
};

double roundDegrees(double degrees, int decimals) {
    const double scale = std::pow(10.0, decimals);
    const double value = std::round(degrees * scale) / scale;
    return value == 0 ? 0.0 : value;  // avoids -0
}

StatedBox roundDegrees(const StatedBox& box, int decimals) {
    return {{roundDegrees(box.low.lonDeg, decimals), roundDegrees(box.low.latDeg, decimals)},
            {roundDegrees(box.high.lonDeg, decimals), roundDegrees(box.high.latDeg, decimals)}};
}

// Longitudes continue across the antimeridian: 179.9, 180.1.
LonLat placeOf(glm::dvec2 local, const Frame& frame) {
    const LonLat place = frame.lonLatFromLocal(local);
    return {wrapLongitudeNear(place.lonDeg, frame.origin().lonDeg), place.latDeg};
}

bool isBox(const Region& region, const StatedBox& box, const Frame& frame) {
    const auto made = makeRegionFromLonLatBox(frame, wrapLongitude(box.low.lonDeg), box.low.latDeg,
                                              wrapLongitude(box.high.lonDeg), box.high.latDeg);
    return made && made->polygons == region.polygons;
}

// Sides shorter than this are left straight by readRegion, whose limit is 500 m (ogr_polygons_gdal.cpp),
// degrees.
constexpr double longestSideDeg = 400.0 / 111320;

// Adds points from one corner up to the next (not included), along the side that is straight in the local
// plane.
void addSideJson(nlohmann::ordered_json& json, glm::dvec2 from, glm::dvec2 to, const Frame& frame) {
    const LonLat a = placeOf(from, frame), b = placeOf(to, frame);
    const double degrees = std::hypot(b.lonDeg - a.lonDeg, b.latDeg - a.latDeg);
    const int pieces = std::max(1, int(std::ceil(degrees / longestSideDeg)));
    for (int i = 0; i < pieces; ++i) {
        const glm::dvec2 point(glm::vec2(from + (to - from) * (double(i) / pieces)));
        const LonLat place = placeOf(point, frame);
        json.push_back({place.lonDeg, place.latDeg});
    }
}

nlohmann::ordered_json ringJson(const Ring& ring, const Frame& frame) {
    auto json = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < ring.size(); ++i)
        addSideJson(json, glm::dvec2(ring[i]), glm::dvec2(ring[(i + 1) % ring.size()]), frame);
    if (!json.empty()) json.push_back(json.front());
    return json;
}

nlohmann::ordered_json polygonJson(const Footprint& polygon, const Frame& frame) {
    auto json = nlohmann::ordered_json::array({ringJson(polygon.outer, frame)});
    for (const Ring& hole : polygon.holes) json.push_back(ringJson(hole, frame));
    return json;
}

}  // namespace

std::optional<std::string> formatBox(const Region& region, const Frame& frame) {
    if (region.polygons.size() != 1 || !region.polygons[0].holes.empty()) return std::nullopt;
    StatedBox box;
    for (const glm::vec2 point : region.polygons[0].outer) box.add(placeOf(glm::dvec2(point), frame));
    constexpr int maxDecimals = 14;
    for (int decimals = 2; decimals <= maxDecimals; ++decimals) {
        const StatedBox stated = roundDegrees(box, decimals);
        if (isBox(region, stated, frame))
            return fmt::format("{},{},{},{}", roundDegrees(wrapLongitude(stated.low.lonDeg), decimals),
                               stated.low.latDeg, roundDegrees(wrapLongitude(stated.high.lonDeg), decimals),
                               stated.high.latDeg);
    }
    return std::nullopt;
}

std::string formatRegion(const Region& region, const City& city) {
    if (const auto box = formatBox(region, city.frame)) return *box;
    const Box2 whole = bounds(city);
    const bool isCity = !whole.empty() && region.polygons == makeRegionFromLocalBox(whole).polygons;
    return isCity ? "city" : regionFileName;
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

// A box that was typed has no name of its own.
std::string nameOf(const Region& region) { return region.name == "box" ? std::string() : region.name; }

}  // namespace noonmark
