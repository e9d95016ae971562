#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/engines/inverse/sources/facet_lanes.h"
#include "core/engines/inverse/sources/nearest_levels.h"
#include "core/engines/inverse/sources/source_finder.h"
#include "core/engines/inverse/sources/surface_facets.h"

namespace noonmark {

/// The shadows of a city's facets on flat ground at one instant: one polygon each, over which the height of
/// the occluding point is linear. Filled block by block of lanes, one major position at a time.
class ProjectedFacets final : public SourceInstant {
public:
    /// `facets` and `lanes` must outlive this; `facets` are in cells of the lanes' grid.
    ProjectedFacets(const SurfaceFacets& facets, const Lanes& lanes, glm::dvec3 towardsSun,
                    float nearestHitM);

    void fill(int block, LaneSources& sources, int into) const override;

private:
    /// The shadow polygon of a facet: the positions that it may cover, and the height above them.
    struct Throw {
        int firstMajor = 0, endMajor = 0;  // empty range: no shadow
        int firstMinor = 0, endMinor = 0;
        // Height of the occluding point: atOrigin + major x perMajor + minor x perMinor.
        double atOriginM = 0, perMajorM = 0, perMinorM = 0;
        int firstBlock = 0, endBlock = 0;
    };
    struct Range {
        int first = 0;
        int end = 0;
    };
    /// An edge of the polygon, from its lower major position to the higher.
    struct Edge {
        glm::dvec2 low, high;  // major and minor position
        double slope = 0;      // minor per major; unspecified if both ends have the same major position
    };
    /// The whole major positions that an edge crosses, and the crossings.
    struct EdgeLine {
        Range majors;
        double minor = 0;  // at the first of them
        double slope = 0;
    };
    /// Working memory, reused for all facets.
    struct Scratch {
        std::vector<EdgeLine> lines;
        std::vector<double> low, high;    // the two crossings at each major position
        std::vector<int> firstLane, end;  // lanes of the block between them, by major position
        std::vector<double> crossings;
        std::vector<NearestLevels::Span> spans;
    };

    void sortIntoBlocks();
    void throwEdges(const SurfaceFacet& facet);
    [[nodiscard]] Throw thrownBy(const SurfaceFacet& facet) const;
    [[nodiscard]] glm::dvec2 thrown(glm::dvec3 point) const;
    [[nodiscard]] std::span<const Edge> edgesOf(const SurfaceFacet& facet) const {
        return std::span(edges_).subspan(facet.firstEdge, facet.edgeCount);
    }
    [[nodiscard]] Range majorsInBlock(std::uint32_t facet, int block) const;
    void findSpans(std::uint32_t facet, int block, Scratch& scratch) const;
    void findLines(const SurfaceFacet& facet, Range majors, std::vector<EdgeLine>& lines) const;
    [[nodiscard]] LanePlaces placesOf(const Throw& cast, int firstMajor, int block) const;
    void spansOfConvex(const Throw& cast, Range majors, int block, Scratch& scratch) const;
    void spansOfAny(const Throw& cast, Range majors, int block, Scratch& scratch) const;
    void addSpan(const Throw& cast, int major, Range lanes, int block,
                 std::vector<NearestLevels::Span>& spans) const;

    const SurfaceFacets& facets_;
    const Lanes& lanes_;
    glm::dvec2 throwCells_;  // shadow offset per metre of height; x and y of the grid
    float nearestM_;         // lowest height that counts
    std::vector<Throw> throws_;
    std::vector<Edge> edges_;                          // as SurfaceFacets::edges; of facets that cast shadow
    std::vector<std::vector<std::uint32_t>> ofBlock_;  // facets of each block, ascending
};

}  // namespace noonmark
