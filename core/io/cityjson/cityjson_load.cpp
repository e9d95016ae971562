#include "core/io/cityjson/cityjson_load.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/io/cityjson/cityjson_geometry.h"
#include "core/io/cityjson/object_values.h"
#include "core/io/files/stoppable_stream.h"
#include "core/io/heights/tree_fields.h"

namespace noonmark {

namespace {

using Json = nlohmann::json;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

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
        vertices.push_back(triple(vertex).value_or(glm::dvec3(nan)) * transform.scale + transform.translate);
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
        : file_(std::move(file)), values_(file_, settings), choice_(choice), stop_(std::move(stop)) {}
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
        std::vector<std::string> names, values;
        const Json& attributes = member(source, "attributes");
        if (attributes.is_object())
            for (const auto& [name, value] : attributes.items()) {
                names.push_back(name);
                values.push_back(formatText(value));
            }
        tree.facts = collectTreeFacts(findTreeFields(names), values, where, data.warnings);
        block.trees.push_back(std::move(tree));
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

bool isBlank(const std::string& line) { return line.find_first_not_of(" \t\r\n") == line.npos; }

// Reads what follows the first value: the features of a sequence. False when stopped.
bool readSequence(StoppableStream& stream, Loader& loader, Progress& progress, const std::stop_token& stop) {
    std::string line;
    for (std::size_t number = 1; std::getline(stream, line); ++number) {
        if (stop.stop_requested()) return false;
        if (isBlank(line)) continue;
        loader.data.sequence = true;
        loader.addFeature(Json::parse(line, nullptr, false), number);
        if (number % 256 == 0) progress.report(stream.share(), "reading the features");
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
    progress.report(0, "reading the city");
    const Json first = firstValue(stream);
    if (stop.stop_requested()) return cancelled();
    if (first.is_discarded())
        return failure("The file is not valid JSON; it may be incomplete", file.string(),
                       "Export or download it again");
    Loader loader(file.filename().string(), settings, *choice, stop);
    if (const auto header = loader.addHeader(first); !header) return tl::make_unexpected(header.error());
    if (stop.stop_requested()) return cancelled();
    if (!readSequence(stream, loader, progress, stop)) return cancelled();
    return std::move(loader.data);
}

}  // namespace noonmark
