#include "core/study/elements/element_cityjson.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/memory_guard.h"
#include "core/geo/crs_to_lon_lat.h"
#include "core/geo/earth_drop.h"
#include "core/io/files/plain_file.h"
#include "core/io/files/stoppable_stream.h"
#include "core/io/formats/format.h"
#include "core/io/settings/place_advice.h"
#include "core/study/elements/points_on_surfaces.h"

namespace noonmark {

namespace {

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
        const auto rounded = [](double value) { return std::round(value * 1e4) / 1e4; };
        semantic["sunlight_hours_per_day_mean"] = rounded(hours.mean);
        semantic["sunlight_hours_per_day_min"] = rounded(hours.least);
        semantic["sunlight_hours_per_day_max"] = rounded(hours.most);
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
