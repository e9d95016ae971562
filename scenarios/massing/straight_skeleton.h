#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/city/footprints/footprint.h"

namespace noonmark {

/// The straight skeleton of a polygon with holes (Aichholzer and others, 1995). Computed once, it gives the
/// polygon inset by any distance: walls stay parallel, holes grow. Backend: straight_skeleton_cgal.cpp.
class StraightSkeleton {
public:
    /// More points than real lots have. Above it CGAL takes seconds and cannot be cancelled.
    static constexpr std::size_t maxPoints = 300;

    /// About 0.1 ms for ten points; grows at least with the square of their number. Error: the polygon is not
    /// simple, or it has more than maxPoints.
    static Result<StraightSkeleton> of(const Footprint& footprint);

    StraightSkeleton(StraightSkeleton&&) noexcept;
    StraightSkeleton& operator=(StraightSkeleton&&) noexcept;
    ~StraightSkeleton();

    /// The polygons left at `distanceM` (>= 0) inside the outline: none, one or several, simple and oriented.
    [[nodiscard]] std::vector<Footprint> inset(double distanceM) const;

    /// Metres; the inset of this distance is empty.
    [[nodiscard]] double deepestM() const { return deepestM_; }

private:
    struct Skeleton;
    StraightSkeleton(std::unique_ptr<Skeleton> skeleton, double deepestM);
    std::unique_ptr<Skeleton> skeleton_;
    double deepestM_ = 0;
};

}  // namespace noonmark
