#include "core/study/elements/element_sample.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

// The seed is spread over the fractions 0 to 1 by the golden ratio.
std::vector<std::size_t> choosePoints(std::size_t all, std::size_t count, std::uint32_t seed) {
    count = std::min(count, all);
    const double start = std::fmod(seed * 0.6180339887498949, 1.0);
    std::vector<std::size_t> chosen(count);
    for (std::size_t i = 0; i < count; ++i)
        chosen[i] = std::min(all - 1, std::size_t((double(i) + start) * double(all) / double(count)));
    return chosen;
}

SurfacePoints pointsAt(const SurfacePoints& all, const std::vector<std::size_t>& chosen) {
    SurfacePoints points;
    for (const std::size_t i : chosen) {
        points.positions.push_back(all.positions[i]);
        points.normals.push_back(all.normals[i]);
    }
    return points;
}

Result<ElementError> sampleElementError(const ElementStudy& study, Progress& progress,
                                        const std::stop_token& stop) {
    const auto& sample = study.settings.errorSample;
    const auto chosen =
        choosePoints(study.receivers.size(), sampleSize(sample, study.sun.steps.size()), sample.seed);
    const auto truth =
        tracePoints(study.city, pointsAt(study.receivers.points, chosen), study.sun, progress, stop);
    if (!truth) return tl::make_unexpected(truth.error());
    ElementError error{.points = chosen.size(), .rays = truth->cost.rays};
    const double whole = study.minutes.possibleMin / 100, longest = longestDayMinutes(study.sun) / 100;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const double gross = std::abs(study.minutes.sunlitOf(chosen[i]) - truth->sunlitOf(i)) / whole;
        const double run =
            std::abs(double(study.minutes.longestShadowMin[chosen[i]] - truth->longestShadowMin[i])) /
            longest;
        error.grossMeanPct += gross / double(chosen.size());
        error.grossLargestPct = std::max(error.grossLargestPct, gross);
        error.continuousMeanPct += run / double(chosen.size());
        error.continuousLargestPct = std::max(error.continuousLargestPct, run);
    }
    return error;
}

}  // namespace noonmark
