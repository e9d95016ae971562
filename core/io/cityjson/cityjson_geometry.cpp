#include "core/io/cityjson/cityjson_geometry.h"

#include <fmt/format.h>

#include <charconv>

namespace noonmark {

namespace {

using Json = nlohmann::json;

const Json& member(const Json& object, const char* key) {
    static const Json none;
    const auto place = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && place != object.end() ? *place : none;
}

std::string formatText(const Json& value) {
    return value.is_string() ? value.get<std::string>() : std::string();
}

// A number in version 1.0, text in later versions.
std::optional<double> lodOf(const Json& value) {
    if (value.is_number()) return value.get<double>();
    const std::string text = formatText(value);
    double lod = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), lod);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(lod) : std::nullopt;
}

// Reads boundaries; counts and drops malformed ones.
class BoundaryReader {
public:
    explicit BoundaryReader(std::size_t vertexCount) : vertexCount_(vertexCount) {}
    std::size_t broken = 0;

    std::vector<CityJsonBody> solids(const Json& list) {
        std::vector<CityJsonBody> result;
        for (const Json& item : listOf(list)) result.push_back(solid(item));
        return result;
    }
    CityJsonBody solid(const Json& list) {
        CityJsonBody result;
        for (const Json& shell : listOf(list)) result.push_back(surfaces(shell));
        return result;
    }
    std::vector<Surface> surfaces(const Json& list) {
        std::vector<Surface> result;
        for (const Json& item : listOf(list)) {
            Surface one = surface(item);
            if (!one.empty()) result.push_back(std::move(one));
        }
        return result;
    }

private:
    // An empty list if the value is not a list.
    const Json& listOf(const Json& value) {
        static const Json empty = Json::array();
        if (value.is_array()) return value;
        ++broken;
        return empty;
    }
    Surface surface(const Json& rings) {
        Surface result;
        for (const Json& ring : listOf(rings)) {
            std::vector<std::uint32_t> indices;
            if (!readRing(ring, indices)) {
                ++broken;
                return {};
            }
            result.push_back(std::move(indices));
        }
        return result;
    }
    bool readRing(const Json& ring, std::vector<std::uint32_t>& indices) const {
        if (!ring.is_array()) return false;
        for (const Json& index : ring) {
            if (!index.is_number_unsigned() || index.get<std::uint64_t>() >= vertexCount_) return false;
            indices.push_back(std::uint32_t(index.get<std::uint64_t>()));
        }
        return true;
    }
    std::size_t vertexCount_;
};

bool isSolidType(const std::string& type) {
    return type == "Solid" || type == "MultiSolid" || type == "CompositeSolid";
}
bool isSurfaceType(const std::string& type) { return type == "MultiSurface" || type == "CompositeSurface"; }

CityJsonGeometry parseGeometry(const Json& geometry, double lod, BoundaryReader& reader) {
    const std::string type = formatText(member(geometry, "type"));
    const Json& boundaries = member(geometry, "boundaries");
    CityJsonGeometry result{lod, isSolidType(type), {}};
    if (type == "Solid")
        result.bodies.push_back(reader.solid(boundaries));
    else if (result.solid)
        result.bodies = reader.solids(boundaries);
    else
        result.bodies.push_back({reader.surfaces(boundaries)});
    return result;
}

// A geometry of an object that could be chosen.
struct Candidate {
    const Json* geometry;
    LodRank rank;
};

// The best body and the best footprint; null if there is none.
struct Chosen {
    std::optional<Candidate> body;
    std::optional<Candidate> footprint;
    bool templates = false;
};

void keepBetter(std::optional<Candidate>& best, const Candidate& candidate, const LodChoice& choice) {
    if (!best || isBetter(candidate.rank, best->rank, choice)) best = candidate;
}

Chosen choose(const Json& geometries, const LodChoice& choice) {
    Chosen result;
    if (!geometries.is_array()) return result;
    for (const Json& geometry : geometries) {
        const std::string type = formatText(member(geometry, "type"));
        result.templates = result.templates || type == "GeometryInstance";
        if (!isSolidType(type) && !isSurfaceType(type)) continue;
        const Candidate candidate{&geometry, {lodOf(member(geometry, "lod")).value_or(1), isSolidType(type)}};
        keepBetter(candidate.rank.lod < 1 ? result.footprint : result.body, candidate,
                   candidate.rank.lod < 1 ? LodChoice{} : choice);
    }
    if (choice.wished && *choice.wished < 1) result.body.reset();
    return result;
}

}  // namespace

void chooseGeometry(const Json& geometries, const LodChoice& choice, std::size_t vertexCount,
                    const std::string& where, CityJsonObject& object, Warnings& warnings) {
    const Chosen best = choose(geometries, choice);
    BoundaryReader reader(vertexCount);
    if (best.body) object.body = parseGeometry(*best.body->geometry, best.body->rank.lod, reader);
    if (best.footprint)
        object.footprint = parseGeometry(*best.footprint->geometry, best.footprint->rank.lod, reader);
    if (best.templates) warnings.push_back({WarningKind::dropped, "geometry templates are not read", where});
    if (best.body && choice.wished && best.body->rank.lod != *choice.wished)
        warnings.push_back({WarningKind::assumed,
                            "the wanted level of detail is missing; the next one is used",
                            fmt::format("{} ({:g})", where, best.body->rank.lod)});
    if (reader.broken > 0)
        warnings.push_back({WarningKind::dropped, "surfaces with missing vertices",
                            fmt::format("{} ({})", where, reader.broken)});
}

}  // namespace noonmark
