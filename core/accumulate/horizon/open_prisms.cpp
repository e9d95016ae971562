#include "core/accumulate/horizon/open_prisms.h"

#include <algorithm>
#include <span>

#include "core/accumulate/horizon/open_parts.h"

namespace noonmark {

namespace {

bool isPrism(const Part& part) { return !part.mesh && part.footprint.outer.size() >= 3; }

std::vector<glm::dvec2> cellsOf(const Ring& ring, const Grid& grid) {
    std::vector<glm::dvec2> cells;
    for (const glm::vec2 corner : ring)
        cells.emplace_back((double(corner.x) - grid.westM) / grid.cellM - 0.5,
                           (double(corner.y) - grid.southM) / grid.cellM - 0.5);
    return cells;
}

OpenPrism prismOf(const Part& part, const Grid& grid, double datumM) {
    OpenPrism prism{
        {cellsOf(part.footprint.outer, grid)}, double(part.bottomM) - datumM, double(part.topM) - datumM};
    for (const Ring& hole : part.footprint.holes) prism.rings.push_back(cellsOf(hole, grid));
    return prism;
}

}  // namespace

Result<OpenShapes> openShapes(const OpenParts& parts, const Grid& grid, double datumM) {
    OpenShapes shapes;
    for (const OpenPart& open : parts)
        if (isPrism(*open.part))
            shapes.prisms.push_back(prismOf(*open.part, grid, datumM));
        else
            addTriangles(*open.part, grid, datumM, shapes.triangles);
    if (const auto able = checkTriangles(shapes.triangles.size() + shapes.prisms.size()); !able)
        return tl::make_unexpected(able.error());
    return shapes;
}

void PrismOutline::set(const OpenPrism& prism, const ShadowAxes& axes, double alongPerMetre) {
    edges.clear();
    bottom = prism.bottomM * alongPerMetre;
    top = prism.topM * alongPerMetre;
    ShadowExtent extent;
    for (const std::vector<glm::dvec2>& ring : prism.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const ShadowAxes::Point a = axes.from(ring[i]), b = axes.from(ring[(i + 1) % ring.size()]);
            extent.add(a);
            a.q < b.q ? add(a, b) : add(b, a);
        }
    lowQ = extent.lowQ;
    highQ = extent.highQ;
    lowestAlong = extent.lowAlong;
    highestAlong = extent.highAlong;
    std::ranges::sort(edges, {}, &Edge::lowQ);
}

void PrismOutline::add(const ShadowAxes::Point& a, const ShadowAxes::Point& b) {
    if (a.q < b.q) edges.push_back({a.q, b.q, a.along, (b.along - a.along) / (b.q - a.q)});
}

void OutlineWalk::begin(const PrismOutline& outline) {
    next_ = outline.edges.data();
    end_ = next_ + outline.edges.size();
    crossed_.clear();
}

std::span<const double> OutlineWalk::alongs(double q) {
    for (; next_ != end_ && next_->lowQ <= q; ++next_) crossed_.push_back(next_);
    std::erase_if(crossed_, [&](const PrismOutline::Edge* edge) { return edge->highQ <= q; });
    alongs_.clear();
    for (const PrismOutline::Edge* edge : crossed_)
        alongs_.push_back(edge->along + edge->slope * (q - edge->lowQ));
    std::ranges::sort(alongs_);
    return std::span(alongs_).first(alongs_.size() / 2 * 2);
}

void OpenSweep::add(const OpenPrism& prism) {
    outline_.set(prism, axes_, alongPerMetre_);
    if (outline_.top <= 0 || !(outline_.lowQ < outline_.highQ)) return;
    if (outline_.highQ <= view_->within.lowQ || outline_.lowQ >= view_->within.highQ) return;
    const double first = std::max(std::ceil(outline_.lowestAlong), lines_.first),
                 last =
                     std::min(std::floor(outline_.highestAlong + outline_.top / lowestTan_ + 1), lines_.last);
    const auto mostAt = [&](double along) {
        return along > outline_.highestAlong ? codeAt(outline_.top, along - outline_.highestAlong)
                                             : codeAt(1, 0);
    };
    forEachLine({first, last}, {outline_.lowQ, outline_.highQ}, mostAt,
                [&](int along, HorizonCode most) { addLine(outline_, along, most); });
}

// None of the cells can see it higher than `most`, but for a level of rounding.
void OpenSweep::addLine(const PrismOutline& prism, int along, HorizonCode most) {
    const LineCells cells = cellsOf(along, prism.lowQ, prism.highQ);
    walk_.begin(prism);
    for (int across = cells.first; across < cells.end; ++across) {
        const std::int32_t number = numberAt(cells.line, across);
        if (number < 0 || horizons_[std::size_t(number)] > most) continue;
        const std::span<const double> walls = walk_.alongs(across - cells.shift);
        for (std::size_t i = 0; i < walls.size(); i += 2)
            addCell(prism, number, along - walls[i + 1], along - walls[i]);
    }
}

void OpenSweep::addCell(const PrismOutline& prism, std::int32_t number, double toNear, double toFar) {
    if (toFar <= onWhatHangs) return;
    const double ground = groundOf(number), bottom = prism.bottom - ground, top = prism.top - ground;
    // Below the prism itself: everything up to the zenith. In it or above it: nothing.
    if (top <= 0 || (toNear <= 0 && bottom <= 0)) return;
    addGap(number, codeAt(bottom, toFar), toNear > 0 ? codeAt(top, toNear) : codeAt(1, 0));
}

}  // namespace noonmark
