#include "core/io/osm/read_osm_buildings.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/base/gdal_calls.h"
#include "core/base/progress.h"
#include "core/base/safe_text.h"
#include "core/geo/lon_lat.h"
#include "core/io/files/plain_file.h"
#include "core/io/footprints/build_footprints.h"
#include "core/io/formats/format.h"
#include "core/io/heights/height_reading.h"
#include "core/io/heights/tree_fields.h"
#include "core/io/layers/feature_stream.h"
#include "core/io/osm/osm_layers.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

constexpr double rowSpacingM = 8;
constexpr std::size_t maxInRow = 10'000;
constexpr double unitsPerDegree = 1e7;

LonLat placeOf(OsmPoint point) { return {point.lon / unitsPerDegree, point.lat / unitsPerDegree}; }

std::string_view findTag(const OsmTags& tags, std::string_view key) {
    const auto found = std::ranges::find(tags, key, &std::pair<std::string, std::string>::first);
    return found == tags.end() ? std::string_view() : std::string_view(found->second);
}

TreeFacts factsOf(const OsmTags& tags, const std::string& where, Warnings& warnings) {
    static const std::vector<KnownTreeField> fields = findTreeFields(osmTreeKeys());
    std::vector<std::string> values;
    for (const std::string& key : osmTreeKeys()) values.emplace_back(findTag(tags, key));
    return collectTreeFacts(fields, values, where, warnings);
}

// Along the line from its first point on; the rest of a piece carries over to the next.
std::vector<LonLat> placeRow(const OsmWay& way) {
    std::vector<LonLat> places{placeOf(way.points.front())};
    double toNextM = rowSpacingM;
    for (std::size_t i = 1; i < way.points.size() && places.size() < maxInRow; ++i) {
        const LonLat from = placeOf(way.points[i - 1]), to = placeOf(way.points[i]);
        const double lengthM = computeGreatCircleM(from, to);
        double atM = toNextM;
        for (; atM <= lengthM && places.size() < maxInRow; atM += rowSpacingM) {
            const double share = atM / lengthM;
            places.push_back({from.lonDeg + share * (to.lonDeg - from.lonDeg),
                              from.latDeg + share * (to.latDeg - from.latDeg)});
        }
        toNextM = atM - lengthM;
    }
    return places;
}

}  // namespace

const std::vector<std::string>& osmTreeKeys() {
    static const std::vector<std::string> keys{"natural",       "height",   "est_height", "diameter_crown",
                                               "circumference", "genus",    "species",    "taxon",
                                               "leaf_cycle",    "leaf_type"};
    return keys;
}

std::vector<ReadTree> listOsmTrees(const OsmMap& map, Warnings& warnings) {
    std::vector<ReadTree> trees;
    for (const OsmNode& node : map.points)
        if (findTag(node.tags, osmTreeKey) == "tree")
            trees.push_back(
                {placeOf(node.point), factsOf(node.tags, fmt::format("node {}", node.id), warnings)});
    for (const OsmWay& way : map.ways) {
        const bool isPath = way.line || way.area;  // rows may be closed
        if (!isPath || way.points.empty() || findTag(way.tags, osmTreeKey) != "tree_row") continue;
        const std::string where = fmt::format("way {}", way.id);
        const TreeFacts facts = factsOf(way.tags, where, warnings);
        for (const LonLat place : placeRow(way)) trees.push_back({place, facts});
        warnings.push_back(
            {WarningKind::assumed, fmt::format("the trees of a row stand {:g} m apart", rowSpacingM), where});
    }
    return trees;
}

void addOsmWood(const OsmArea& area, std::vector<ReadTree>& trees, Warnings& warnings) {
    if (findTag(area.tags, osmTreeKey) != "wood") return;
    const std::string where = fmt::format("{} {}", area.relation ? "relation" : "way", area.id);
    const TreeFacts facts = factsOf(area.tags, where, warnings);
    const std::size_t before = trees.size();
    for (const LonLatPolygon& polygon : area.polygons) coverWithCanopy(polygon, facts, trees);
    warnings.push_back({WarningKind::assumed, std::string(woodIsClosedCanopy),
                        fmt::format("{}: {}", where, countOf(trees.size() - before, "column"))});
}

namespace {

constexpr std::array<std::string_view, 2> buildingAreaKeys{"building", "building:part"};

// Closed ways that are read for trees are no polygons that might have been buildings.
bool mayBeBuilding(const OsmArea& area) {
    const auto has = [&](std::string_view key) { return !findTag(area.tags, key).empty(); };
    return area.relation || !has(osmTreeKey) || std::ranges::any_of(buildingAreaKeys, has);
}

// The tags that describe a building; tags that the user named come to them.
std::vector<std::string> buildingKeys(const ReadSettings& settings) {
    std::vector<std::string> keys{"name",
                                  "building",
                                  "building:part",
                                  "height",
                                  "building:height",
                                  "min_height",
                                  "building:min_height",
                                  "building:levels",
                                  "building:min_level",
                                  "roof:height",
                                  "roof:levels",
                                  "roof:shape",
                                  "location",
                                  "layer",
                                  "level",
                                  "tunnel",
                                  "entrance",
                                  "status"};
    for (const std::string& chosen : {settings.heightField, settings.levelsField, settings.nameField})
        if (!chosen.empty() && std::ranges::find(keys, chosen) == keys.end()) keys.push_back(chosen);
    return keys;
}

/// Collects the facts of buildings from tags, as FootprintLayer does from fields.
class BuildingTags {
public:
    BuildingTags(const std::vector<std::string>& keys, const ReadSettings& settings)
        : fields_(
              knownFields(keys, {settings.heightField, settings.levelsField, settings.nameField}, false)) {
        settleUnits(fields_, {settings.heightUnit, false});
        rules_.heights = {settings.metresPerLevel, settings.defaultHeightM};
        rules_.heights.decimalComma = false;
        rules_.tagged = true;
    }

    std::optional<FeatureFacts> facts(const OsmArea& area, Warnings& warnings) {
        auto facts =
            collectFacts(valuesOf(area.tags), rules_,
                         fmt::format("{} {}", area.relation ? "relation" : "way", area.id), warnings);
        if (facts) ++origins_[facts->heights.origin];
        return facts;
    }

    // Warnings are not passed on: tags are known names, and a map without heights has none.
    void addHeights(HeightFacts& heights, const std::string& file) const {
        Warnings unheard;
        addHeightFacts(origins_, fields_, {}, file, heights, unheard);
    }

private:
    [[nodiscard]] FeatureValues valuesOf(const OsmTags& tags) const {
        FeatureValues values;
        for (const KnownField& field : fields_)
            for (auto tag = tags.rbegin(); tag != tags.rend(); ++tag)
                if (tag->first == field.name) {
                    if (std::string text = trimmed(tag->second); !text.empty())
                        values.push_back({field.meaning.role, field.name, std::move(text), {}, field.unit});
                    break;
                }
        return values;
    }

    std::vector<KnownField> fields_;
    LayerRules rules_;
    HeightOrigins origins_;
};

}  // namespace

std::string_view nameOf(OsmFormat format) {
    switch (format) {
        case OsmFormat::pbf:
            return "OpenStreetMap PBF";
        case OsmFormat::xml:
            return "OpenStreetMap XML";
        case OsmFormat::overpass:
            return "OpenStreetMap JSON (Overpass)";
    }
    return "OpenStreetMap";
}

namespace {

// Its header stands before its elements, and names the program that made it.
bool isOverpass(std::string_view head) {
    constexpr std::array<std::string_view, 4> makers{"\"osm3s\"", "Overpass API", "OpenStreetMap server",
                                                     "CGImap"};
    return head.find("\"elements\"") != head.npos &&
           std::ranges::any_of(makers, [&](std::string_view maker) { return head.find(maker) != head.npos; });
}

}  // namespace

std::optional<OsmFormat> osmFormatOf(std::string_view head) {
    // PBF begins with the length of a blob header whose type is "OSMHeader".
    if (head.size() > 15 && head.substr(4, 11) == "\x0a\x09OSMHeader") return OsmFormat::pbf;
    const auto start = head.find_first_not_of("\xEF\xBB\xBF \t\r\n");
    const bool markup = start != head.npos && head[start] == '<';
    const bool xml = markup && (head.find("<osm ") != head.npos || head.find("<osm>") != head.npos);
    if (start != head.npos && head[start] == '{' && isOverpass(head)) return OsmFormat::overpass;
    return xml ? std::optional(OsmFormat::xml) : std::nullopt;
}

std::optional<OsmFormat> findOsmFormat(const std::filesystem::path& file) {
    return osmFormatOf(readFileHead(file).bytes);
}

Result<OsmBuildings> readOsmBuildings(const std::filesystem::path& file, OsmFormat format,
                                      const ReadSettings& settings, Progress& progress,
                                      const std::stop_token& stop) {
    const std::vector<std::string> keys = buildingKeys(settings);
    std::vector<std::string> kept = keys;
    std::ranges::copy(osmTreeKeys(), std::back_inserter(kept));
    const OsmSelection selection{.keys = kept,
                                 .areaKeys = {"building", "building:part", osmTreeKey},
                                 .lineKeys = {osmTreeKey},
                                 .pointKeys = {osmTreeKey}};
    const auto map = readOsmMap(file, format, selection, progress, stop);
    if (!map) return tl::make_unexpected(map.error());
    OsmBuildings buildings;
    const std::string name = file.filename().string();
    BuildingTags tags(keys, settings);
    forEachOsmArea(
        *map,
        [&](OsmArea area) {
            addOsmWood(area, buildings.trees, buildings.warnings);
            if (!mayBeBuilding(area)) return;
            ++buildings.areas;
            if (auto facts = tags.facts(area, buildings.warnings))
                buildings.features.push_back({*std::move(facts), std::move(area.polygons)});
        },
        stop);
    if (stop.stop_requested()) return cancelled();
    tags.addHeights(buildings.heights, name);
    std::ranges::move(listOsmTrees(*map, buildings.warnings), std::back_inserter(buildings.trees));
    return buildings;
}

namespace {

using Path = std::filesystem::path;

/// Reading's share of the progress.
class ReadingProgress final : public Progress {
public:
    explicit ReadingProgress(Progress& whole) : whole_(whole) {}
    void report(double fraction, std::string_view stage) override {
        whole_.report(shareOfReading * fraction, stage);
    }

private:
    Progress& whole_;
};

// Files from GDAL's driver have one layer of areas by this name.
Result<void> checkLayer(const Path& file, const ReadSettings& settings) {
    if (settings.layer.empty() || settings.layer == "multipolygons") return {};
    return failure(fmt::format("There is no layer \"{}\"", settings.layer), file.string(),
                   "OpenStreetMap has one layer of buildings: name none");
}

Result<OsmBuildings> readChecked(const Path& file, OsmFormat format, const ReadSettings& settings,
                                 Progress& progress, const std::stop_token& stop) {
    if (auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    ReadingProgress reading(progress);
    const GdalCalls calls;
    auto buildings = checkLayer(file, settings).and_then([&] {
        return readOsmBuildings(file, format, settings, reading, stop);
    });
    if (!buildings) return buildings;
    if (buildings->areas == 0)
        return failure("It holds no polygons", file.string(), "Export the building footprints as polygons");
    if (buildings->features.empty())
        return failure(fmt::format("None of its {} polygons can be used as a building", buildings->areas),
                       file.string(), findMostFrequent(buildings->warnings));
    addMapRemarks(calls.complaints(), file.filename().string(), buildings->warnings);
    return buildings;
}

// A beginning that tells neither form is that of XML with long comments.
OsmFormat osmFormatOf(const Path& file) { return findOsmFormat(file).value_or(OsmFormat::xml); }

tl::unexpected<Error> notRead(const std::exception& exception, const Path& file) {
    return failure(fmt::format("The map cannot be read ({})", exception.what()), file.string(),
                   "Check that it is complete, or export it again");
}

}  // namespace

Result<FilePiece> readOsmFootprints(const Path& file, const ReadSettings& settings, Progress& progress,
                                    std::stop_token stop) try {
    const OsmFormat format = osmFormatOf(file);
    auto buildings = readChecked(file, format, settings, progress, stop);
    if (!buildings) return tl::make_unexpected(buildings.error());
    FilePiece piece{.warnings = std::move(buildings->warnings),
                    .format = std::string(nameOf(format)),
                    .features = buildings->areas,
                    .attribution = osmCredit,
                    .heights = std::move(buildings->heights),
                    .crs = describeCrs("WGS 84", CrsSource::file)};
    piece.trees = std::move(buildings->trees);
    if (auto built = buildFootprints(piece, std::move(buildings->features), settings, progress, stop); !built)
        return tl::make_unexpected(built.error());
    if (!piece.buildings.empty()) return piece;
    return failure("None of its polygons can be used as a building", file.string(),
                   findMostFrequent(piece.warnings));
} catch (const std::exception& exception) {
    return notRead(exception, file);
}

Result<FootprintScan> scanOsmFootprints(const Path& file, const ReadSettings& settings, Progress& progress,
                                        std::stop_token stop) try {
    const auto buildings = readChecked(file, osmFormatOf(file), settings, progress, stop);
    if (!buildings) return tl::make_unexpected(buildings.error());
    FootprintScan scan;
    scan.indexed = false;
    FeatureCentres centres;
    for (const UnplacedFeature& feature : buildings->features) {
        centres.add(feature);
        scan.add(feature);
    }
    scan.frame = centres.frame(settings.farAwayM);
    return scan;
} catch (const std::exception& exception) {
    return notRead(exception, file);
}

}  // namespace noonmark
