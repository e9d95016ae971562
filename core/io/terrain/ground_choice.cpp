#include "core/io/terrain/ground_choice.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <atomic>
#include <map>
#include <unordered_set>

#include "core/base/safe_text.h"
#include "core/city/building_heights.h"
#include "core/geo/frame.h"
#include "core/io/heights/unknown_fields.h"
#include "core/io/settings/read_settings.h"
#include "core/io/terrain/buildings_on_terrain.h"

namespace noonmark {

namespace {

BuildingList allBuildings(const std::vector<GroundFile>& files) {
    BuildingList all;
    for (const GroundFile& file : files)
        all.insert(all.end(), file.piece->buildings.begin(), file.piece->buildings.end());
    return all;
}

// The first terrain of the ground and the first model of the surface.
class GroundChooser {
public:
    GroundChooser(const std::vector<GroundFile>& files, TerrainShows shows)
        : files_(files), shows_(shows), buildings_(allBuildings(files)) {}

    GroundChoice choose(const std::stop_token& stop) {
        for (const GroundFile& file : files_)
            if (file.piece->terrain && !stop.stop_requested()) offer(file, stop);
        if (ground_ != nullptr)
            choice_.terrain = ground_->piece->terrain;
        else if (surface_ != nullptr)
            choice_.terrain = std::make_shared<const Terrain>(
                takeGroundAround(*surface_->piece->terrain, buildings_, stop));
        if (surface_ != nullptr) describeSurface();
        return std::move(choice_);
    }

    [[nodiscard]] const GroundFile* surface() const { return surface_; }

private:
    void offer(const GroundFile& file, const std::stop_token& stop) {
        const GroundFile*& place = isSurface(file, stop) ? surface_ : ground_;
        if (place == nullptr)
            place = &file;
        else
            warn(WarningKind::leftOut, "a second terrain; the first one is used", file.name);
    }

    bool isSurface(const GroundFile& file, const std::stop_token& stop) {
        if (!file.isRaster || shows_ == TerrainShows::ground) return false;
        const OutlineSteps steps = measureOutlineSteps(*file.piece->terrain, buildings_, stop);
        const bool isIt = shows_ == TerrainShows::surface || steps.showsBuildings();
        if (isIt && surface_ == nullptr) steps_ = steps;
        return isIt;
    }

    void describeSurface() {
        const std::string where =
            fmt::format("{} ({} of {} outlines, by {:.1f} m in the median)", surface_->name,
                        formatThousands(steps_.stepped), formatThousands(steps_.buildings), steps_.medianM);
        if (ground_ != nullptr)
            warn(WarningKind::leftOut,
                 "a surface model, which steps at the outlines of buildings; the other terrain is the ground",
                 where);
        else if (shows_ == TerrainShows::automatic)
            warn(WarningKind::assumed,
                 fmt::format("the terrain steps at the outlines of buildings, which would count twice: the "
                             "ground around them is used instead ({} uses it unchanged)",
                             readOption("terrain_shows", "ground")),
                 where);
    }

    void warn(WarningKind kind, std::string what, std::string where) {
        choice_.warnings.push_back({kind, std::move(what), std::move(where)});
    }

    const std::vector<GroundFile>& files_;
    TerrainShows shows_;
    BuildingList buildings_;
    OutlineSteps steps_;
    const GroundFile *ground_ = nullptr, *surface_ = nullptr;
    GroundChoice choice_;
};

// A building whose assumed heights are replaced by those of the surface; null if none can be.
std::shared_ptr<const Building> measureOnSurface(const Building& building, const Terrain& surface,
                                                 const Terrain& ground) {
    const float lowestM = findLowestGround(building, ground);
    return withHeights(building, [&](const Part& part) { return measureHeight(part, surface, lowestM); });
}

std::size_t measureOnSurface(FilePiece& piece, const Terrain& surface, const Terrain& ground,
                             const std::stop_token& stop) {
    std::atomic<std::size_t> count = 0;
    tbb::parallel_for(std::size_t{0}, piece.buildings.size(), [&](std::size_t i) {
        if (stop.stop_requested() || !hasAssumedHeight(*piece.buildings[i])) return;
        if (auto measured = measureOnSurface(*piece.buildings[i], surface, ground)) {
            piece.buildings[i] = std::move(measured);
            ++count;
        }
    });
    return count;
}

std::size_t countAssumed(const std::vector<GroundFile>& files) {
    std::size_t assumed = 0;
    for (const GroundFile& file : files)
        assumed += std::size_t(std::ranges::count_if(
            file.piece->buildings, [](const auto& building) { return hasAssumedHeight(*building); }));
    return assumed;
}

// Says that the surface could give heights, if they are missing.
void offerHeights(const std::vector<GroundFile>& files, const GroundFile* surface, Warnings& warnings) {
    const std::size_t assumed = surface != nullptr ? countAssumed(files) : 0;
    if (assumed > 0)
        warnings.push_back({WarningKind::assumed,
                            fmt::format("heights are assumed that the surface model shows: {} uses it",
                                        readOption("heights_from_surface")),
                            fmt::format("{}; {}", countOf(assumed, "building"), surface->name)});
}

void takeHeights(const std::vector<GroundFile>& files, const GroundFile* surface, GroundChoice& choice,
                 HeightFacts& heights, const std::stop_token& stop) {
    if (surface == nullptr)
        return choice.warnings.push_back(
            {WarningKind::leftOut, "heights from the surface: no terrain shows buildings", "the terrain"});
    std::size_t measured = 0;
    for (const GroundFile& file : files) {
        measured += measureOnSurface(*file.piece, *surface->piece->terrain, *choice.terrain, stop);
        withdrawAssumed(file);
    }
    heights.fields.push_back({surface->name, "surface - ground", "median roof", "m", measured});
    choice.warnings.push_back({WarningKind::assumed,
                               "buildings without a height got that of the surface model above the ground",
                               fmt::format("{}; {}", countOf(measured, "building"), surface->name)});
}

}  // namespace

GroundChoice chooseGround(const std::vector<GroundFile>& files, const ReadSettings& settings,
                          HeightFacts& heights, const std::stop_token& stop) {
    GroundChooser chooser(files, settings.terrainShows);
    GroundChoice choice = chooser.choose(stop);
    if (stop.stop_requested()) return choice;
    if (settings.heightsFromSurface)
        takeHeights(files, chooser.surface(), choice, heights, stop);
    else
        offerHeights(files, chooser.surface(), choice.warnings);
    return choice;
}

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

std::string quoteField(const std::string& field) {
    return field.find(' ') == field.npos ? field : "'" + field + "'";
}

void warnOfRoofs(const GroundFile& file, const std::string& field, std::size_t count, bool chosen) {
    const std::string where = fmt::format("{}: {} ({})", file.name, field, countOf(count, "building"));
    if (chosen)
        file.piece->warnings.push_back({WarningKind::assumed,
                                        "the elevation of the roof was taken as the height, since you chose "
                                        "it: nothing states the ground",
                                        where});
    else
        file.piece->warnings.push_back(
            {WarningKind::leftOut,
             fmt::format(
                 "the roof's elevation, which gives no height without the ground's: add a terrain, or "
                 "where it counts from the ground, {}",
                 readOption("height_field", quoteField(field))),
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
        for (const auto& [field, count] : countRoofs(*file.piece)) warnOfRoofs(file, field, count, chosen);
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
