#include "core/accumulate/accrual/surface_lookup.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/accumulate/horizon/lanes16.h"

namespace noonmark {

namespace {

constexpr Ints16 laneBit{1,      1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
                         1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15};
constexpr Ints16 counting{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// All that a step's lookup needs besides the points and the map.
struct StepView {
    float shearX, shearY;
    float column[3], row[3], q[3];  ///< of texelFromPlane
    float perQ[3];                  ///< 1 / q of a texel's centre, from (column, row, 1)
    float sun[3];                   ///< in the frame's axes
    float biasM;
    float slopeM;  ///< slope bias x metres a texel where q is 1 x sun[2]
    int columns, rows;
    int stride;
};

// Vectors go out by reference: returned, they would cross instruction sets.
[[gnu::always_inline]] inline void load(const std::vector<float>& from, std::size_t at, Floats16& values) {
    std::memcpy(&values, from.data() + at, sizeof values);
}

[[gnu::always_inline]] inline void linear(const float* row, const Floats16& x, const Floats16& y,
                                          Floats16& value) {
    value = row[0] * x + row[1] * y + row[2];
}

[[gnu::always_inline]] inline void nearestTexel(const Floats16& place, int count, Ints16& texel) {
    const Floats16 last = Floats16{} + float(count - 1);
    Floats16 at = place + 0.5F;
    at = at < 0 ? Floats16{} : at;
    at = at > last ? last : at;
    texel = __builtin_convertvector(at, Ints16);
}

/// Sixteen points in the map of a step.
struct SeenPoints {
    Floats16 w, q;
    Ints16 column, row;
    Floats16 centrePerQ;  ///< 1 / q at the texel's centre
};

[[gnu::always_inline]] inline void see(const PlacedSurface& points, std::size_t first, const StepView& step,
                                       SeenPoints& seen) {
    Floats16 x, y, alongColumns, alongRows;
    load(points.w, first, seen.w);
    load(points.x, first, x);
    load(points.y, first, y);
    x -= seen.w * step.shearX;
    y -= seen.w * step.shearY;
    linear(step.q, x, y, seen.q);
    linear(step.column, x, y, alongColumns);
    linear(step.row, x, y, alongRows);
    nearestTexel(alongColumns / seen.q, step.columns, seen.column);
    nearestTexel(alongRows / seen.q, step.rows, seen.row);
    const Floats16 column = __builtin_convertvector(seen.column, Floats16);
    const Floats16 row = __builtin_convertvector(seen.row, Floats16);
    linear(step.perQ, column, row, seen.centrePerQ);
}

/// How sixteen surfaces stand to the sun.
struct SeenNormals {
    Floats16 facing;  ///< cosine
    Floats16 slope;   ///< metres of depth a texel, where q is 1, x slope bias
};

[[gnu::always_inline]] inline void see(const PlacedSurface& points, std::size_t first, const StepView& step,
                                       SeenNormals& seen) {
    Floats16 across, up, towards;
    load(points.across, first, across);
    load(points.up, first, up);
    load(points.towards, first, towards);
    seen.facing = across * step.sun[0] + up * step.sun[1] + towards * step.sun[2];
    const Floats16 least = Floats16{} + 1e-6F;
    across = across < 0 ? -across : across;
    up = up < 0 ? -up : up;
    seen.slope = step.slopeM * (across + up) / (seen.facing > least ? seen.facing : least);
}

[[gnu::always_inline]] inline std::uint64_t sixteen(const PlacedSurface& points, std::size_t first,
                                                    const StepView& step, const float* depth) {
    SeenPoints seen;
    SeenNormals normals;
    see(points, first, step, seen);
    see(points, first, step, normals);
    const Ints16 texel = seen.row * step.stride + seen.column;
    Floats16 stored;
    for (int lane = 0; lane < 16; ++lane) stored[lane] = depth[texel[lane]];
    const Floats16 threshold = (seen.w + step.biasM + normals.slope * seen.q) * seen.centrePerQ;
    Ints16 bits = stored > threshold ? laneBit : Ints16{};
    bits = normals.facing > 0 ? bits : laneBit;
    for (int apart = 8; apart > 0; apart /= 2) bits |= __builtin_shuffle(bits, counting ^ apart);
    return std::uint64_t(std::uint32_t(bits[0]));
}

NOONMARK_EVERY_ISA
void lookUp(const PlacedSurface& points, const StepView& step, const float* depth, std::size_t words,
            std::uint64_t* shaded) {
    for (std::size_t word = 0; word < words; ++word) {
        const std::size_t first = word * 64;
        shaded[word] = sixteen(points, first, step, depth) | sixteen(points, first + 16, step, depth) << 16U |
                       sixteen(points, first + 32, step, depth) << 32U |
                       sixteen(points, first + 48, step, depth) << 48U;
    }
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
    // The area of a texel grows with the cube of q; its side is taken to grow evenly, which is less near the
    // eye and more far away than its narrow side needs.
    const double texelM = std::pow(std::abs(glm::determinant(frame.texelFromPlane)), -0.5);
    view.slopeM = slopeBias * float(texelM * sun.z);
    view.columns = frame.columns, view.rows = frame.rows, view.stride = stride;
    return view;
}

}  // namespace

PlacedSurface placedSurface(const SurfacePoints& points, const MapFrame& frame) {
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
    lookUp(surface_, view, slice.depth.data(), shaded.size(), shaded.data());
    const std::size_t beyond = shaded.size() * 64 - surface_.count;
    if (beyond > 0) shaded.back() &= ~std::uint64_t{0} >> beyond;
}

}  // namespace noonmark
