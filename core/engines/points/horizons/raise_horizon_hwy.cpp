#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/points/horizons/raise_horizon_hwy.cpp"
#include <hwy/foreach_target.h>

#include <cmath>

#include "core/engines/points/horizons/box_visit-inl.h"
#include "core/engines/points/horizons/horizon_of_point.h"
#include "core/simd/cache_line.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

constexpr int binCount = SunBins::count;
constexpr float uncertain = 0.01F;  // bins; more than azimuths are
// Radians, and how much a sine bends in that share of it; both with more to spare than rounding.
constexpr float halfBin = 0.0022F, bent = 1e-5F;

/// The tangents of one point to raise; the bounds may be null.
struct Raised {
    float *horizon, *touch = nullptr, *cover = nullptr;
};

/// Raises the horizon of one point by edges, and its bounds.
template <bool bounds>
class EdgeRaiser {
public:
    EdgeRaiser(const BinDirections& bins, glm::vec3 eye, const Raised& raised)
        : bins_(bins), eye_(eye), at_(eye), raised_(raised) {}

    HWY_INLINE void raiseBy(const EdgeBlock& block) const {
        HWY_ALIGN float azimuthA[BoxTree::width], azimuthB[BoxTree::width];
        std::uint32_t left = 0;
        for (std::size_t i = 0; i < BoxTree::width; i += lanesOfEight)
            left |= mayRaise(block, i, azimuthA + i, azimuthB + i) << i;
        for (; left != 0; left &= left - 1) {
            const auto i = std::size_t(hwy::Num0BitsBelowLS1Bit_Nonzero32(left));
            raiseBy(block, i, azimuthA[i], azimuthB[i]);
        }
    }

private:
    // Bits of the edges from `i` on, and the azimuths of their ends in bins. Leaves out edges that lie below
    // the eye, that are seen from the side which hides nothing, or, without bounds, between the middles of
    // two bins.
    HWY_INLINE std::uint32_t mayRaise(const EdgeBlock& block, std::size_t i, float* azimuthA,
                                      float* azimuthB) const {
        constexpr Eight d;
        const auto from = [&](const auto& of, float eye) {
            return hn::Sub(hn::LoadU(d, &of[i]), hn::Set(d, eye));
        };
        const auto ax = from(block.ax, eye_.x), ay = from(block.ay, eye_.y);
        const auto bx = from(block.bx, eye_.x), by = from(block.by, eye_.y);
        const auto a = azimuthInBins(ax, ay), b = azimuthInBins(bx, by);
        hn::Store(a, d, azimuthA);
        hn::Store(b, d, azimuthB);
        const auto top = hn::Max(hn::LoadU(d, &block.az[i]), hn::LoadU(d, &block.bz[i]));
        const auto above = hn::Gt(top, hn::Set(d, eye_.z));
        const auto one = hn::Mul(ay, bx), other = hn::Mul(ax, by);
        const auto rounding = hn::Mul(hn::Add(hn::Abs(one), hn::Abs(other)), hn::Set(d, -1e-6F));
        const auto behind =
            hn::And(hn::Lt(hn::Sub(one, other), rounding), maskOfBits(d, block.oneSided >> i));
        if constexpr (bounds) return bitsOfMask(d, hn::AndNot(behind, above));
        const auto spare = hn::Set(d, uncertain), half = hn::Set(d, 0.5F);
        const auto firstMiddle = hn::Floor(hn::Sub(hn::Add(hn::Min(a, b), half), spare));
        const auto lastMiddle = hn::Floor(hn::Add(hn::Add(hn::Max(a, b), half), spare));
        const auto covers = hn::Gt(lastMiddle, firstMiddle);
        return bitsOfMask(d, hn::AndNot(behind, hn::And(above, covers)));
    }

    // The edge lies in a plane through the eye, so the tangent of its altitude is a sine of the azimuth.
    HWY_INLINE void raiseBy(const EdgeBlock& block, std::size_t i, float azimuthA, float azimuthB) const {
        const glm::dvec3 a = glm::dvec3(block.ax[i], block.ay[i], block.az[i]) - at_;
        const glm::dvec3 b = glm::dvec3(block.bx[i], block.by[i], block.bz[i]) - at_;
        const double turn = a.y * b.x - a.x * b.y;  // positive: b is clockwise of a
        if (turn < 0 && (block.oneSided >> i & 1U) != 0) return;
        constexpr double endOn = 1e-12;  // square metres
        if (std::abs(turn) < endOn) return;
        const BinRange covered =
            turn > 0 ? middlesBetween(a, b, azimuthA, azimuthB) : middlesBetween(b, a, azimuthB, azimuthA);
        const auto east = float((b.z * a.y - a.z * b.y) / turn),
                   north = float((a.z * b.x - b.z * a.x) / turn);
        if constexpr (bounds)
            turn > 0 ? touchEnds(covered, {east, north}, {azimuthA, tanOf(a)}, {azimuthB, tanOf(b)})
                     : touchEnds(covered, {east, north}, {azimuthB, tanOf(b)}, {azimuthA, tanOf(a)});
        if (covered.last < covered.first) return;
        raiseBins(covered, {east, north});
        if constexpr (bounds) raiseCover({covered.first + 1, covered.last - 1}, {east, north});
    }

    /// The tangent of an edge is east sin(azimuth) + north cos(azimuth).
    struct Sine {
        float east, north;
    };
    /// An end of an edge: its azimuth in bins, and the tangent of its altitude.
    struct End {
        float azimuth, tan;
    };
    HWY_INLINE static float tanOf(glm::dvec3 end) {
        return float(end.z / std::sqrt(end.x * end.x + end.y * end.y));
    }

    // The bins in which an edge ends. Within a bin it is nowhere higher than at the ends of what lies there,
    // but for 3e-6 of the tangent.
    HWY_INLINE void touchEnds(BinRange covered, Sine sine, End from, End to) const {
        float first = std::max(from.tan, to.tan), last = first;
        if (covered.last >= covered.first) {
            first = std::max(from.tan, mostIn(covered.first, sine));
            last = std::max(to.tan, mostIn(covered.last, sine));
        }
        touchAt(from.azimuth, first);
        touchAt(to.azimuth, last);
    }

    HWY_INLINE void touchAt(float azimuth, float tan) const {
        for (const float beside : {azimuth - uncertain, azimuth + uncertain}) {
            float& touch = raised_.touch[wrapped(int(std::floor(beside)))];
            touch = std::max(touch, tan * (1 + bent));
        }
    }

    HWY_INLINE static std::size_t wrapped(int bin) {
        return std::size_t(bin < 0 ? bin + binCount : bin >= binCount ? bin - binCount : bin);
    }

    // The most that an edge which covers a bin's middle may reach there.
    HWY_INLINE float mostIn(int bin, Sine sine) const {
        const std::size_t k = wrapped(bin);
        const float tan = sine.east * bins_.sine[k] + sine.north * bins_.cosine[k],
                    change = sine.east * bins_.cosine[k] - sine.north * bins_.sine[k];
        return tan * (1 + bent) + std::abs(change) * halfBin;
    }

    // Metres to the right of the line from the eye along a bin's middle. `bin`: at most a turn out of range.
    HWY_INLINE double rightOf(int bin, glm::dvec3 place) const {
        const std::size_t k = wrapped(bin);
        return place.x * bins_.exactCosine[k] - place.y * bins_.exactSine[k];
    }

    // The bins whose middle lies from one place to the other, which is less than half a turn on. The azimuths
    // are good to a bin, and double precision decides.
    HWY_INLINE BinRange middlesBetween(glm::dvec3 from, glm::dvec3 to, float azimuthFrom,
                                       float azimuthTo) const {
        int first = int(azimuthFrom + 0.5F), last = int(azimuthTo + 0.5F) - 1;
        if (rightOf(first, from) > 0)
            ++first;
        else if (rightOf(first - 1, from) <= 0)
            --first;
        if (rightOf(last, to) < 0)
            --last;
        else if (rightOf(last + 1, to) >= 0)
            ++last;
        if (last + 1 < first) last += binCount;  // past north
        if (last < first || last - first > binCount / 2) return {0, -1};
        const int turns = first < 0 ? binCount : first >= binCount ? -binCount : 0;
        return {first + turns, last + turns};
    }

    HWY_INLINE void raiseBins(BinRange range, Sine sine) const {
        constexpr RowOfBins d;
        forEachRow(range, [&](std::size_t k, std::size_t count) {
            const auto within = hn::FirstN(d, count);
            const auto tan = tanIn(k, sine), old = hn::LoadU(d, raised_.horizon + k);
            const auto hidesAll = hn::Ge(tan, hn::LoadU(d, &bins_.highestTan[k]));
            const auto raised = hn::IfThenElse(hidesAll, hn::Set(d, BinDirections::always), tan);
            hn::StoreU(hn::IfThenElse(hn::And(hn::Gt(tan, old), within), raised, old), d,
                       raised_.horizon + k);
            if constexpr (bounds) raiseTo(raised_.touch + k, hn::Add(tan, slackIn(k, sine, tan)), within);
        });
    }

    // The edge covers the middles before and after each of these bins, so all of the bin.
    HWY_INLINE void raiseCover(BinRange range, Sine sine) const {
        if (range.last < range.first) return;
        forEachRow(range, [&](std::size_t k, std::size_t count) {
            const auto tan = tanIn(k, sine);
            raiseTo(raised_.cover + k, hn::Sub(tan, slackIn(k, sine, tan)), hn::FirstN(RowOfBins{}, count));
        });
    }

    // Calls visit(bin, count of bins) for bins side by side.
    template <class Visit>
    HWY_INLINE void forEachRow(BinRange range, const Visit& visit) const {
        splitAtNorth(range, [&](int first, int last) {
            for (int bin = first; bin <= last; bin += binsOfRow)
                visit(std::size_t(bin), std::size_t(last - bin + 1));
        });
    }

    HWY_INLINE hn::Vec<RowOfBins> tanIn(std::size_t k, Sine sine) const {
        constexpr RowOfBins d;
        return hn::Add(hn::Mul(hn::Set(d, sine.east), hn::LoadU(d, &bins_.sine[k])),
                       hn::Mul(hn::Set(d, sine.north), hn::LoadU(d, &bins_.cosine[k])));
    }

    // By how much the tangent may differ from that at the middle of the bin.
    HWY_INLINE hn::Vec<RowOfBins> slackIn(std::size_t k, Sine sine, hn::Vec<RowOfBins> tan) const {
        constexpr RowOfBins d;
        const auto change = hn::Sub(hn::Mul(hn::Set(d, sine.east), hn::LoadU(d, &bins_.cosine[k])),
                                    hn::Mul(hn::Set(d, sine.north), hn::LoadU(d, &bins_.sine[k])));
        return hn::Add(hn::Mul(hn::Abs(change), hn::Set(d, halfBin)),
                       hn::Mul(hn::Abs(tan), hn::Set(d, bent)));
    }

    HWY_INLINE static void raiseTo(float* tans, hn::Vec<RowOfBins> tan, hn::Mask<RowOfBins> within) {
        constexpr RowOfBins d;
        const auto old = hn::LoadU(d, tans);
        hn::StoreU(hn::IfThenElse(within, hn::Max(old, tan), old), d, tans);
    }

    const BinDirections& bins_;
    glm::vec3 eye_;
    glm::dvec3 at_;
    Raised raised_;
};

}  // namespace

namespace {

template <bool bounds>
HWY_INLINE void raise(const EdgeTree& edges, const BinDirections& bins, glm::vec3 eye, const Raised& raised) {
    const EdgeRaiser<bounds> raiser(bins, eye, raised);
    BoxVisit(edges.boxes, eye, raised.horizon)
        .visitLeaves([&](std::uint32_t leaf) { raiser.raiseBy(edges.blocks[leaf]); },
                     [&](std::uint32_t leaf) { prefetchLines(&edges.blocks[leaf]); });
}

}  // namespace

void raiseHorizon(const EdgeTree& edges, const BinDirections& bins, glm::vec3 eye, BinTangents& horizon) {
    raise<false>(edges, bins, eye, {horizon.data()});
}

void raiseHorizonAndBounds(const EdgeTree& edges, const BinDirections& bins, glm::vec3 eye,
                           BinTangents& horizon, BinTangents& touch, BinTangents& cover) {
    raise<true>(edges, bins, eye, {horizon.data(), touch.data(), cover.data()});
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {
NOONMARK_KERNEL(raiseHorizon);
void raiseHorizon(const EdgeTree& edges, const BinDirections& bins, glm::vec3 eye, BinTangents& horizon) {
    NOONMARK_CALL(raiseHorizon)(edges, bins, eye, horizon);
}
NOONMARK_KERNEL(raiseHorizonAndBounds);
void raiseHorizonAndBounds(const EdgeTree& edges, const BinDirections& bins, glm::vec3 eye,
                           BinTangents& horizon, BinTangents& touch, BinTangents& cover) {
    NOONMARK_CALL(raiseHorizonAndBounds)(edges, bins, eye, horizon, touch, cover);
}
}  // namespace noonmark
#endif
