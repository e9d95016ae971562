#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/city/footprints/footprint.h"

namespace noonmark {

/// The straight skeleton of a polygon with holes (Aichholzer and others, 1995): made once, it gives the
/// polygon inset by any distance, walls parallel to the old ones, holes grown. Backend:
/// straight_skeleton_cgal.cpp.
class StraightSkeleton {
public:
    /// More points than any lot has: beyond it CGAL takes seconds, and cannot be stopped.
    static constexpr std::size_t mostPoints = 300;

    /// Some 0.1 ms for ten points; grows with the square of their number, or worse. Error: no simple polygon,
    /// or more than mostPoints.
    static Result<StraightSkeleton> of(const Footprint& footprint);

    StraightSkeleton(StraightSkeleton&&) noexcept;
    StraightSkeleton& operator=(StraightSkeleton&&) noexcept;
    ~StraightSkeleton();

    /// What is left at `distanceM` (>= 0) from the outline: none, one or several polygons, simple and
    /// oriented.
    [[nodiscard]] std::vector<Footprint> inset(double distanceM) const;

    /// The distance at which nothing is left, metres.
    [[nodiscard]] double deepestM() const { return deepestM_; }

private:
    struct Skeleton;
    StraightSkeleton(std::unique_ptr<Skeleton> skeleton, double deepestM);
    std::unique_ptr<Skeleton> skeleton_;
    double deepestM_ = 0;
};

}  // namespace noonmark
