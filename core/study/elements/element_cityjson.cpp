#include "core/study/elements/element_models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/json_number.h"
#include "core/base/memory_guard.h"
#include "core/geo/crs.h"
#include "core/geo/frame.h"
#include "core/io/files/plain_file.h"
#include "core/io/formats/format.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

/// Hours of sun of the points on a surface.
struct SurfaceHours {
    std::size_t points = 0;
    double mean = 0, minimum = 0, maximum = 0;  ///< hours a day
};

/// Finds the points of a map that lie on a flat polygon.
class PointsOnSurfaces {
public:
    static constexpr double maxDistanceM = 0.3;        ///< from the plane of the polygon
    explicit PointsOnSurfaces(const ElementMap& map);  ///< the map must outlive it

    /// `rings`: the outer one, then holes; local metres, of finite coordinates, counterclockwise seen from
    /// outside. Returns indices of elements that face as the polygon does and lie inside it.
    [[nodiscard]] std::vector<std::size_t> find(const std::vector<std::vector<glm::dvec3>>& rings) const;

private:
    using Cell = std::pair<int, int>;
    struct HashOfCell {
        std::size_t operator()(const Cell& cell) const {
            return std::size_t(cell.first) * 73856093U ^ std::size_t(cell.second) * 19349663U;
        }
    };
    const ElementMap& map_;
    std::unordered_map<Cell, std::vector<std::size_t>, HashOfCell> cells_;
};

constexpr double cellM = 4, minSameWay = 0.7, maxCells = 1e6;

using Rings = std::vector<std::vector<glm::dvec3>>;

int cellOf(double metres) { return int(std::floor(std::clamp(metres, -1e8, 1e8) / cellM)); }

// Newell's method: for polygons that are not quite flat, too.
glm::dvec3 findNormal(const std::vector<glm::dvec3>& ring) {
    glm::dvec3 normal(0);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        normal += glm::dvec3((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y));
    }
    const double length = glm::length(normal);
    return length > 0 ? normal / length : glm::dvec3(0);
}

glm::dvec3 middleOf(const std::vector<glm::dvec3>& ring) {
    glm::dvec3 sum(0);
    for (const glm::dvec3& corner : ring) sum += corner;
    return sum / double(ring.size());
}

// Even-odd, over all rings, in the plane of the polygon.
bool isInside(const Rings& rings, const PaneAxes& axes, glm::dvec3 place) {
    bool inside = false;
    const glm::dvec2 at(glm::dot(place, axes.along), glm::dot(place, axes.up));
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec3 &one = ring[i], &two = ring[(i + 1) % ring.size()];
            const glm::dvec2 a(glm::dot(one, axes.along), glm::dot(one, axes.up));
            const glm::dvec2 b(glm::dot(two, axes.along), glm::dot(two, axes.up));
            if ((a.y > at.y) == (b.y > at.y)) continue;
            if (at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
        }
    return inside;
}

PointsOnSurfaces::PointsOnSurfaces(const ElementMap& map) : map_(map) {
    for (std::size_t i = 0; i < map_.elements.size(); ++i) {
        const glm::vec3& at = map_.elements[i].position;
        cells_[{cellOf(double(at.x)), cellOf(double(at.y))}].push_back(i);
    }
}

std::vector<std::size_t> PointsOnSurfaces::find(const Rings& rings) const {
    std::vector<std::size_t> found;
    if (rings.empty() || rings.front().size() < 3) return found;
    const glm::dvec3 normal = findNormal(rings.front()), middle = middleOf(rings.front());
    if (normal == glm::dvec3(0)) return found;
    const PaneAxes axes = findPaneAxes(normal);
    glm::dvec2 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
    for (const glm::dvec3& corner : rings.front()) {
        low = glm::min(low, glm::dvec2(corner) - maxDistanceM);
        high = glm::max(high, glm::dvec2(corner) + maxDistanceM);
    }
    if ((high.x - low.x) / cellM * ((high.y - low.y) / cellM) > maxCells) return found;
    for (int x = cellOf(low.x); x <= cellOf(high.x); ++x)
        for (int y = cellOf(low.y); y <= cellOf(high.y); ++y) {
            const auto cell = cells_.find({x, y});
            if (cell == cells_.end()) continue;
            for (const std::size_t i : cell->second) {
                const glm::dvec3 place(map_.elements[i].position);
                const bool isOn = glm::dot(normal, glm::dvec3(map_.elements[i].normal)) > minSameWay &&
                                  std::abs(glm::dot(normal, place - middle)) <= maxDistanceM;
                if (isOn && isInside(rings, axes, place)) found.push_back(i);
            }
        }
    return found;
}

SurfaceHours sumHours(const ElementMap& map, const std::vector<std::size_t>& points) {
    SurfaceHours hours{.points = points.size()};
    if (points.empty()) return hours;
    hours.minimum = std::numeric_limits<double>::max();
    for (const std::size_t i : points) {
        const double sun = map.elements[i].sunlitMin / 60;
        hours.mean += sun / double(points.size());
        hours.minimum = std::min(hours.minimum, sun);
        hours.maximum = std::max(hours.maximum, sun);
    }
    return hours;
}

using CityJson = nlohmann::ordered_json;

constexpr const char* surfaceAdvice =
    "Give the file that the city was read from; its surfaces must be marked as WallSurface, RoofSurface, ...";

constexpr std::array<std::string_view, 6> surfaceTypes{
    "WallSurface", "Window", "Door", "RoofSurface", "OuterCeilingSurface", "ClosureSurface"};

CityJson* findMember(CityJson& object, const char* key) {
    if (!object.is_object()) return nullptr;
    const auto found = object.find(key);
    return found != object.end() ? &*found : nullptr;
}

std::string memberText(CityJson& object, const char* key) {
    const CityJson* member = findMember(object, key);
    return member && member->is_string() ? member->get<std::string>() : std::string();
}

double numberIn(const CityJson& value) {
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

glm::dvec3 readTriple(const CityJson* value, glm::dvec3 otherwise) {
    if (!value || !value->is_array() || value->size() < 3) return otherwise;
    return {numberIn((*value)[0]), numberIn((*value)[1]), numberIn((*value)[2])};
}

/// How many lists lie around the surfaces of a geometry; -1 for other types.
int depthOfType(const std::string& type) {
    if (type == "MultiSurface" || type == "CompositeSurface") return 0;
    if (type == "Solid") return 1;
    return type == "MultiSolid" || type == "CompositeSolid" ? 2 : -1;
}

/// Where the coordinates of a file lie in the city.
struct CityJsonPlacing {
    glm::dvec3 scale{1}, translate{0};
    const CrsToLonLat& crs;
    const City& city;

    [[nodiscard]] std::vector<glm::dvec3> place(CityJson* vertices) const {
        std::vector<glm::dvec3> places;
        if (!vertices || !vertices->is_array()) return places;
        std::vector<glm::dvec2> flat;
        const glm::dvec3 none(std::numeric_limits<double>::quiet_NaN());
        for (const CityJson& vertex : *vertices) {
            places.push_back(readTriple(&vertex, none) * scale + translate);
            flat.emplace_back(places.back());
        }
        const std::vector<LonLat> lonLat = crs.lonLat(flat);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const glm::dvec2 local = city.frame.localFromLonLat(lonLat[i]);
            const double drop = city.terrain ? earthDropM(local) : 0;
            places[i] = {local,
                         places[i].z * crs.metresPerElevationUnit() - city.frame.originElevationM() - drop};
        }
        return places;
    }
};

/// Writes hours into the semantics of one block of objects, which share vertices.
class HoursWriter {
public:
    HoursWriter(const ElementMap& map, const PointsOnSurfaces& finder, CityJsonWithHours& result,
                std::vector<bool>& isOnSurface)
        : map_(map), finder_(finder), result_(result), isOnSurface_(isOnSurface) {}

    void addTo(CityJson& root, std::vector<glm::dvec3> vertices) {
        vertices_ = std::move(vertices);
        CityJson* objects = findMember(root, "CityObjects");
        if (!objects || !objects->is_object()) return;
        for (auto& [id, object] : objects->items())
            if (CityJson* geometries = findMember(object, "geometry"); geometries && geometries->is_array())
                for (CityJson& geometry : *geometries) addToGeometry(geometry);
    }

private:
    void addToGeometry(CityJson& geometry) {
        const int depth = depthOfType(memberText(geometry, "type"));
        CityJson* semantics = findMember(geometry, "semantics");
        if (depth < 0 || !semantics) return;
        CityJson *surfaces = findMember(*semantics, "surfaces"), *values = findMember(*semantics, "values"),
                 *boundaries = findMember(geometry, "boundaries");
        if (!surfaces || !surfaces->is_array() || !values || !boundaries) return;
        uses_.assign(surfaces->size(), 0);
        countUses(*values);
        addToLists(*boundaries, *values, *surfaces, depth);
    }

    void countUses(const CityJson& values) {
        if (values.is_array())
            for (const CityJson& value : values) countUses(value);
        else if (values.is_number_unsigned() && values.get<std::size_t>() < uses_.size())
            ++uses_[values.get<std::size_t>()];
    }

    void addToLists(const CityJson& boundaries, CityJson& values, CityJson& surfaces, int depth) {
        if (!boundaries.is_array() || !values.is_array()) return;
        for (std::size_t i = 0; i < std::min(boundaries.size(), values.size()); ++i)
            depth > 0 ? addToLists(boundaries[i], values[i], surfaces, depth - 1)
                      : addToSurface(boundaries[i], values[i], surfaces);
    }

    void addToSurface(const CityJson& surface, CityJson& value, CityJson& surfaces) {
        if (!value.is_number_unsigned() || value.get<std::size_t>() >= uses_.size()) return;
        const auto index = value.get<std::size_t>();
        const std::string type = memberText(surfaces[index], "type");
        if (std::ranges::find(surfaceTypes, type) == surfaceTypes.end()) return;
        const std::vector<std::size_t> points = finder_.find(ringsOf(surface));
        if (points.empty()) return;
        for (const std::size_t point : points) isOnSurface_[point] = true;
        ++result_.surfaces;
        writeHours(ownObject(value, surfaces), sumHours(map_, points));
    }

    /// The semantic object of this surface alone. Objects below a wall name it by its number, so the first
    /// to leave does not take them along.
    CityJson& ownObject(CityJson& value, CityJson& surfaces) {
        const auto index = value.get<std::size_t>();
        if (uses_[index] == 1) return surfaces[index];
        --uses_[index];
        CityJson copy = surfaces[index];
        copy.erase("children");
        value = surfaces.size();
        surfaces.push_back(std::move(copy));
        return surfaces.back();
    }

    static void writeHours(CityJson& semantic, const SurfaceHours& hours) {
        const auto rounded = [](double value) { return roundAsText(value, 4); };
        semantic["sunlight_hours_per_day_mean"] = rounded(hours.mean);
        semantic["sunlight_hours_per_day_min"] = rounded(hours.minimum);
        semantic["sunlight_hours_per_day_max"] = rounded(hours.maximum);
        semantic["sunlight_points"] = hours.points;
    }

    /// Empty if a corner cannot be used.
    [[nodiscard]] std::vector<std::vector<glm::dvec3>> ringsOf(const CityJson& surface) const {
        std::vector<std::vector<glm::dvec3>> rings;
        if (!surface.is_array()) return rings;
        for (const CityJson& ring : surface) {
            if (!ring.is_array()) return {};
            std::vector<glm::dvec3>& corners = rings.emplace_back();
            for (const CityJson& index : ring) {
                if (!index.is_number_unsigned() || index.get<std::size_t>() >= vertices_.size()) return {};
                const glm::dvec3& corner = vertices_[index.get<std::size_t>()];
                if (!std::isfinite(corner.x + corner.y + corner.z)) return {};
                corners.push_back(corner);
            }
        }
        return rings;
    }

    const ElementMap& map_;
    const PointsOnSurfaces& finder_;
    CityJsonWithHours& result_;
    std::vector<bool>& isOnSurface_;
    std::vector<glm::dvec3> vertices_;
    std::vector<std::size_t> uses_;  // of the semantic objects of a geometry
};

/// The parts of a file: itself, or the lines of a sequence.
Result<std::vector<CityJson>> parseParts(const std::filesystem::path& file, const std::stop_token& stop) {
    if (const auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    StoppableStream stream(file, stop);
    if (!stream.opened()) return failure("The file cannot be read", file.string());
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (stop.stop_requested()) return cancelled();
    std::vector<CityJson> parts;
    CityJson whole = CityJson::parse(text, nullptr, false);
    if (!whole.is_discarded()) parts.push_back(std::move(whole));
    for (std::size_t at = 0; parts.empty() && at < text.size();) {
        if (stop.stop_requested()) return cancelled();
        const std::size_t end = std::min(text.size(), text.find('\n', at));
        CityJson line = CityJson::parse(text.begin() + std::ptrdiff_t(at), text.begin() + std::ptrdiff_t(end),
                                        nullptr, false);
        const bool isBlank = text.find_first_not_of(" \t\r", at) >= end;
        if (line.is_discarded() && !isBlank)
            return failure("This is not CityJSON", file.filename().string(), surfaceAdvice);
        if (!isBlank) parts.push_back(std::move(line));
        at = end + 1;
        if (at >= text.size()) break;
    }
    if (parts.empty() || memberText(parts.front(), "type") != "CityJSON")
        return failure("This is not CityJSON", file.filename().string(), surfaceAdvice);
    return parts;
}

Result<CityJsonWithHours> copyWithHours(const std::filesystem::path& file, const std::string& crs,
                                        const City& city, const ElementMap& map,
                                        const std::stop_token& stop) {
    const std::string name = file.filename().string();
    auto parts = parseParts(file, stop);
    if (!parts) return tl::make_unexpected(parts.error());
    CityJson& header = parts->front();
    CityJson none, *metadata = findMember(header, "metadata"), *transform = findMember(header, "transform");
    const std::string own = memberText(metadata ? *metadata : none, "referenceSystem");
    const std::string stated = own.empty() ? crs : own;
    if (stated.empty()) return failure("The city has no coordinate reference system", name, crsAdvice());
    const auto toLonLat = CrsToLonLat::of(stated);
    if (!toLonLat) return failure(toLonLat.error().what, name, toLonLat.error().advice);
    CityJson& placed = transform ? *transform : none;
    const CityJsonPlacing placing{readTriple(findMember(placed, "scale"), glm::dvec3(1)),
                                  readTriple(findMember(placed, "translate"), glm::dvec3(0)), *toLonLat,
                                  city};
    CityJsonWithHours result;
    std::vector<bool> isOnSurface(map.elements.size());
    const PointsOnSurfaces finder(map);
    HoursWriter writer(map, finder, result, isOnSurface);
    for (CityJson& part : *parts) {
        if (stop.stop_requested()) return cancelled();
        writer.addTo(part, placing.place(findMember(part, "vertices")));
        result.text += part.dump(-1, ' ', false, CityJson::error_handler_t::replace) + '\n';
    }
    result.points = std::size_t(std::ranges::count(isOnSurface, true));
    if (result.surfaces == 0)
        return failure("None of the file's surfaces has a point of the study", name, surfaceAdvice);
    return result;
}

}  // namespace

Result<CityJsonWithHours> addHoursToCityJson(const std::filesystem::path& file, const std::string& crs,
                                             const City& city, const ElementMap& map,
                                             const std::stop_token& stop) {
    return guardMemory({.what = "the copy of the CityJSON file", .advice = "Divide the file"},
                       [&] { return copyWithHours(file, crs, city, map, stop); });
}

std::optional<std::string> copyCityJsonOf(const ElementStudy& study, const ElementMap& map,
                                          const std::stop_token& stop) {
    const Provenance& provenance = study.provenance;
    if (provenance.inputs.size() != 1) return std::nullopt;
    const InputFile& input = provenance.inputs.front();
    if (findByEnding(input.path, FileKind::cityJson) == nullptr) return std::nullopt;
    const auto now = describeInputFile(input.path);
    if (!now || now->sha256 != input.sha256) return std::nullopt;
    const std::string crs = provenance.reading ? provenance.reading->crs.value_or("") : "";
    auto copy = addHoursToCityJson(input.path, crs, study.city, map, stop);
    return copy ? std::optional(std::move(copy->text)) : std::nullopt;
}

}  // namespace noonmark
