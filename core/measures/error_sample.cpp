#include "core/measures/error_sample.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "core/engines/common/shadow_reach.h"
#include "core/measures/compared_cells.h"

namespace noonmark {

namespace {

/// Points that fill the unit square evenly, whatever their number.
class EvenPoints {
public:
    explicit EvenPoints(std::uint32_t seed) {
        std::mt19937 random(seed);
        at_ = {double(random()) * 0x1p-32, double(random()) * 0x1p-32};
    }
    glm::dvec2 next() {
        constexpr double plastic = 1.32471795724474602596;  // solves x^3 = x + 1
        at_ = {std::fmod(at_.x + 1 / plastic, 1), std::fmod(at_.y + 1 / (plastic * plastic), 1)};
        return at_;
    }

private:
    glm::dvec2 at_{0};
};

/// Column and row.
glm::ivec2 cellAt(const Grid& grid, glm::dvec2 share) {
    const auto place = [](double s, int count) { return std::min(int(s * count), count - 1); };
    return {place(share.x, grid.columns), place(share.y, grid.rows)};
}

}  // namespace

std::size_t sampleSize(const ErrorSampleSettings& settings, std::size_t steps) {
    const auto wanted = std::uint64_t(std::clamp(settings.receivers, 0, ErrorSampleSettings::maxReceivers));
    const std::uint64_t affordable = ErrorSampleSettings::maxRays / std::max<std::size_t>(1, steps);
    return std::min(wanted, std::max<std::uint64_t>(affordable, ErrorSampleSettings::minReceivers));
}

std::vector<std::uint32_t> spreadReceivers(const Receivers& receivers, std::size_t count,
                                           std::uint32_t seed) {
    if (receivers.cells.size() <= count) return receivers.cells;
    EvenPoints points(seed);
    std::set<std::uint32_t> chosen;
    for (std::size_t tried = 0; tried < 1000 * count && chosen.size() < count; ++tried) {
        const glm::ivec2 at = cellAt(receivers.grid, points.next());
        const std::size_t cell = receivers.grid.index(at.x, at.y);
        if (isReceiver(receivers.kind[cell])) chosen.insert(std::uint32_t(cell));
    }
    return {chosen.begin(), chosen.end()};
}

std::vector<std::uint32_t> spreadReceivers(const Receivers& piece, const Grid& whole, std::size_t points,
                                           std::uint32_t seed) {
    const Grid& grid = piece.grid;
    const int west = int(std::lround((grid.westM - whole.westM) / whole.cellM));
    const int south = int(std::lround((grid.southM - whole.southM) / whole.cellM));
    EvenPoints places(seed);
    std::set<std::uint32_t> chosen;
    for (std::size_t i = 0; i < points; ++i) {
        const glm::ivec2 at = cellAt(whole, places.next()) - glm::ivec2(west, south);
        if (at.x < 0 || at.y < 0 || at.x >= grid.columns || at.y >= grid.rows) continue;
        const std::size_t cell = grid.index(at.x, at.y);
        if (isReceiver(piece.kind[cell])) chosen.insert(std::uint32_t(cell));
    }
    return {chosen.begin(), chosen.end()};
}

Receivers onlyReceivers(const Receivers& receivers, std::vector<std::uint32_t> cells) {
    Receivers some{receivers.grid, receivers.kind, receivers.groundM, std::move(cells)};
    std::ranges::replace_if(some.kind, isReceiver, CellKind::outside);
    for (const std::uint32_t cell : some.cells) some.kind[cell] = receivers.kind[cell];
    return some;
}

Result<std::vector<ComparedCell>> compareWithReference(const City& city, const Receivers& receivers,
                                                       const SunSteps& sun, const ShadowField& field,
                                                       std::vector<std::uint32_t> cells, Progress& progress,
                                                       std::stop_token stop) {
    const Receivers sample = onlyReceivers(receivers, std::move(cells));
    if (stop.stop_requested()) return cancelled();
    return RayScene::over(city, findBuildingsInReach(city, sample, sun), stop)
        .and_then([&](const RayScene& scene) {
            return compareByRays(scene, sample, sun, field, sample.cells, progress, stop);
        });
}

double longestDayMinutes(const SunSteps& sun) {
    std::uint32_t steps = 0;
    for (const SunDay& day : sun.days) steps = std::max(steps, day.count);
    return steps * sun.stepMinutes;
}

Result<SampledError> sampleError(const City& city, const Receivers& receivers, const SunSteps& sun,
                                 const ShadowField& field, const ErrorSampleSettings& settings,
                                 Progress& progress, std::stop_token stop) {
    auto cells = spreadReceivers(receivers, sampleSize(settings, sun.steps.size()), settings.seed);
    return compareWithReference(city, receivers, sun, field, std::move(cells), progress, std::move(stop))
        .map([&](const std::vector<ComparedCell>& pairs) {
            SampledError error = errorOf(pairs, field.sunlitMinutesPerDay, longestDayMinutes(sun));
            error.ofReceivers = receivers.cells.size();
            error.rays = std::uint64_t(pairs.size()) * sun.steps.size();
            return error;
        });
}

Result<void> takeError(const Result<SampledError>& measured, std::optional<SampledError>& error,
                       Warnings& warnings) {
    if (measured) {
        error = *measured;
        return {};
    }
    if (isCancelled(measured.error())) return tl::make_unexpected(measured.error());
    warnings.push_back(
        {WarningKind::leftOut, "the error against the ray reference", measured.error().text()});
    return {};
}

}  // namespace noonmark
