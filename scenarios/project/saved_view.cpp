#include "scenarios/project/saved_view.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

constexpr double farthestM = 1e7;

bool isWithin(double value, double low, double high) { return value >= low && value <= high; }

}  // namespace

bool isBox(const ViewBox& box) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.lowM[axis] >= -farthestM && box.highM[axis] <= farthestM &&
              box.lowM[axis] < box.highM[axis]))
            return false;
    return true;
}

Result<void> validate(const SavedView& view) {
    const glm::dvec3 target = view.targetM;
    const bool near = std::max({std::abs(target.x), std::abs(target.y), std::abs(target.z)}) <= farthestM;
    const bool camera = near && isWithin(view.distanceM, 1e-3, farthestM) &&
                        isWithin(view.headingDeg, 0, 360) && isWithin(view.pitchDeg, 0, 90);
    const bool moment =
        !view.moment || (view.moment->date.ok() && isWithin(double(view.moment->at.count()), 0, 24 * 60));
    if (camera && moment && (!view.section || isBox(*view.section))) return {};
    return failure("The camera, the moment or the section box of a saved view is out of range",
                   "view '" + view.name + "'", "Delete the view and save it again");
}

}  // namespace noonmark
