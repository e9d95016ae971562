#include "core/engines/accrual/surface_lookup.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/simd/registers.h"

namespace noonmark {

namespace {

/// The data that a step's lookup needs besides the points and the map.
struct StepView {
    float shearX, shearY;
    float column[3], row[3], q[3];  ///< rows of texelFromPlane
    float perQ[3];                  ///< 1 / q of a texel's centre, from (column, row, 1)
    float sun[3];                   ///< in the frame's axes
    float biasM;
    float slopeM;  ///< slope bias x metres per texel at q = 1 x sun[2]
    int columns, rows;
    int stride;
};

// Vectors are returned by reference: returning them by value would cross instruction sets.
template <class Floats>
[[gnu::always_inline]] inline void load(const std::vector<float>& from, std::size_t at, Floats& values) {
    std::memcpy(&values, from.data() + at, sizeof values);
}

template <class Floats>
[[gnu::always_inline]] inline void linear(const float* row, const Floats& x, const Floats& y, Floats& value) {
    value = row[0] * x + row[1] * y + row[2];
}

template <class Floats, class Ints>
[[gnu::always_inline]] inline void nearestTexel(const Floats& place, int count, Ints& texel) {
    const Floats last = Floats{} + float(count - 1);
    Floats at = place + 0.5F;
    at = at < 0 ? Floats{} : at;
    at = at > last ? last : at;
    texel = __builtin_convertvector(at, Ints);
}

/// Points in the map of a step, one per lane of a register.
template <class Register>
struct SeenPoints {
    FloatsOf<Register> w, q;
    IntsOf<Register> column, row;
    FloatsOf<Register> centrePerQ;  ///< 1 / q at the texel's centre
};

template <class Register>
[[gnu::always_inline]] inline void see(const PlacedSurface& points, std::size_t first, const StepView& step,
                                       SeenPoints<Register>& seen) {
    using Floats = FloatsOf<Register>;
    Floats x, y, alongColumns, alongRows;
    load(points.w, first, seen.w);
    load(points.x, first, x);
    load(points.y, first, y);
    x -= seen.w * step.shearX;
    y -= seen.w * step.shearY;
    linear(step.q, x, y, seen.q);
    linear(step.column, x, y, alongColumns);
    linear(step.row, x, y, alongRows);
    alongColumns /= seen.q;
    alongRows /= seen.q;
    nearestTexel(alongColumns, step.columns, seen.column);
    nearestTexel(alongRows, step.rows, seen.row);
    const Floats column = __builtin_convertvector(seen.column, Floats);
    const Floats row = __builtin_convertvector(seen.row, Floats);
    linear(step.perQ, column, row, seen.centrePerQ);
}

/// Orientation of their surfaces to the sun.
template <class Register>
struct SeenNormals {
    FloatsOf<Register> facing;  ///< cosine
    FloatsOf<Register> slope;   ///< slope bias x metres of depth per texel at q = 1
};

template <class Register>
[[gnu::always_inline]] inline void see(const PlacedSurface& points, std::size_t first, const StepView& step,
                                       SeenNormals<Register>& seen) {
    using Floats = FloatsOf<Register>;
    Floats across, up, towards;
    load(points.across, first, across);
    load(points.up, first, up);
    load(points.towards, first, towards);
    seen.facing = across * step.sun[0] + up * step.sun[1] + towards * step.sun[2];
    const Floats least = Floats{} + 1e-6F;
    across = across < 0 ? -across : across;
    up = up < 0 ? -up : up;
    seen.slope = step.slopeM * (across + up) / (seen.facing > least ? seen.facing : least);
}

// One bit for each lane's point, lowest first.
template <class Register>
[[gnu::always_inline]] inline std::uint64_t shadedOf(const PlacedSurface& points, std::size_t first,
                                                     const StepView& step, const float* depth) {
    constexpr int lanes = lanesIn<Register>;
    SeenPoints<Register> seen;
    SeenNormals<Register> normals;
    see(points, first, step, seen);
    see(points, first, step, normals);
    const IntsOf<Register> texel = seen.row * step.stride + seen.column;
    FloatsOf<Register> stored;
    for (int lane = 0; lane < lanes; ++lane) stored[lane] = depth[texel[lane]];
    const FloatsOf<Register> threshold = (seen.w + step.biasM + normals.slope * seen.q) * seen.centrePerQ;
    IntsOf<Register> counting;
    count<Register>(counting);
    const IntsOf<Register> laneBit = 1 << counting;
    IntsOf<Register> bits = stored > threshold ? laneBit : IntsOf<Register>{};
    bits = normals.facing > 0 ? bits : laneBit;
    for (int apart = lanes / 2; apart > 0; apart /= 2) {
        IntsOf<Register> others;
        shuffleLanes<IntsOf<Register>>(bits, counting ^ apart, others);
        bits |= others;
    }
    return std::uint64_t(std::uint32_t(bits[0]));
}

// Limited to registers of 32 bytes: gathering sixteen texels at once takes longer than eight twice.
void lookUp(const PlacedSurface& points, const StepView& step, const float* depth,
            std::span<std::uint64_t> shaded) {
    runWithWidestRegisters<32>([&](auto registers) __attribute__((always_inline)) {
        using Register = decltype(registers);
        const float* const depths = depth;
        for (std::size_t word = 0; word < shaded.size(); ++word) {
            std::uint64_t bits = 0;
            for (unsigned i = 0; i < 64; i += lanesIn<Register>)
                bits |= shadedOf<Register>(points, word * 64 + i, step, depths) << i;
            shaded[word] = bits;
        }
    });
}

void takeRow(float* to, const glm::dmat3& matrix, int row) {
    for (int column = 0; column < 3; ++column) to[column] = float(matrix[column][row]);
}

StepView viewOf(const MapFrame& frame, glm::dvec3 towardsSun, float biasM, float slopeBias, int stride) {
    StepView view{};
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

void SurfaceLookup::look(const DepthSlice& slice, glm::dvec3 towardsSun,
                         std::span<std::uint64_t> shaded) const {
    const StepView view = viewOf(frame_, towardsSun, biasM_, slopeBias_, int(slice.stride));
    lookUp(surface_, view, slice.depth.data(), shaded);
    const std::size_t beyond = shaded.size() * 64 - surface_.count;
    if (beyond > 0) shaded.back() &= ~std::uint64_t{0} >> beyond;
}

}  // namespace noonmark
