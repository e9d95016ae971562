#include "core/io/cityjson/cityjson_load.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <span>

#include "core/describe/text.h"
#include "core/geo/crs.h"
#include "core/geo/lon_lat.h"
#include "core/io/pieces/read_part.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

// The box of an object's vertices: longitude, latitude, metres of elevation.
struct PlaceBox {
    glm::dvec3 low{1e30};
    glm::dvec3 high{-1e30};
    void add(glm::dvec3 place) {
        if (!std::isfinite(place.x) || !std::isfinite(place.y) || !std::isfinite(place.z)) return;
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    void add(const PlaceBox& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    [[nodiscard]] bool empty() const { return low.x > high.x; }
    [[nodiscard]] LonLat middle() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2}; }
};

void addVertices(const std::optional<CityJsonGeometry>& geometry, const std::vector<glm::dvec3>& places,
                 PlaceBox& box) {
    if (!geometry) return;
    for (const CityJsonBody& body : geometry->bodies)
        for (const auto& shell : body)
            for (const Surface& surface : shell)
                for (const auto& ring : surface)
                    for (const auto index : ring) box.add(places[index]);
}

PlaceBox computeBox(const CityJsonObject& object, const std::vector<glm::dvec3>& places) {
    PlaceBox box;
    addVertices(object.body, places, box);
    addVertices(object.footprint, places, box);
    return box;
}

// Transforms the file's coordinates to longitude, latitude and metres. All longitudes are taken near the
// first, so that a city on both sides of 180 degrees stays together.
void toPlaces(std::span<glm::dvec3> vertices, const CrsToLonLat& crs, std::optional<double>& nearDeg) {
    const std::vector<glm::dvec2> points(vertices.begin(), vertices.end());
    const std::vector<LonLat> places = crs.lonLat(points);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!nearDeg && std::isfinite(places[i].lonDeg)) nearDeg = places[i].lonDeg;
        vertices[i] = {wrapLongitudeNear(places[i].lonDeg, nearDeg.value_or(0)), places[i].latDeg,
                       vertices[i].z * crs.metresPerElevationUnit()};
    }
}

// False when stopped.
bool toPlaces(CityJsonData& data, const CrsToLonLat& crs, const std::stop_token& stop) {
    constexpr std::size_t atOnce = 1U << 16U;  // some 0.1 s
    std::optional<double> nearDeg;
    for (CityJsonBlock& block : data.blocks)
        for (std::size_t first = 0; first < block.vertices.size(); first += atOnce) {
            if (stop.stop_requested()) return false;
            const std::span all(block.vertices);
            toPlaces(all.subspan(first, std::min(atOnce, all.size() - first)), crs, nearDeg);
        }
    return true;
}

// The box of every object, in order, including empty boxes.
std::vector<PlaceBox> boxesOf(const CityJsonData& data) {
    std::vector<PlaceBox> boxes;
    for (const CityJsonBlock& block : data.blocks)
        for (const CityJsonObject& object : block.objects)
            boxes.push_back(computeBox(object, block.vertices));
    return boxes;
}

double quantile(std::vector<double> values, double share) {
    const auto at = values.begin() + std::ptrdiff_t(double(values.size() - 1) * share);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

// Nothing if no object has a position.
std::optional<LonLat> medianOf(const std::vector<PlaceBox>& boxes) {
    std::vector<double> lons, lats;
    for (const PlaceBox& box : boxes) {
        if (box.empty()) continue;
        lons.push_back(box.middle().lonDeg);
        lats.push_back(box.middle().latDeg);
    }
    if (lons.empty()) return std::nullopt;
    return LonLat{wrapLongitude(quantile(std::move(lons), 0.5)), quantile(std::move(lats), 0.5)};
}

// Removes distant objects from the data and their boxes from the list.
void leaveOutFar(CityJsonData& data, std::vector<PlaceBox>& boxes, LonLat median, double farAwayM,
                 const std::string& file) {
    std::vector<PlaceBox> kept;
    std::size_t next = 0;
    for (CityJsonBlock& block : data.blocks)
        std::erase_if(block.objects, [&](const CityJsonObject& object) {
            const PlaceBox& box = boxes[next++];
            const bool far = !box.empty() && computeGreatCircleM(box.middle(), median) > farAwayM;
            if (far)
                data.warnings.push_back({WarningKind::leftOut, NM_TEXT("far from the middle of the data"),
                                         file + ": " + object.id});
            else
                kept.push_back(box);
            return far;
        });
    boxes = std::move(kept);
}

double groundLevel(const CityJsonData& data, const std::vector<PlaceBox>& boxes) {
    std::vector<double> buildings, terrain;
    std::size_t next = 0;
    for (const CityJsonBlock& block : data.blocks)
        for (const CityJsonObject& object : block.objects) {
            const PlaceBox& box = boxes[next++];
            if (!box.empty()) (object.type == "TINRelief" ? terrain : buildings).push_back(box.low.z);
        }
    if (!buildings.empty()) return quantile(std::move(buildings), 0.05);
    return terrain.empty() ? 0 : quantile(std::move(terrain), 0);
}

Frame chosenFrame(const CityJsonData& data, const std::vector<PlaceBox>& boxes) {
    PlaceBox all;
    for (const PlaceBox& box : boxes) all.add(box);
    const LonLat middle = all.middle();
    return Frame({wrapLongitude(middle.lonDeg), middle.latDeg}, groundLevel(data, boxes));
}

void toLocal(CityJsonData& data, const Frame& frame) {
    for (CityJsonBlock& block : data.blocks)
        for (glm::dvec3& vertex : block.vertices)
            vertex = {frame.localFromLonLat({vertex.x, vertex.y}), vertex.z - frame.originElevationM()};
}

}  // namespace

Result<Frame> placeCity(CityJsonData& data, const ReadSettings& settings, const std::string& file,
                        const std::stop_token& stop) {
    const std::string text = data.crs.empty() ? settings.crs.value_or("") : data.crs;
    if (text.empty()) return failure("The city has no coordinate reference system", file, crsAdvice());
    Result<CrsToLonLat> crs = CrsToLonLat::of(text);
    if (!crs) return failure(crs.error().what, file, crs.error().advice);
    crs->removeZoneNumber();
    data.crsText = describeCrs(crs->name(), data.crs.empty() ? CrsSource::user : CrsSource::file);
    if (!crs->elevationUnitIsStated() && crs->metresPerElevationUnit() != 1)
        data.warnings.push_back(
            {WarningKind::assumed, "elevations have no unit; the unit of the map is assumed", file});
    if (!toPlaces(data, *crs, stop)) return cancelled();
    if (crs->hasRemovedZoneNumber())
        data.warnings.push_back({WarningKind::assumed, std::string(zoneNumberRemoved), file});
    std::vector<PlaceBox> boxes = boxesOf(data);
    const std::optional<LonLat> median = medianOf(boxes);
    if (!median && boxes.empty())
        return failure("The file holds no buildings and no terrain", file,
                       "Choose a file that contains some");
    if (!median || !crs->isPlausible(*median))
        return failure(fmt::format("The coordinates cannot belong to {}", crs->name()), file,
                       "Check which coordinate reference system they are in");
    leaveOutFar(data, boxes, *median, settings.farAwayM, file);
    const Frame frame = settings.frame ? *settings.frame : chosenFrame(data, boxes);
    toLocal(data, frame);
    return frame;
}

}  // namespace noonmark
