#include "core/measures/compared_cells.h"

#include "core/base/progress_share.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/ray/ray_minutes.h"
#include "core/measures/error_sample.h"

namespace noonmark {

namespace {

/// Labels the progress of the reference and hides its partial results from viewers.
class SampleProgress final : public Progress {
public:
    explicit SampleProgress(Progress& progress) : progress_(progress) {}
    void report(double fraction, std::string_view) override {
        progress_.report(fraction, "measuring the error on a sample");
    }

private:
    Progress& progress_;
};

// The field's minutes are floats, so the reference's are rounded to float too.
ComparedCell compareCell(const ShadowField& field, std::uint32_t cell, const PointMinutes& truth) {
    const auto columns = std::uint32_t(field.grid.columns);
    return {field.grid.centre(int(cell % columns), int(cell / columns)), field.grossMin[cell],
            float(truth.gross), field.continuousMin[cell], float(truth.continuous)};
}

}  // namespace

Result<std::vector<ComparedCell>> compareByRays(const RayScene& scene, const Receivers& receivers,
                                                const SunSteps& sun, const ShadowField& field,
                                                std::span<const std::uint32_t> cells, Progress& progress,
                                                const std::stop_token& stop) {
    std::vector<glm::vec3> places;
    for (const std::uint32_t cell : cells) places.push_back(receivers.position(cell));
    SampleProgress sampling(progress);
    return traceMinutesAt(scene, places, sun, sampling, stop)
        .map([&](const std::vector<PointMinutes>& truths) {
            std::vector<ComparedCell> pairs;
            for (std::size_t i = 0; i < cells.size(); ++i)
                pairs.push_back(compareCell(field, cells[i], truths[i]));
            return pairs;
        });
}

namespace {

std::vector<glm::vec3> positionsOf(const Receivers& receivers, const std::vector<std::uint32_t>& cells) {
    std::vector<glm::vec3> places;
    for (const std::uint32_t cell : cells) places.push_back(receivers.position(cell));
    return places;
}

Result<RayScene> sceneAround(const City& city, const Receivers& sample, const SunSteps& sun,
                             const std::stop_token& stop) {
    if (stop.stop_requested()) return cancelled();
    return RayScene::over(city, findBuildingsInReach(city, sample, sun), stop);
}

}  // namespace

Result<std::vector<std::vector<double>>> traceSets(const City& city, const Receivers& receivers,
                                                   const SunSteps& sun, const StepSets& sets,
                                                   const std::vector<std::uint32_t>& cells,
                                                   Progress& progress, const std::stop_token& stop) {
    const Receivers sample = onlyReceivers(receivers, cells);
    const auto scene = sceneAround(city, sample, sun, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    const std::vector<glm::vec3> places = positionsOf(sample, cells);
    std::vector<std::vector<double>> minutes;
    for (std::size_t set = 0; set < sets.names.size(); ++set) {
        const SunSteps steps = sets.stepsOf(set, sun);
        ProgressShare share(progress, set, sets.names.size());
        SampleProgress sampling(share);
        auto truths = traceMinutesAt(*scene, places, steps, sampling, stop);
        if (!truths) return tl::make_unexpected(truths.error());
        auto& ofSet = minutes.emplace_back();
        for (const PointMinutes& truth : *truths) ofSet.push_back(truth.gross * double(steps.dayCount()));
    }
    return minutes;
}

std::vector<std::vector<double>> minutesAt(const ShadowBreakdown& sums,
                                           const std::vector<std::uint32_t>& cells) {
    std::vector<std::vector<double>> some(sums.minutes.size());
    for (const std::uint32_t cell : cells) {
        const std::size_t receiver = findReceiver(sums, cell);
        for (std::size_t set = 0; set < some.size(); ++set)
            some[set].push_back(double(sums.minutes[set][receiver]));
    }
    return some;
}

Result<ComparedSets> compareSets(const City& city, const Receivers& receivers, const SunSteps& sun,
                                 const ShadowBreakdown& sums, const std::vector<std::uint32_t>& cells,
                                 Progress& progress, const std::stop_token& stop) {
    return traceSets(city, receivers, sun, sums.sets, cells, progress, stop)
        .map([&](std::vector<std::vector<double>>&& reference) {
            return ComparedSets{minutesAt(sums, cells), std::move(reference)};
        });
}

}  // namespace noonmark
