#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lab/accrual/surface_lookup_hwy.cpp"
#include <hwy/foreach_target.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/lab/accrual/surface_accrual.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

// No wider: gathering sixteen texels at once takes longer than eight twice.
using D = LanesUpTo<float, 8>;
using DI = hn::RebindToSigned<D>;
using V = hn::Vec<D>;
using Ints = hn::Vec<DI>;
constexpr D d;
constexpr DI di;
constexpr std::size_t lanes = hn::MaxLanes(d);

HWY_INLINE V linear(const float* row, V x, V y) {
    return hn::Add(hn::Add(hn::Mul(hn::Set(d, row[0]), x), hn::Mul(hn::Set(d, row[1]), y)),
                   hn::Set(d, row[2]));
}

HWY_INLINE Ints nearestTexel(V place, int count) {
    const V at = hn::Max(hn::Add(place, hn::Set(d, 0.5F)), hn::Zero(d));
    return hn::ConvertTo(di, hn::Min(at, hn::Set(d, float(count - 1))));
}

/// Points in the map of a step, one per lane.
struct SeenPoints {
    V w, q;
    Ints column, row;
    V centrePerQ;  ///< 1 / q at the texel's centre
};

HWY_INLINE SeenPoints seePoints(const PlacedSurface& points, std::size_t first, const SurfaceView& step) {
    SeenPoints seen;
    seen.w = hn::LoadU(d, &points.w[first]);
    const V x = hn::Sub(hn::LoadU(d, &points.x[first]), hn::Mul(seen.w, hn::Set(d, step.shearX))),
            y = hn::Sub(hn::LoadU(d, &points.y[first]), hn::Mul(seen.w, hn::Set(d, step.shearY)));
    seen.q = linear(step.q, x, y);
    seen.column = nearestTexel(hn::Div(linear(step.column, x, y), seen.q), step.columns);
    seen.row = nearestTexel(hn::Div(linear(step.row, x, y), seen.q), step.rows);
    seen.centrePerQ = linear(step.perQ, hn::ConvertTo(d, seen.column), hn::ConvertTo(d, seen.row));
    return seen;
}

/// Orientation of their surfaces to the sun.
struct SeenNormals {
    V facing;  ///< cosine
    V slope;   ///< slope bias x metres of depth per texel at q = 1
};

HWY_INLINE SeenNormals seeNormals(const PlacedSurface& points, std::size_t first, const SurfaceView& step) {
    const V across = hn::LoadU(d, &points.across[first]), up = hn::LoadU(d, &points.up[first]),
            towards = hn::LoadU(d, &points.towards[first]);
    const V facing =
        hn::Add(hn::Add(hn::Mul(across, hn::Set(d, step.sun[0])), hn::Mul(up, hn::Set(d, step.sun[1]))),
                hn::Mul(towards, hn::Set(d, step.sun[2])));
    const V aslant = hn::Mul(hn::Set(d, step.slopeM), hn::Add(hn::Abs(across), hn::Abs(up)));
    return {facing, hn::Div(aslant, hn::Max(facing, hn::Set(d, 1e-6F)))};
}

// One bit for each lane's point, lowest first.
HWY_INLINE std::uint32_t findShaded(const PlacedSurface& points, std::size_t first, const SurfaceView& step,
                                    const float* depth) {
    const SeenPoints seen = seePoints(points, first, step);
    const SeenNormals normals = seeNormals(points, first, step);
    const Ints texel = hn::Add(hn::Mul(seen.row, hn::Set(di, step.stride)), seen.column);
    const V bias = hn::Add(hn::Add(seen.w, hn::Set(d, step.biasM)), hn::Mul(normals.slope, seen.q));
    const auto occluded = hn::Gt(hn::GatherIndex(d, depth, texel), hn::Mul(bias, seen.centrePerQ));
    return bitsOfMask(d, hn::Or(occluded, hn::Not(hn::Gt(normals.facing, hn::Zero(d)))));
}

}  // namespace

void lookUpSurface(const PlacedSurface& points, const SurfaceView& step, const float* depth,
                   std::span<std::uint64_t> shaded) {
    for (std::size_t word = 0; word < shaded.size(); ++word) {
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < 64; i += lanes)
            bits |= std::uint64_t(findShaded(points, word * 64 + i, step, depth)) << i;
        shaded[word] = bits;
    }
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

namespace {

void takeRow(float* to, const glm::dmat3& matrix, int row) {
    for (int column = 0; column < 3; ++column) to[column] = float(matrix[column][row]);
}

SurfaceView viewOf(const MapFrame& frame, glm::dvec3 towardsSun, float biasM, float slopeBias, int stride) {
    SurfaceView view{};
    const glm::dvec2 shear = frame.shearOf(towardsSun);
    view.shearX = float(shear.x), view.shearY = float(shear.y);
    takeRow(view.column, frame.texelFromPlane, 0);
    takeRow(view.row, frame.texelFromPlane, 1);
    takeRow(view.q, frame.texelFromPlane, 2);
    takeRow(view.perQ, glm::inverse(frame.texelFromPlane), 2);
    const glm::dvec3 sun = frame.turned(towardsSun);
    view.sun[0] = float(sun.x), view.sun[1] = float(sun.y), view.sun[2] = float(sun.z);
    view.biasM = biasM;
    // The area of a texel grows with the cube of q. Its side is assumed to grow linearly, which gives less
    // bias near the eye and more far away than its narrow side needs.
    const double texelM = std::pow(std::abs(glm::determinant(frame.texelFromPlane)), -0.5);
    view.slopeM = slopeBias * float(texelM * sun.z);
    view.columns = frame.columns, view.rows = frame.rows, view.stride = stride;
    return view;
}

}  // namespace

PlacedSurface placeSurface(const SurfacePoints& points, const MapFrame& frame) {
    PlacedSurface surface;
    surface.count = points.size();
    const std::size_t padded = (points.size() + 63) / 64 * 64;
    for (auto* array : {&surface.x, &surface.y, &surface.w, &surface.across, &surface.up, &surface.towards})
        array->assign(padded, 0);
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
        const glm::dvec3 place = frame.placed(points.positions[i]);
        const glm::dvec3 normal = frame.turned(glm::dvec3(points.normals[i]));
        surface.x[i] = float(place.x), surface.y[i] = float(place.y), surface.w[i] = float(place.z);
        surface.across[i] = float(normal.x), surface.up[i] = float(normal.y);
        surface.towards[i] = float(normal.z);
    });
    surface.lowestW = std::ranges::min(surface.w);
    return surface;
}

SurfaceLookup::SurfaceLookup(PlacedSurface surface, const MapFrame& frame, const AccrualSettings& settings)
    : surface_(std::move(surface)), frame_(frame), biasM_(settings.biasM), slopeBias_(settings.slopeBias) {}

NOONMARK_KERNEL(lookUpSurface);
void SurfaceLookup::look(const DepthSlice& slice, glm::dvec3 towardsSun,
                         std::span<std::uint64_t> shaded) const {
    const SurfaceView view = viewOf(frame_, towardsSun, biasM_, slopeBias_, int(slice.stride));
    NOONMARK_CALL(lookUpSurface)(surface_, view, slice.depth.data(), shaded);
    const std::size_t beyond = shaded.size() * 64 - surface_.count;
    if (beyond > 0) shaded.back() &= ~std::uint64_t{0} >> beyond;
}

}  // namespace noonmark
#endif
