#include "core/lab/inverse/sources/projected_source_finder.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "core/engines/projected/casters/ring_lines.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

namespace {

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

constexpr double nowhere = std::numeric_limits<double>::infinity();

// The first whole position at or beyond `position`, 0 to `count`.
int firstAtOrBeyond(double position, int count) {
    const double held = std::clamp(position, 0.0, double(count));
    const int below = int(held);
    return below + int(held > below);
}

// First coordinate at which the line from a to b reaches `level` in the second coordinate.
double passes(glm::dvec2 a, glm::dvec2 b, double level) {
    return a.x + (b.x - a.x) * ((level - a.y) / (b.y - a.y));
}

/// A strip of the second coordinate, and the range of the first coordinate found inside it.
struct Strip {
    double low, high;
    double from = nowhere, to = -nowhere;

    void add(glm::dvec2 a, glm::dvec2 b) {
        if (a.y > b.y) std::swap(a, b);
        if (a.y >= low && b.y <= high) {
            from = std::min({from, a.x, b.x});
            to = std::max({to, a.x, b.x});
            return;
        }
        if (b.y < low || a.y > high) return;
        take(a.y < low ? passes(a, b, low) : a.x);
        take(b.y > high ? passes(a, b, high) : b.x);
    }
    void take(double place) {
        from = std::min(from, place);
        to = std::max(to, place);
    }
};

void findCrossings(const auto& lines, int major, std::vector<double>& crossings) {
    crossings.clear();
    for (const auto& line : lines)
        if (major >= line.majors.first && major < line.majors.end)
            crossings.push_back(line.minor + (major - line.majors.first) * line.slope);
    std::ranges::sort(crossings);
}

ProjectedFacets::ProjectedFacets(const SurfaceFacets& facets, const Lanes& lanes, glm::dvec3 towardsSun,
                                 float nearestHitM)
    : facets_(facets),
      lanes_(lanes),
      throwCells_(shadowOffsetInCells(towardsSun, lanes.grid().cellM)),
      nearestM_(nearestHitM * float(towardsSun.z)),
      throws_(facets.facets.size()),
      edges_(facets.edges.size()) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, throws_.size(), 512), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            throws_[i] = thrownBy(facets_.facets[i]);
            if (throws_[i].firstBlock < throws_[i].endBlock) throwEdges(facets_.facets[i]);
        }
    });
    sortIntoBlocks();
}

void ProjectedFacets::throwEdges(const SurfaceFacet& facet) {
    const std::size_t first = facet.firstEdge;
    for (std::size_t i = first; i < first + facet.edgeCount; ++i) {
        glm::dvec2 a = thrown(facets_.edges[i][0]), b = thrown(facets_.edges[i][1]);
        if (a.x > b.x) std::swap(a, b);
        edges_[i] = {a, b, (b.y - a.y) / (b.x - a.x)};
    }
}

// Most facets reach few blocks, and most blocks have few facets.
void ProjectedFacets::sortIntoBlocks() {
    ofBlock_.resize(std::size_t(lanes_.blocks()));
    for (std::uint32_t i = 0; i < throws_.size(); ++i)
        for (int block = throws_[i].firstBlock; block < throws_[i].endBlock; ++block)
            ofBlock_[std::size_t(block)].push_back(i);
}

// Returns major and minor position.
glm::dvec2 ProjectedFacets::thrown(glm::dvec3 point) const {
    const glm::dvec2 place = glm::dvec2(point.x, point.y) + point.z * throwCells_;
    return lanes_.alongX() ? place : glm::dvec2(place.y, place.x);
}

// From ground point p, the point h metres up on the way to the sun is p - h x throw, so the facet's plane
// determines h.
ProjectedFacets::Throw ProjectedFacets::thrownBy(const SurfaceFacet& facet) const {
    const glm::dvec3 n = facet.normal;
    const double facing = n.z - n.x * throwCells_.x - n.y * throwCells_.y;
    const double grazing = 1e-9 * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    if (std::abs(facing) <= grazing) return {};
    glm::dvec2 low(nowhere), high(-nowhere);
    double lowLane = nowhere, highLane = -nowhere;  // before the bend is rounded
    for (const auto& edge : facets_.edgesOf(facet)) {
        const glm::dvec2 place = thrown(edge[0]);
        low = glm::min(low, place);
        high = glm::max(high, place);
        const double lane = place.y - lanes_.slope() * place.x - lanes_.firstLane();
        lowLane = std::min(lowLane, lane);
        highLane = std::max(highLane, lane);
    }
    if (facing > 0) {
        const CellBox& box = facet.fromBehind;
        low = glm::max(low, lanes_.alongX() ? box.low : glm::dvec2(box.low.y, box.low.x));
        high = glm::min(high, lanes_.alongX() ? box.high : glm::dvec2(box.high.y, box.high.x));
    }
    Throw cast{.firstMajor = firstAtOrBeyond(low.x, lanes_.majors()),
               .endMajor = firstAtOrBeyond(high.x, lanes_.majors()),
               .firstMinor = firstAtOrBeyond(low.y, lanes_.minors()),
               .endMinor = firstAtOrBeyond(high.y, lanes_.minors()),
               .atOriginM = facet.offset / facing,
               .perMajorM = -(lanes_.alongX() ? n.x : n.y) / facing,
               .perMinorM = -(lanes_.alongX() ? n.y : n.x) / facing};
    if (cast.firstMajor >= cast.endMajor || cast.firstMinor >= cast.endMinor) return {};
    const auto blockOf = [&](double lane) {
        return int(std::clamp(lane, 0.0, double(lanes_.count() - 1))) / Lanes::perBlock;
    };
    cast.firstBlock = blockOf(lowLane - 1);
    cast.endBlock = blockOf(highLane + 1) + 1;
    return cast;
}

void ProjectedFacets::fill(int block, LaneSources& sources, int into) const {
    const FlushDenormals flush;
    NearestLevels levels(sources, into);
    Scratch scratch;
    scratch.low.resize(std::size_t(lanes_.majors()));
    scratch.high.resize(scratch.low.size());
    scratch.firstLane.resize(scratch.low.size());
    scratch.end.resize(scratch.low.size());
    for (const std::uint32_t i : ofBlock_[std::size_t(block)]) {
        findSpans(i, block, scratch);
        levels.add(scratch.spans, {float(throws_[i].perMinorM), nearestM_, facets_.facets[i].building});
    }
    levels.finish();
}

// Positions of the polygon's part in the block; a lane's positions lie within half a cell of its straight
// line.
ProjectedFacets::Range ProjectedFacets::majorsInBlock(std::uint32_t facet, int block) const {
    const double firstLane = block * Lanes::perBlock + lanes_.firstLane();
    Strip strip{firstLane - 0.75, firstLane + Lanes::perBlock - 0.25};
    const auto sheared = [&](glm::dvec2 place) {
        return glm::dvec2(place.x, place.y - lanes_.slope() * place.x);
    };
    for (const Edge& edge : edgesOf(facets_.facets[facet])) strip.add(sheared(edge.low), sheared(edge.high));
    const Throw& cast = throws_[facet];
    return {std::max(cast.firstMajor, firstAtOrBeyond(strip.from, lanes_.majors())),
            std::min(cast.endMajor, firstAtOrBeyond(strip.to + 1e-6, lanes_.majors()))};
}

void ProjectedFacets::findSpans(std::uint32_t facet, int block, Scratch& scratch) const {
    scratch.spans.clear();
    const Range majors = majorsInBlock(facet, block);
    if (majors.first >= majors.end) return;
    findLines(facets_.facets[facet], majors, scratch.lines);
    if (facets_.facets[facet].convex)
        spansOfConvex(throws_[facet], majors, block, scratch);
    else
        spansOfAny(throws_[facet], majors, block, scratch);
}

// Half-open, as in core/city/footprints/footprint.h.
void ProjectedFacets::findLines(const SurfaceFacet& facet, Range majors, std::vector<EdgeLine>& lines) const {
    lines.clear();
    for (const Edge& edge : edgesOf(facet)) {
        const int first = std::max(majors.first, firstAtOrBeyond(edge.low.x, lanes_.majors()));
        const int end = std::min(majors.end, firstAtOrBeyond(edge.high.x, lanes_.majors()));
        if (first >= end) continue;
        lines.push_back({{first, end}, edge.low.y + (first - edge.low.x) * edge.slope, edge.slope});
    }
}

LanePlaces ProjectedFacets::placesOf(const Throw& cast, int firstMajor, int block) const {
    return {&lanes_.bend()[std::size_t(firstMajor)], block * Lanes::perBlock + lanes_.firstLane(),
            cast.firstMinor, cast.endMinor};
}

// A convex polygon's outline crosses each major position twice or not at all.
void ProjectedFacets::spansOfConvex(const Throw& cast, Range majors, int block, Scratch& scratch) const {
    const int count = majors.end - majors.first;
    std::fill_n(scratch.low.data(), count, nowhere);
    std::fill_n(scratch.high.data(), count, -nowhere);
    for (const EdgeLine& line : scratch.lines) {
        const int from = line.majors.first - majors.first;
        widen(line.minor, line.slope, line.majors.end - line.majors.first, &scratch.low[std::size_t(from)],
              &scratch.high[std::size_t(from)]);
    }
    findLanesBetween(scratch.low.data(), scratch.high.data(), placesOf(cast, majors.first, block), count,
                     scratch.firstLane.data(), scratch.end.data());
    for (int i = 0; i < count; ++i)
        addSpan(cast, majors.first + i, {scratch.firstLane[std::size_t(i)], scratch.end[std::size_t(i)]},
                block, scratch.spans);
}

void ProjectedFacets::spansOfAny(const Throw& cast, Range majors, int block, Scratch& scratch) const {
    for (int major = majors.first; major < majors.end; ++major) {
        findCrossings(scratch.lines, major, scratch.crossings);
        for (std::size_t k = 0; k + 1 < scratch.crossings.size(); k += 2) {
            Range lanes;
            findLanesBetween(&scratch.crossings[k], &scratch.crossings[k + 1], placesOf(cast, major, block),
                             1, &lanes.first, &lanes.end);
            addSpan(cast, major, lanes, block, scratch.spans);
        }
    }
}

void ProjectedFacets::addSpan(const Throw& cast, int major, Range lanes, int block,
                              std::vector<NearestLevels::Span>& spans) const {
    if (lanes.first >= lanes.end) return;
    const int lane0 = lanes_.minor(block * Lanes::perBlock, major);
    spans.push_back({major, lanes.first, lanes.end,
                     float(cast.atOriginM + major * cast.perMajorM + lane0 * cast.perMinorM)});
}

}  // namespace

ProjectedSourceFinder::ProjectedSourceFinder(SurfaceFacets facets, int levels, float nearestHitM)
    : facets_(std::move(facets)), levels_(levels), nearestHitM_(nearestHitM) {}

std::unique_ptr<SourceInstant> ProjectedSourceFinder::at(glm::dvec3 towardsSun, const Lanes& lanes) const {
    return std::make_unique<ProjectedFacets>(facets_, lanes, towardsSun, nearestHitM_);
}

}  // namespace noonmark
