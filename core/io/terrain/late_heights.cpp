#include "core/io/terrain/late_heights.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_set>

#include "core/city/plausible_heights.h"
#include "core/geo/earth_drop.h"
#include "core/io/heights/unknown_fields.h"
#include "core/io/terrain/stand_on_terrain.h"

namespace noonmark {

namespace {

using Ids = std::unordered_set<std::string>;

Ids findAssumed(const FilePiece& piece) {
    Ids assumed;
    for (const auto& building : piece.buildings)
        for (const Part& part : building->parts)
            if (part.heightSource == HeightSource::assumed) assumed.insert(part.sourceId);
    return assumed;
}

// Of a height that is none any more.
bool isObsolete(const Warning& warning, const std::string& file, const Ids& assumed) {
    if (warning.what.starts_with(noFieldKnown)) return assumed.empty();
    if (!warning.what.starts_with(noHeightInData)) return false;
    const bool named = warning.where.starts_with(file + ": ");
    return !assumed.contains(warning.where) &&
           !(named && assumed.contains(warning.where.substr(file.size() + 2)));
}

std::optional<float> roofOverGround(const Building& building, const RoofElevation& roof,
                                    const Terrain* terrain, const Frame& frame) {
    double heightM = roof.elevationM;
    if (terrain != nullptr) {
        const Box2 box = bounds(building);
        const glm::dvec2 middle = glm::dvec2(box.low + box.high) / 2.0;
        if (beyondM(terrain->grid, middle) > 0) return std::nullopt;
        heightM -=
            frame.originElevationM() + earthDropM(middle) + double(findLowestGround(building, *terrain));
    }
    return heightM <= tallestBuildingM ? std::optional(float(heightM)) : std::nullopt;
}

void sayRoofs(const GroundFile& file, const std::string& field, std::size_t count, bool chosen) {
    const std::string where = fmt::format("{}: {} ({} buildings)", file.name, field, formatThousands(count));
    if (chosen)
        file.piece->warnings.push_back({WarningKind::assumed,
                                        "the elevation of the roof was taken as the height, since you chose "
                                        "it: nothing states the ground",
                                        where});
    else
        file.piece->warnings.push_back(
            {WarningKind::leftOut,
             "the roof's elevation, which gives no height without the ground's: add "
             "a terrain",
             where});
}

// Number of buildings by field.
using Counts = std::map<std::string, std::size_t>;

Counts countRoofs(const FilePiece& piece) {
    Counts counts;
    for (const auto& roof : piece.roofs)
        if (roof) ++counts[roof->field];
    return counts;
}

Counts takeRoofs(FilePiece& piece, const Terrain* terrain, const Frame& frame) {
    Counts counts;
    for (std::size_t i = 0; i < piece.roofs.size(); ++i) {
        if (!piece.roofs[i] || !hasAssumedHeight(*piece.buildings[i])) continue;
        const auto height = roofOverGround(*piece.buildings[i], *piece.roofs[i], terrain, frame);
        auto measured = withHeights(*piece.buildings[i], [&](const Part&) { return height; });
        if (!measured) continue;
        piece.buildings[i] = std::move(measured);
        ++counts[piece.roofs[i]->field];
    }
    return counts;
}

}  // namespace

bool hasAssumedHeight(const Building& building) {
    return std::ranges::any_of(building.parts,
                               [](const Part& part) { return part.heightSource == HeightSource::assumed; });
}

std::shared_ptr<const Building> withHeights(
    const Building& building, const std::function<std::optional<float>(const Part&)>& heightOf) {
    constexpr float minM = 1;
    Building measured = building;
    const float baseM = std::ranges::min_element(building.parts, {}, &Part::bottomM)->bottomM;
    bool any = false;
    for (Part& part : measured.parts) {
        if (part.heightSource != HeightSource::assumed) continue;
        const auto height = heightOf(part);
        if (!height || baseM + *height < part.bottomM + minM) continue;
        part.topM = baseM + *height;
        part.heightSource = HeightSource::measured;
        any = true;
    }
    return any ? std::make_shared<const Building>(std::move(measured)) : nullptr;
}

void measureRoofs(const GroundFile& file, const Terrain* terrain, const Frame& frame, bool chosen,
                  HeightFacts& heights) {
    if (file.piece->roofs.empty()) return;
    if (terrain == nullptr)
        for (const auto& [field, count] : countRoofs(*file.piece)) sayRoofs(file, field, count, chosen);
    if (terrain == nullptr && !chosen) return;
    for (const auto& [field, count] : takeRoofs(*file.piece, terrain, frame))
        heights.fields.push_back(
            {file.name, terrain != nullptr ? field + " - terrain" : field, "", "m", count});
    withdrawAssumed(file);
}

void withdrawAssumed(const GroundFile& file) {
    const Ids assumed = findAssumed(*file.piece);
    std::erase_if(file.piece->warnings,
                  [&](const Warning& warning) { return isObsolete(warning, file.name, assumed); });
    if (assumed.empty()) file.piece->heights.unknown.clear();
}

}  // namespace noonmark
