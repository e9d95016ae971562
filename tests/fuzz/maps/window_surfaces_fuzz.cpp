// Surfaces of CityJSON and CityJSONSeq that are marked as windows or doors, and their receivers in a city of
// one house.
#include <cmath>
#include <set>

#include "core/io/elements/read_glazing.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

namespace noonmark::tests {

namespace {

City makeHouse() {
    City city;
    city.frame = Frame(LonLat{3.9957, 51.9176});
    Building house;
    house.sourceId = "house";
    house.parts.push_back({.footprint = {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}}, .bottomM = 0, .topM = 9});
    city.buildings.push_back(std::make_shared<const Building>(house));
    return city;
}

void requireSound(const GlazingRead& read) {
    require(!read.windows.empty(), "a file without windows is an error");
    require(read.windows.size() <= GlazingFileSettings::maxWindows, "more windows than the limit");
    for (const GlazingShape& window : read.windows) {
        require(!window.id.empty(), "a window without an id");
        require(window.corners.size() >= 3, "a surface has at least three corners");
        for (const glm::dvec3& corner : window.corners)
            require(std::isfinite(corner.x) && std::isfinite(corner.y) && std::isfinite(corner.z),
                    "a corner that is not finite");
    }
}

void requireSound(const GlazingPlaced& placed) {
    std::set<std::string> ids;
    for (std::size_t i = 0; i < placed.receivers.size(); ++i) {
        const glm::vec3 normal = placed.receivers.points.normals[i];
        require(std::abs(glm::length(normal) - 1) < 1e-3F, "a normal that is no unit vector");
        require(ids.insert(placed.receivers.elements[i].id).second, "an id that occurs twice");
    }
}

}  // namespace

}  // namespace noonmark::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    static const noonmark::City city = makeHouse();
    const auto file = fuzzFile("windows.city.json", formatText(data, size));
    const auto read = noonmark::readCityJsonGlazing(file, {.crs = "EPSG:7415"}, city, {});
    if (!read) {
        requireSound(read.error());
        return 0;
    }
    requireSound(*read);
    const auto everywhere = noonmark::makeRegionFromLocalBox({{-1e5, -1e5}, {1e5, 1e5}});
    requireSound(noonmark::placeGlazing(city, everywhere, read->windows, {}));
    return 0;
}
