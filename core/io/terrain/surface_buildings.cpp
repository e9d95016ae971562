#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <limits>

#include "core/base/safe_text.h"
#include "core/city/terrain/post_grid.h"
#include "core/describe/text.h"
#include "core/io/settings/read_settings.h"
#include "core/io/terrain/buildings_on_terrain.h"
#include "core/io/terrain/ground_choice.h"

namespace noonmark {

namespace {

bool haveNoBuildings(const std::vector<GroundFile>& files) {
    return std::ranges::all_of(files, [](const GroundFile& file) { return file.piece->buildings.empty(); });
}

constexpr double leastSurfaceM2 = 10;  // of a building; less is a mast, a lorry or noise
constexpr double noticedZeroM = 0.5;   // from this on a warning states it
constexpr std::size_t mostParts = 1'000'000;

/// What the posts of a surface show. Those of `taken` lie within an earlier surface, which makes the
/// buildings there, those of `elsewhere` far from the extent.
enum class Shown : char { ground, building, canopy, unknown, taken, beyondGround, elsewhere };

/// Canopy heights at the posts of a surface, 0 where there is none.
std::vector<float> mapCanopy(const PostGrid& posts, const std::vector<ReadTree>& trees, const Frame& frame,
                             const std::stop_token& stop) {
    std::vector<float> heights(posts.size());
    for (const ReadTree& tree : trees) {
        if (stop.stop_requested()) break;
        if (!tree.facts.canopyCellM2 || !tree.facts.heightM) continue;
        const glm::dvec2 middle = posts.columnRowOf(frame.localFromLonLat(tree.place));
        const double half = std::max(0.5, std::sqrt(*tree.facts.canopyCellM2) / posts.cellM / 2);
        const auto first = [&](double at) { return std::max(0, int(std::ceil(at - half))); };
        const auto last = [&](double at, int count) {
            return std::min(count - 1, int(std::floor(at + half)));
        };
        if (!(std::abs(middle.x) < 1e6 && std::abs(middle.y) < 1e6)) continue;
        for (int row = first(middle.y); row <= last(middle.y, posts.rows); ++row)
            for (int column = first(middle.x); column <= last(middle.x, posts.columns); ++column) {
                float& height = heights[posts.index(column, row)];
                height = std::max(height, float(*tree.facts.heightM));
            }
    }
    return heights;
}

// A canopy whose height is that of the surface is the canopy; over a roof the surface shows the roof.
bool isCanopy(float canopyM, float aboveM) {
    return canopyM > 0 && std::abs(aboveM - canopyM) <= std::max(leastRaisedM, 0.2F * canopyM);
}

// All around the extent that readers read; nothing: everything is read.
std::optional<Box2> findLocalExtent(const ReadSettings& settings, const Frame& frame) {
    if (!settings.extent) return std::nullopt;
    const LonLatBox box = growBox(*settings.extent, aroundExtentM);
    Box2 local;
    for (const double west : {0.0, 0.5, 1.0})
        for (const double south : {0.0, 0.5, 1.0})
            local.add(glm::vec2(frame.localFromLonLat(
                {std::lerp(box.westDeg, box.eastDeg, west), std::lerp(box.southDeg, box.northDeg, south)})));
    return local;
}

bool liesIn(const Box2& box, glm::dvec2 point) {
    return point.x >= double(box.low.x) && point.y >= double(box.low.y) && point.x <= double(box.high.x) &&
           point.y <= double(box.high.y);
}

bool isGap(const FilePiece& piece, std::size_t post) {
    return !piece.unknownPosts.empty() && piece.unknownPosts[post] != 0;
}

// Whether a surface has an elevation at the point.
bool knows(const FilePiece& surface, glm::dvec2 point) {
    const PostGrid& posts = surface.terrain->grid;
    if (beyondM(posts, point) > 0) return false;
    const glm::ivec2 nearest(glm::round(posts.insideOf(posts.columnRowOf(point))));
    return !isGap(surface, posts.index(nearest.x, nearest.y));
}

/// Finds what the posts of one surface after the other show.
class SurfaceLook {
public:
    SurfaceLook(const std::vector<ReadTree>& trees, const ReadSettings& settings, const Frame& frame)
        : trees_(trees), frame_(frame), extent_(findLocalExtent(settings, frame)) {}

    std::vector<Shown> find(const SurfacePair& pair, const std::stop_token& stop) {
        const PostGrid& posts = pair.surface->piece->terrain->grid;
        const std::vector<float> canopy = mapCanopy(posts, trees_, frame_, stop);
        std::vector<Shown> shown(posts.size(), Shown::ground);
        tbb::parallel_for(0, posts.rows, [&](int row) {
            for (int column = 0; column < posts.columns && !stop.stop_requested(); ++column) {
                const std::size_t i = posts.index(column, row);
                shown[i] = findOne(pair, i, posts.centre(column, row), canopy[i]);
            }
        });
        earlier_.push_back(pair.surface->piece);
        return shown;
    }

private:
    [[nodiscard]] Shown findOne(const SurfacePair& pair, std::size_t post, glm::dvec2 at,
                                float canopyM) const {
        const Terrain& ground = *pair.ground->piece->terrain;
        if (extent_ && !liesIn(*extent_, at)) return Shown::elsewhere;
        if (isGap(*pair.surface->piece, post)) return Shown::unknown;
        if (std::ranges::any_of(earlier_, [&](const FilePiece* other) { return knows(*other, at); }))
            return Shown::taken;
        if (beyondM(ground.grid, at) > 0) return Shown::beyondGround;
        const float aboveM = pair.surface->piece->terrain->elevationM[post] - elevationAt(ground, at);
        if (aboveM < leastRaisedM) return Shown::ground;
        return isCanopy(canopyM, aboveM) ? Shown::canopy : Shown::building;
    }

    const std::vector<ReadTree>& trees_;
    const Frame& frame_;
    std::optional<Box2> extent_;
    std::vector<const FilePiece*> earlier_;
};

/// Cells of one part: their elevations differ by at most twice the tolerance.
struct SurfacePart {
    std::size_t building = 0;
    float lowM = std::numeric_limits<float>::max(), highM = std::numeric_limits<float>::lowest();
    [[nodiscard]] float middleM() const { return (lowM + highM) / 2; }
};

/// The cells of a surface that are buildings.
struct SurfaceGroups {
    std::vector<std::int32_t> partOfPost;  ///< counted from 1; 0 is no part
    std::vector<SurfacePart> parts;
    std::size_t buildings = 0;
    std::size_t tooSmall = 0;  ///< places of less than 10 m2, which are none
};

/// Groups cells that are joined over their sides into buildings, and these into parts.
class SurfaceGrouper {
public:
    SurfaceGrouper(const Terrain& surface, const std::vector<Shown>& shown, double toleranceM,
                   const std::stop_token& stop)
        : surface_(surface), shown_(shown), toleranceM_(toleranceM), stop_(stop), known_(shown.size()) {
        groups_.partOfPost.resize(shown.size());
    }

    /// Ends early when stopped, and with more parts than `mostParts`.
    SurfaceGroups group() {
        for (std::size_t i = 0; i < shown_.size() && !stop_.stop_requested(); ++i) {
            const std::vector<std::size_t> cells = collect(i, [&](std::size_t cell) { return isNew(cell); });
            if (cells.empty()) continue;
            if (double(cells.size()) * surface_.grid.cellM * surface_.grid.cellM < leastSurfaceM2) {
                ++groups_.tooSmall;
                continue;
            }
            divide(cells);
            ++groups_.buildings;
            if (groups_.parts.size() > mostParts) break;
        }
        return std::move(groups_);
    }

private:
    // The cells that can be reached from one, nearest first; `take` admits each once.
    template <class Take>
    std::vector<std::size_t> collect(std::size_t from, const Take& take) const {
        std::vector<std::size_t> cells;
        if (take(from)) cells.push_back(from);
        const auto columns = std::size_t(surface_.grid.columns);
        for (std::size_t next = 0; next < cells.size() && !stop_.stop_requested(); ++next) {
            const std::size_t cell = cells[next], column = cell % columns;
            const auto offer = [&](bool isThere, std::size_t beside) {
                if (isThere && take(beside)) cells.push_back(beside);
            };
            offer(column > 0, cell - 1);
            offer(column + 1 < columns, cell + 1);
            offer(cell >= columns, cell - columns);
            offer(cell + columns < shown_.size(), cell + columns);
        }
        return cells;
    }

    bool isNew(std::size_t cell) {
        if (shown_[cell] != Shown::building || known_[cell] != 0) return false;
        known_[cell] = 1;
        return true;
    }

    void divide(const std::vector<std::size_t>& cells) {
        for (const std::size_t first : cells) {
            if (groups_.partOfPost[first] != 0 || groups_.parts.size() > mostParts) continue;
            SurfacePart part{.building = groups_.buildings};
            collect(first, [&](std::size_t cell) { return addCell(cell, part); });
            groups_.parts.push_back(part);
        }
    }

    bool addCell(std::size_t cell, SurfacePart& part) {
        if (shown_[cell] != Shown::building || groups_.partOfPost[cell] != 0) return false;
        const float z = surface_.elevationM[cell];
        const float low = std::min(part.lowM, z), high = std::max(part.highM, z);
        if (double(high) - double(low) > 2 * toleranceM_) return false;
        part.lowM = low, part.highM = high;
        groups_.partOfPost[cell] = std::int32_t(groups_.parts.size() + 1);
        return true;
    }

    const Terrain& surface_;
    const std::vector<Shown>& shown_;
    double toleranceM_;
    const std::stop_token& stop_;
    std::vector<char> known_;
    SurfaceGroups groups_;
};

/// Makes the buildings, their outlines on the corners of cells, z local.
class SurfaceBuildingMaker {
public:
    /// `before`: buildings of other surfaces, whose numbers are taken.
    SurfaceBuildingMaker(const SurfaceGroups& groups, const PostGrid& posts, std::size_t before)
        : groups_(groups), posts_(posts), before_(before), buildings_(groups.buildings) {}

    void add(std::int32_t number, const std::vector<RawRing>& rings) {
        const SurfacePart& part = groups_.parts[std::size_t(number) - 1];
        Building& building = buildings_[part.building];
        std::vector<RawRing> placed;
        for (const RawRing& ring : rings) placed.push_back(onCorners(ring));
        for (Footprint& piece : repairFootprint(placed).pieces)
            building.parts.push_back(
                {.sourceId = fmt::format("{}.{}", nameOf(part.building), building.parts.size() + 1),
                 .footprint = std::move(piece),
                 .topM = part.middleM(),
                 .heightSource = HeightSource::measured});
    }

    /// Each set down: z counts from the lowest ground under it. When stopped, some are missing.
    BuildingList finish(const Terrain& ground, const std::stop_token& stop) {
        BuildingList made(buildings_.size());
        tbb::parallel_for(std::size_t{0}, buildings_.size(), [&](std::size_t i) {
            Building& building = buildings_[i];
            if (stop.stop_requested() || building.parts.empty()) return;
            building.sourceId = nameOf(i);
            const float lowestM = findLowestGround(building, ground);
            for (Part& part : building.parts) part.topM -= lowestM;
            made[i] = std::make_shared<const Building>(std::move(building));
        });
        std::erase(made, nullptr);
        return made;
    }

private:
    [[nodiscard]] std::string nameOf(std::size_t building) const {
        return fmt::format("surface {}", before_ + building + 1);
    }

    // Of a ring in columns and rows that count from the corner of the first cell.
    [[nodiscard]] RawRing onCorners(const RawRing& ring) const {
        RawRing placed;
        for (const glm::dvec2 corner : ring) placed.push_back(posts_.centre(corner.x - 0.5, corner.y - 0.5));
        return placed;
    }

    const SurfaceGroups& groups_;
    const PostGrid& posts_;
    std::size_t before_;
    std::vector<Building> buildings_;
};

/// Says what was made of a surface and what was not.
class SurfaceReport {
public:
    explicit SurfaceReport(const SurfacePair& pair) : pair_(pair), piece_(*pair.surface->piece) {}

    void sayMade(const Terrain& surface, double toleranceM) {
        std::size_t parts = 0;
        for (const auto& building : piece_.buildings) parts += building->parts.size();
        say(WarningKind::assumed,
            fmt::format("no file has outlines: what rises {:.0f} m and more above the ground in the surface "
                        "model is buildings, with heights to within {:g} m ({}) and outlines along its cells",
                        leastRaisedM, toleranceM, readOption("surface_tolerance_m")),
            fmt::format("{} above {}: {} of {}, cells of {:.2f} m", pair_.surface->name, pair_.ground->name,
                        countOf(piece_.buildings.size(), "building"), countOf(parts, "part"),
                        surface.grid.cellM));
        if (std::abs(pair_.zeroM) > noticedZeroM)
            say(WarningKind::assumed,
                "the surface and the ground differ where both show the ground: their heights may count from "
                "different zeros",
                fmt::format("{} and {}: {:.1f} m", pair_.surface->name, pair_.ground->name, pair_.zeroM));
    }

    void sayLeftOut(const std::vector<Shown>& shown, std::size_t tooSmall, std::size_t unknown) {
        count("what rises on less than 10 m2 in the surface model", tooSmall, "place");
        count("cells without elevation in the surface model, which show no buildings", unknown, "cell");
        for (const auto& [what, why] :
             {std::pair(Shown::canopy, "canopy in the surface model, which is no building"),
              std::pair(Shown::taken, "cells of a surface model that an earlier one covers"),
              std::pair(Shown::beyondGround, "cells of the surface model beyond the ground's border")})
            count(why, std::size_t(std::ranges::count(shown, what)), "cell");
    }

private:
    void say(WarningKind kind, std::string what, std::string where) {
        piece_.warnings.push_back({kind, std::move(what), std::move(where)});
    }
    void count(const char* what, std::size_t number, const char* unit) {
        if (number > 0)
            say(WarningKind::leftOut, what,
                fmt::format("{}: {}", pair_.surface->name, countOf(number, unit)));
    }

    const SurfacePair& pair_;
    FilePiece& piece_;
};

// The buildings of one surface go into its file. Returns how many numbers of buildings are taken then.
Result<std::size_t> makeBuildings(const SurfacePair& pair, SurfaceLook& look, std::size_t before,
                                  const ReadSettings& settings, Progress& progress,
                                  const std::stop_token& stop) {
    FilePiece& piece = *pair.surface->piece;
    const std::shared_ptr<const Terrain> surface = piece.terrain;
    const auto report = [&](double done) {
        progress.report(done, NM_TEXT("making buildings of the surface model"));
    };
    report(0);
    const std::vector<Shown> shown = look.find(pair, stop);
    report(0.2);
    SurfaceGroups groups = SurfaceGrouper(*surface, shown, settings.surfaceToleranceM, stop).group();
    if (groups.parts.size() > mostParts)
        return limitReached("The surface model shows more than a million parts of buildings",
                            pair.surface->name,
                            "Read a part of it by " + readOption("extent") + ", or raise " +
                                readOption("surface_tolerance_m"));
    report(0.4);
    SurfaceBuildingMaker maker(groups, surface->grid, before);
    const bool isDone = outlineNumbers(
        groups.partOfPost, surface->grid.columns, surface->grid.rows,
        [&](std::int32_t number, const std::vector<RawRing>& rings) { maker.add(number, rings); }, stop);
    if (stop.stop_requested()) return cancelled();
    if (!isDone) return failure("The surface model cannot be outlined", pair.surface->name);
    report(0.8);
    piece.buildings = maker.finish(*pair.ground->piece->terrain, stop);
    piece.groundM.assign(piece.buildings.size(), std::nullopt);
    SurfaceReport(pair).sayLeftOut(shown, groups.tooSmall, surface->source.filled);
    return before + groups.buildings;
}

// What is left of the buildings is counted and said.
Result<void> keepUsable(const SurfacePair& pair, const ReadSettings& settings, const Frame& frame,
                        HeightFacts& heights) {
    FilePiece& piece = *pair.surface->piece;
    if (settings.extent) keepExtent(pair.surface->name, piece, frame, *settings.extent);
    if (auto some = leaveOutImplausible(pair.surface->name, piece); !some) return some;
    SurfaceReport(pair).sayMade(*piece.terrain, settings.surfaceToleranceM);
    heights.fields.push_back({pair.surface->name, "surface - ground", "cells", "m", piece.buildings.size()});
    return {};
}

// Only the ground stays a terrain.
void leaveOutOthers(const std::vector<GroundFile>& files, const std::vector<SurfacePair>& pairs) {
    for (const GroundFile& file : files) {
        if (&file == pairs.front().ground || !file.piece->terrain) continue;
        if (std::ranges::find(pairs, &file, &SurfacePair::surface) == pairs.end())
            file.piece->warnings.push_back(
                {WarningKind::leftOut,
                 fmt::format("a terrain that is neither {} nor a surface above it; of several tiles make one "
                             "file first: gdalbuildvrt ground.vrt TILES",
                             pairs.front().ground->name),
                 file.name});
        file.piece->terrain.reset();
    }
}

}  // namespace

Result<bool> makeSurfaceBuildings(const std::vector<GroundFile>& files, const std::vector<ReadTree>& trees,
                                  const ReadSettings& settings, const Frame& frame, HeightFacts& heights,
                                  Progress& progress, const std::stop_token& stop) {
    if (settings.terrainShows == TerrainShows::ground || !haveNoBuildings(files)) return false;
    const auto pairs = findSurfacePairs(files);
    if (!pairs) return tl::make_unexpected(pairs.error());
    if (pairs->empty()) return false;
    SurfaceLook look(trees, settings, frame);
    std::size_t taken = 0;
    for (std::size_t i = 0; i < pairs->size(); ++i) {
        const SurfacePair& pair = (*pairs)[i];
        ProgressShare share(progress, i, pairs->size());
        const auto made = makeBuildings(pair, look, taken, settings, share, stop);
        if (!made) return tl::make_unexpected(made.error());
        taken = *made;
        if (auto kept = keepUsable(pair, settings, frame, heights); !kept)
            return tl::make_unexpected(kept.error());
    }
    leaveOutOthers(files, *pairs);
    return true;
}

}  // namespace noonmark
