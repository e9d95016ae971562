#include "app/window/view_refinement.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

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

/// What is done in one go: some days of all points, or one day of some points.
struct Turn {
    std::size_t firstPoint = 0;
    std::size_t points = 0;
    int days = 1;
};

Turn nextTurn(const ViewAnswer& answer, const SunSteps& sun, bool inParts) {
    const ExploredView& view = answer.view;
    const std::size_t all = view.surface->points.size();
    const int daysLeft = view.days - view.daysDone;
    const bool finest = answer.level == finestLevel;
    if (finest && !inParts) return {0, all, daysLeft};
    const double stepsADay = double(sun.steps.size()) / double(sun.dayCount());
    const double pointDays =
        std::max(1.0, refinementLevels[answer.level].mostTests / std::max(1.0, stepsADay));
    const double days = std::floor(pointDays / std::max(1.0, double(all)));
    if (!finest || days >= 1) return {0, all, int(std::clamp(days, 1.0, double(daysLeft)))};
    return {view.pointsDone, std::min(all - view.pointsDone, std::size_t(pointDays)), 1};
}

// Days number `first` to `first + count` of an order in which every beginning is spread over the period.
SunSteps scatteredDays(const SunSteps& sun, int first, int count) {
    const std::size_t all = sun.dayCount();
    const std::size_t stride = scatteringStride(all);
    std::vector<std::size_t> days;
    for (int k = first; k < first + count; ++k) days.push_back(std::size_t(k) * stride % all);
    return chosenDays(sun, days);
}

SurfacePoints pointsOf(const SurfacePoints& all, const Turn& turn) {
    if (turn.points == all.size()) return all;
    const auto some = [&turn](const std::vector<glm::vec3>& values) {
        const auto first = values.begin() + std::ptrdiff_t(turn.firstPoint);
        return std::vector<glm::vec3>(first, first + std::ptrdiff_t(turn.points));
    };
    return {some(all.positions), some(all.normals), all.eye};
}

double meanOver(double a, int daysOfA, double b, int daysOfB) {
    return b + (a - b) * (double(daysOfA) / (daysOfA + daysOfB));
}

// Two parts of a period in one: gross is a mean over days, continuous the longest of any day.
void join(ExploredView& view, const Turn& turn, const SurfaceShadow& more) {
    const int before = view.daysDone;
    SurfaceShadow& shadow = view.shadow;
    for (std::size_t i = 0; i < turn.points; ++i) {
        float& gross = shadow.grossMin[turn.firstPoint + i];
        float& longest = shadow.continuousMin[turn.firstPoint + i];
        gross = before == 0 ? more.grossMin[i]
                            : float(meanOver(double(gross), before, double(more.grossMin[i]), turn.days));
        longest = before == 0 ? more.continuousMin[i] : std::max(longest, more.continuousMin[i]);
    }
    if (turn.firstPoint > 0) return;
    shadow.sunlitMinutesPerDay =
        before == 0 ? more.sunlitMinutesPerDay
                    : meanOver(shadow.sunlitMinutesPerDay, before, more.sunlitMinutesPerDay, turn.days);
    shadow.engine = more.engine;
}

void count(ExploredView& view, const Turn& turn) {
    view.pointsDone = turn.firstPoint + turn.points;
    if (view.pointsDone < view.surface->points.size()) {
        view.daysShown = std::clamp(view.daysShown, 0, std::max(turn.days, view.daysDone));
        return;
    }
    view.pointsDone = 0;
    view.daysDone += turn.days;
    view.daysShown = view.daysDone;
}

// What a coarser view knows of the points of a finer one.
void takeOver(ExploredView& view, const ViewAnswer* coarser) {
    const float unknown = std::numeric_limits<float>::quiet_NaN();
    view.shadow.grossMin.assign(view.surface->points.size(), unknown);
    view.shadow.continuousMin = view.shadow.grossMin;
    if (!coarser) return;
    view.daysShown = coarser->view.daysShown;
    for (std::size_t i = 0; i < view.surface->points.size(); ++i) {
        const auto known = coarser->view.pointAt(glm::dvec3(view.surface->points.positions[i]));
        if (!known) continue;
        view.shadow.grossMin[i] = coarser->view.shadow.grossMin[*known];
        view.shadow.continuousMin[i] = coarser->view.shadow.continuousMin[*known];
    }
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

Result<ViewAnswer> withMore(ViewAnswer answer, const ViewQuestion& question, const SurfaceEngine& engine,
                            Progress& progress, std::stop_token stop) {
    ExploredView& view = answer.view;
    const Turn turn = nextTurn(answer, *answer.sun, engine.inParts);
    const auto shadow = engine.accumulator->accumulate(
        question.city->city(), pointsOf(view.surface->points, turn),
        scatteredDays(*answer.sun, view.daysDone, turn.days), progress, std::move(stop));
    if (!shadow) return tl::make_unexpected(shadow.error());
    join(view, turn, *shadow);
    count(view, turn);
    return answer;
}

Result<ViewAnswer> atLevel(int level, const ViewQuestion& question, const ViewAnswer* coarser,
                           const SurfaceEngine& engine, Progress& progress, const std::stop_token& stop) {
    auto sun = sunOf(question, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    ViewAnswer answer;
    answer.level = level;
    answer.sun = *std::move(sun);
    answer.view.days = int(answer.sun->dayCount());
    answer.view.spacingPx = refinementLevels[level].spacingPx;
    answer.view.camera = cameraOf(question.pose, question.lens, answer.view.spacingPx);
    const City& city = question.city->city();
    const auto surface =
        visibleSurface(question.city->picker.scene().value(), !city.terrain, answer.view.camera, stop);
    if (!surface) return tl::make_unexpected(surface.error());
    answer.view.surface =
        std::make_shared<const VisibleSurface>(within(surroundingsOf(*question.city), *surface));
    takeOver(answer.view, coarser);
    return withMore(std::move(answer), question, engine, progress, stop);
}

}  // namespace

Result<ViewAnswer> refined(const ViewQuestion& question, const ViewAnswer* before,
                           const SurfaceEngine& engine, Progress& progress, std::stop_token stop) {
    if (!before) return atLevel(0, question, nullptr, engine, progress, stop);
    if (before->level < finestLevel)
        return atLevel(before->level + 1, question, before, engine, progress, stop);
    return withMore(*before, question, engine, progress, std::move(stop));
}

bool isFinest(const ViewAnswer& answer) {
    return answer.level == finestLevel && answer.view.daysDone == answer.view.days;
}

}  // namespace noonmark
