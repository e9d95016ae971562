#include "scenarios/impact/impact_error.h"

#include "core/base/progress_share.h"

namespace noonmark {

namespace {

ComparedCell changeOf(const ComparedCell& before, const ComparedCell& after) {
    return {.centreM = after.centreM,
            .grossMin = after.grossMin - before.grossMin,
            .referenceGrossMin = after.referenceGrossMin - before.referenceGrossMin,
            .continuousMin = after.continuousMin - before.continuousMin,
            .referenceContinuousMin = after.referenceContinuousMin - before.referenceContinuousMin};
}

}  // namespace

Result<SampledError> measureChangeError(const CityField& before, const CityField& after,
                                        const Receivers& receivers, const SunSteps& sun,
                                        const ErrorSampleSettings& settings, Progress& progress,
                                        const std::stop_token& stop) {
    const std::vector<std::uint32_t> cells =
        spreadReceivers(receivers, sampleSize(settings, 2 * sun.steps.size()), settings.seed);
    std::vector<ComparedCell> changes[2];
    for (int i = 0; i < 2; ++i) {
        const auto& [city, field] = i == 0 ? before : after;
        ProgressShare share(progress, std::size_t(i), 2);
        auto compared = compareWithReference(city, receivers, sun, field, cells, share, stop);
        if (!compared) return tl::make_unexpected(compared.error());
        changes[i] = *std::move(compared);
    }
    for (std::size_t i = 0; i < cells.size(); ++i) changes[1][i] = changeOf(changes[0][i], changes[1][i]);
    SampledError error = errorOf(changes[1], after.field.sunlitMinutesPerDay, longestDayMinutes(sun));
    error.ofReceivers = receivers.cells.size();
    error.rays = 2 * cells.size() * sun.steps.size();
    return error;
}

}  // namespace noonmark
