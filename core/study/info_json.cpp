#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/city/meshes/triangle_count.h"
#include "core/city/terrain/building_ground.h"
#include "core/study/study.h"
#include "core/study/text/height_words.h"
#include "core/study/text/terrain_text.h"
#include "core/study/text/tree_words.h"
#include "core/study/text/warnings_json.h"
#include "core/sun/zone_country.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

// Counts from one pass over the city.
struct Counts {
    std::size_t parts = 0;
    std::size_t overhanging = 0;
    std::size_t triangles = 0;
    float tallestM = 0;
    std::string tallest;
};

void add(Counts& counts, const Part& part) {
    ++counts.parts;
    if (part.isOverhanging) ++counts.overhanging;
    counts.triangles += countTriangles(part);
}

Counts countsOf(const City& city) {
    Counts counts;
    for (const auto& building : city.buildings) {
        for (const Part& part : building->parts) add(counts, part);
        const float height = heightM(*building, city);
        if (height <= counts.tallestM) continue;
        counts.tallestM = height;
        counts.tallest = building->name.empty() ? building->sourceId : building->name;
    }
    return counts;
}

// The lowest and the highest of some values; null without any.
class Range {
public:
    void add(double value) {
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
    }
    [[nodiscard]] Json json() const { return low_ > high_ ? Json() : Json{low_, high_}; }

private:
    double low_ = std::numeric_limits<double>::max();
    double high_ = std::numeric_limits<double>::lowest();
};

// Heights of parts, metres, by their source; sources that no part has are left out.
Json heightRanges(const City& city) {
    std::array<Range, heightSources.size()> ranges;
    for (const auto& building : city.buildings)
        for (const Part& part : building->parts)
            ranges[std::size_t(part.heightSource)].add(double(part.topM) - double(part.bottomM));
    Json json = Json::object();
    for (const HeightSource source : heightSources)
        if (Json range = ranges[std::size_t(source)].json(); !range.is_null())
            json[std::string(nameOf(source))] = std::move(range);
    return json;
}

// Elevations of the ground that buildings stand on, metres above the datum of the city.
Json groundRange(const City& city) {
    Range range;
    for (const auto& building : city.buildings)
        range.add(city.frame.originElevationM() + double(findGroundUnder(*building, city)));
    return range.json();
}

Json extentLonLat(const City& city) {
    const Box2 box = bounds(city);
    if (box.empty()) return nullptr;
    const LonLat low = city.frame.lonLatFromLocal(glm::dvec2(box.low));
    const LonLat high = city.frame.lonLatFromLocal(glm::dvec2(box.high));
    return {low.lonDeg, low.latDeg, high.lonDeg, high.latDeg};
}

// The town nearest to the middle of the buildings; null without a table of towns.
Json townJson(const City& city) {
    const Box2 box = bounds(city);
    if (box.empty()) return nullptr;
    const auto middle = (glm::dvec2(box.low) + glm::dvec2(box.high)) / 2.0;
    const auto town = findNearestTown(city.frame.lonLatFromLocal(middle));
    if (!town) return nullptr;
    return {
        {"name", town->name}, {"country", countryName(town->country)}, {"away_m", std::round(town->awayM)}};
}

}  // namespace

std::string infoJson(const CityRead& read) {
    const Counts counts = countsOf(read.city);
    Json info;
    info["format"] = read.format;
    info["features"] = read.features;
    info["buildings"] = read.city.buildings.size();
    info["parts"] = counts.parts;
    info["parts_hanging"] = counts.overhanging;
    info["triangles"] = counts.triangles;
    info["heights"] = heightsJson(countHeights(read.city), read.heights);
    info["height_sources"] = info["heights"]["by_source"];
    info["height_ranges_m"] = heightRanges(read.city);
    info["ground_m"] = groundRange(read.city);
    info["tallest_m"] = double(counts.tallestM);
    info["tallest"] = counts.tallest;
    info["crs"] = read.crs;
    info["nearest_town"] = townJson(read.city);
    info["extent_lonlat"] = extentLonLat(read.city);
    info["origin_lonlat"] = {read.city.frame.origin().lonDeg, read.city.frame.origin().latDeg};
    info["origin_elevation_m"] = read.city.frame.originElevationM();
    info["terrain"] = read.city.terrain != nullptr;
    info["terrain_source"] = read.city.terrain ? terrainJson(*read.city.terrain) : Json();
    info["trees"] = read.city.trees ? treesJson(*read.city.trees) : Json();
    info["attribution"] = read.attribution;
    info["warnings"] = warningsJson(read.warnings);
    return toJsonText(info);
}

}  // namespace noonmark
