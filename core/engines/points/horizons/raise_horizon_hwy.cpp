#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/points/horizons/raise_horizon_hwy.cpp"
#include <hwy/foreach_target.h>

#include <cmath>

#include "core/engines/points/horizons/box_visit-inl.h"
#include "core/engines/points/horizons/raise_horizon.h"
#include "core/simd/kernel.h"
#include "core/simd/prefetch.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

constexpr int binCount = SunBins::count;

/// Raises the horizon of one point by edges.
class EdgeRaiser {
public:
    EdgeRaiser(const BinDirections& bins, glm::vec3 eye, float* horizon)
        : bins_(bins), eye_(eye), at_(eye), horizon_(horizon) {}

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
    // the eye, that are seen from the side which hides nothing, or between the middles of two bins.
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
        const auto spare = hn::Set(d, 0.01F), half = hn::Set(d, 0.5F);  // more than azimuths are uncertain
        const auto firstMiddle = hn::Floor(hn::Sub(hn::Add(hn::Min(a, b), half), spare));
        const auto lastMiddle = hn::Floor(hn::Add(hn::Add(hn::Max(a, b), half), spare));
        const auto covers = hn::Gt(lastMiddle, firstMiddle);
        return bitsOfMask(d, hn::AndNot(behind, hn::And(above, covers)));
    }

    // The edge lies in a plane through the eye, so the tangent of its altitude is east sin(azimuth) + north
    // cos(azimuth).
    HWY_INLINE void raiseBy(const EdgeBlock& block, std::size_t i, float azimuthA, float azimuthB) const {
        const glm::dvec3 a = glm::dvec3(block.ax[i], block.ay[i], block.az[i]) - at_;
        const glm::dvec3 b = glm::dvec3(block.bx[i], block.by[i], block.bz[i]) - at_;
        const double turn = a.y * b.x - a.x * b.y;  // positive: b is clockwise of a
        if (turn < 0 && (block.oneSided >> i & 1U) != 0) return;
        constexpr double endOn = 1e-12;  // square metres
        if (std::abs(turn) < endOn) return;
        const BinRange covered =
            turn > 0 ? middlesBetween(a, b, azimuthA, azimuthB) : middlesBetween(b, a, azimuthB, azimuthA);
        if (covered.last < covered.first) return;
        raiseBins(covered, float((b.z * a.y - a.z * b.y) / turn), float((a.z * b.x - b.z * a.x) / turn));
    }

    // Metres to the right of the line from the eye along a bin's middle. `bin`: at most a turn out of range.
    HWY_INLINE double rightOf(int bin, glm::dvec3 place) const {
        const auto k = std::size_t(bin < 0 ? bin + binCount : bin >= binCount ? bin - binCount : bin);
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

    HWY_INLINE void raiseBins(BinRange range, float east, float north) const {
        constexpr RowOfBins d;
        const auto e = hn::Set(d, east), n = hn::Set(d, north), always = hn::Set(d, BinDirections::always);
        splitAtNorth(range, [&](int first, int last) {
            for (int bin = first; bin <= last; bin += binsOfRow) {
                const auto k = std::size_t(bin);
                const auto old = hn::LoadU(d, horizon_ + bin);
                const auto tan = hn::Add(hn::Mul(e, hn::LoadU(d, &bins_.sine[k])),
                                         hn::Mul(n, hn::LoadU(d, &bins_.cosine[k])));
                const auto hidesAll = hn::Ge(tan, hn::LoadU(d, &bins_.highestTan[k]));
                const auto raised = hn::IfThenElse(hidesAll, always, tan);
                const auto higher = hn::And(hn::Gt(tan, old), hn::FirstN(d, std::size_t(last - bin + 1)));
                hn::StoreU(hn::IfThenElse(higher, raised, old), d, horizon_ + bin);
            }
        });
    }

    const BinDirections& bins_;
    glm::vec3 eye_;
    glm::dvec3 at_;
    float* horizon_;
};

}  // namespace

void raiseHorizon(const EdgeTree& edges, const BinDirections& bins, glm::vec3 eye, BinTangents& horizon) {
    const EdgeRaiser raiser(bins, eye, horizon.data());
    BoxVisit(edges.boxes, eye, horizon.data())
        .visitLeaves([&](std::uint32_t leaf) { raiser.raiseBy(edges.blocks[leaf]); },
                     [&](std::uint32_t leaf) { prefetchLines(&edges.blocks[leaf]); });
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {
NOONMARK_KERNEL(raiseHorizon);
void raiseHorizon(const EdgeTree& edges, const BinDirections& bins, glm::vec3 eye, BinTangents& horizon) {
    NOONMARK_CALL(raiseHorizon)(edges, bins, eye, horizon);
}
}  // namespace noonmark
#endif
