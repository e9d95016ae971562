#include "core/accumulate/projected/caster_fill.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "core/accumulate/horizon/lanes16.h"
#include "core/accumulate/projected/convex_fill.h"

namespace noonmark {

namespace {

using Kind = ShadowCaster::Kind;

constexpr double farOff = 1e9;
// The shadow of a wall that stands begins so much sunward of it, metres up: where the rays of a receiver just
// behind it begin in the building (rayOrigin()). No receiver stands in there.
constexpr double behindWallM = 1e-3;

// All that is done for one caster is compiled into fill(), for each instruction set.
#define NOONMARK_INTO_FILL [[gnu::always_inline]] inline

NOONMARK_INTO_FILL void keepLeast(StepDoubles& least, const StepDoubles& other) {
    least = other < least ? other : least;
}
NOONMARK_INTO_FILL void keepMost(StepDoubles& most, const StepDoubles& other) {
    most = other > most ? other : most;
}

}  // namespace

SweptBox sweptBox(const ShadowCaster& caster, const StepThrows& throws) {
    const double bottom = caster.bottomM > 0 ? double(caster.bottomM) : -behindWallM, top = caster.topM;
    const glm::dvec2 ofBottom = glm::min(throws.low * bottom, throws.high * bottom),
                     toBottom = glm::max(throws.low * bottom, throws.high * bottom);
    return {caster.low + glm::min(ofBottom, throws.low * top),
            caster.high + glm::max(toBottom, throws.high * top)};
}

CasterFill::CasterFill(const ShadowCasters& casters) : casters_(casters), far_(casters.casters.size()) {}

NOONMARK_INTO_FILL CasterFill::Way::Way(const StepThrows& throws) : up(throws.at.y) {
    const StepDoubles divisor = up != 0 ? up : StepDoubles{} + 1;
    slope = throws.at.x / divisor;
}

inline bool CasterFill::Sweep::isFar(std::size_t edge, std::size_t step) const {
    return throws.at.x[step] * edges[edge].along.y - throws.at.y[step] * edges[edge].along.x > 0;
}

// At all steps.
NOONMARK_INTO_FILL bool CasterFill::Sweep::areFar(const Arc& arc) const {
    if (arc.first == arc.end) return false;
    const auto facing = [&](std::size_t edge) __attribute__((always_inline)) {
        return std::pair(edges[edge].along.y, edges[edge].along.x);
    };
    const auto [firstY, firstX] = facing(arc.first);
    const auto [lastY, lastX] = facing(before(arc.end));
    const auto [endY, endX] = facing(arc.end);
    const auto [beforeY, beforeX] = facing(before(arc.first));
    const StepPoints& to = throws.at;
    StepDoubles farthest = to.x * firstY - to.y * firstX, nearest = to.x * endY - to.y * endX;
    keepLeast(farthest, to.x * lastY - to.y * lastX);
    keepMost(nearest, to.x * beforeY - to.y * beforeX);
    const StepBits ones = ~StepBits{}, none{};
    const StepBits notFar = farthest > 0 ? none : ones, notNear = nearest > 0 ? ones : none;
    return !anySet(notFar | notNear);
}

CasterFill::Arc CasterFill::Sweep::findFar(std::size_t step) const {
    const std::size_t count = edges.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!isFar(i, step) || isFar(before(i), step)) continue;
        std::size_t end = after(i);
        while (isFar(end, step)) end = after(end);
        return {.first = std::uint32_t(i), .end = std::uint32_t(end)};
    }
    return {};
}

void CasterFill::Sweep::bound(Arc& arc) const {
    arc.low = arc.high = points[arc.end];
    std::size_t i = arc.first;
    do {
        arc.low = glm::min(arc.low, points[i]);
        arc.high = glm::max(arc.high, points[i]);
        i = after(i);
    } while (i != arc.end);
}

CasterFill::FarEdges CasterFill::Sweep::facingApart(const Arc& facing) const {
    FarEdges kept{facing, {.first = facing.end, .end = facing.first}, {}};
    if (facing.first ==
        facing.end)  // all are near: from the lowest, so that each side runs upwards or downwards
        kept.near.first = kept.near.end =
            std::uint32_t(std::ranges::min_element(points, {}, &glm::dvec2::y) - points.begin());
    bound(kept.far);
    bound(kept.near);
    kept.chord = RingEdge(points[facing.end], points[facing.first]);
    return kept;
}

NOONMARK_INTO_FILL CasterFill::Sweep CasterFill::sweepOf(const ShadowCaster& caster,
                                                         const StepThrows& throws) const {
    const double top = caster.topM;
    return {.caster = caster,
            .points = casters_.pointsOf(caster),
            .edges = casters_.edgesOf(caster),
            .throws = throws,
            .far = throws.at.scaled(top),
            .farLow = throws.low * top,
            .farHigh = throws.high * top};
}

NOONMARK_INTO_FILL void CasterFill::Sweep::beginAt(double bottomM) {
    near = throws.at.scaled(bottomM);
    nearLow = glm::min(throws.low * bottomM, throws.high * bottomM);  // may be behind a wall
    nearHigh = glm::max(throws.low * bottomM, throws.high * bottomM);
}

NOONMARK_EVERY_ISA std::uint64_t CasterFill::fill(std::span<const std::uint32_t> casters,
                                                  const StepThrows& throws, const BitLayout& layout,
                                                  const RowBand& band, std::span<std::uint64_t> rasters) {
    const Way way(throws);
    std::uint64_t rows = 0;
    for (const std::uint32_t caster : casters)
        rows += std::uint64_t(fillOne(caster, throws, way, layout, band, rasters));
    return rows;
}

NOONMARK_INTO_FILL int CasterFill::fillOne(std::uint32_t index, const StepThrows& throws, const Way& way,
                                           const BitLayout& layout, const RowBand& band,
                                           std::span<std::uint64_t> rasters) {
    const ShadowCaster& caster = casters_.casters[index];
    if (caster.kind == Kind::face) {
        shapeFace(caster, throws);
        return fillShape(shape_, layout, band, rasters);
    }
    Sweep sweep = sweepOf(caster, throws);
    if (!sweep.areFar(far_[index].far)) return fillApart(index, sweep, way, layout, band, rasters);
    return shape(sweep, far_[index], way) ? fillShape(shape_, layout, band, rasters) : 0;
}

// The steps with the same far edges together.
NOONMARK_EVERY_ISA int CasterFill::fillApart(std::uint32_t index, Sweep& sweep, const Way& way,
                                             const BitLayout& layout, const RowBand& band,
                                             std::span<std::uint64_t> rasters) {
    const auto same = [](const Arc& a, const Arc& b) { return a.first == b.first && a.end == b.end; };
    int rows = 0;
    for (std::size_t step = 0; step < stepsTogether;) {
        const Arc far = sweep.findFar(step);
        far_[index] = sweep.facingApart(far);
        const std::size_t first = step++;
        while (step < stepsTogether && same(sweep.findFar(step), far)) ++step;
        if (!shape(sweep, far_[index], way)) continue;
        for (std::size_t other = 0; other < stepsTogether; ++other)
            if (other < first || other >= step) shape_.high[other] = std::numeric_limits<double>::lowest();
        rows += fillShape(shape_, layout, band, rasters);
    }
    return rows;
}

// The hull of the ring at both places: at the far one the edges that face away, at the near one the others,
// and between them the lines that its two outermost corners draw. False: it throws nothing.
NOONMARK_INTO_FILL bool CasterFill::shape(Sweep& sweep, const FarEdges& edges, const Way& way) {
    const Arc& arc = edges.far;
    const bool oneWall = arc.end == sweep.after(arc.first);
    // Of a wall that faces the sun one on the other side throws the shadow.
    if (sweep.caster.kind == Kind::wall && (arc.first == arc.end || arc.first != 0)) return false;
    const bool fromGround =
        sweep.caster.stands || (sweep.caster.kind == Kind::wall && sweep.caster.bottomM == 0);
    sweep.beginAt(fromGround && oneWall ? -behindWallM : double(sweep.caster.bottomM));
    clear();
    shape_.western[0].begin(sweep.far, sweep.farLow.y, sweep.farHigh.y);
    shape_.eastern[0].begin(sweep.far, sweep.farLow.y, sweep.farHigh.y);
    shape_.western[1].begin(sweep.near, sweep.nearLow.y, sweep.nearHigh.y);
    shape_.eastern[1].begin(sweep.near, sweep.nearLow.y, sweep.nearHigh.y);
    if (arc.first != arc.end) {
        const glm::dvec2 first = sweep.points[arc.first], last = sweep.points[arc.end];
        addEnds(sweep, arc, 0);
        bound(arc.low, arc.high, sweep.far, sweep.farLow, sweep.farHigh);
        addStrip(sweep, first, last, way);
        if (sweep.caster
                .stands) {  // what lies sunward of the chord between these corners is under the caster
            addChord(sweep, edges.chord, first, last);
            return true;
        }
    }
    addEnds(sweep, edges.near, 1);
    bound(edges.near.low, edges.near.high, sweep.near, sweep.nearLow, sweep.nearHigh);
    return true;
}

NOONMARK_INTO_FILL void CasterFill::clear() {
    shape_.sides.westerns = shape_.sides.easterns = 0;
    const double large = std::numeric_limits<double>::max();
    shape_.lowest = glm::dvec2(large);
    shape_.highest = -shape_.lowest;
    shape_.low = StepDoubles{} + large;
    shape_.high = StepDoubles{} - large;
}

// Makes room for points in [low, high], moved.
NOONMARK_INTO_FILL void CasterFill::bound(glm::dvec2 low, glm::dvec2 high, const StepPoints& at,
                                          glm::dvec2 atLow, glm::dvec2 atHigh) {
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
    shape_.sides.western[shape_.sides.westerns++] = western;
    shape_.sides.eastern[shape_.sides.easterns++] = eastern;
}

// The paths of the two outermost corners; level ones bound nothing.
NOONMARK_INTO_FILL void CasterFill::addStrip(const Sweep& sweep, glm::dvec2 first, glm::dvec2 last,
                                             const Way& way) {
    const StepDoubles none{}, up = sweep.far.y - sweep.near.y, height = up > 0 ? up : -up;
    const StepPoints a = first + sweep.near, b = last + sweep.near;
    const StepDoubles throughA = a.x - a.y * way.slope, throughB = b.x - b.y * way.slope;
    StepLine &western = shape_.sides.western[0], &eastern = shape_.sides.eastern[0];
    western.atRow0 = up > 0 ? throughB : throughA;
    western.atRow0 = height >= 1e-6 ? western.atRow0 : none - farOff;
    eastern.atRow0 = up > 0 ? throughA : throughB;
    eastern.atRow0 = height >= 1e-6 ? eastern.atRow0 : none + farOff;
    western.slope = eastern.slope = height >= 1e-6 ? way.slope : none;
    shape_.sides.westerns = shape_.sides.easterns = 1;
}

// The arc's edges into the chains of an end. Its western edges run downwards.
NOONMARK_INTO_FILL void CasterFill::addEnds(const Sweep& sweep, const Arc& arc, std::size_t end) {
    EdgeChain &western = shape_.western[end], &eastern = shape_.eastern[end];
    std::size_t i = arc.first;
    do {
        if (sweep.edges[i].side == RingEdge::Side::eastern) eastern.add(sweep.edges[i]);
        i = sweep.after(i);
    } while (i != arc.end);
    do {
        i = sweep.before(i);
        if (sweep.edges[i].side == RingEdge::Side::western) western.add(sweep.edges[i]);
    } while (i != arc.first);
}

NOONMARK_INTO_FILL void CasterFill::addChord(const Sweep& sweep, const RingEdge& chord, glm::dvec2 first,
                                             glm::dvec2 last) {
    if (chord.side == RingEdge::Side::western) shape_.western[1].add(chord);
    if (chord.side == RingEdge::Side::eastern) shape_.eastern[1].add(chord);
    bound(glm::min(first, last), glm::max(first, last), sweep.near, sweep.nearLow, sweep.nearHigh);
}

// Seen from behind a face of a closed mesh throws nothing: one on the other side throws this shadow.
void CasterFill::shapeFace(const ShadowCaster& caster, const StepThrows& throws) {
    clear();
    for (EdgeChain& chain : shape_.western) chain.count = 0;
    for (EdgeChain& chain : shape_.eastern) chain.count = 0;
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

#undef NOONMARK_INTO_FILL

}  // namespace noonmark
