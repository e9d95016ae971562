#include "app/gui/view/exploration/view_turn.h"

#include <algorithm>
#include <cmath>

#include "core/engines/common/scattered_order.h"
#include "core/sun/chosen_days.h"

namespace noonmark {

namespace {

constexpr double coarseTests = 1e7;

ViewTurn countTurn(ViewTurn turn, const SunSteps& sun) {
    turn.tests = double(turn.points) * turn.days * stepsADay(sun);
    return turn;
}

double meanOver(double a, int daysOfA, double b, int daysOfB) {
    return b + (a - b) * (double(daysOfA) / (daysOfA + daysOfB));
}

void joinValues(SurfaceShadow& shadow, const ViewTurn& turn, int daysBefore, const SurfaceShadow& found) {
    for (std::size_t i = 0; i < turn.points; ++i) {
        float& gross = shadow.grossMin[turn.firstPoint + i];
        float& longest = shadow.continuousMin[turn.firstPoint + i];
        gross = daysBefore == 0
                    ? found.grossMin[i]
                    : float(meanOver(double(gross), daysBefore, double(found.grossMin[i]), turn.days));
        longest = daysBefore == 0 ? found.continuousMin[i] : std::max(longest, found.continuousMin[i]);
    }
}

void count(ExploredView& view, const ViewTurn& turn) {
    view.pointsDone = turn.firstPoint + turn.points;
    if (view.pointsDone < view.surface->points.size()) {
        view.daysShown = std::clamp(view.daysShown, 0, std::max(turn.days, view.daysDone));
        return;
    }
    view.pointsDone = 0;
    view.daysDone += turn.days;
    view.daysShown = view.daysDone;
}

}  // namespace

double stepsADay(const SunSteps& sun) {
    return std::max(1.0, double(sun.steps.size()) / double(std::max<std::size_t>(1, sun.dayCount())));
}

int coarseDays(std::size_t points, const SunSteps& sun) {
    const double days = coarseTests / (stepsADay(sun) * std::max(1.0, double(points)));
    return int(std::clamp(days, 1.0, double(sun.dayCount())));
}

ViewTurn nextTurn(const ExploredView& view, const WantedDays& wanted, const SunSteps& sun, double maxTests) {
    const std::size_t all = view.surface->points.size();
    const int days = view.daysDone == 0 ? wanted.first : 1;
    const double pointDays = maxTests / stepsADay(sun);
    const double whole = std::floor(pointDays / std::max(1.0, double(all)));
    if (view.pointsDone == 0 && whole >= days)
        return countTurn({0, all, int(std::min(whole, double(wanted.all - view.daysDone)))}, sun);
    const auto some = std::size_t(std::max(1.0, pointDays / days));
    return countTurn({view.pointsDone, std::min(all - view.pointsDone, some), days}, sun);
}

ViewTurn allTheRest(const ExploredView& view, int days, const SunSteps& sun) {
    return countTurn({0, view.surface->points.size(), days - view.daysDone}, sun);
}

SurfacePoints pointsOf(const SurfacePoints& all, const ViewTurn& turn) {
    if (turn.points == all.size()) return all;
    const auto some = [&turn](const std::vector<glm::vec3>& values) {
        const auto first = values.begin() + std::ptrdiff_t(turn.firstPoint);
        return std::vector<glm::vec3>(first, first + std::ptrdiff_t(turn.points));
    };
    return {some(all.positions), some(all.normals), all.eye};
}

SunSteps daysOf(const SunSteps& sun, int first, int count) {
    const std::size_t all = sun.dayCount();
    const std::size_t stride = chooseScatteringStride(all);
    std::vector<std::size_t> days;
    for (int k = first; k < first + count; ++k) days.push_back(std::size_t(k) * stride % all);
    return chooseDays(sun, days);
}

void join(ExploredView& view, const ViewTurn& turn, const SurfaceShadow& found) {
    const int before = view.daysDone;
    joinValues(view.shadow, turn, before, found);
    if (turn.firstPoint == 0) {
        view.shadow.sunlitMinutesPerDay = before == 0 ? found.sunlitMinutesPerDay
                                                      : meanOver(view.shadow.sunlitMinutesPerDay, before,
                                                                 found.sunlitMinutesPerDay, turn.days);
        view.shadow.engine = found.engine;
    }
    count(view, turn);
}

}  // namespace noonmark
