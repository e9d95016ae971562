#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/engines/ray/ray_reference.h"
#include "core/engines/trees/crowns_around.h"
#include "core/measures/places/place_run.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

namespace {

/// What is added at one step to the areas without trees, m2.
struct AddedAreas {
    double baseline = 0, scenario = 0, incremental = 0, gained = 0;

    // Of a cell: shares of the sun that are taken, without trees and with them.
    void add(double before, double after, double beforeWith, double afterWith, double areaM2) {
        baseline += (beforeWith - before) * areaM2;
        scenario += (afterWith - after) * areaM2;
        incremental += (std::max(0.0, afterWith - beforeWith) - std::max(0.0, after - before)) * areaM2;
        gained += (std::max(0.0, beforeWith - afterWith) - std::max(0.0, before - after)) * areaM2;
    }
    void add(const AddedAreas& more) {
        baseline += more.baseline;
        scenario += more.scenario;
        incremental += more.incremental;
        gained += more.gained;
    }
};

std::vector<double> listAreas(const PlaceShadow& shadow) {
    std::vector<double> areas(shadow.baseline.receivers, shadow.cellAreaM2);
    for (const WeightedCell& cell : shadow.uneven) areas[cell.bit] += cell.extra * shadow.cellAreaM2;
    return areas;
}

void addKind(ShadowOnPlace& kind, double areaM2, Instant at, double stepMinutes) {
    kind.areaHoursM2 += areaM2 * stepMinutes / 60;
    if (areaM2 <= kind.largestM2) return;
    kind.largestM2 = areaM2;
    kind.largestAt = at;
}

void clearAreas(ShadowOnPlace& kind) {
    kind.areaHoursM2 = kind.largestM2 = 0;
    kind.largestAt.reset();
}

// `day`: that of the steps at which crowns count as shadow.
DayTimeline setAreas(DayTimeline day, const DayTimeline& without, const std::vector<AddedAreas>& added) {
    day.steps = without.steps;
    for (ShadowOnPlace* kind : {&day.baseline, &day.scenario, &day.incremental, &day.gained})
        clearAreas(*kind);
    for (std::size_t i = 0; i < day.steps.size(); ++i) {
        PlaceStep& step = day.steps[i];
        step.baselineM2 += added[i].baseline;
        step.scenarioM2 += added[i].scenario;
        step.incrementalM2 = std::max(0.0, step.incrementalM2 + added[i].incremental);
        step.gainedM2 = std::max(0.0, step.gainedM2 + added[i].gained);
        addKind(day.baseline, step.baselineM2, step.at, day.stepMinutes);
        addKind(day.scenario, step.scenarioM2, step.at, day.stepMinutes);
        addKind(day.incremental, step.incrementalM2, step.at, day.stepMinutes);
        addKind(day.gained, step.gainedM2, step.at, day.stepMinutes);
    }
    return day;
}

}  // namespace

PlaceTrees::PlaceTrees(const City& baseline, const City* scenario, const PlaceReceivers& places,
                       const SunSteps& sun)
    : places_(places),
      sun_(sun),
      before_(findCrowns(baseline, places.receivers, sun)),
      differ_(scenario != nullptr && scenario->trees != baseline.trees) {
    if (differ_) after_ = findCrowns(*scenario, places.receivers, sun);
    for (CrownScene* scene : {&before_, &after_})
        if (scene->empty()) scene->inLeaf.assign(sun.steps.size(), 0);
    for (const SunStep& step : sun.steps) {
        directions_.push_back(glm::normalize(glm::dvec3(step.direction)));
        const glm::dvec3& towards = directions_.back();
        lowestTan_ = std::min(lowestTan_, towards.z / std::hypot(towards.x, towards.y));
    }
}

std::size_t PlaceTrees::treesUsed() const { return std::max(before_.crowns.size(), after_.crowns.size()); }

namespace {

/// What crowns of one column add to a place on a day: areas by step, and shadow from
/// TreeShade::defaultShadedFrom on.
struct ShadedDay {
    explicit ShadedDay(const PlaceShadow& without) : shadow(without), added(without.steps.size()) {}
    PlaceShadow shadow;
    std::vector<AddedAreas> added;
};

struct CellAtStep {
    std::size_t step, cell;
    bool wasDark, isDark;
    double areaM2;
};

// `before`, `after`: shares that crowns take. Cells of one word of the masks belong to one task.
void addCell(const CellAtStep& at, double before, double after, ShadedDay& day, AddedAreas& added) {
    added.add(at.wasDark ? 1 : 0, at.isDark ? 1 : 0, at.wasDark ? 1 : before, at.isDark ? 1 : after,
              at.areaM2);
    if (before >= TreeShade::defaultShadedFrom) day.shadow.baseline.shade(at.step, at.cell);
    if (after >= TreeShade::defaultShadedFrom) day.shadow.scenario.shade(at.step, at.cell);
}

using ByStep = std::vector<AddedAreas>;

void addChunks(const std::vector<ByStep>& chunks, ByStep& sum) {
    for (const ByStep& one : chunks)
        for (std::size_t step = 0; step < one.size(); ++step) sum[step].add(one[step]);
}

}  // namespace

PlaceTrees::Shaded PlaceTrees::shade(std::size_t place, std::size_t day, const PlaceShadow& shadow,
                                     const DayTimeline& without, const TimelineSettings& settings,
                                     const std::stop_token& stop) const {
    constexpr std::size_t cellsTogether = 256;
    static_assert(cellsTogether % 64 == 0);
    const std::size_t steps = shadow.steps.size(), first = sun_.days[day].first;
    const std::vector<double> areas = listAreas(shadow);
    const std::size_t chunks = (areas.size() + cellsTogether - 1) / cellsTogether;
    ShadedDay evergreen(shadow), seasonal(shadow);
    std::vector<ByStep> ofEvergreens(chunks, ByStep(steps)), ofSeasons = ofEvergreens;
    tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t chunk) {
        const FlushDenormals flush;
        CrownsOverPlace before(before_), after(differ_ ? after_ : before_);
        const std::size_t end = std::min(areas.size(), (chunk + 1) * cellsTogether);
        for (std::size_t cell = chunk * cellsTogether; cell < end && !stop.stop_requested(); ++cell) {
            const std::uint32_t index = places_.receivers.cells[places_.receiverOf(place, cell)];
            const glm::dvec3 origin(placeRayOrigin(places_.receivers.position(index)));
            const bool hasBefore = before.begin(origin, lowestTan_);
            const bool hasAfter = differ_ ? after.begin(origin, lowestTan_) : hasBefore;
            for (std::size_t step = 0; (hasBefore || hasAfter) && step < steps; ++step) {
                const CellAtStep at{step, cell, shadow.baseline.shaded(step, cell),
                                    shadow.scenario.shaded(step, cell), areas[cell]};
                if (at.wasDark && at.isDark) continue;
                const glm::dvec3 direction = directions_[first + step];
                const auto one = before.at(first + step, direction);
                const auto other = differ_ ? after.at(first + step, direction) : one;
                addCell(at, one.evergreen, other.evergreen, evergreen, ofEvergreens[chunk][step]);
                addCell(at, one.seasonal, other.seasonal, seasonal, ofSeasons[chunk][step]);
            }
        }
    });
    addChunks(ofEvergreens, evergreen.added);
    addChunks(ofSeasons, seasonal.added);
    const auto timelineOf = [&](const ShadedDay& shaded) {
        return setAreas(computeTimeline(shaded.shadow, settings), without, shaded.added);
    };
    return {timelineOf(evergreen), timelineOf(seasonal)};
}

}  // namespace noonmark
