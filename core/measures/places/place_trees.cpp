#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

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

/// By step, with trees as evergreens and with their seasons.
struct AddedSteps {
    explicit AddedSteps(std::size_t steps) : evergreen(steps), seasonal(steps) {}
    std::vector<AddedAreas> evergreen, seasonal;
};

/// The crowns of one city around one cell after the other.
class CrownsOverCell {
public:
    explicit CrownsOverCell(const CrownScene& scene) : scene_(scene), all_(scene.crowns.size()) {
        std::iota(all_.begin(), all_.end(), 0U);
    }
    bool begin(glm::dvec3 origin, double lowestTan) {
        origin_ = origin;
        return around_.gather(scene_.crowns, all_, origin, lowestTan);
    }
    struct Taken {
        double evergreen = 0, seasonal = 0;  // shares of the sun
    };
    [[nodiscard]] Taken at(std::size_t step, glm::dvec3 direction) const {
        double inLeaf = 0, bare = 0;  // optical depths
        const std::size_t phase = scene_.phases.at(step);
        for (const std::uint32_t index : around_.at(CrownsAround::slotOf(direction))) {
            const Crown& crown = scene_.crowns[index];
            const double chord = computeChord(crown, origin_, direction);
            inLeaf += chord * crown.leafOnPerM;
            bare += chord * scene_.phases.perM(phase, crown);
        }
        return {-std::expm1(-inLeaf), -std::expm1(-(scene_.inLeaf[step] != 0 ? inLeaf : bare))};
    }

private:
    const CrownScene& scene_;
    std::vector<std::uint32_t> all_;
    CrownsAround around_;
    glm::dvec3 origin_{};
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

DayTimeline addAreas(const DayTimeline& without, const std::vector<AddedAreas>& added) {
    DayTimeline day{.day = without.day,
                    .areaM2 = without.areaM2,
                    .sunlitMinutes = without.sunlitMinutes,
                    .stepMinutes = without.stepMinutes,
                    .steps = without.steps};
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

PlaceTrees::Shaded PlaceTrees::shade(std::size_t place, std::size_t day, const PlaceShadow& shadow,
                                     const DayTimeline& without, const std::stop_token& stop) const {
    constexpr std::size_t cellsTogether = 256;
    const std::size_t steps = shadow.steps.size(), first = sun_.days[day].first;
    const std::vector<double> areas = listAreas(shadow);
    const std::size_t chunks = (areas.size() + cellsTogether - 1) / cellsTogether;
    std::vector<AddedSteps> ofChunk(chunks, AddedSteps(steps));
    tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t chunk) {
        const FlushDenormals flush;
        CrownsOverCell before(before_), after(differ_ ? after_ : before_);
        AddedSteps& added = ofChunk[chunk];
        const std::size_t end = std::min(areas.size(), (chunk + 1) * cellsTogether);
        for (std::size_t cell = chunk * cellsTogether; cell < end && !stop.stop_requested(); ++cell) {
            const std::uint32_t index = places_.receivers.cells[places_.receiverOf(place, cell)];
            const glm::dvec3 origin(placeRayOrigin(places_.receivers.position(index)));
            const bool hasBefore = before.begin(origin, lowestTan_);
            const bool hasAfter = differ_ ? after.begin(origin, lowestTan_) : hasBefore;
            for (std::size_t step = 0; (hasBefore || hasAfter) && step < steps; ++step) {
                const bool wasDark = shadow.baseline.shaded(step, cell),
                           isDark = shadow.scenario.shaded(step, cell);
                if (wasDark && isDark) continue;
                const glm::dvec3 direction = directions_[first + step];
                const auto one = before.at(first + step, direction);
                const auto other = differ_ ? after.at(first + step, direction) : one;
                const double dark = wasDark ? 1 : 0, darkAfter = isDark ? 1 : 0;
                added.evergreen[step].add(dark, darkAfter, wasDark ? 1 : one.evergreen,
                                          isDark ? 1 : other.evergreen, areas[cell]);
                added.seasonal[step].add(dark, darkAfter, wasDark ? 1 : one.seasonal,
                                         isDark ? 1 : other.seasonal, areas[cell]);
            }
        }
    });
    AddedSteps all(steps);
    for (const AddedSteps& one : ofChunk)
        for (std::size_t step = 0; step < steps; ++step) {
            all.evergreen[step].add(one.evergreen[step]);
            all.seasonal[step].add(one.seasonal[step]);
        }
    return {addAreas(without, all.evergreen), addAreas(without, all.seasonal)};
}

}  // namespace noonmark
