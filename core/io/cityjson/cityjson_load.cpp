#include "core/io/cityjson/cityjson_load.h"

#include <fmt/format.h>
#include <array>
#include <charconv>
#include <cmath>
#include <istream>
#include <limits>
#include <nlohmann/json.hpp>
#include <streambuf>
#include <string>

#include "core/base/cgroup_limits.h"
#include "core/describe/text.h"
#include "core/io/files/json_nesting.h"
#include "core/io/files/plain_file.h"
#include "core/io/heights/tree_fields.h"

namespace noonmark {

const nlohmann::json& memberIn(const nlohmann::json& object, const char* key) {
    static const nlohmann::json none;
    const auto place = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && place != object.end() ? *place : none;
}

std::string textIn(const nlohmann::json& value) {
    return value.is_string() ? value.get<std::string>() : std::string();
}

std::optional<double> lodIn(const nlohmann::json& geometry) {
    const nlohmann::json& value = memberIn(geometry, "lod");
    if (value.is_number()) return value.get<double>();
    const std::string text = textIn(value);
    double lod = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), lod);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(lod) : std::nullopt;
}

namespace {

/// Fills `object.body` and `object.footprint` from the object's "geometry": the body is the best of the
/// levels of detail 1 and above (cityjson_model.h). Surfaces with indices beyond `vertexCount` are dropped
/// with a warning, which names the object as `where`.
void chooseGeometry(const nlohmann::json& geometries, const LodChoice& choice, std::size_t vertexCount,
                    const std::string& where, CityJsonObject& object, Warnings& warnings);

using Json = nlohmann::json;

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
    const std::string type = textIn(memberIn(geometry, "type"));
    const Json& boundaries = memberIn(geometry, "boundaries");
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
        const std::string type = textIn(memberIn(geometry, "type"));
        result.templates = result.templates || type == "GeometryInstance";
        if (!isSolidType(type) && !isSurfaceType(type)) continue;
        const Candidate candidate{&geometry, {lodIn(geometry).value_or(1), isSolidType(type)}};
        keepBetter(candidate.rank.lod < 1 ? result.footprint : result.body, candidate,
                   candidate.rank.lod < 1 ? LodChoice{} : choice);
    }
    if (choice.wished && *choice.wished < 1) result.body.reset();
    return result;
}

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

constexpr double unreadableNumber = std::numeric_limits<double>::quiet_NaN();

const Json& member(const Json& object, const char* key) {
    static const Json none;
    if (!object.is_object()) return none;
    const auto place = object.find(key);
    return place != object.end() ? *place : none;
}

std::string formatText(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    return value.is_number() ? value.dump() : std::string();
}

// The file's integers times scale, plus translate; without a transform the numbers unchanged.
struct Transform {
    glm::dvec3 scale{1};
    glm::dvec3 translate{0};
};

std::optional<glm::dvec3> triple(const Json& value) {
    if (!value.is_array() || value.size() < 3) return std::nullopt;
    for (int i = 0; i < 3; ++i)
        if (!value[std::size_t(i)].is_number()) return std::nullopt;
    return glm::dvec3(value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
}

Transform transformOf(const Json& root) {
    const Json& transform = member(root, "transform");
    return {triple(member(transform, "scale")).value_or(glm::dvec3(1)),
            triple(member(transform, "translate")).value_or(glm::dvec3(0))};
}

// An invalid vertex becomes NaN: the surfaces that use it are dropped later.
std::vector<glm::dvec3> verticesOf(const Json& root, const Transform& transform) {
    std::vector<glm::dvec3> vertices;
    const Json& list = member(root, "vertices");
    if (!list.is_array()) return vertices;
    vertices.reserve(list.size());
    for (const Json& vertex : list)
        vertices.push_back(triple(vertex).value_or(glm::dvec3(unreadableNumber)) * transform.scale +
                           transform.translate);
    return vertices;
}

std::string crsOf(const Json& root) {
    const Json& metadata = member(root, "metadata");
    const std::string stated = formatText(member(metadata, "referenceSystem"));
    if (!stated.empty()) return stated;
    const std::string epsg = formatText(member(member(metadata, "crs"), "epsg"));  // before 1.0
    return epsg.empty() ? std::string() : "EPSG:" + epsg;
}

bool isOfBuilding(const std::string& type) {
    return type == "Building" || type == "BuildingPart" || type == "BuildingInstallation";
}

std::string firstOf(const Json& list) {
    return list.is_array() && !list.empty() ? formatText(list[0]) : std::string();
}

// The indices in nested lists.
void collectVertices(const Json& boundaries, std::size_t vertexCount, std::vector<std::size_t>& vertices) {
    if (boundaries.is_number_unsigned() && boundaries.get<std::size_t>() < vertexCount)
        vertices.push_back(boundaries.get<std::size_t>());
    if (boundaries.is_array())
        for (const Json& inner : boundaries) collectVertices(inner, vertexCount, vertices);
}

class Loader {
public:
    Loader(std::string file, const ReadSettings& settings, LodChoice choice, std::stop_token stop)
        : file_(std::move(file)), values_(settings), choice_(choice), stop_(std::move(stop)) {}
    CityJsonData data;

    Result<void> addHeader(const Json& root) {
        if (formatText(member(root, "type")) != "CityJSON")
            return failure("This is not CityJSON", file_,
                           "A sequence (CityJSONSeq) must begin with a line of type CityJSON");
        data.version = formatText(member(root, "version"));
        data.crs = crsOf(root);
        data.attribution =
            formatText(member(member(member(root, "metadata"), "pointOfContact"), "contactName"));
        transform_ = transformOf(root);
        if (!data.version.starts_with("1.") && !data.version.starts_with("2."))
            warn(WarningKind::assumed, "its version is unknown; it was read as 2.0",
                 file_ + " (" + data.version + ")");
        addBlock(root);
        return {};
    }

    // One line of a sequence.
    void addFeature(const Json& feature, std::size_t line) {
        if (formatText(member(feature, "type")) == "CityJSONFeature" &&
            member(feature, "CityObjects").is_object())
            addBlock(feature);
        else
            warn(WarningKind::dropped, "a line that is not a CityJSON feature",
                 fmt::format("{}: line {}", file_, line));
    }

private:
    void warn(WarningKind kind, std::string what, std::string where) {
        data.warnings.push_back({kind, std::move(what), std::move(where)});
    }

    void addBlock(const Json& root) {
        CityJsonBlock block{verticesOf(root, transform_), {}, {}};
        const Json& objects = member(root, "CityObjects");
        if (!objects.is_object() || objects.empty()) return;
        for (const auto& [id, object] : objects.items()) {
            if (stop_.stop_requested()) return;
            addObject(id, object, block);
        }
        if (!block.objects.empty() || !block.trees.empty()) data.blocks.push_back(std::move(block));
    }

    void addObject(const std::string& id, const Json& source, CityJsonBlock& block) {
        ++data.features;
        CityJsonObject object{.id = id,
                              .type = formatText(member(source, "type")),
                              .parent = firstOf(member(source, "parents"))};
        const std::string where = file_ + ": " + id;
        if (object.type == "SolitaryVegetationObject") return addTree(source, where, block);
        if (object.type == "PlantCover") return addPlants(source, where, std::move(object), block);
        if (!isOfBuilding(object.type) && object.type != "TINRelief")
            return warn(
                WarningKind::leftOut,
                fmt::format("not a building but {}", object.type.empty() ? "without a type" : object.type),
                where);
        const Json& attributes = member(source, "attributes");
        object.name = formatText(member(attributes, "name"));
        object.status = formatText(member(attributes, "status"));
        addValues(attributes, object);
        chooseGeometry(member(source, "geometry"), choice_, block.vertices.size(), where, object,
                       data.warnings);
        block.objects.push_back(std::move(object));
    }

    void addTree(const Json& source, const std::string& where, CityJsonBlock& block) {
        CityJsonTree tree;
        const Json& geometries = member(source, "geometry");
        for (std::size_t i = 0; geometries.is_array() && i < geometries.size() && tree.vertices.empty(); ++i)
            collectVertices(member(geometries[i], "boundaries"), block.vertices.size(), tree.vertices);
        if (tree.vertices.empty()) return warn(WarningKind::leftOut, "a tree without a place", where);
        tree.facts = factsOf(source, where);
        block.trees.push_back(std::move(tree));
    }

    void addPlants(const Json& source, const std::string& where, CityJsonObject object,
                   CityJsonBlock& block) {
        chooseGeometry(member(source, "geometry"), choice_, block.vertices.size(), where, object,
                       data.warnings);
        CityJsonTree plants = makePlantCover(object, factsOf(source, where));
        if (plants.vertices.empty())
            return warn(WarningKind::leftOut, "an area of plants without a shape", where);
        block.trees.push_back(std::move(plants));
    }

    TreeFacts factsOf(const Json& source, const std::string& where) {
        std::vector<std::string> names, values;
        const Json& attributes = member(source, "attributes");
        if (attributes.is_object())
            for (const auto& [name, value] : attributes.items()) {
                names.push_back(name);
                values.push_back(formatText(value));
            }
        return collectTreeFacts(findTreeFields(names), values, where, data.warnings);
    }

    void addValues(const Json& attributes, CityJsonObject& object) {
        if (!attributes.is_object()) return;
        std::vector<ObjectAttribute> all;
        for (const auto& [name, value] : attributes.items()) {
            ObjectAttribute attribute{name, formatText(value), {}};
            if (value.is_number()) attribute.number = value.get<double>();
            all.push_back(std::move(attribute));
        }
        values_.add(all, object, data);
    }

    std::string file_;
    ObjectValues values_;
    LodChoice choice_;
    std::stop_token stop_;
    Transform transform_;
};

// Some 10 GB of memory for a city; 24 for empty lists, so that the memory itself is watched, too.
constexpr std::uintmax_t maxValueBytes = std::uintmax_t(1) << 30;

/// The file's bytes, which end where the first value is nested too deep, and where one is too long.
class BoundedJson : private std::streambuf, public std::istream {
public:
    explicit BoundedJson(std::istream& from) : std::istream(this), from_(from) {}

    /// What ended the bytes; nothing: the file itself.
    [[nodiscard]] std::optional<Error> limit() const { return limit_; }
    void beginLine() { isFirst_ = false, left_ = maxValueBytes; }

private:
    using Traits = std::char_traits<char>;
    int underflow() override {
        if (limit_ || !from_) return Traits::eof();
        from_.read(piece_.data(), std::streamsize(piece_.size()));
        const auto count = std::size_t(from_.gcount());
        if (isFirst_ && !nesting_.take({piece_.data(), count}))
            limit_ =
                limitReached(fmt::format("Its values are nested more than {} deep", JsonNesting::maxLevels))
                    .value();
        else if (count > left_)
            limit_ = limitReached("One of its values has more than 1 GB", {},
                                  "Divide it, or export it as CityJSONSeq, a feature a line")
                         .value();
        else if (++pieces_ % piecesBetweenLooks == 0 && memory_.isShort())
            limit_ = limitReached("It needs more than three quarters of the free memory", {},
                                  "Divide it, export it as CityJSONSeq, or close other programs")
                         .value();
        if (limit_ || count == 0) return Traits::eof();
        left_ -= count;
        setg(piece_.data(), piece_.data(), piece_.data() + count);
        return Traits::to_int_type(piece_[0]);
    }

    std::istream& from_;
    JsonNesting nesting_;
    bool isFirst_ = true;
    std::uintmax_t left_ = maxValueBytes;
    std::optional<Error> limit_;
    MemoryWatch memory_;
    std::size_t pieces_ = 0;
    static constexpr std::size_t piecesBetweenLooks = 64;  // 4 MB: at most 100 MB of memory
    std::array<char, 1U << 16U> piece_{};
};

bool isBlank(const std::string& line) { return line.find_first_not_of(" \t\r\n") == line.npos; }

// Reads what follows the first value: the features of a sequence. False when stopped.
bool readSequence(BoundedJson& json, const StoppableStream& stream, Loader& loader, Progress& progress,
                  const std::stop_token& stop) {
    std::string line;
    for (std::size_t number = 1; json.beginLine(), std::getline(json, line); ++number) {
        if (stop.stop_requested()) return false;
        if (isBlank(line)) continue;
        loader.data.sequence = true;
        const bool isShallow = JsonNesting().take(line);
        loader.addFeature(isShallow ? Json::parse(line, nullptr, false) : Json(Json::value_t::discarded),
                          number);
        if (number % 256 == 0) progress.report(stream.share(), NM_TEXT("reading the features"));
    }
    return true;
}

// The first value of the file; a discarded value if it is not JSON.
Json firstValue(std::istream& stream) try {
    Json first;
    stream >> first;
    return first;
} catch (const std::exception&) {
    return Json(Json::value_t::discarded);
}

}  // namespace

Result<CityJsonData> loadCityJson(const std::filesystem::path& file, const ReadSettings& settings,
                                  Progress& progress, const std::stop_token& stop) {
    const Result<LodChoice> choice = parseLodChoice(settings.lod);
    if (!choice) return tl::make_unexpected(choice.error());
    StoppableStream stream(file, stop);
    if (!stream.opened())
        return failure("The file cannot be opened", file.string(),
                       "Check that it is there and that you may read it");
    progress.report(0, NM_TEXT("reading the city"));
    BoundedJson json(stream);
    const Json first = firstValue(json);
    if (stop.stop_requested()) return cancelled();
    const auto refused = [&] {
        return limitReached(json.limit()->what, file.string(), json.limit()->advice);
    };
    if (json.limit()) return refused();
    if (first.is_discarded())
        return failure("The file is not valid JSON; it may be incomplete", file.string(),
                       "Export or download it again");
    Loader loader(file.filename().string(), settings, *choice, stop);
    if (const auto header = loader.addHeader(first); !header) return tl::make_unexpected(header.error());
    if (stop.stop_requested()) return cancelled();
    if (!readSequence(json, stream, loader, progress, stop)) return cancelled();
    if (json.limit()) return refused();
    return std::move(loader.data);
}

}  // namespace noonmark
