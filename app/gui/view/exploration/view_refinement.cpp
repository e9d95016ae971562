#include "app/gui/view/exploration/view_refinement.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/base/progress.h"
#include "core/engines/common/receiver_tiles.h"

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

namespace {

constexpr float surroundingsM = 100;
constexpr int finestLevel = int(std::size(refinementSpacingsPx)) - 1;
constexpr double coarserSamples = 0.25;  // share of the next level's samples
constexpr double turnSeconds = 0.12;     // half the time of a picture at five pictures per second

Result<std::shared_ptr<const SunSteps>> sunOf(const ViewQuestion& question, const std::stop_token& stop) {
    if (question.sun) return question.sun;
    const auto period = validate(question.period);
    if (!period) return tl::make_unexpected(period.error());
    auto sun = computeDaylightSteps(question.period, question.observer, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    return std::make_shared<const SunSteps>(*std::move(sun));
}

void clearResults(ExploredView& view) {
    view.shadow.grossMin.assign(view.surface->points.size(), std::numeric_limits<float>::quiet_NaN());
    view.shadow.continuousMin = view.shadow.grossMin;
}

// Gives the points of a finer view the values of the coarser one.
void updateBuildings(ViewAnswer& answer, const ViewAnswer& coarser) {
    ExploredView& view = answer.view;
    clearResults(view);
    view.daysShown = coarser.view.daysShown;
    view.shadow.sunlitMinutesPerDay = coarser.view.shadow.sunlitMinutesPerDay;
    StepsAround around{coarser.steps, std::vector(view.surface->points.size(), StepsAround::none)};
    for (std::size_t i = 0; i < view.surface->points.size(); ++i) {
        const auto known = coarser.view.pointAt(glm::dvec3(view.surface->points.positions[i]));
        if (!known) continue;
        view.shadow.grossMin[i] = coarser.view.shadow.grossMin[*known];
        view.shadow.continuousMin[i] = coarser.view.shadow.continuousMin[*known];
        around.nearest[i] = std::uint32_t(*known);
    }
    if (coarser.steps) answer.around = std::make_shared<const StepsAround>(std::move(around));
}

// Leaves out the ground beyond the city: its surroundings are not known, and it would wrongly appear sunlit.
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
    const Box2 box = city.arrays->bounds.box;
    return {box.low - glm::vec2(surroundingsM), box.high + glm::vec2(surroundingsM)};
}

WantedDays wantedDays(const ViewAnswer& answer) {
    return {answer.coarseDays, answer.level == finestLevel ? answer.view.days : answer.coarseDays};
}

ViewTurn chooseTurn(const ViewAnswer& answer, const ViewEngine& engine, double maxTests) {
    // The first picture of a view takes all points, so that it has no holes.
    const WantedDays wanted = wantedDays(answer);
    if (!engine.inParts || answer.first) return allTheRest(answer.view, wanted.all, *answer.sun);
    return nextTurn(answer.view, wanted, *answer.sun, maxTests);
}

Result<ViewAnswer> withMore(ViewAnswer answer, const ViewQuestion& question, const ViewEngine& engine,
                            Progress& progress, std::stop_token stop) {
    ExploredView& view = answer.view;
    answer.turn = chooseTurn(answer, engine, question.turnTests);
    const Stopwatch watch;
    EdgeMasks steps;
    const auto shadow = engine.accumulator->accumulate(
        question.city->city(), pointsOf(view.surface->points, answer.turn),
        daysOf(*answer.sun, view.daysDone, answer.turn.days), progress, std::move(stop),
        {answer.around.get(), answer.level < finestLevel ? &steps : nullptr});
    if (!shadow) return tl::make_unexpected(shadow.error());
    answer.turnSeconds = watch.seconds();
    if (!steps.empty()) answer.steps = std::make_shared<const EdgeMasks>(std::move(steps));
    answer.first = false;
    join(view, answer.turn, *shadow);
    answer.around = nullptr;
    return answer;
}

// The camera of a level and its visible points, without shadow values.
Result<ViewAnswer> lookedAt(int level, const ViewQuestion& question, std::shared_ptr<const SunSteps> sun,
                            const std::stop_token& stop) {
    ViewAnswer answer;
    answer.level = level;
    answer.sun = std::move(sun);
    answer.view.days = int(answer.sun->dayCount());
    answer.view.spacingPx = refinementSpacingsPx[level];
    answer.view.camera = makeExploredCamera(question.pose, question.lens, answer.view.spacingPx);
    if (question.section)
        answer.view.camera.section =
            VisibleBox{glm::vec3(question.section->lowM), glm::vec3(question.section->highM)};
    const City& city = question.city->city();
    const auto surface =
        findVisibleSurface(question.city->picker.scene().value(), !city.terrain, answer.view.camera, stop);
    if (!surface) return tl::make_unexpected(surface.error());
    answer.view.surface =
        std::make_shared<const VisibleSurface>(within(surroundingsOf(*question.city), *surface));
    return answer;
}

// The coarsest level is only for views with so many pixels that one day of the second level would take too
// long.
int firstLevel(const ViewQuestion& question, const SunSteps& sun) {
    const PixelCamera camera = makeExploredCamera(question.pose, question.lens, refinementSpacingsPx[1]);
    const double tests = double(camera.widthPx) * camera.heightPx * stepsADay(sun);
    return tests > 3 * std::max(question.turnTests, firstTurnTests) ? 0 : 1;
}

Result<ViewAnswer> firstAnswer(const ViewQuestion& question, const ViewEngine& engine, Progress& progress,
                               const std::stop_token& stop) {
    auto sun = sunOf(question, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    const int level = firstLevel(question, **sun);
    auto answer = lookedAt(level, question, *std::move(sun), stop);
    if (!answer) return answer;
    answer->first = true;
    answer->coarseDays = coarseDays(answer->view.surface->points.size(), *answer->sun);
    clearResults(answer->view);
    return withMore(*std::move(answer), question, engine, progress, stop);
}

Result<ViewAnswer> finerAnswer(const ViewQuestion& question, const ViewAnswer& coarser,
                               const ViewEngine& engine, Progress& progress, const std::stop_token& stop) {
    auto answer = lookedAt(coarser.level + 1, question, coarser.sun, stop);
    if (!answer) return answer;
    answer->coarseDays = coarser.coarseDays;
    updateBuildings(*answer, coarser);
    // An engine that works all at once delivers partial results, which need an answer to build on.
    if (!engine.inParts) return answer;
    return withMore(*std::move(answer), question, engine, progress, stop);
}

// If nothing is known around a point, the rest of its period is not known either.
void take(const std::vector<float>& running, bool onWhatWasKnown, std::vector<float>& shown) {
    for (std::size_t i = 0; i < shown.size(); ++i)
        if (!onWhatWasKnown || !std::isnan(shown[i])) shown[i] = running[i];
}

}  // namespace

double turnTestsAfter(const ViewAnswer& answer) {
    const double asFast = answer.turn.tests * turnSeconds / std::max(answer.turnSeconds, 1e-6);
    return std::clamp(asFast, minTurnTests, 1e10);
}

Result<ViewAnswer> refineView(const ViewQuestion& question, const ViewAnswer* before,
                              const ViewEngine& engine, Progress& progress, std::stop_token stop) {
    if (!before) return firstAnswer(question, engine, progress, stop);
    if (before->level < finestLevel && before->view.daysDone == wantedDays(*before).all)
        return finerAnswer(question, *before, engine, progress, stop);
    return withMore(*before, question, engine, progress, std::move(stop));
}

std::optional<ViewAnswer> withRunning(const ViewAnswer& answer, const PartialField& running) {
    const ExploredView& view = answer.view;
    const bool sameTurn = view.daysDone == 0 && running.field.grossMin.size() == view.surface->points.size();
    const double steps = running.share * view.days, stepsBehind = coarserSamples * view.daysShown;
    if (!sameTurn || (!running.wholePeriod && steps <= stepsBehind)) return std::nullopt;
    ViewAnswer shown = answer;
    take(running.field.grossMin, running.wholePeriod, shown.view.shadow.grossMin);
    take(running.field.continuousMin, running.wholePeriod, shown.view.shadow.continuousMin);
    shown.view.shadow.sunlitMinutesPerDay = running.field.sunlitMinutesPerDay;
    shown.view.running = running.part;
    return shown;
}

bool isFinest(const ViewAnswer& answer) {
    return answer.level == finestLevel && answer.view.daysDone == answer.view.days;
}

}  // namespace noonmark
