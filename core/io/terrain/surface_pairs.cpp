#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "core/io/terrain/buildings_on_terrain.h"
#include "core/io/terrain/ground_choice.h"

namespace noonmark {

namespace {

constexpr double coarsestM = 10;     // cells that could show a building
constexpr double farthestZeroM = 2;  // between the zeros of two rasters of one place

/// How a raster lies above another one, at up to 500 x 500 of its posts that both have.
struct SurfaceFit {
    std::size_t posts = 0;
    std::size_t raised = 0;  ///< above by more than 2 m
    std::size_t sunken = 0;  ///< below by more than 2 m
    double zeroM = 0;        ///< how far where both show the ground

    /// Whether it can be a surface with buildings on the other one.
    [[nodiscard]] bool isSurface() const { return posts >= 100 && raised >= 4 && 20 * sunken < raised; }
};

// A twentieth part of the posts lies lower than where both show the ground, fewer where most of it is built
// on.
double findZero(std::vector<float>& above) {
    const auto lowest = [&](std::size_t outOf) {
        const auto at = above.begin() + std::ptrdiff_t(above.size() / outOf);
        std::ranges::nth_element(above, at);
        return double(*at);
    };
    const double zeroM = lowest(20);
    return zeroM > 0 ? std::max(0.0, lowest(200)) : zeroM;
}

bool isUnknown(const FilePiece& piece, std::size_t post) {
    return !piece.unknownPosts.empty() && piece.unknownPosts[post] != 0;
}

bool isGapAt(const FilePiece& piece, glm::dvec2 at) {
    const PostGrid& posts = piece.terrain->grid;
    const glm::dvec2 nearest = posts.insideOf(posts.columnRowOf(at));
    return isUnknown(piece, posts.index(int(std::lround(nearest.x)), int(std::lround(nearest.y))));
}

// Where the ground has gaps, as under buildings, nothing says that it is that of the surface.
SurfaceFit compareRasters(const FilePiece& surface, const FilePiece& below) {
    const Terrain& ground = *below.terrain;
    constexpr int side = 500;
    const PostGrid& posts = surface.terrain->grid;
    SurfaceFit fit;
    std::vector<float> above;
    for (int row = 0; row < posts.rows; row += std::max(1, posts.rows / side))
        for (int column = 0; column < posts.columns; column += std::max(1, posts.columns / side)) {
            const std::size_t post = posts.index(column, row);
            const glm::dvec2 at = posts.centre(column, row);
            if (isUnknown(surface, post) || beyondM(ground.grid, at) > 0) continue;
            const float aboveM = surface.terrain->elevationM[post] - elevationAt(ground, at);
            if (!isGapAt(below, at)) above.push_back(aboveM);
        }
    if (above.empty()) return fit;
    fit.posts = above.size();
    fit.raised = std::size_t(std::ranges::count_if(above, [](float m) { return m > leastRaisedM; }));
    fit.sunken = std::size_t(std::ranges::count_if(above, [](float m) { return m < -leastRaisedM; }));
    fit.zeroM = findZero(above);
    return fit;
}

bool mayShowBuildings(const GroundFile& file) {
    return file.isRaster && file.piece->terrain && file.piece->terrain->grid.cellM <= coarsestM;
}

/// A pair that may be one of a surface and its ground.
struct PossiblePair {
    SurfacePair pair;
    SurfaceFit fit;
    [[nodiscard]] double apartM() const { return std::abs(fit.zeroM); }
    [[nodiscard]] double raisedShare() const { return double(fit.raised) / double(fit.posts); }
};

std::vector<PossiblePair> findAllPairs(const std::vector<GroundFile>& files) {
    std::vector<PossiblePair> pairs;
    for (const GroundFile& surface : files)
        for (const GroundFile& ground : files) {
            if (&surface == &ground || !mayShowBuildings(surface) || !ground.piece->terrain) continue;
            const SurfaceFit fit = compareRasters(*surface.piece, *ground.piece);
            if (fit.isSurface()) pairs.push_back({{&surface, &ground, fit.zeroM}, fit});
        }
    return pairs;
}

tl::unexpected<Error> otherZeros(const SurfacePair& pair) {
    return failure(
        fmt::format("Where {} is lowest above {}, it lies {:.1f} m {}: their heights count from different "
                    "zeros, or it shows no open ground",
                    pair.surface->name, pair.ground->name, std::abs(pair.zeroM),
                    pair.zeroM > 0 ? "above" : "below"),
        pair.surface->name,
        "Give both in one vertical reference system and unit, and with open ground, or read them with "
        "outlines of buildings");
}

}  // namespace

// A raster of heights above the ground has another zero, and above a surface of another year rises less than
// above the ground.
Result<std::vector<SurfacePair>> findSurfacePairs(const std::vector<GroundFile>& files) {
    const std::vector<PossiblePair> all = findAllPairs(files);
    std::vector<SurfacePair> pairs;
    if (all.empty()) return pairs;
    const PossiblePair& nearest = *std::ranges::min_element(all, {}, &PossiblePair::apartM);
    if (nearest.apartM() > farthestZeroM) return otherZeros(nearest.pair);
    const PossiblePair* best = &nearest;
    for (const PossiblePair& one : all)
        if (one.apartM() <= farthestZeroM && one.raisedShare() > best->raisedShare()) best = &one;
    for (const PossiblePair& one : all)
        if (one.pair.ground == best->pair.ground && one.apartM() <= farthestZeroM) pairs.push_back(one.pair);
    return pairs;
}

}  // namespace noonmark
