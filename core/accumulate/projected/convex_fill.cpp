#include "core/accumulate/projected/convex_fill.h"

#include "core/accumulate/projected/convex_spans.h"

namespace noonmark {

int fillConvex(std::span<const glm::dvec2> polygon, const BitLayout& layout,
               std::span<std::uint64_t> raster) {
    return forEachSpan(polygon, layout.columns, layout.rows,
                       [&](int row, int first, int end) { setRun(layout.row(raster, row), first, end); });
}

}  // namespace noonmark
