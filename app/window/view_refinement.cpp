#include "app/window/view_refinement.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/accumulate/scattered_order.h"
#include "core/sun/chosen_days.h"

namespace noonmark {

namespace {

constexpr float surroundingsM = 100;
constexpr int finestLevel = int(std::size(refinementLevels)) - 1;

Result<std::shared_ptr<const SunSteps>> sunOf(const ViewQuestion& question, const std::stop_token& stop) {
    if (question.sun) return question.sun;
    const auto period = checked(question.period);
    if (!period) return tl::make_unexpected(period.error());
    auto sun = sunSteps(question.period, question.observer, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    if (sun->steps.empty())
        return failure("The sun is below the horizon all the time", textOf(question.period),
                       "Choose other hours or days");
    return std::make_shared<const SunSteps>(*std::move(sun));
}

int daysAtOnce(const RefinementLevel& level, std::size_t points, const SunSteps& sun) {
    const double testsADay = double(points) * double(sun.steps.size()) / double(sun.dayCount());
    const double days = std::floor(level.mostTests / std::max(1.0, testsADay));
    return int(std::clamp(days, 1.0, double(sun.dayCount())));
}

// Days number `first` to `first + count` of an order in which every beginning is spread over the period.
SunSteps scatteredDays(const SunSteps& sun, int first, int count) {
    const std::size_t all = sun.dayCount();
    const std::size_t stride = scatteringStride(all);
    std::vector<std::size_t> days;
    for (int k = first; k < first + count; ++k) days.push_back(std::size_t(k) * stride % all);
    return chosenDays(sun, days);
}

// Two parts of a period in one: gross is a mean over days, continuous the longest of any day.
SurfaceShadow joined(const SurfaceShadow& a, int daysOfA, SurfaceShadow b, int daysOfB) {
    const double shareOfA = double(daysOfA) / (daysOfA + daysOfB);
    const auto mean = [shareOfA](double of, double with) { return with + (of - with) * shareOfA; };
    for (std::size_t i = 0; i < b.grossMin.size(); ++i) {
        b.grossMin[i] = float(mean(double(a.grossMin[i]), double(b.grossMin[i])));
        b.continuousMin[i] = std::max(a.continuousMin[i], b.continuousMin[i]);
    }
    b.sunlitMinutesPerDay = mean(a.sunlitMinutesPerDay, b.sunlitMinutesPerDay);
    return b;
}

// Beyond the city nothing is known of what stands there: that ground would only seem to lie in the sun.
VisibleSurface within(const Box2& box, const VisibleSurface& seen) {
    VisibleSurface kept;
    kept.points.eye = seen.points.eye;
    for (std::size_t i = 0; i < seen.points.size(); ++i) {
        const glm::vec3 place = seen.points.positions[i];
        if (place.x < box.low.x || place.x > box.high.x || place.y < box.low.y || place.y > box.high.y)
            continue;
        kept.points.positions.push_back(place);
        kept.points.normals.push_back(seen.points.normals[i]);
        kept.pixel.push_back(seen.pixel[i]);
    }
    return kept;
}

Box2 surroundingsOf(const OpenCity& city) {
    const Box2 box = city.arrays.bounds.box;
    return {box.low - glm::vec2(surroundingsM), box.high + glm::vec2(surroundingsM)};
}

Result<ViewAnswer> withMoreDays(ViewAnswer answer, const ViewQuestion& question,
                                const SurfaceAccumulator& engine, Progress& progress, std::stop_token stop) {
    ExploredView& view = answer.view;
    const RefinementLevel& level = refinementLevels[answer.level];
    const int atOnce = daysAtOnce(level, view.surface.points.size(), *answer.sun);
    const int days = std::min(atOnce, view.days - view.daysDone);
    auto shadow =
        engine.accumulate(question.city->city(), view.surface.points,
                          scatteredDays(*answer.sun, view.daysDone, days), progress, std::move(stop));
    if (!shadow) return tl::make_unexpected(shadow.error());
    view.shadow =
        view.daysDone > 0 ? joined(view.shadow, view.daysDone, *std::move(shadow), days) : *std::move(shadow);
    view.daysDone += days;
    return answer;
}

Result<ViewAnswer> atLevel(int level, const ViewQuestion& question, const SurfaceAccumulator& engine,
                           Progress& progress, const std::stop_token& stop) {
    auto sun = sunOf(question, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    ViewAnswer answer;
    answer.level = level;
    answer.sun = *std::move(sun);
    answer.view.days = int(answer.sun->dayCount());
    answer.view.spacingPx = refinementLevels[level].spacingPx;
    answer.view.camera = cameraOf(question.pose, question.lens, answer.view.spacingPx);
    const City& city = question.city->city();
    auto surface =
        visibleSurface(question.city->picker.scene().value(), !city.terrain, answer.view.camera, stop);
    if (!surface) return tl::make_unexpected(surface.error());
    answer.view.surface = within(surroundingsOf(*question.city), *surface);
    return withMoreDays(std::move(answer), question, engine, progress, stop);
}

}  // namespace

Result<ViewAnswer> refined(const ViewQuestion& question, const ViewAnswer* before,
                           const SurfaceAccumulator& engine, Progress& progress, std::stop_token stop) {
    if (!before) return atLevel(0, question, engine, progress, stop);
    if (before->level < finestLevel) return atLevel(before->level + 1, question, engine, progress, stop);
    return withMoreDays(*before, question, engine, progress, std::move(stop));
}

bool isFinest(const ViewAnswer& answer) {
    return answer.level == finestLevel && answer.view.daysDone == answer.view.days;
}

}  // namespace noonmark
