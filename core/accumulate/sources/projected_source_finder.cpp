#include "core/accumulate/sources/projected_source_finder.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/accumulate/flush_denormals.h"
#include "core/accumulate/projected/cell_coordinates.h"
#include "core/accumulate/sources/nearest_levels.h"

namespace noonmark {

namespace {

// A band's levels stay in the second-level cache.
constexpr std::size_t bandBytes = std::size_t{384} << 10U;

int rowsOfABand(const Grid& grid, int levels) {
    const std::size_t rowBytes = std::size_t(levels) * std::size_t(grid.columns) * 8;
    return std::clamp(int(bandBytes / rowBytes), 4, 64);
}

int firstAtOrBeyond(double position, int count) {
    return int(std::ceil(std::clamp(position, 0.0, double(count))));
}

/// What one facet throws on the ground at one instant.
struct Throw {
    int firstRow = 0, endRow = 0;  // empty: nothing
    int firstColumn = 0, endColumn = 0;
    // Height of the occluding point above cell (column, row): atOrigin + column x + row y.
    double atOriginM = 0, perColumnM = 0, perRowM = 0;
};

/// An edge of what a facet throws: the rows it crosses, and where.
struct EdgeLine {
    int firstRow, endRow;
    double column;  // at the first row
    double slope;
};

/// Memory that is used again, facet after facet.
struct FillScratch {
    std::vector<EdgeLine> lines;
    std::vector<double> crossings;
};

/// All facets at one instant.
class ThrownFacets {
public:
    /// Bands are so many rows high.
    ThrownFacets(const SurfaceFacets& facets, const Grid& grid, glm::dvec3 towardsSun, float nearestHitM,
                 int bandRows)
        : facets_(facets),
          grid_(grid),
          throwCells_(throwInCells(towardsSun, grid.cellM)),
          nearestM_(nearestHitM * float(towardsSun.z)),
          throws_(facets.facets.size()) {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, throws_.size(), 1024), [&](const auto& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                throws_[i] = thrownBy(facets_.facets[i]);
        });
        sortIntoBands(bandRows);
    }

    /// Rows [firstRow, endRow) are those of one band.
    void fill(NearestLevels& levels, int firstRow, int endRow, FillScratch& scratch) const {
        for (const std::uint32_t i : ofBand_[std::size_t(firstRow / bandRows_)]) {
            const int from = std::max(throws_[i].firstRow, firstRow),
                      to = std::min(throws_[i].endRow, endRow);
            findLines(facets_.facets[i], scratch.lines);
            for (int row = from; row < to; ++row) fillRow(levels, i, row, row - firstRow, scratch);
        }
    }

private:
    // Most facets reach few bands, and few facets a band.
    void sortIntoBands(int bandRows) {
        bandRows_ = bandRows;
        ofBand_.resize(std::size_t((grid_.rows + bandRows - 1) / bandRows));
        for (std::uint32_t i = 0; i < throws_.size(); ++i) {
            const Throw& cast = throws_[i];
            if (cast.firstRow >= cast.endRow || cast.firstColumn >= cast.endColumn) continue;
            for (int band = cast.firstRow / bandRows; band * bandRows < cast.endRow; ++band)
                ofBand_[std::size_t(band)].push_back(i);
        }
    }

    // From below the point h metres up on the way to the sun is p - h throw, so the facet's plane gives h.
    [[nodiscard]] Throw thrownBy(const SurfaceFacet& facet) const {
        const glm::dvec3 n = facet.normal;
        const double facing = n.z - n.x * throwCells_.x - n.y * throwCells_.y;
        const double grazing = 1e-9 * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
        if (std::abs(facing) <= grazing) return {};
        CellBox box = boundsOf(facet);
        if (facing > 0) {
            box.low = glm::max(box.low, facet.fromBehind.low);
            box.high = glm::min(box.high, facet.fromBehind.high);
        }
        return {firstAtOrBeyond(box.low.y, grid_.rows),
                firstAtOrBeyond(box.high.y, grid_.rows),
                firstAtOrBeyond(box.low.x, grid_.columns),
                firstAtOrBeyond(box.high.x, grid_.columns),
                facet.offset / facing,
                -n.x / facing,
                -n.y / facing};
    }

    [[nodiscard]] glm::dvec2 thrown(glm::dvec3 point) const {
        return glm::dvec2(point.x, point.y) + point.z * throwCells_;
    }

    [[nodiscard]] CellBox boundsOf(const SurfaceFacet& facet) const {
        CellBox box;
        for (const auto& [a, b] : facets_.edgesOf(facet)) {
            box.low = glm::min(box.low, thrown(a));
            box.high = glm::max(box.high, thrown(a));
        }
        return box;
    }

    void fillRow(NearestLevels& levels, std::size_t index, int row, int bandRow, FillScratch& scratch) const {
        const Throw& cast = throws_[index];
        std::vector<double>& crossings = scratch.crossings;
        crossings.clear();
        for (const EdgeLine& line : scratch.lines)
            if (row >= line.firstRow && row < line.endRow)
                crossings.push_back(line.column + (row - line.firstRow) * line.slope);
        std::ranges::sort(crossings);
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
            const int first = std::max(firstAtOrBeyond(crossings[k], grid_.columns), cast.firstColumn);
            const int end = std::min(firstAtOrBeyond(crossings[k + 1], grid_.columns), cast.endColumn);
            if (first < end)
                levels.add({bandRow, first, end, cast.atOriginM + row * cast.perRowM, cast.perColumnM,
                            nearestM_, facets_.facets[index].building});
        }
    }

    // Half-open, as core/city/crossing.h.
    void findLines(const SurfaceFacet& facet, std::vector<EdgeLine>& lines) const {
        lines.clear();
        for (const auto& [from, to] : facets_.edgesOf(facet)) {
            glm::dvec2 a = thrown(from), b = thrown(to);
            if (a.y > b.y) std::swap(a, b);
            const int first = firstAtOrBeyond(a.y, grid_.rows), end = firstAtOrBeyond(b.y, grid_.rows);
            if (first >= end) continue;
            const double slope = (b.x - a.x) / (b.y - a.y);
            lines.push_back({first, end, a.x + (first - a.y) * slope, slope});
        }
    }

    const SurfaceFacets& facets_;
    const Grid& grid_;
    glm::dvec2 throwCells_;
    float nearestM_;  // lowest height that counts
    std::vector<Throw> throws_;
    int bandRows_ = 1;
    std::vector<std::vector<std::uint32_t>> ofBand_;  // facets, ascending
};

void copyBand(const NearestLevels& band, const Grid& grid, int firstRow, int endRow, ShadowSources& sources) {
    for (int level = 0; level < sources.levels; ++level)
        for (int row = firstRow; row < endRow; ++row) {
            const std::size_t at = std::size_t(level) * grid.size() + grid.index(0, row);
            band.copyRow(level, row - firstRow, &sources.heightM[at], &sources.building[at]);
        }
}

}  // namespace

ProjectedSourceFinder::ProjectedSourceFinder(SurfaceFacets facets, const Grid& grid, int levels,
                                             float nearestHitM)
    : facets_(std::move(facets)), grid_(grid), levels_(levels), nearestHitM_(nearestHitM) {}

void ProjectedSourceFinder::find(glm::dvec3 towardsSun, ShadowSources& sources,
                                 const std::stop_token& stop) const {
    sources.levels = levels_;
    sources.steepestM = steepestOnASurface(towardsSun, grid_.cellM);
    sources.heightM.resize(std::size_t(levels_) * grid_.size());
    sources.building.resize(sources.heightM.size());
    const int rows = rowsOfABand(grid_, levels_);
    const ThrownFacets instant(facets_, grid_, towardsSun, nearestHitM_, rows);
    tbb::enumerable_thread_specific<NearestLevels> bands(levels_, rows, grid_.columns);
    tbb::parallel_for(0, (grid_.rows + rows - 1) / rows, [&](int number) {
        if (stop.stop_requested()) return;
        const FlushDenormals flush;
        NearestLevels& band = bands.local();
        FillScratch scratch;
        const int first = number * rows, end = std::min(first + rows, grid_.rows);
        band.clear();
        instant.fill(band, first, end, scratch);
        copyBand(band, grid_, first, end, sources);
    });
}

}  // namespace noonmark
