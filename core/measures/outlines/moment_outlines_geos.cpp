#include "core/measures/outlines/moment_outlines.h"

#include <geos_c.h>
#include <tbb/parallel_for.h>
#include <array>
#include <atomic>
#include <cstdint>
#include <glm/common.hpp>

#include "core/city/footprints/geos_shapes.h"
#include "core/city/footprints/repair_footprint.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

using Geometry = Geos::Geometry;
constexpr double tileM = 100;  // some hundred polygons a tile: a union of few takes less than of many

/// The area divided into equal tiles, and which polygons meet each of them.
class TileGrid {
public:
    explicit TileGrid(const Box2& area)
        : area_(area),
          size_(glm::dvec2(area.high) - glm::dvec2(area.low)),
          count_(glm::ceil(size_ / tileM)) {}

    [[nodiscard]] std::size_t count() const { return std::size_t(count_.x) * std::size_t(count_.y); }
    [[nodiscard]] Box2 box(std::size_t tile) const {
        const std::size_t columns(count_.x), row = tile / columns;
        const glm::dvec2 at(double(tile % columns), double(row));
        return {corner(at), corner(at + 1.0)};
    }

    /// For each tile the indices of the shapes whose bounds meet it.
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> sort(const auto& shapes,
                                                               const auto& boundsOf) const {
        std::vector<std::vector<std::uint32_t>> ofTile(count());
        for (std::uint32_t i = 0; i < shapes.size(); ++i) {
            const auto [low, high] = boundsOf(shapes[i]);
            const glm::dvec2 first = glm::max(columnRow(low), 0.0),
                             last = glm::min(columnRow(high), count_ - 1.0);
            for (double row = first.y; row <= last.y; ++row)
                for (double column = first.x; column <= last.x; ++column)
                    ofTile[std::size_t(row) * std::size_t(count_.x) + std::size_t(column)].push_back(i);
        }
        return ofTile;
    }

private:
    // The corners of neighbouring tiles are the same numbers.
    [[nodiscard]] glm::vec2 corner(glm::dvec2 at) const {
        return glm::vec2(glm::dvec2(area_.low) + size_ * (at / count_));
    }
    [[nodiscard]] glm::dvec2 columnRow(glm::dvec2 point) const {
        return glm::floor((point - glm::dvec2(area_.low)) / size_ * count_);
    }

    Box2 area_;
    glm::dvec2 size_, count_;
};

struct Bounds {
    glm::dvec2 low, high;
};

Bounds boundsOfPolygon(const ConvexPolygon& polygon) {
    Bounds box{polygon.front(), polygon.front()};
    for (const glm::dvec2 point : polygon) {
        box.low = glm::min(box.low, point);
        box.high = glm::max(box.high, point);
    }
    return box;
}

Bounds boundsOfFootprint(const Footprint& footprint) {
    const Box2 box = bounds(footprint);
    return {glm::dvec2(box.low), glm::dvec2(box.high)};
}

/// Polygons sorted into tiles.
class TiledPolygons {
public:
    TiledPolygons(const std::vector<ConvexPolygon>& polygons, const TileGrid& tiles)
        : polygons_(polygons), ofTile_(tiles.sort(polygons, boundsOfPolygon)) {}

    /// The polygons in a tile, cut at its edges.
    [[nodiscard]] std::vector<ConvexPolygon> in(std::size_t tile, const Box2& box) const {
        std::vector<ConvexPolygon> pieces;
        for (const std::uint32_t i : ofTile_[tile]) {
            ConvexPolygon piece = clipToBox(polygons_[i], box);
            if (!piece.empty()) pieces.push_back(std::move(piece));
        }
        dropContained(pieces);
        return pieces;
    }

private:
    const std::vector<ConvexPolygon>& polygons_;
    std::vector<std::vector<std::uint32_t>> ofTile_;
};

// Unlike uniteGeometry(), leaves the points on the edges of tiles.
Geometry unite(const Geos& geos, const Geometry& polygons) {
    if (!polygons) return geos.owned(nullptr);
    Geometry joined = geos.owned(GEOSUnaryUnion_r(geos, polygons.get()));
    return joined ? std::move(joined) : geos.owned(GEOSUnaryUnionPrec_r(geos, polygons.get(), overlayGridM));
}

Geometry unite(const Geos& geos, const std::vector<ConvexPolygon>& pieces) {
    std::vector<GEOSGeometry*> shapes;
    for (const ConvexPolygon& piece : pieces) shapes.push_back(makePolygonGeometry(geos, {piece}).release());
    return unite(geos, collection(geos, std::move(shapes)));
}

Geometry joinTwo(const Geos& geos, const Geometry& a, const Geometry& b) {
    if (!a || !b) return geos.owned(nullptr);
    Geometry joined = geos.owned(GEOSUnion_r(geos, a.get(), b.get()));
    return joined ? std::move(joined) : geos.owned(GEOSUnionPrec_r(geos, a.get(), b.get(), overlayGridM));
}

Geometry coverGeometry(const Geos& geos, const std::vector<Footprint>& cover, const Box2& box) {
    const Geometry all = collection(geos, cover);
    // A margin, so that no cover ends just before the edge of the tile.
    return unite(
        geos, geos.owned(all ? GEOSClipByRect_r(geos, all.get(), double(box.low.x) - 1, double(box.low.y) - 1,
                                                double(box.high.x) + 1, double(box.high.y) + 1)
                             : nullptr));
}

/// One tile's parts of the three outlines. Null: GEOS failed.
using TileOutlines = std::array<Geometry, 3>;

/// Everything that falls on the area, sorted into tiles.
struct TiledShadows {
    TileGrid tiles;
    TiledPolygons common, baseline, scenario;
    const std::vector<Footprint>& cover;
    std::vector<std::vector<std::uint32_t>> coverOfTile;

    TiledShadows(const ProjectedShadowPolygons& polygons, const std::vector<Footprint>& over,
                 const Box2& area)
        : tiles(area),
          common(polygons.common, tiles),
          baseline(polygons.baseline, tiles),
          scenario(polygons.scenario, tiles),
          cover(over),
          coverOfTile(tiles.sort(over, boundsOfFootprint)) {}

    [[nodiscard]] TileOutlines join(const Geos& geos, std::size_t tile) const {
        const Box2 box = tiles.box(tile);
        std::vector<Footprint> over;
        for (const std::uint32_t i : coverOfTile[tile]) over.push_back(cover[i]);
        const Geometry covered = coverGeometry(geos, over, box), shared = unite(geos, common.in(tile, box)),
                       before = unite(geos, baseline.in(tile, box)),
                       after = unite(geos, scenario.in(tile, box));
        const Geometry wasDark = joinTwo(geos, shared, before), isDark = joinTwo(geos, shared, after);
        return {subtractGeometry(geos, wasDark, covered),
                subtractGeometry(geos, subtractGeometry(geos, after, wasDark), covered),
                subtractGeometry(geos, subtractGeometry(geos, before, isDark), covered)};
    }
};

// Rounding to float32 may make edges cross or points coincide.
std::vector<Footprint> repaired(const std::vector<Footprint>& polygons) {
    std::vector<Footprint> valid;
    for (const Footprint& polygon : polygons) {
        std::vector<RawRing> rings{RawRing(polygon.outer.begin(), polygon.outer.end())};
        for (const Ring& hole : polygon.holes) rings.emplace_back(hole.begin(), hole.end());
        for (Footprint& piece : repairFootprint(rings).pieces) valid.push_back(std::move(piece));
    }
    return valid;
}

// The tiles' parts of one outline, joined along the edges of the tiles.
Result<std::vector<Footprint>> joinTiles(std::vector<TileOutlines>& tiles, std::size_t outline) {
    const Geos geos;
    std::vector<GEOSGeometry*> parts;
    bool failed = false;
    for (TileOutlines& tile : tiles) {
        failed = failed || !tile[outline];
        if (tile[outline]) parts.push_back(tile[outline].release());
    }
    const Geometry all = geos.owned(
        GEOSGeom_createCollection_r(geos, GEOS_GEOMETRYCOLLECTION, parts.data(), unsigned(parts.size())));
    const Geometry joined = failed ? geos.owned(nullptr) : uniteGeometry(geos, all);
    if (!joined) return internalError("The polygons of the shadows cannot be joined", "outlines of shadows");
    return repaired(toPolygons(geos, joined));
}

}  // namespace

Result<ShadowOutlines> joinShadows(const ProjectedShadowPolygons& polygons,
                                   const std::vector<Footprint>& cover, const Box2& area, Progress& progress,
                                   const std::stop_token& stop) {
    const TiledShadows shadows(polygons, cover, area);
    // Contexts outlive the geometries that they made.
    const std::vector<Geos> contexts(shadows.tiles.count());
    std::vector<TileOutlines> tiles(contexts.size());
    std::atomic<std::size_t> done = 0;
    tbb::parallel_for(std::size_t{0}, contexts.size(), [&](std::size_t tile) {
        if (stop.stop_requested()) return;
        tiles[tile] = shadows.join(contexts[tile], tile);
        progress.report(double(++done) / double(contexts.size()), NM_TEXT("joining shadows"));
    });
    if (stop.stop_requested()) return cancelled();
    std::array<Result<std::vector<Footprint>>, 3> joined;
    tbb::parallel_for(std::size_t{0}, joined.size(),
                      [&](std::size_t outline) { joined[outline] = joinTiles(tiles, outline); });
    for (const auto& outline : joined)
        if (!outline) return tl::make_unexpected(outline.error());
    if (stop.stop_requested()) return cancelled();
    return ShadowOutlines{*std::move(joined[0]), *std::move(joined[1]), *std::move(joined[2])};
}

}  // namespace noonmark
