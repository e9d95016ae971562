#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/points/horizons/face_gaps_hwy.cpp"
#include <hwy/foreach_target.h>

#include <cmath>

#include "core/engines/points/horizons/box_visit-inl.h"
#include "core/engines/points/horizons/horizon_of_point.h"
#include "core/simd/cache_line.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

constexpr RowOfBins row;
using Row = hn::Vec<RowOfBins>;

/// A place in the vertical planes of a row's bins: metres along the plane and above the eye.
struct PlanePlace {
    Row along, up;
};

/// A corner of a face as seen in the planes of a row's bins.
struct Corner {
    Row right;  // metres to the right of the plane
    PlanePlace at;
};

/// Finds what the faces of overhangs hide from one eye.
class GapFinder {
public:
    GapFinder(const BinDirections& bins, glm::vec3 eye, const float* horizon, std::vector<BinGap>& gaps)
        : bins_(bins), eye_(eye), horizon_(horizon), gaps_(gaps) {}

    HWY_INLINE void addBlock(const FaceBlock& block) {
        HWY_ALIGN float azimuth[3][BoxTree::width];
        for (std::size_t corner = 0; corner < 3; ++corner)
            for (std::size_t i = 0; i < BoxTree::width; i += lanesOfEight) {
                constexpr Eight d;
                const auto x = hn::Sub(hn::LoadU(d, &block.x[corner][i]), hn::Set(d, eye_.x));
                const auto y = hn::Sub(hn::LoadU(d, &block.y[corner][i]), hn::Set(d, eye_.y));
                hn::Store(azimuthInBins(x, y), d, azimuth[corner] + i);
            }
        for (std::size_t i = 0; i < BoxTree::width; ++i) {
            const float top = std::max({block.z[0][i], block.z[1][i], block.z[2][i]});
            if (top > eye_.z) addFace(block, i, {azimuth[0][i], azimuth[1][i], azimuth[2][i]});
        }
    }

private:
    // At least the bins that the face covers. A face above or below the eye may cover all.
    static BinRange binsOf(std::array<float, 3> azimuths) {
        constexpr auto turn = float(SunBins::count);
        float low = 0, high = 0;
        for (std::size_t i = 1; i < 3; ++i) {
            float further = azimuths[i] - azimuths[0];
            if (further > turn / 2) further -= turn;
            if (further < -turn / 2) further += turn;
            low = std::min(low, further), high = std::max(high, further);
        }
        if (high - low >= turn / 2 - 1) return {0, SunBins::count - 1};
        const float from = azimuths[0] + low, to = azimuths[0] + high;
        return binsAround(from < 0 ? from + turn : from, to >= turn ? to - turn : to < 0 ? to + turn : to);
    }

    HWY_INLINE void addFace(const FaceBlock& block, std::size_t i, std::array<float, 3> azimuths) {
        glm::vec3 corners[3];
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = glm::vec3(block.x[k][i], block.y[k][i], block.z[k][i]) - eye_;
        splitAtNorth(binsOf(azimuths), [&](int first, int last) {
            for (int bin = first; bin <= last; bin += binsOfRow) addRow(corners, bin, last - bin + 1);
        });
    }

    HWY_INLINE Corner cornerIn(glm::vec3 corner, Row sine, Row cosine) const {
        const Row x = hn::Set(row, corner.x), y = hn::Set(row, corner.y);
        return {hn::Sub(hn::Mul(x, cosine), hn::Mul(y, sine)),
                {hn::Add(hn::Mul(x, sine), hn::Mul(y, cosine)), hn::Set(row, corner.z)}};
    }

    static HWY_INLINE hn::Mask<RowOfBins> isLeft(const Corner& corner) {
        return hn::Lt(corner.right, hn::Zero(row));
    }

    // Where an edge crosses the planes, counted from its left end: the same for both faces of the edge.
    static HWY_INLINE PlanePlace crossing(const Corner& a, const Corner& b) {
        const auto swap = isLeft(b);
        const auto left = [&](Row ofA, Row ofB) { return hn::IfThenElse(swap, ofB, ofA); };
        const Row leftRight = left(a.right, b.right), rightRight = left(b.right, a.right);
        const Row share = hn::Div(leftRight, hn::Sub(leftRight, rightRight));
        const auto between = [&](Row from, Row to) {
            return hn::Add(from, hn::Mul(share, hn::Sub(to, from)));
        };
        return {between(left(a.at.along, b.at.along), left(b.at.along, a.at.along)),
                between(left(a.at.up, b.at.up), left(b.at.up, a.at.up))};
    }

    static HWY_INLINE PlanePlace choose(hn::Mask<RowOfBins> mask, const PlanePlace& yes,
                                        const PlanePlace& no) {
        return {hn::IfThenElse(mask, yes.along, no.along), hn::IfThenElse(mask, yes.up, no.up)};
    }

    // The planes cut the face along a line from `near` to `far`.
    HWY_INLINE void addRow(const glm::vec3 (&corners)[3], int bin, int count) {
        const auto asked =
            hn::And(hn::Lt(hn::LoadU(row, horizon_ + bin), hn::Set(row, BinDirections::always)),
                    hn::FirstN(row, std::size_t(count)));
        if (hn::AllFalse(row, asked)) return;
        const Row sine = hn::LoadU(row, &bins_.sine[std::size_t(bin)]);
        const Row cosine = hn::LoadU(row, &bins_.cosine[std::size_t(bin)]);
        const Corner a = cornerIn(corners[0], sine, cosine), b = cornerIn(corners[1], sine, cosine);
        const Corner c = cornerIn(corners[2], sine, cosine);
        const auto crossesAb = hn::Xor(isLeft(a), isLeft(b)), crossesCa = hn::Xor(isLeft(c), isLeft(a));
        const auto crosses = hn::Or(crossesAb, crossesCa);
        const PlanePlace ofBc = crossing(b, c);
        const PlanePlace one = choose(crossesAb, crossing(a, b), ofBc);
        const PlanePlace other = choose(crossesCa, crossing(c, a), ofBc);
        const auto oneIsNear = hn::Lt(one.along, other.along);
        addCut(choose(oneIsNear, one, other), choose(oneIsNear, other, one), hn::And(asked, crosses), bin);
    }

    HWY_INLINE void addCut(const PlanePlace& near, const PlanePlace& far, hn::Mask<RowOfBins> mask, int bin) {
        const Row zero = hn::Zero(row), infinite = hn::Set(row, BinDirections::always);
        const Row nearTan = hn::Div(near.up, near.along), farTan = hn::Div(far.up, far.along);
        // A cut that begins behind the eye passes below it, or covers the zenith.
        const Row rise = hn::Div(hn::Sub(far.up, near.up), hn::Sub(far.along, near.along));
        const auto below = hn::Le(hn::Sub(near.up, hn::Mul(rise, near.along)), zero);
        const auto ahead = hn::Gt(near.along, zero);
        const auto nearIsLow = hn::Lt(nearTan, farTan);
        Row low = hn::IfThenElse(ahead, hn::IfThenElse(nearIsLow, nearTan, farTan),
                                 hn::IfThenElse(below, zero, farTan));
        const Row high = hn::IfThenElse(ahead, hn::IfThenElse(nearIsLow, farTan, nearTan),
                                        hn::IfThenElse(below, farTan, infinite));
        low = hn::IfThenElse(hn::Gt(low, zero), low, zero);
        const auto hides = hn::And(hn::Gt(far.along, zero), hn::Gt(high, hn::LoadU(row, horizon_ + bin)));
        append(low, high, bitsOfMask(row, hn::And(mask, hides)), bin);
    }

    HWY_INLINE void append(Row low, Row high, std::uint32_t bits, int bin) {
        HWY_ALIGN float lows[binsOfRow], highs[binsOfRow];
        hn::Store(low, row, lows);
        hn::Store(high, row, highs);
        for (; bits != 0; bits &= bits - 1) {
            const auto i = std::size_t(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
            gaps_.push_back({bin + int(i), lows[i], highs[i]});
        }
    }

    const BinDirections& bins_;
    glm::vec3 eye_;
    const float* horizon_;
    std::vector<BinGap>& gaps_;
};

}  // namespace

void findFaceGaps(const FaceTree& faces, const BinDirections& bins, glm::vec3 eye, const BinTangents& horizon,
                  std::vector<BinGap>& gaps) {
    GapFinder finder(bins, eye, horizon.data(), gaps);
    BoxVisit(faces.boxes, eye, horizon.data())
        .visitLeaves([&](std::uint32_t leaf) { finder.addBlock(faces.blocks[leaf]); },
                     [&](std::uint32_t leaf) { prefetchLines(&faces.blocks[leaf]); });
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {
NOONMARK_KERNEL(findFaceGaps);
void findFaceGaps(const FaceTree& faces, const BinDirections& bins, glm::vec3 eye, const BinTangents& horizon,
                  std::vector<BinGap>& gaps) {
    NOONMARK_CALL(findFaceGaps)(faces, bins, eye, horizon, gaps);
}
}  // namespace noonmark
#endif
