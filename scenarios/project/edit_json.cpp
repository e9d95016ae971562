#include "scenarios/project/edit_json.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/base/json_number.h"
#include "core/base/safe_text.h"
#include "core/describe/field_json.h"
#include "core/describe/field_values.h"
#include "core/io/settings/read_settings.h"
#include "scenarios/massing/massing_fields.h"
#include "scenarios/massing/tower_design.h"
#include "scenarios/project/tables/geometry_blob.h"

namespace noonmark {

namespace {

/// The design of a tower as it is saved with its edit (docs/project-file.md). What has its default is left
/// out.
nlohmann::ordered_json toJson(const TowerDesign& design);

/// The design that toJson() wrote. Throws nlohmann's exceptions or std::invalid_argument where a member is
/// missing, of the wrong type or out of range. The settings may still be impossible on the lot: makeMassing()
/// tells.
DesignOfShape parseDesign(const nlohmann::ordered_json& json);

using Json = nlohmann::ordered_json;

constexpr std::size_t maxEntries = 500;  // setbacks or uses of one tower

template <class S>
Json partJson(const Fields<S>& fields, const S& settings) {
    return fieldsJson(fields.of(settings), {.which = FieldJson::Which::stated});
}

// With its plate, even where that is the whole lot.
template <class S>
Json withPlate(Json json, const Fields<S>& fields, const S& settings) {
    json.update(partJson(fields, settings));
    if (!json.contains("plate")) json["plate"] = Json::object();
    return json;
}

// Throws for what is missing, of another kind or out of range.
template <class S>
S partFrom(const Fields<S>& fields, const Json& json) {
    S settings;
    for (const Field& field : fields.rows())
        if (field.restated) (void)json.at(std::string(field.key));
    auto read = readFieldsJson(fields.of(settings), json);
    if (read) read = checkRanges(fields.of(settings));
    if (!read) throw std::invalid_argument(read.error().what);
    return settings;
}

// An absent list is empty.
template <class S>
std::vector<S> listFrom(const Json& json, const char* member, const Fields<S>& fields) {
    std::vector<S> list;
    if (!json.contains(member)) return list;
    if (json.at(member).size() > maxEntries) throw std::invalid_argument("too many entries");
    for (const Json& one : json.at(member)) list.push_back(partFrom(fields, one));
    return list;
}

MassingSettings parseSettings(const Json& json) {
    (void)json.at("plate");
    MassingSettings settings = partFrom(massingFields(), json);
    if (json.contains("podium")) {
        (void)json.at("podium").at("plate");
        settings.podium = partFrom(podiumFields(), json.at("podium"));
    }
    settings.setbacks = listFrom(json, "setbacks", setbackFields());
    settings.uses = listFrom(json, "uses", floorUseFields());
    settings.further = listFrom(json, "further", furtherTowerFields());
    return settings;
}

Json toJson(const TowerDesign& design) {
    const MassingSettings& settings = design.settings;
    Json json{
        {"lot", design.lotName}, {"lot_outer", ringJson(design.lot.outer)}, {"lot_holes", Json::array()}};
    for (const Ring& hole : design.lot.holes) json["lot_holes"].push_back(ringJson(hole));
    json = withPlate(std::move(json), massingFields(), settings);
    if (settings.podium) json["podium"] = withPlate(Json::object(), podiumFields(), *settings.podium);
    for (const Setback& setback : settings.setbacks)
        json["setbacks"].push_back(partJson(setbackFields(), setback));
    for (const FloorUse& use : settings.uses) json["uses"].push_back(partJson(floorUseFields(), use));
    for (const FurtherTower& tower : settings.further)
        json["further"].push_back(partJson(furtherTowerFields(), tower));
    return json;
}

DesignOfShape parseDesign(const Json& json) {
    auto design = std::make_shared<TowerDesign>();
    design->lotName = json.at("lot").get<std::string>();
    design->lot.outer = parseRing(json.at("lot_outer"));
    for (const Json& hole : json.at("lot_holes")) design->lot.holes.push_back(parseRing(hole));
    design->settings = parseSettings(json);
    return design;
}

}  // namespace

namespace {

constexpr NumberLimits scaleLimits{1e-6, 1e6};
constexpr NumberLimits storeyOrNoneM{0, 10};
constexpr NumberLimits angleLimitsDeg{-1e6, 1e6};
constexpr NumberLimits treeLimitsM{0, 1000};
constexpr NumberLimits yearLimits{0, 1000};

std::string wordsIn(const Json& json, const char* key) {
    return cleanText(json.at(key).get_ref<const std::string&>());
}

Json toJson(const TriangleMesh& mesh) {
    Json vertices = Json::array(), triangles = Json::array();
    for (const glm::vec3 point : mesh.vertices) vertices.push_back({point.x, point.y, point.z});
    for (const glm::uvec3 corner : mesh.triangles) triangles.push_back({corner.x, corner.y, corner.z});
    return {{"vertices", vertices}, {"triangles", triangles}};
}

std::shared_ptr<const TriangleMesh> meshOf(const Json& json) {
    auto mesh = std::make_shared<TriangleMesh>();
    for (const Json& at : json.at("vertices"))
        mesh->vertices.emplace_back(float(numberFrom(at.at(0), placeLimitsM)),
                                    float(numberFrom(at.at(1), placeLimitsM)),
                                    float(numberFrom(at.at(2), elevationLimitsM)));
    for (const Json& at : json.at("triangles")) {
        const glm::uvec3 corners{wholeNumberFrom<unsigned>(at.at(0)), wholeNumberFrom<unsigned>(at.at(1)),
                                 wholeNumberFrom<unsigned>(at.at(2))};
        for (int i = 0; i < 3; ++i)
            if (corners[i] >= mesh->vertices.size())
                throw std::invalid_argument("a triangle names a vertex that does not exist");
        mesh->triangles.push_back(corners);
    }
    return mesh;
}

Json toJson(const Part& part) {
    Json holes = Json::array();
    for (const Ring& hole : part.footprint.holes) holes.push_back(ringJson(hole));
    Json json{{"source_id", part.sourceId},
              {"outer", ringJson(part.footprint.outer)},
              {"holes", holes},
              {"bottom_m", part.bottomM},
              {"top_m", part.topM},
              {"height_source", nameOf(part.heightSource)},
              {"hangs", part.isOverhanging}};
    if (part.mesh) json["mesh"] = toJson(*part.mesh);
    return json;
}

Part cutInterval(const Json& json) {
    Part part{.sourceId = wordsIn(json, "source_id"), .footprint = {parseRing(json.at("outer")), {}}};
    for (const Json& hole : json.at("holes")) part.footprint.holes.push_back(parseRing(hole));
    part.bottomM = float(numberFrom(json.at("bottom_m"), elevationLimitsM));
    part.topM = float(numberFrom(json.at("top_m"), elevationLimitsM));
    if (!(part.topM > part.bottomM)) throw std::invalid_argument("a part without a height");
    if (const auto source = parseHeightSource(json.at("height_source").get<std::string>()))
        part.heightSource = *source;
    part.isOverhanging = json.at("hangs").get<bool>();
    if (json.contains("mesh")) part.mesh = meshOf(json.at("mesh"));
    return part;
}

Json toJson(const Building& building) {
    Json parts = Json::array();
    for (const Part& part : building.parts) parts.push_back(toJson(part));
    return {
        {"id", building.sourceId}, {"name", building.name}, {"status", building.status}, {"parts", parts}};
}

NewShape shapeOf(const Json& json) {
    Building building{
        .sourceId = wordsIn(json, "id"), .name = wordsIn(json, "name"), .status = wordsIn(json, "status")};
    for (const Json& part : json.at("parts")) building.parts.push_back(cutInterval(part));
    if (building.parts.empty()) throw std::invalid_argument("a building without parts");
    return std::make_shared<const Building>(std::move(building));
}

Json withDesign(Json json, const DesignOfShape& design) {
    if (design) json["design"] = toJson(*design);
    return json;
}

DesignOfShape designOf(const Json& json) {
    return json.contains("design") ? parseDesign(json.at("design")) : nullptr;
}

Json treeJson(const Tree& tree) { return fieldsJson(treeRecordFields().of(tree)); }

Tree treeOf(const Json& json) {
    Tree tree = partFrom(treeRecordFields(), json);
    tree.sourceId = cleanText(tree.sourceId);
    tree.species = cleanText(tree.species);
    return tree;
}

double storeyHeightOf(const Json& json) {
    return json.contains("storey_height_m") ? numberFrom(json.at("storey_height_m"), storeyOrNoneM) : 0;
}

// Those of a later version are not understood and left.
std::string readingOf(const Json& json) {
    if (!json.contains("reading")) return {};
    const auto reading = readSettingsFrom(json.at("reading").dump());
    return reading ? formatText(*reading) : std::string();
}

double readScaleOf(const Json& json) {
    return json.contains("read_scale") ? numberFrom(json.at("read_scale"), scaleLimits) : 1;
}

struct Writer {
    Json operator()(const Demolish& edit) const { return {{"building", edit.building}}; }
    Json operator()(const Replace& edit) const {
        return withDesign({{"building", edit.building}, {"with", toJson(*edit.with)}}, edit.design);
    }
    Json operator()(const AddBuilding& edit) const {
        return withDesign({{"with", toJson(*edit.building)}}, edit.design);
    }
    Json operator()(const ChangeHeight& edit) const {
        return {{"building", edit.building}, {"height_m", edit.heightM}};
    }
    Json operator()(const Move& edit) const {
        return {{"building", edit.building}, {"east_m", edit.byM.x}, {"north_m", edit.byM.y}};
    }
    Json operator()(const Rotate& edit) const {
        return {{"building", edit.building}, {"clockwise_deg", edit.clockwiseDeg}};
    }
    Json operator()(const ImportMesh& edit) const {
        Json json{{"with", toJson(*edit.shape)},
                  {"file", edit.file},
                  {"about_m", {edit.placement.about.x, edit.placement.about.y}},
                  {"scale", edit.placement.scale},
                  {"clockwise_deg", edit.placement.clockwiseDeg},
                  {"east_m", edit.placement.byM.x},
                  {"north_m", edit.placement.byM.y}};
        if (edit.storeyHeightM > 0) json["storey_height_m"] = edit.storeyHeightM;
        if (!edit.reading.empty()) json["reading"] = Json::parse(edit.reading);
        if (edit.readScale != 1) json["read_scale"] = edit.readScale;
        return json;
    }
    Json operator()(const PlantTree& edit) const { return {{"with", treeJson(edit.tree)}}; }
    Json operator()(const FellTree& edit) const { return {{"tree", edit.tree}}; }
    Json operator()(const ReplaceTree& edit) const {
        return {{"tree", edit.tree}, {"with", treeJson(edit.with)}};
    }
    Json operator()(const MoveTree& edit) const {
        return {{"tree", edit.tree}, {"east_m", edit.byM.x}, {"north_m", edit.byM.y}};
    }
    Json operator()(const GrowTree& edit) const {
        return {{"tree", edit.tree},
                {"years", edit.years},
                {"height_m", edit.heightM},
                {"crown_base_m", edit.crownBaseM},
                {"crown_diameter_m", edit.crownDiameterM}};
    }
};

glm::dvec2 moveOf(const Json& json) {
    return {numberFrom(json.at("east_m"), placeLimitsM), numberFrom(json.at("north_m"), placeLimitsM)};
}

Placement placementOf(const Json& json) {
    const Json& about = json.at("about_m");
    return {.about = {numberFrom(about.at(0), placeLimitsM), numberFrom(about.at(1), placeLimitsM)},
            .scale = numberFrom(json.at("scale"), scaleLimits),
            .clockwiseDeg = numberFrom(json.at("clockwise_deg"), angleLimitsDeg),
            .byM = moveOf(json)};
}

Edit read(const std::string& kind, const Json& json) {
    const auto building = [&] { return wordsIn(json, "building"); };
    if (kind == "demolish") return Demolish{building()};
    if (kind == "replace") return Replace{building(), shapeOf(json.at("with")), designOf(json)};
    if (kind == "add") return AddBuilding{shapeOf(json.at("with")), designOf(json)};
    if (kind == "height") return ChangeHeight{building(), numberFrom(json.at("height_m"), elevationLimitsM)};
    if (kind == "move") return Move{building(), moveOf(json)};
    if (kind == "rotate") return Rotate{building(), numberFrom(json.at("clockwise_deg"), angleLimitsDeg)};
    if (kind == "import")
        return ImportMesh{shapeOf(json.at("with")), placementOf(json), wordsIn(json, "file"),
                          storeyHeightOf(json),     readingOf(json),   readScaleOf(json)};
    const auto tree = [&] { return wordsIn(json, "tree"); };
    const auto lengthM = [&](const char* key) { return numberFrom(json.at(key), treeLimitsM); };
    if (kind == "plant") return PlantTree{treeOf(json.at("with"))};
    if (kind == "fell") return FellTree{tree()};
    if (kind == "replace-tree") return ReplaceTree{tree(), treeOf(json.at("with"))};
    if (kind == "move-tree") return MoveTree{tree(), moveOf(json)};
    if (kind == "grow")
        return GrowTree{tree(), numberFrom(json.at("years"), yearLimits), lengthM("height_m"),
                        lengthM("crown_base_m"), lengthM("crown_diameter_m")};
    throw std::invalid_argument("an edit of an unknown kind");
}

}  // namespace

// Invalid UTF-8 is replaced: names read from files may contain it.
std::string toJson(const Edit& edit) {
    return std::visit(Writer{}, edit).dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<Edit> parseEdit(const std::string& kind, const std::string& json) try {
    return read(kind, Json::parse(json));
} catch (const std::exception& error) {
    return failure(std::string("An edit cannot be read (") + error.what() + ")", "edit '" + kind + "'",
                   "The project file is damaged, or was written by another program");
}

}  // namespace noonmark
