#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/city/city.h"
#include "core/geo/grid.h"
#include "core/lab/inverse/lanes.h"
#include "core/lab/inverse/sources/source_finder.h"

namespace noonmark {

/// A box of positions on a grid, in cells.
struct CellBox {
    glm::dvec2 low{1e30};
    glm::dvec2 high{-1e30};
};

/// A plane piece of a building's surface, bounded by edges in any order (even-odd rule). x and y in cells of
/// a grid, z in metres.
struct SurfaceFacet {
    glm::dvec3 normal{};  ///< outward; normal . point = offset on the plane
    double offset = 0;
    std::uint32_t firstEdge = 0;  ///< index in SurfaceFacets::edges
    std::uint32_t edgeCount = 0;
    std::uint32_t building = 0;  ///< index in City::buildings
    bool convex = false;         ///< one loop, turning one way: any line crosses it twice or never
    /// Positions from which a ray may hit this facet from behind before any other of its building: those
    /// inside, or so close to the surface that the entry is ignored. Empty: none.
    CellBox fromBehind;
};

/// The complete surface of some buildings.
struct SurfaceFacets {
    using Edge = std::array<glm::dvec3, 2>;
    std::vector<SurfaceFacet> facets;
    std::vector<Edge> edges;

    [[nodiscard]] std::span<const Edge> edgesOf(const SurfaceFacet& facet) const {
        return std::span(edges).subspan(facet.firstEdge, facet.edgeCount);
    }
};

/// Walls, roofs and undersides of prisms, and triangles of meshes, of the buildings with these indices, on
/// flat ground at z = 0; parts below the ground are left out. `nearestHitM`: closer hits will be ignored,
/// metres.
SurfaceFacets makeSurfaceFacets(const City& city, std::span<const std::uint32_t> buildings, const Grid& grid,
                                double nearestHitM);

/// Extends the ranges low[i] to high[i] by the values of a line at consecutive positions, minor + i x slope.
void widen(double minor, double slope, int count, double* low, double* high);

/// Where a block's lanes lie at consecutive positions: lane 0 at from + bend[i]; positions are clamped to
/// [first, end).
struct LanePlaces {
    const int* bend;
    int from, first, end;
};

/// The lanes, 0 to 16, at whole positions from low[i] up to but not including high[i]; none if firstLane[i]
/// is not below endLane[i].
void findLanesBetween(const double* low, const double* high, const LanePlaces& places, int count,
                      int* firstLane, int* endLane);

/// A block's levels in memory; those of one major position are contiguous.
struct BlockLevels {
    CacheLine<float>* heightM;
    CacheLine<std::uint32_t>* building;
    int count;
};

/// The nearest few occluders of each position in a block of lanes, each building once.
class NearestLevels {
public:
    /// Writes to block `into` of `sources`, which starts out empty.
    NearestLevels(LaneSources& sources, int into);

    /// Lanes [first, end) of a block at one major position; 0 <= first < end <= 16.
    struct Span {
        int major = 0;
        int first = 0;
        int end = 0;
        float heightM = 0;  ///< height of the occluding point above the ground, at lane 0
    };
    /// Values shared by the spans of one facet.
    struct Facet {
        float perLaneM = 0;  ///< change of height from lane to lane
        float nearestM = 0;  ///< smaller heights are ignored
        std::uint32_t building = 0;
    };
    /// Keeps, for each position, the lowest height of each building and the buildings with the lowest
    /// heights.
    void add(std::span<const Span> spans, const Facet& facet);

    /// Converts the block to the form of LaneSources; call once, at the end.
    void finish();

private:
    [[nodiscard]] BlockLevels levels() const;
    LaneSources& sources_;
    std::size_t firstLine_, lines_;
};

/// Finds sources building by building: at one instant each facet of a building's surface casts a polygon on
/// the ground, over which the height of the occluding point is linear; the nearest few are kept for each
/// position. Finds what rays find, up to rounding at the polygons' edges, for all cells at once. Cost: some
/// 10 ns per polygon and 16 cells.
class ProjectedSourceFinder final : public SourceFinder {
public:
    /// `facets` in cells of the grid over which lanes will be made.
    ProjectedSourceFinder(SurfaceFacets facets, int levels, float nearestHitM);
    [[nodiscard]] int levels() const override { return levels_; }
    [[nodiscard]] std::unique_ptr<SourceInstant> at(glm::dvec3 towardsSun, const Lanes& lanes) const override;
    [[nodiscard]] std::uint64_t raysAnInstant() const override { return 0; }

private:
    SurfaceFacets facets_;
    int levels_;
    float nearestHitM_;
};

}  // namespace noonmark
