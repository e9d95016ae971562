#include "core/accumulate/projected/caster_fill.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "core/accumulate/horizon/lanes16.h"

namespace noonmark {

namespace {

using Kind = ShadowCaster::Kind;

constexpr double farOff = 1e9;
// Shadows of walls begin so much sunward of them, metres up: where the rays of a receiver just behind a wall
// begin in the building (rayOrigin()). No receiver stands in there.
constexpr double behindWallM = 1e-3;

double bottomOf(const ShadowCaster& caster) {
    const bool fromGround = caster.kind == Kind::wall && caster.bottomM == 0;
    return fromGround ? -behindWallM : double(caster.bottomM);
}

void keepLeast(StepDoubles& least, const StepDoubles& other) { least = other < least ? other : least; }
void keepMost(StepDoubles& most, const StepDoubles& other) { most = other > most ? other : most; }

template <std::size_t count>
void addWestern(StepLines<count>& lines, const StepLine& line) {
    lines.western[lines.westerns++] = line;
}

template <std::size_t count>
void addEastern(StepLines<count>& lines, const StepLine& line) {
    lines.eastern[lines.easterns++] = line;
}

}  // namespace

SweptBox sweptBox(const ShadowCaster& caster, const StepThrows& throws) {
    const double bottom = bottomOf(caster), top = caster.topM;
    const glm::dvec2 ofBottom = glm::min(throws.low * bottom, throws.high * bottom),
                     toBottom = glm::max(throws.low * bottom, throws.high * bottom);
    return {caster.low + glm::min(ofBottom, throws.low * top),
            caster.high + glm::max(toBottom, throws.high * top)};
}

CasterFill::CasterFill(const ShadowCasters& casters) : casters_(casters), far_(casters.casters.size()) {}

bool CasterFill::Sweep::isFar(std::size_t edge, std::size_t step) const {
    return move.x[step] * edges[edge].along.y - move.y[step] * edges[edge].along.x > 0;
}

// At all steps.
NOONMARK_EVERY_ISA bool CasterFill::Sweep::areFar(const FarEdges& some) const {
    if (some.first == some.end) return false;
    const auto facing = [&](std::size_t edge, StepDoubles& is) {
        is = move.x * edges[edge].along.y - move.y * edges[edge].along.x;
    };
    StepDoubles farthest, nearest, other;
    facing(some.first, farthest);
    facing(before(some.end), other);
    keepLeast(farthest, other);
    facing(some.end, nearest);
    facing(before(some.first), other);
    keepMost(nearest, other);
    bool all = true;
    for (std::size_t step = 0; step < stepsTogether; ++step)
        all &= (farthest[step] > 0) & (nearest[step] <= 0);
    return all;
}

CasterFill::FarEdges CasterFill::Sweep::findFar(std::size_t step) const {
    const std::size_t count = edges.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!isFar(i, step) || isFar(before(i), step)) continue;
        std::size_t end = (i + 1) % count;
        while (isFar(end, step)) end = (end + 1) % count;
        return {std::uint32_t(i), std::uint32_t(end)};
    }
    return {};
}

CasterFill::Sweep CasterFill::sweepOf(const ShadowCaster& caster, const StepThrows& throws) const {
    const double bottom = bottomOf(caster), top = caster.topM;
    Sweep sweep{caster,
                casters_.pointsOf(caster),
                casters_.edgesOf(caster),
                throws.at.scaled(bottom),
                throws.at.scaled(top),
                {},
                glm::min(throws.low * bottom, throws.high * bottom),  // `bottom` may be behind the wall
                glm::max(throws.low * bottom, throws.high * bottom),
                throws.low * top,
                throws.high * top};
    sweep.move = sweep.far - sweep.near;
    return sweep;
}

int CasterFill::fill(std::uint32_t index, const StepThrows& throws, const BitLayout& layout,
                     const RowBand& band, std::span<std::uint64_t> rasters) {
    const ShadowCaster& caster = casters_.casters[index];
    if (caster.kind == Kind::face) {
        shapeFace(caster, throws);
        return fillShape(shape_, layout, band, rasters);
    }
    const Sweep sweep = sweepOf(caster, throws);
    if (sweep.areFar(far_[index]))
        return shape(sweep, far_[index]) ? fillShape(shape_, layout, band, rasters) : 0;
    int rows = 0;
    for (std::size_t step = 0; step < stepsTogether;) {  // those with the same edges together
        const FarEdges far = far_[index] = sweep.findFar(step);
        const std::size_t first = step++;
        while (step < stepsTogether && sweep.findFar(step) == far) ++step;
        if (!shape(sweep, far)) continue;
        for (std::size_t other = 0; other < stepsTogether; ++other)
            if (other < first || other >= step) shape_.high[other] = std::numeric_limits<double>::lowest();
        rows += fillShape(shape_, layout, band, rasters);
    }
    return rows;
}

// The hull of the ring at both places: at the far one the edges that face away, at the near one the others,
// and between them the lines that its two outermost corners draw. False: it throws nothing.
bool CasterFill::shape(const Sweep& sweep, const FarEdges& far) {
    // Of a wall that faces the sun one on the other side throws the shadow.
    if (sweep.caster.kind == Kind::wall && (far.first == far.end || far.first != 0)) return false;
    clear();
    if (far.first == far.end) {
        addEnds(sweep, 0, sweep.edges.size(), false);
        return true;
    }
    const glm::dvec2 first = sweep.points[far.first], last = sweep.points[far.end];
    addEnds(sweep, far.first, far.end, true);
    addStrip(sweep, first, last);
    if (sweep.caster.stands) {  // what lies sunward of the chord between these corners is under the caster
        bound(glm::min(first, last), glm::max(first, last), sweep.near, sweep.nearLow, sweep.nearHigh);
        const StepPoints a = last + sweep.near, b = first + sweep.near;
        const StepDoubles counterClockwise = StepDoubles{} + 1;
        addSide(a, b, counterClockwise);
    } else {
        addEnds(sweep, far.end, far.first, false);
    }
    return true;
}

void CasterFill::clear() {
    shape_.sides.westerns = shape_.sides.easterns = shape_.ends.westerns = shape_.ends.easterns = 0;
    const double large = std::numeric_limits<double>::max();
    shape_.lowest = glm::dvec2(large);
    shape_.highest = -shape_.lowest;
    shape_.low = StepDoubles{} + large;
    shape_.high = StepDoubles{} - large;
    shape_.endLow = large;
    shape_.endHigh = -large;
}

// Makes room for points in [low, high], moved.
void CasterFill::bound(glm::dvec2 low, glm::dvec2 high, const StepPoints& at, glm::dvec2 atLow,
                       glm::dvec2 atHigh) {
    keepLeast(shape_.low, low.y + at.y);
    keepMost(shape_.high, high.y + at.y);
    shape_.lowest = glm::min(shape_.lowest, low + atLow);
    shape_.highest = glm::max(shape_.highest, high + atHigh);
}

// An edge of a shape that runs counter-clockwise where `turn` > 0, clockwise where it is below.
void CasterFill::addSide(const StepPoints& a, const StepPoints& b, const StepDoubles& turn) {
    const StepDoubles up = b.y - a.y, none{};
    StepLine western{none - farOff, none}, eastern{none + farOff, none};
    for (std::size_t step = 0; step < stepsTogether; ++step) {
        if (std::abs(up[step]) < 1e-6) continue;
        StepLine& line = up[step] * turn[step] > 0 ? eastern : western;
        // The lower end first, as in RingEdge.
        const double slope = (b.x[step] - a.x[step]) / up[step];
        line.slope[step] = slope;
        line.atRow0[step] = up[step] > 0 ? a.x[step] - a.y[step] * slope : b.x[step] - b.y[step] * slope;
    }
    addWestern(shape_.sides, western);
    addEastern(shape_.sides, eastern);
}

// The paths of the two outermost corners.
NOONMARK_EVERY_ISA void CasterFill::addStrip(const Sweep& sweep, glm::dvec2 first, glm::dvec2 last) {
    const StepDoubles none{}, up = sweep.move.y;
    const StepDoubles divisor = up != 0 ? up : none + 1;
    const StepDoubles slope = sweep.move.x / divisor;
    const StepPoints a = first + sweep.near, b = last + sweep.near;
    const StepDoubles throughA = a.x - a.y * slope, throughB = b.x - b.y * slope;
    StepLine western, eastern;
    western.slope = eastern.slope = slope;
    western.atRow0 = up > 0 ? throughB : throughA;
    eastern.atRow0 = up > 0 ? throughA : throughB;
    for (StepLine* line : {&western, &eastern}) {  // level ones bound nothing
        const StepDoubles off = none + (line == &western ? -farOff : farOff), height = up > 0 ? up : -up;
        line->atRow0 = height >= 1e-6 ? line->atRow0 : off;
        line->slope = height >= 1e-6 ? line->slope : none;
    }
    addWestern(shape_.sides, western);
    addEastern(shape_.sides, eastern);
}

// Edges [first, end) round the ring, moved; their rows are those of the ends.
NOONMARK_EVERY_ISA void CasterFill::addEnds(const Sweep& sweep, std::size_t first, std::size_t end,
                                            bool atFar) {
    const StepPoints& at = atFar ? sweep.far : sweep.near;
    const glm::dvec2 atLow = atFar ? sweep.farLow : sweep.nearLow,
                     atHigh = atFar ? sweep.farHigh : sweep.nearHigh;
    const std::size_t count = sweep.edges.size();
    glm::dvec2 low = sweep.points[end % count], high = low;
    std::size_t i = first;
    do {
        const RingEdge& edge = sweep.edges[i];
        const StepLine line{edge.atRow0 + (at.x - at.y * edge.slope), StepDoubles{} + edge.slope};
        if (edge.side == RingEdge::Side::western) addWestern(shape_.ends, line);
        if (edge.side == RingEdge::Side::eastern) addEastern(shape_.ends, line);
        low = glm::min(low, sweep.points[i]);
        high = glm::max(high, sweep.points[i]);
        i = i + 1 == count ? 0 : i + 1;
    } while (i != end % count);
    bound(low, high, at, atLow, atHigh);
    shape_.endLow = std::min(shape_.endLow, low.y + atLow.y);
    shape_.endHigh = std::max(shape_.endHigh, high.y + atHigh.y);
}

// Seen from behind a face of a closed mesh throws nothing: one on the other side throws this shadow.
void CasterFill::shapeFace(const ShadowCaster& caster, const StepThrows& throws) {
    clear();
    const auto points = casters_.pointsOf(caster);
    StepPoints thrown[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const double height = caster.heights[i];
        const StepPoints at = throws.at.scaled(height);
        bound(points[i], points[i], at, throws.low * height, throws.high * height);
        thrown[i] = points[i] + at;
    }
    const StepPoints u = thrown[1] - thrown[0], v = thrown[2] - thrown[0];
    const StepDoubles turn = u.x * v.y - u.y * v.x;
    for (std::size_t i = 0; i < 3; ++i) addSide(thrown[i], thrown[(i + 1) % 3], turn);
    for (std::size_t step = 0; step < stepsTogether; ++step)
        if (turn[step] == 0 || (turn[step] < 0 && !caster.twoSided))
            shape_.high[step] = std::numeric_limits<double>::lowest();
}

}  // namespace noonmark
