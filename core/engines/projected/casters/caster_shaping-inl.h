// The shapes of casters' shadows at eight steps, for kernels; include after core/simd/kernel.h.
#if defined(NOONMARK_CASTER_SHAPING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef NOONMARK_CASTER_SHAPING_INL_H
#undef NOONMARK_CASTER_SHAPING_INL_H
#else
#define NOONMARK_CASTER_SHAPING_INL_H
#endif

#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "core/engines/projected/filling/step_filler.h"
#include "core/engines/projected/filling/step_registers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {

/// Computes the shapes of casters' shadows at eight steps.
class Shaping {
public:
    HWY_INLINE explicit Shaping(const StepOffsets& offsets) : offsets_(offsets) {
        for (std::size_t step = 0; step < stepsTogether; ++step) {
            const double up = offsets.at.y[step];
            slope_[step] = offsets.at.x[step] / (up != 0 ? up : 1);
        }
    }

    /// Whether exactly these edges face away from the sun at all steps.
    [[nodiscard]] HWY_INLINE bool areFar(const CasterRing& ring, const EdgeArc& arc) const {
        if (arc.first == arc.end) return false;
        const Points to{offsets_.at.x, offsets_.at.y};
        const auto turn = [&](std::size_t edge) HWY_ATTR {
            return to.x * ring.edges[edge].along.y - to.y * ring.edges[edge].along.x;
        };
        const Doubles farthest = minimum(turn(arc.first), turn(ring.before(arc.end))),
                      nearest = maximum(turn(arc.end), turn(ring.before(arc.first)));
        return allAndNoneAboveZero(farthest, nearest);
    }

    /// The hull of the ring at its far and its near position: the edges that face away from the sun at the
    /// far one, the others at the near one, and between them the lines drawn by the two outermost corners.
    /// False: it casts no shadow.
    HWY_INLINE bool shape(const ShadowCaster& caster, const CasterRing& ring, const FarEdges& edges) {
        const EdgeArc& arc = edges.far;
        const bool oneWall = arc.end == ring.after(arc.first), wall = caster.kind == ShadowCaster::Kind::wall;
        // If a wall faces the sun, the wall on the opposite side casts the shadow.
        if (wall && (arc.first == arc.end || arc.first != 0)) return false;
        const bool fromGround = caster.stands || (wall && caster.bottomM == 0);
        const Place far(offsets_, caster.topM),
            near(offsets_, fromGround && oneWall ? -behindWallM : double(caster.bottomM));
        clear();
        begin(far, 0);
        begin(near, 1);
        if (arc.first != arc.end) {
            const glm::dvec2 first = ring.points[arc.first], last = ring.points[arc.end];
            addEnds(ring, arc, 0);
            bound(arc.low, arc.high, far);
            addStrip(far, near, first, last);
            if (caster.stands) {  // on the sunward side of this chord is only the caster itself
                addChord(near, edges.chord, first, last);
                return true;
            }
        }
        addEnds(ring, edges.near, 1);
        bound(edges.near.low, edges.near.high, near);
        return true;
    }

    /// A face of a closed mesh that is seen from behind casts no shadow: a face on the opposite side casts
    /// it.
    HWY_INLINE void shapeFace(const ShadowCaster& caster, std::span<const glm::dvec2> points) {
        clear();
        for (EdgeChain& chain : shape_.western) chain.count = 0;
        for (EdgeChain& chain : shape_.eastern) chain.count = 0;
        Points thrown[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const Place place(offsets_, caster.heights[i]);
            bound(points[i], points[i], place);
            thrown[i] = points[i] + place.at;
        }
        const Points u = thrown[1] - thrown[0], v = thrown[2] - thrown[0];
        StepDoubles turn;
        (u.x * v.y - u.y * v.x).store(turn);
        for (std::size_t i = 0; i < 3; ++i) addSide(thrown[i], thrown[(i + 1) % 3], turn);
        for (std::size_t step = 0; step < stepsTogether; ++step)
            if (turn[step] == 0 || (turn[step] < 0 && !caster.twoSided)) leaveOut(step);
    }

    /// Makes the shape empty at this step.
    void leaveOut(std::size_t step) { shape_.high[step] = std::numeric_limits<double>::lowest(); }

    [[nodiscard]] const StepShape& made() const { return shape_; }

private:
    using Doubles = EightDoubles;
    using Points = EightPoints;
    static constexpr double farOff = 1e9;

    /// The offset of the shadow of points at one height, in cells.
    struct Place {
        Points at;
        glm::dvec2 low, high;  ///< bounds over all steps
        HWY_INLINE Place(const StepOffsets& throws, double heightM)
            : at{Doubles(throws.at.x) * heightM, Doubles(throws.at.y) * heightM},
              low(glm::min(throws.low * heightM, throws.high * heightM)),
              high(glm::max(throws.low * heightM, throws.high * heightM)) {}
    };

    HWY_INLINE void clear() {
        shape_.sides.westerns = shape_.sides.easterns = 0;
        const double large = std::numeric_limits<double>::max();
        shape_.lowest = glm::dvec2(large);
        shape_.highest = -shape_.lowest;
        Doubles(large).store(shape_.low);
        Doubles(-large).store(shape_.high);
    }

    HWY_INLINE void begin(const Place& place, std::size_t end) {
        for (EdgeChain* chain : {&shape_.western[end], &shape_.eastern[end]}) {
            chain->begin(place.low.y, place.high.y);
            place.at.store(chain->at);
        }
    }

    // Extends the bounds by points in [low, high], shifted by `place`.
    HWY_INLINE void bound(glm::dvec2 low, glm::dvec2 high, const Place& place) {
        minimum(Doubles(shape_.low), low.y + place.at.y).store(shape_.low);
        maximum(Doubles(shape_.high), high.y + place.at.y).store(shape_.high);
        shape_.lowest = glm::min(shape_.lowest, low + place.low);
        shape_.highest = glm::max(shape_.highest, high + place.high);
    }

    // The paths of the two outermost corners; level paths bound no rows.
    HWY_INLINE void addStrip(const Place& far, const Place& near, glm::dvec2 first, glm::dvec2 last) {
        const Doubles none(0), slope(slope_), up = far.at.y - near.at.y, height = whereAboveZero(up, up, -up);
        const Points a = first + near.at, b = last + near.at;
        const Doubles throughA = a.x - a.y * slope, throughB = b.x - b.y * slope;
        StepLine &western = shape_.sides.western[0], &eastern = shape_.sides.eastern[0];
        const Doubles west = whereAboveZero(up, throughB, throughA),
                      east = whereAboveZero(up, throughA, throughB);
        whereAtLeast(1e-6, height, west, Doubles(-farOff)).store(western.atRow0);
        whereAtLeast(1e-6, height, east, Doubles(farOff)).store(eastern.atRow0);
        const Doubles along = whereAtLeast(1e-6, height, slope, none);
        along.store(western.slope);
        along.store(eastern.slope);
        shape_.sides.westerns = shape_.sides.easterns = 1;
    }

    // Adds the arc's edges to the chains of one end. Western edges run downwards.
    HWY_INLINE void addEnds(const CasterRing& ring, const EdgeArc& arc, std::size_t end) {
        EdgeChain &western = shape_.western[end], &eastern = shape_.eastern[end];
        std::size_t i = arc.first;
        do {
            if (ring.edges[i].side == RingEdge::Side::eastern) eastern.add(ring.edges[i]);
            i = ring.after(i);
        } while (i != arc.end);
        do {
            i = ring.before(i);
            if (ring.edges[i].side == RingEdge::Side::western) western.add(ring.edges[i]);
        } while (i != arc.first);
    }

    HWY_INLINE void addChord(const Place& near, const RingEdge& chord, glm::dvec2 first, glm::dvec2 last) {
        if (chord.side == RingEdge::Side::western) shape_.western[1].add(chord);
        if (chord.side == RingEdge::Side::eastern) shape_.eastern[1].add(chord);
        bound(glm::min(first, last), glm::max(first, last), near);
    }

    // Adds an edge of a shape that runs counter-clockwise where `turn` > 0 and clockwise where it is
    // negative.
    HWY_INLINE void addSide(const Points& from, const Points& to, const StepDoubles& turn) {
        StepPoints a, b;
        from.store(a);
        to.store(b);
        StepLine &western = shape_.sides.western[shape_.sides.westerns++],
                 &eastern = shape_.sides.eastern[shape_.sides.easterns++];
        for (std::size_t step = 0; step < stepsTogether; ++step) {
            western.atRow0[step] = -farOff;
            eastern.atRow0[step] = farOff;
            western.slope[step] = eastern.slope[step] = 0;
            const double up = b.y[step] - a.y[step];
            if (std::abs(up) < 1e-6) continue;
            StepLine& line = up * turn[step] > 0 ? eastern : western;
            // The lower end first, as in RingEdge.
            const double slope = (b.x[step] - a.x[step]) / up;
            line.slope[step] = slope;
            line.atRow0[step] = up > 0 ? a.x[step] - a.y[step] * slope : b.x[step] - b.y[step] * slope;
        }
    }

    const StepOffsets& offsets_;
    StepDoubles slope_;  // of the shadow's direction, in columns per row
    StepShape shape_;
};

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
