#include "core/io/osm/read_osm_buildings.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "core/base/progress_share.h"
#include "core/io/formats/format.h"
#include "core/io/heights/height_origins.h"
#include "core/io/layers/feature_stream.h"
#include "core/io/osm/osm_areas.h"
#include "core/io/osm/osm_trees.h"
#include "core/io/settings/place_advice.h"

namespace noonmark {

namespace {

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
    BuildingTags(const std::vector<std::string>& keys, const ReadSettings& settings, const std::string& file,
                 Warnings& warnings)
        : fields_(
              knownFields(keys, {settings.heightField, settings.levelsField, settings.nameField}, false)) {
        settleUnits(fields_, {settings.heightUnit, false}, file, warnings);
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

std::optional<OsmFormat> osmFormatOf(std::string_view head) {
    // PBF begins with the length of a blob header whose type is "OSMHeader".
    if (head.size() > 15 && head.substr(4, 11) == "\x0a\x09OSMHeader") return OsmFormat::pbf;
    const auto start = head.find_first_not_of("\xEF\xBB\xBF \t\r\n");
    const bool markup = start != head.npos && head[start] == '<';
    const bool xml = markup && (head.find("<osm ") != head.npos || head.find("<osm>") != head.npos);
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
                                 .areaKeys = {"building", "building:part"},
                                 .lineKeys = {osmTreeKey},
                                 .pointKeys = {osmTreeKey}};
    const auto map = readOsmMap(file, format, selection, progress, stop);
    if (!map) return tl::make_unexpected(map.error());
    OsmBuildings buildings;
    const std::string name = file.filename().string();
    BuildingTags tags(keys, settings, name, buildings.warnings);
    forEachOsmArea(
        *map,
        [&](OsmArea area) {
            ++buildings.areas;
            if (auto facts = tags.facts(area, buildings.warnings))
                buildings.features.push_back({*std::move(facts), std::move(area.polygons)});
        },
        stop);
    if (stop.stop_requested()) return cancelled();
    tags.addHeights(buildings.heights, name);
    buildings.trees = listOsmTrees(*map, buildings.warnings);
    return buildings;
}

}  // namespace noonmark
