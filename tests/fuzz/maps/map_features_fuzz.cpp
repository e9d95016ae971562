// Processing of a map's features after GDAL has read them: their tags, their outlines, and buildings from
// outlines and parts. Much faster than the formats of OpenStreetMap. Each line is a feature with fields
// separated by "|": first its corners in metres, rings separated by ";", then its tags:
//   0 0 40 0 40 20 0 20;9 9 9 12 12 9|building=yes|height=12 m
#include <cstdlib>
#include <sstream>

#include "core/io/footprints/build_footprints.h"
#include "core/io/footprints/place_features.h"
#include "core/io/heights/field_roles.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

namespace noonmark::tests {
namespace {

const Frame frame({-73.98, 40.75});

LonLatPolygon polygonOf(const std::string& text) {
    LonLatPolygon polygon;
    std::istringstream rings(text);
    for (std::string ring; std::getline(rings, ring, ';');) {
        std::istringstream numbers(ring);
        std::vector<LonLat> points;
        for (glm::dvec2 point; numbers >> point.x >> point.y;)
            points.push_back(frame.lonLatFromLocal(glm::clamp(point, -1e5, 1e5)));
        if (!points.empty()) polygon.push_back(std::move(points));
    }
    return polygon;
}

void addTag(const std::string& tag, FeatureValues& values) {
    const auto equals = std::min(tag.find('='), tag.size());
    const std::string key = tag.substr(0, equals);
    const std::string text = tag.substr(std::min(equals + 1, tag.size()));
    if (const auto meaning = findTagMeaning(key); meaning && !text.empty())
        values.push_back({meaning->role, key, text, {}, meaning->unit.value_or(LengthUnit::metres)});
}

std::optional<UnplacedFeature> featureOf(const std::string& line, Warnings& warnings) {
    std::istringstream pieces(line);
    std::string piece;
    std::getline(pieces, piece, '|');
    LonLatPolygon polygon = polygonOf(piece);
    FeatureValues values;
    while (std::getline(pieces, piece, '|')) addTag(piece, values);
    auto facts =
        collectFacts(values, {.heights = {}, .tagged = true, .sayNoBuilding = true}, "feature", warnings);
    if (!facts || polygon.empty()) return std::nullopt;
    return UnplacedFeature{*std::move(facts), {std::move(polygon)}};
}

void assemble(std::vector<UnplacedFeature> features) {
    Warnings warnings;
    const Frame middle = frameOf(features, ReadSettings().farAwayM);
    const auto placed = placeFeatures(std::move(features), middle, 60000, warnings);
    for (const AssembledBuilding& made : assembleBuildings(placed, 3.2, warnings))
        requireSound(made.building);
}

}  // namespace
}  // namespace noonmark::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    (void)fuzzFolder();
    std::vector<noonmark::UnplacedFeature> features;
    noonmark::Warnings warnings;
    std::istringstream lines{std::string(formatText(data, size))};
    for (std::string line; std::getline(lines, line) && features.size() < 20;)
        if (auto feature = featureOf(line, warnings)) features.push_back(*std::move(feature));
    if (!features.empty()) assemble(std::move(features));
    return 0;
}
