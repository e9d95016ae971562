#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/base/safe_text.h"
#include "core/city/map_context.h"
#include "core/city/trees/tree_facts.h"
#include "core/describe/field_values.h"
#include "core/io/settings/read_settings.h"
#include "core/study/text/height_facts_text.h"
#include "core/study/text/terrain_text.h"
#include "scenarios/project/read_project.h"
#include "scenarios/project/tables/database.h"
#include "scenarios/project/tables/geometry_blob.h"
#include "scenarios/project/tables/geopackage.h"
#include "scenarios/project/write_project.h"

namespace noonmark {

namespace {

template <class T>
std::vector<T> readValues(std::string_view bytes) {
    if (bytes.size() % sizeof(T) != 0) throwDamaged("a list of numbers is cut off");
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

using Meshes = std::unordered_map<std::int64_t, std::shared_ptr<const TriangleMesh>>;

Meshes readMeshes(Database& database) {
    Meshes meshes;
    Statement row = database.prepare("SELECT id, vertices, triangles FROM meshes");
    while (row.step()) {
        auto mesh = std::make_shared<TriangleMesh>();
        mesh->vertices = readValues<glm::vec3>(row.blob(1));
        mesh->triangles = readValues<glm::uvec3>(row.blob(2));
        const CheckedRow checked(row, "meshes");
        if (mesh->triangles.empty()) checked.refuse("the mesh is empty");
        for (const glm::vec3 v : mesh->vertices)
            if (!isWithin(double(v.x), placeLimitsM) || !isWithin(double(v.y), placeLimitsM) ||
                !isWithin(double(v.z), elevationLimitsM))
                checked.refuse("a vertex of the mesh is out of range");
        for (const glm::uvec3 t : mesh->triangles)
            if (std::max({t.x, t.y, t.z}) >= mesh->vertices.size())
                throwDamaged("a mesh triangle names a vertex that does not exist");
        meshes.emplace(row.integer(0), std::move(mesh));
    }
    return meshes;
}

void addParts(const Statement& row, const Meshes& meshes, Building& building) {
    const CheckedRow checked(row, "buildings");
    auto polygons = toPolygons(row.blob(1));
    if (!polygons) checked.refuse("a building has an invalid outline");
    for (Footprint& polygon : *polygons) {
        Part part{.sourceId = cleanText(row.text(3)),
                  .footprint = std::move(polygon),
                  .bottomM = float(checked.number(8, "bottom_m", elevationLimitsM)),
                  .topM = float(checked.number(9, "top_m", elevationLimitsM)),
                  .heightSource = parseHeightSource(row.text(6)).value_or(HeightSource::assumed),
                  .isOverhanging = row.integer(7) != 0};
        if (!(part.topM > part.bottomM)) checked.refuse("a building has no height");
        if (const auto mesh = meshes.find(row.integer(0)); mesh != meshes.end()) part.mesh = mesh->second;
        building.parts.push_back(std::move(part));
    }
}

std::vector<std::shared_ptr<const Building>> readBuildings(Database& database) {
    const Meshes meshes = readMeshes(database);
    std::vector<std::shared_ptr<const Building>> buildings;
    // Rows are in the order of the buildings unless a building was changed later.
    Statement row = database.prepare(
        "SELECT fid, geom, building_id, source_id, name, status, height_source, hangs, bottom_m, top_m, "
        "building "
        "FROM buildings ORDER BY building, fid");
    std::int64_t last = -1;
    Building building;
    const auto finish = [&] {
        if (!building.parts.empty())
            buildings.push_back(std::make_shared<const Building>(std::move(building)));
        building = {};
    };
    while (row.step()) {
        if (row.integer(10) != last) finish();
        last = row.integer(10);
        // Buildings are saved under these numbers.
        if (last != std::int64_t(buildings.size())) throwDamaged("buildings are missing");
        building.sourceId = cleanText(row.text(2));
        building.name = cleanText(row.text(4));
        building.status = cleanText(row.text(5));
        addParts(row, meshes, building);
    }
    finish();
    return buildings;
}

std::shared_ptr<const Terrain> readTerrain(Database& database) {
    Statement row =
        database.prepare("SELECT id, west_m, south_m, cell_m, columns, rows, elevations_m FROM terrain");
    if (!row.step()) return nullptr;
    auto terrain = std::make_shared<Terrain>();
    const CheckedRow checked(row, "terrain");
    terrain->grid = checked.grid(1);
    terrain->elevationM = readValues<float>(row.blob(6));
    if (terrain->elevationM.size() != terrain->grid.size())
        checked.refuse("elevations_m does not have one value per cell");
    for (const float elevation : terrain->elevationM)
        if (!isWithin(double(elevation), elevationLimitsM)) checked.refuse("an elevation is out of range");
    // Older files have no such row; their posts are cell centres.
    if (!takeSource(readFact(database, "terrain_source"), *terrain))
        checked.refuse("the terrain has an invalid position");
    return terrain;
}

double numberOf(Database& database, const std::string& key, const NumberLimits& limits) {
    const std::string text = readFact(database, key);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !isWithin(value, limits))
        throwDamaged(fmt::format("table noonmark, {}: not {:g} to {:g}", key, limits.low, limits.high));
    return value;
}

}  // namespace

std::shared_ptr<const City> readCityTables(Database& database, Warnings& warnings) {
    auto city = std::make_shared<City>();
    const LonLat origin{numberOf(database, "origin_lon_deg", {-360, 360}),
                        numberOf(database, "origin_lat_deg", {-90, 90})};
    city->frame = Frame(origin, numberOf(database, "origin_elevation_m", elevationLimitsM));
    city->buildings = readBuildings(database);
    city->terrain = readTerrain(database);
    city->context = readContext(database);
    city->trees = readTreeTable(database, *city, warnings);
    return city;
}

// Reads and writes the layer `trees` and the row `leaf_days` of the table `noonmark`.

namespace {

constexpr const char* leafDaysKey = "leaf_days";
constexpr double thinnestM = 0.01;  // a tree has some height and a crown some width

NumberLimits treeLimitsOf(const char* key, double lowest = 0) {
    const ValueRange range = *fieldWithKey(treeRecordFields().rows(), key).range;
    return {std::max(range.min, lowest), range.max};
}

LeafDays readLeafDays(Database& database, const City& city) {
    const std::string text = readFact(database, leafDaysKey);
    if (text.empty()) return assumeLeafDays(city.frame.origin().latDeg);
    int on = 0, off = 0;
    const bool both = std::sscanf(text.c_str(), "%d-%d", &on, &off) == 2;
    if (!both || on < 1 || off < 1 || on > 366 || off > 366)
        throwDamaged("table noonmark, leaf_days: not two days of a year");
    return {on, off};
}

/// Trees whose layer states what is not used.
struct TreeRepairs {
    std::size_t words = 0;  ///< that are unknown
    std::size_t bases = 0;  ///< of crowns, not below the top
    std::size_t days = 0;   ///< in and out of leaf, which are no days

    [[nodiscard]] Warnings list() const {
        Warnings warnings;
        const auto say = [&](const char* what, std::size_t count) {
            if (count > 0)
                warnings.push_back({WarningKind::repaired, what, fmt::format("layer trees ({})", count)});
        };
        say("unknown words for the shape of trees or the source of a figure; what follows from their species "
            "is used",
            words);
        say("the crown's base lies above the tree's top; a share of the height is used", bases);
        say("leaf days of trees that are no days of the year (MM-DD); those of the city's trees are used",
            days);
        return warnings;
    }
};

/// One row of the layer, which a GIS program may have left incomplete.
class TreeRow {
public:
    TreeRow(const Statement& row, TreeRepairs& repairs)
        : row_(row), checked_(row, "trees"), repairs_(repairs) {}

    [[nodiscard]] Tree read() const {
        const auto points = toPoints(row_.blob(1));
        if (!points || points->size() != 1) checked_.refuse("a tree has no place");
        TreeFacts facts{.sourceId = cleanText(row_.text(2)),
                        .species = cleanText(row_.text(3)),
                        .heightM = stated(4, "height_m", thinnestM),
                        .crownDiameterM = stated(5, "crown_diameter_m", thinnestM),
                        .crownBaseM = stated(6, "crown_base_m")};
        if (facts.sourceId.empty()) facts.sourceId = fmt::format("tree {}", row_.integer(0));
        if (!row_.isNull(8)) facts.evergreen = row_.integer(8) != 0;
        Tree tree = completeTree(facts);
        tree.place = glm::dvec2(points->front());
        takeStated(tree);
        if (facts.crownBaseM && !(float(*facts.crownBaseM) < tree.heightM)) ++repairs_.bases;
        return tree;
    }

private:
    [[nodiscard]] std::optional<double> stated(int column, const char* name, double lowest = 0) const {
        if (row_.isNull(column)) return std::nullopt;
        return checked_.number(column, name, treeLimitsOf(name, lowest));
    }

    void takeStated(Tree& tree) const {
        const std::array known{takeWord(7, parseCrownShape, tree.shape),
                               takeWord(9, parseTreeSource, tree.heightSource),
                               takeWord(10, parseTreeSource, tree.crownSource)};
        if (std::ranges::find(known, false) != known.end()) ++repairs_.words;
        if (const auto share = stated(11, "leaf_on")) tree.leafOnTransmissivity = float(*share);
        if (const auto share = stated(12, "leaf_off")) tree.leafOffTransmissivity = float(*share);
        takeDay(13, tree.leafOnDay);
        takeDay(14, tree.leafOffDay);
    }

    void takeDay(int column, std::optional<int>& day) const {
        const std::string text = row_.text(column);
        if (text.empty()) return;
        const auto stated = parseDayOfYear(text);
        if (stated)
            day = *stated;
        else
            ++repairs_.days;
    }

    // False if the row states a word that is none.
    template <class Word>
    bool takeWord(int column, std::optional<Word> (*parse)(std::string_view), Word& word) const {
        const auto text = row_.text(column);
        const std::optional<Word> found = parse(text);
        word = found.value_or(word);
        return found || text.empty();
    }

    const Statement& row_;
    CheckedRow checked_;
    TreeRepairs& repairs_;
};

}  // namespace

std::shared_ptr<const Trees> readTreeTable(Database& database, const City& city, Warnings& warnings) {
    Trees trees{.trees = {}, .leafDays = readLeafDays(database, city)};
    Statement row = database.prepare(
        "SELECT fid, geom, tree_id, species, height_m, crown_diameter_m, crown_base_m, shape, evergreen, "
        "height_source, crown_source, leaf_on, leaf_off, leaf_on_day, leaf_off_day FROM trees "
        "WHERE geom IS NOT NULL ORDER BY fid");
    std::unordered_set<std::string> used;
    TreeRepairs repairs;
    while (row.step()) {
        Tree tree = TreeRow(row, repairs).read();
        const std::string own = tree.sourceId;  // a copied row of a GIS program has that of its original
        for (int copy = 2; !used.insert(tree.sourceId).second; ++copy)
            tree.sourceId = fmt::format("{} ({})", own, copy);
        tree.groundM = groundAt(city, tree.place);
        trees.trees.push_back(std::move(tree));
    }
    std::ranges::move(repairs.list(), std::back_inserter(warnings));
    return trees.trees.empty() ? nullptr : std::make_shared<const Trees>(std::move(trees));
}

void writeTrees(Database& database, const Trees* trees) {
    database.execute("DELETE FROM trees");
    if (trees == nullptr) return removeFact(database, leafDaysKey);
    setFact(database, leafDaysKey, fmt::format("{}-{}", trees->leafDays.on, trees->leafDays.off));
    Statement add = database.prepare(
        "INSERT INTO trees (geom, tree_id, species, height_m, crown_diameter_m, crown_base_m, shape, "
        "evergreen, height_source, crown_source, leaf_on, leaf_off, leaf_on_day, leaf_off_day) VALUES (?, ?, "
        "?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    const auto written = [](const std::optional<int>& day) {
        return day ? std::optional(formatDayOfYear(*day)) : std::nullopt;
    };
    Box2 box;
    for (const Tree& tree : trees->trees) {
        const glm::vec2 place(tree.place);
        add.run(AsBlob{pointBlob(place)}, tree.sourceId, tree.species, tree.heightM, tree.crownDiameterM,
                tree.crownBaseM, nameOf(tree.shape), tree.evergreen, nameOf(tree.heightSource),
                nameOf(tree.crownSource), tree.leafOnTransmissivity, tree.leafOffTransmissivity,
                written(tree.leafOnDay), written(tree.leafOffDay));
        box.add(place);
    }
    touchLayer(database, "trees", double(box.low.x), double(box.low.y), double(box.high.x),
               double(box.high.y));
}

// Reads and writes the table `context`: what maps draw for orientation. All trees are one feature.

namespace {

constexpr const char* attributionKey = "context_attribution";
constexpr NumberLimits widthLimitsM{0, 1000};

Box2 boxOf(const MapContext& context) {
    Box2 box;
    for (const ContextArea& area : context.areas)
        for (const Footprint& polygon : area.polygons) box.add(bounds(polygon));
    for (const ContextLine& line : context.lines)
        for (const glm::vec2 point : line.points) box.add(point);
    for (const glm::vec2 tree : context.trees) box.add(tree);
    return box;
}

void readLine(const Statement& row, ContextKind kind, MapContext& context) {
    const CheckedRow checked(row, "context");
    auto points = toPoints(row.blob(1));
    if (!points) checked.refuse("the shape is not valid");
    if (kind == ContextKind::tree)
        context.trees.insert(context.trees.end(), points->begin(), points->end());
    else if (points->size() > 1)
        context.lines.push_back({kind, row.text(3),
                                 row.isNull(4) ? 2.0F : float(checked.number(4, "width_m", widthLimitsM)),
                                 *std::move(points)});
}

}  // namespace

void writeContext(Database& database, const MapContext* context) {
    database.execute("DELETE FROM context");
    setFact(database, attributionKey, context == nullptr ? std::string() : context->attribution);
    if (context == nullptr) return;
    Statement add = database.prepare("INSERT INTO context (geom, kind, name, width_m) VALUES (?, ?, ?, ?)");
    for (const ContextArea& area : context->areas)
        add.run(AsBlob{multiPolygonBlob(area.polygons)}, nameOf(area.kind), area.name,
                std::optional<double>{});
    for (const ContextLine& line : context->lines)
        add.run(AsBlob{lineBlob(line.points)}, nameOf(line.kind), line.name,
                std::optional<double>(line.widthM));
    if (!context->trees.empty())
        add.run(AsBlob{multiPointBlob(context->trees)}, nameOf(ContextKind::tree), "",
                std::optional<double>{});
    const Box2 box = boxOf(*context);
    touchLayer(database, "context", double(box.low.x), double(box.low.y), double(box.high.x),
               double(box.high.y));
}

std::shared_ptr<const MapContext> readContext(Database& database) {
    auto context = std::make_shared<MapContext>();
    Statement row = database.prepare("SELECT fid, geom, kind, name, width_m FROM context ORDER BY fid");
    while (row.step()) {
        const auto kind = parseContextKind(row.text(2));
        if (!kind) continue;  // of a later version, or drawn in a GIS program
        if (auto polygons = toPolygons(row.blob(1)))
            context->areas.push_back({*kind, row.text(3), *std::move(polygons)});
        else
            readLine(row, *kind, *context);
    }
    context->attribution = readFact(database, attributionKey);
    return context->empty() ? nullptr : context;
}

// Reads and writes how the city was read: the tables `warning_texts` and `warnings`, and the rows
// `read_settings` and `height_fields` of the table `noonmark`.

namespace {

constexpr const char* settingsKey = "read_settings";
constexpr const char* heightsKey = "height_fields";
constexpr std::array warningKinds{WarningKind::repaired, WarningKind::clipped, WarningKind::dropped,
                                  WarningKind::leftOut, WarningKind::assumed};

// As a project file names the kind. Files of all versions say "mended" for what was repaired.
std::string_view storedNameOf(WarningKind kind) {
    return kind == WarningKind::repaired ? "mended" : nameOf(kind);
}

// Number of a text in warning_texts; new texts are added.
class WarningTexts {
public:
    explicit WarningTexts(Database& database)
        : database_(database),
          add_(database.prepare("INSERT INTO warning_texts (kind, what) VALUES (?, ?)")) {}

    std::int64_t numberOf(const Warning& warning) {
        const auto [place, isNew] = numbers_.try_emplace({warning.kind, warning.what}, 0);
        if (isNew) {
            add_.run(storedNameOf(warning.kind), warning.what);
            place->second = database_.lastRow();
        }
        return place->second;
    }

private:
    Database& database_;
    Statement add_;
    std::map<std::pair<WarningKind, std::string>, std::int64_t> numbers_;
};

void writeSettings(Database& database, const std::optional<ReadSettings>& settings) {
    if (!settings) return removeFact(database, settingsKey);
    const std::string text = formatText(*settings);
    setFact(database, settingsKey, text.empty() ? "{}" : text);
}

std::optional<ReadSettings> readSettings(Database& database) {
    const std::string text = readFact(database, settingsKey);
    if (text.empty()) return std::nullopt;
    auto settings = readSettingsFrom(text);
    if (!settings) throwDamaged("the settings of reading the city are invalid");
    return settings;
}

void writeHeights(Database& database, const HeightFacts& heights) {
    if (heights == HeightFacts{}) return removeFact(database, heightsKey);
    setFact(database, heightsKey,
            heightFactsJson(heights).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

HeightFacts readHeights(Database& database) {
    const std::string text = readFact(database, heightsKey);
    if (text.empty()) return {};
    auto heights = parseHeightFacts(text);
    if (!heights) throwDamaged("the height fields of the city are invalid");
    return *std::move(heights);
}

WarningKind warningKindOf(const std::string& name) {
    for (const WarningKind kind : warningKinds)
        if (name == storedNameOf(kind)) return kind;
    throwDamaged("a warning is of an unknown kind");
}

}  // namespace

void writeReading(Database& database, const CityReading& reading) {
    writeSettings(database, reading.settings);
    writeHeights(database, reading.heights);
    database.execute("DELETE FROM warnings; DELETE FROM warning_texts;");
    WarningTexts texts(database);
    Statement add = database.prepare("INSERT INTO warnings (text, place) VALUES (?, ?)");
    for (const Warning& warning : reading.warnings) add.run(texts.numberOf(warning), warning.where);
}

std::shared_ptr<const CityReading> readReading(Database& database) {
    auto reading = std::make_shared<CityReading>();
    reading->settings = readSettings(database);
    reading->heights = readHeights(database);
    Statement row = database.prepare(
        "SELECT t.kind, t.what, w.place FROM warnings w LEFT JOIN warning_texts t ON t.id = w.text ORDER BY "
        "w.id");
    while (row.step()) reading->warnings.push_back({warningKindOf(row.text(0)), row.text(1), row.text(2)});
    return reading;
}

}  // namespace noonmark
