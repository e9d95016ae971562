#include "core/io/read_city.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "core/base/gdal_calls.h"
#include "core/base/progress.h"
#include "core/base/safe_text.h"
#include "core/city/map_context.h"
#include "core/describe/text.h"
#include "core/io/context/read_context.h"
#include "core/io/files/plain_file.h"
#include "core/io/meshes/mesh_scene.h"
#include "core/io/osm/read_osm_buildings.h"
#include "core/io/pieces/read_part.h"
#include "core/io/read_region.h"
#include "core/io/settings/read_settings.h"
#include "core/io/terrain/buildings_on_terrain.h"
#include "core/io/terrain/ground_choice.h"
#include "core/io/terrain/standing.h"
#include "core/io/trees/read_trees.h"

namespace noonmark {

namespace {

using Path = std::filesystem::path;

struct InputFile {
    Path path;
    const Format* format = nullptr;
    FilePiece piece;
    std::vector<std::size_t> carriers = {};  // of the piece's buildings (findCarriers)

    [[nodiscard]] bool is(FileKind kind) const { return format->reader.kind == kind; }
};

bool isOutside(std::size_t file, const ReadExtent* window) {
    return window != nullptr && file < window->fileBoxes.size() &&
           !window->fileBoxes[file].touches(window->box);
}

Result<std::vector<InputFile>> recogniseFiles(const std::vector<Path>& paths, const ReadExtent* window,
                                              Formats formats) {
    if (paths.empty())
        return failure(NM_TEXT("No file is named"), {}, NM_TEXT("Name at least one file with buildings"));
    std::vector<InputFile> files;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        if (isOutside(i, window)) continue;
        const auto format = detectFormat(paths[i], formats);
        if (!format) return tl::make_unexpected(format.error());
        files.push_back({paths[i], *format, {}, {}});
    }
    return files;
}

// Order of reading: files with buildings fix the frame before terrain does, whose middle may be far away; a
// mesh without a position comes last.
int readingOrderOf(const InputFile& file, const ReadSettings& settings) {
    if (file.is(FileKind::terrain)) return 1;
    return file.is(FileKind::mesh) && !settings.meshAnchor ? 2 : 0;
}

Result<FilePiece> readPiece(const InputFile& file, const ReadSettings& settings, Progress& progress,
                            const std::stop_token& stop, const ReadExtent* window) {
    if (window != nullptr && window->terrain && file.is(FileKind::terrain)) return FilePiece{};
    std::optional<LonLatBox> box;
    if (settings.extent) box = growBox(*settings.extent, aroundExtentM);
    if (window != nullptr) box = window->box;
    return file.format->reader.read(file.path, settings, progress, stop, box ? &*box : nullptr);
}

// Of what was read: implausible buildings and those outside of the extent go.
Result<void> chooseBuildings(FilePiece& piece, const std::string& file, const ReadSettings& settings) {
    const std::optional<Frame>& frame = settings.frame ? settings.frame : piece.frame;
    if (settings.extent && frame) keepExtent(file, piece, *frame, *settings.extent);
    return leaveOutImplausible(file, piece);
}

tl::unexpected<Error> noneInExtent() {
    return failure("No building touches the extent", readOption("extent"),
                   "Give west,south,east,north in degrees; without it, `noonmark-cli info` says where the "
                   "buildings are");
}

// Of several files, a mesh that holds no building is left out and said; nothing for any other error.
std::optional<FilePiece> pieceWithout(const InputFile& file, const Error& error, bool several) {
    if (!several || !file.is(FileKind::mesh) || error.advice != trianglesAdvice) return std::nullopt;
    FilePiece piece;
    piece.warnings.push_back({WarningKind::leftOut, error.what, file.path.filename().string()});
    return piece;
}

bool holdsNothing(const InputFile& file) { return file.piece.buildings.empty() && !file.piece.terrain; }

bool isTerrain(const InputFile& file) { return file.is(FileKind::terrain); }

// Of several terrains alone buildings may be made, which takes as long as reading a file.
std::size_t partsOfReading(const std::vector<InputFile>& files) {
    return files.size() + (files.size() > 1 && std::ranges::all_of(files, isTerrain) ? 1 : 0);
}

// Reads every file into its piece; the first reader that chooses a frame fixes it for the others.
Result<Frame> readPieces(std::vector<InputFile>& files, ReadSettings settings, Progress& progress,
                         const std::stop_token& stop, const ReadExtent* window) {
    std::vector<InputFile*> turns;
    for (InputFile& file : files) turns.push_back(&file);
    std::ranges::stable_sort(turns, {},
                             [&](const InputFile* file) { return readingOrderOf(*file, settings); });
    for (std::size_t i = 0; i < turns.size(); ++i) {
        if (stop.stop_requested()) return cancelled();
        ProgressShare share(progress, i, partsOfReading(files));
        auto piece = readPiece(*turns[i], settings, share, stop, window);
        if (!piece) {
            auto without = pieceWithout(*turns[i], piece.error(), turns.size() > 1);
            if (!without || (i + 1 == turns.size() && std::ranges::all_of(files, holdsNothing)))
                return tl::make_unexpected(piece.error());
            piece = *std::move(without);
        }
        if (auto some = chooseBuildings(*piece, turns[i]->path.filename().string(), settings); !some)
            return tl::make_unexpected(some.error());
        if (!settings.frame) settings.frame = piece->frame;
        turns[i]->piece = *std::move(piece);
    }
    if (settings.frame) return *settings.frame;
    if (settings.extent) return noneInExtent();
    return failure(NM_TEXT("None of the files states its position on earth"), files.front().path.string(),
                   anchorAdvice());
}

std::string nameOf(const InputFile& file) { return file.path.filename().string(); }

std::vector<GroundFile> groundFiles(std::vector<InputFile>& files) {
    std::vector<GroundFile> all;
    for (InputFile& file : files) {
        const bool isPacked = file.format->reader.read == readArchive && file.piece.buildings.empty();
        all.push_back({nameOf(file), &file.piece, file.is(FileKind::terrain) || isPacked});
    }
    return all;
}

std::vector<BasedBuilding> basedBuildings(const std::vector<InputFile>& files, const Frame& frame) {
    std::vector<BasedBuilding> based;
    for (const InputFile& file : files) {
        const auto some = findBasedBuildings(file.piece, file.carriers, frame);
        based.insert(based.end(), some.begin(), some.end());
    }
    return based;
}

// Makes a terrain from the ground elevations that buildings state, if no terrain was read.
void makeTerrainFromBases(CityRead& all, const std::vector<InputFile>& files, TerrainFromBases wanted) {
    if (all.city.terrain || wanted == TerrainFromBases::never) return;
    const std::vector<BasedBuilding> based = basedBuildings(files, all.city.frame);
    const BaseRelief relief = measureRelief(based);
    if (wanted == TerrainFromBases::automatic && !relief.matters()) return;
    std::optional<Terrain> terrain = interpolateBases(based);
    if (!terrain) return;
    all.warnings.push_back(
        {WarningKind::assumed,
         NM_TEXT("there is no terrain: the ground between the buildings was interpolated from their bases"),
         fmt::format("{}; {}", countOf(based.size(), "building"), formatText(relief))});
    all.city.terrain = std::make_shared<const Terrain>(*std::move(terrain));
}

// Warns about buildings outside the terrain's border, which stand on its nearest elevation.
void countBeyondTerrain(CityRead& all) {
    if (!all.city.terrain) return;
    std::size_t off = 0;
    double farthestM = 0;
    for (const auto& building : all.city.buildings) {
        const Box2 box = bounds(*building);
        const double beyond = beyondM(all.city.terrain->grid, glm::dvec2(box.low + box.high) / 2.0);
        off += beyond > 0 ? 1 : 0;
        farthestM = std::max(farthestM, beyond);
    }
    if (off > 0)
        all.warnings.push_back(
            {WarningKind::assumed, NM_TEXT("buildings beyond the terrain stand on its nearest elevation"),
             fmt::format("{} of {}, up to {:.0f} m from it", off, all.city.buildings.size(), farthestM)});
}

// Warns that stated ground elevations were not used, since there is no terrain.
void warnOfFlattened(CityRead& all, const InputFile& file, std::size_t count) {
    if (count > 0)
        all.warnings.push_back(
            {WarningKind::leftOut,
             fmt::format("the ground elevations of {}: there is no terrain, so the ground is flat",
                         countOf(count, "building")),
             nameOf(file)});
}

bool isClean(const std::string& words) { return cleanText(words) == words; }

// Names and ids come from strangers, and are printed in many places.
std::shared_ptr<const Building> withCleanWords(std::shared_ptr<const Building> building) {
    const auto partIsClean = [](const Part& part) { return isClean(part.sourceId); };
    if (isClean(building->sourceId) && isClean(building->name) && isClean(building->status) &&
        std::ranges::all_of(building->parts, partIsClean))
        return building;
    Building clean = *building;
    for (std::string* words : {&clean.sourceId, &clean.name, &clean.status}) *words = cleanText(*words);
    for (Part& part : clean.parts) part.sourceId = cleanText(part.sourceId);
    return std::make_shared<const Building>(std::move(clean));
}

// A terrain from bases fits the bases that it was made of, and says nothing of others.
Stand standFor(const CityRead& all, Stand wanted) {
    const bool fromBases = all.city.terrain && all.city.terrain->source.method == TerrainMethod::fromBases;
    return fromBases ? Stand::absolute : wanted;
}

void warnOfFit(CityRead& all, const InputFile& file, const Standing& standing, Stand wanted) {
    if (!standing.fit() || standFor(all, wanted) != wanted) return;
    BaseFit fit = *standing.fit();
    fit.file = nameOf(file);
    std::ranges::move(describeStanding(fit, wanted != Stand::automatic), std::back_inserter(all.warnings));
    all.heights.bases.push_back(std::move(fit));
}

void joinBuildings(CityRead& all, const InputFile& file, Stand wanted) {
    const FilePiece& piece = file.piece;
    const Standing standing(piece, file.carriers, all.city.frame, all.city.terrain.get(),
                            standFor(all, wanted));
    warnOfFlattened(all, file, standing.flattened());
    warnOfFit(all, file, standing, wanted);
    auto& buildings = all.city.buildings;
    const std::size_t first = buildings.size();
    buildings.resize(first + piece.buildings.size());
    tbb::parallel_for(std::size_t{0}, piece.buildings.size(),
                      [&](std::size_t i) { buildings[first + i] = withCleanWords(standing.place(i)); });
}

// The ids of the city's buildings, after their file if there are several.
std::vector<std::string> nameBuildings(const CityRead& all, const std::vector<InputFile>& files) {
    std::vector<std::string> names;
    for (const InputFile& file : files)
        for (std::size_t i = 0; i < file.piece.buildings.size(); ++i) {
            const std::string& id = all.city.buildings[names.size()]->sourceId;
            names.push_back(files.size() > 1 ? nameOf(file) + ": " + id : id);
        }
    return names;
}

// Keeps one of buildings that are there twice.
void dropSame(CityRead& all, const std::vector<InputFile>& files) {
    auto& buildings = all.city.buildings;
    const std::vector<SameBuilding> same = findSameBuildings(buildings);
    if (same.empty()) return;
    const std::vector<std::string> names = nameBuildings(all, files);
    std::vector<char> isDropped(buildings.size());
    for (const SameBuilding& one : same) {
        all.warnings.push_back(
            {WarningKind::leftOut,
             fmt::format("{}{} at the same place", secondBuilding, one.byId ? "id" : "outline"),
             fmt::format("{}, beside {}", names[one.dropped], names[one.kept])});
        isDropped[one.dropped] = 1;
    }
    std::size_t next = 0;
    std::erase_if(buildings, [&](const auto&) { return isDropped[next++] != 0; });
}

// If there are several files, adds the file's name to its warnings.
void joinWarnings(CityRead& all, const InputFile& file, bool several) {
    const std::string name = nameOf(file);
    for (Warning warning : file.piece.warnings) {
        if (several && !warning.where.starts_with(name)) warning.where = name + ": " + warning.where;
        all.warnings.push_back(std::move(warning));
    }
}

void joinHeights(HeightFacts& all, const HeightFacts& piece) {
    all.fields.insert(all.fields.end(), piece.fields.begin(), piece.fields.end());
    all.unknown.insert(all.unknown.end(), piece.unknown.begin(), piece.unknown.end());
    all.doubts.insert(all.doubts.end(), piece.doubts.begin(), piece.doubts.end());
    std::ranges::stable_sort(all.fields, std::greater<>{}, &HeightField::features);
}

std::string joinedTexts(const std::vector<InputFile>& files, std::string FilePiece::*text) {
    std::vector<std::string> texts;
    for (const InputFile& file : files) {
        const std::string& one = file.piece.*text;
        if (!one.empty() && std::ranges::find(texts, one) == texts.end()) texts.push_back(one);
    }
    return fmt::format("{}", fmt::join(texts, "; "));
}

// A map says where water is, which is no ground. A map whose water cannot be read is still a city.
void readWater(CityRead& all, const Path& file, MapContext& water, const std::stop_token& stop) {
    NoProgress quiet;
    auto read = readContext(file, {.waterOnly = true}, all.city.frame, quiet, stop);
    if (!read) {
        all.warnings.push_back({WarningKind::leftOut, "water: " + read.error().what, read.error().where});
        return;
    }
    std::ranges::move(read->context.areas, std::back_inserter(water.areas));
    std::ranges::move(read->warnings, std::back_inserter(all.warnings));
}

// Of all maps, also those of which a window reads no building.
void readWater(CityRead& all, const std::vector<Path>& files, const std::stop_token& stop) {
    auto water = std::make_shared<MapContext>();
    for (const Path& file : files)
        if (findOsmFormat(file)) readWater(all, file, *water, stop);
    if (!water->empty()) all.city.context = std::move(water);
}

// Of the city's own files, then of the inventories.
Result<TreesRead> readAllTrees(std::vector<InputFile>& files, const ReadSettings& settings,
                               const std::stop_token& stop) {
    TreesRead all;
    for (InputFile& file : files) std::ranges::move(file.piece.trees, std::back_inserter(all.trees));
    for (const std::string& file : settings.treeFiles) {
        NoProgress quiet;
        auto read = readTrees(file, {.crs = settings.crs}, quiet, stop);
        if (!read) return tl::make_unexpected(read.error());
        std::ranges::move(read->trees, std::back_inserter(all.trees));
        std::ranges::move(read->warnings, std::back_inserter(all.warnings));
    }
    return all;
}

void joinAllTrees(CityRead& all, TreesRead read, double farAwayM) {
    std::ranges::move(read.warnings, std::back_inserter(all.warnings));
    all.city.trees = joinTrees(read.trees, all.city, farAwayM, all.warnings);
}

// The terrain; models of the surface without outlines give buildings, too.
Result<void> takeGround(CityRead& all, std::vector<InputFile>& files, const std::vector<ReadTree>& trees,
                        ReadSettings settings, Progress& progress, const std::stop_token& stop) {
    ProgressShare share(progress, partsOfReading(files) - 1, partsOfReading(files));
    const auto made =
        makeSurfaceBuildings(groundFiles(files), trees, settings, all.city.frame, all.heights, share, stop);
    if (!made) return tl::make_unexpected(made.error());
    if (*made) settings.heightsFromSurface = false;  // all have their height
    GroundChoice ground = chooseGround(groundFiles(files), settings, all.heights, stop);
    if (ground.terrain) all.city.terrain = ground.terrain;
    std::ranges::move(ground.warnings, std::back_inserter(all.warnings));
    return {};
}

// Terrain alone, which a plan of tiles reads by itself, has no buildings anyway.
bool missesExtent(const CityRead& all, const std::vector<InputFile>& files, const ReadSettings& settings) {
    const bool isGround = std::ranges::all_of(
        files, [](const InputFile& file) { return file.piece.terrain && file.piece.buildings.empty(); });
    return settings.extent && all.city.buildings.empty() && !isGround;
}

Result<CityRead> readAll(const std::vector<Path>& paths, const ReadSettings& settings,
                         const ReadExtent* window, Progress& progress, const std::stop_token& stop,
                         Formats formats) {
    const GdalCalls calls(stop);  // recognising a file may read all of it
    auto files = recogniseFiles(paths, window, formats);
    if (!files) return tl::make_unexpected(files.error());
    RisingProgress rising(progress);
    const auto frame = readPieces(*files, settings, rising, stop, window);
    if (!frame) return tl::make_unexpected(frame.error());
    CityRead all;
    all.city.frame = *frame;
    if (window != nullptr) all.city.terrain = window->terrain;
    auto trees = readAllTrees(*files, settings, stop);
    if (!trees) return tl::make_unexpected(trees.error());
    if (auto done = takeGround(all, *files, trees->trees, settings, rising, stop); !done)
        return tl::make_unexpected(done.error());
    if (stop.stop_requested()) return cancelled();
    for (const GroundFile& file : groundFiles(*files))
        measureRoofs(file, all.city.terrain.get(), all.city.frame, !settings.heightField.empty(),
                     all.heights);
    for (InputFile& file : *files) {
        file.carriers = findCarriers(file.piece);
        markOverhangsOnBases(file.piece, file.carriers);
    }
    makeTerrainFromBases(all, *files, settings.terrainFromBases);
    for (const InputFile& file : *files) {
        if (stop.stop_requested()) return cancelled();
        joinBuildings(all, file, settings.stand);
        joinWarnings(all, file, files->size() > 1);
        joinHeights(all.heights, file.piece.heights);
        all.features += file.piece.features;
    }
    if (window == nullptr && missesExtent(all, *files, settings)) return noneInExtent();
    dropSame(all, *files);
    readWater(all, paths, stop);
    countBeyondTerrain(all);
    joinAllTrees(all, *std::move(trees), settings.farAwayM);
    all.format = joinedTexts(*files, &FilePiece::format);
    all.attribution = joinedTexts(*files, &FilePiece::attribution);
    all.crs = joinedTexts(*files, &FilePiece::crs);
    return all;
}

}  // namespace

Result<CityRead> readCity(const std::vector<Path>& paths, const ReadSettings& settings, Progress& progress,
                          std::stop_token stop, Formats formats) {
    auto all = readAll(paths, settings, nullptr, progress, stop, formats);
    if (stop.stop_requested()) return cancelled();
    return all;
}

Result<CityRead> readCityExtent(const std::vector<Path>& paths, const ReadSettings& settings,
                                const ReadExtent& window, Progress& progress, std::stop_token stop) {
    auto all = readAll(paths, settings, &window, progress, stop, coreFormats());
    if (stop.stop_requested()) return cancelled();
    return all;
}

}  // namespace noonmark
