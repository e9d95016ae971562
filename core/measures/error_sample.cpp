#include "core/measures/error_sample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <utility>

#include "core/describe/text.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/ray/surface_rays.h"

namespace noonmark {

namespace {

double standardErrorOf(std::span<const double> values, double mean) {
    const auto count = double(values.size());
    if (count < 2) return mean;  // one value says nothing of its spread
    double squares = 0;
    for (const double value : values) squares += std::pow(value - mean, 2);
    return std::sqrt(squares / (count - 1) / count);
}

template <class Difference>
CellError cellErrorOf(std::span<const ComparedCell> cells, double wholeMin, const Difference& difference) {
    CellError error{.wholeMin = wholeMin};
    std::vector<double> off;
    for (const ComparedCell& cell : cells) {
        off.push_back(std::abs(difference(cell)));
        error.meanMin += off.back() / double(cells.size());
        if (off.size() > 1 && off.back() <= error.maxMin) continue;
        error.maxMin = off.back();
        error.worstM = cell.centreM;
    }
    if (off.empty()) return error;
    error.meanStandardErrorMin = standardErrorOf(off, error.meanMin);
    const auto rank = std::size_t(std::ceil(0.99 * double(off.size()))) - 1;  // nearest rank
    std::ranges::nth_element(off, off.begin() + std::ptrdiff_t(rank));
    error.p99Min = off[rank];
    return error;
}

double grossDifference(const ComparedCell& cell) { return cell.grossMin - cell.referenceGrossMin; }

double continuousDifference(const ComparedCell& cell) {
    return cell.continuousMin - cell.referenceContinuousMin;
}

CellError continuousErrorOf(std::span<const ComparedCell> cells, double longestDayMin) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    if (std::ranges::any_of(cells, [](const ComparedCell& cell) { return std::isnan(cell.continuousMin); }))
        return {.meanMin = unknown, .p99Min = unknown, .maxMin = unknown, .wholeMin = longestDayMin};
    return cellErrorOf(cells, longestDayMin, continuousDifference);
}

// Cells are of equal size: the error of the area is the mean of the cells' errors.
void addArea(SampledError& error, std::span<const ComparedCell> cells) {
    const auto count = double(cells.size());
    double mean = 0;
    std::vector<double> off;
    for (const ComparedCell& cell : cells) off.push_back(grossDifference(cell));
    for (const double difference : off) mean += difference / count;
    error.areaPct = error.gross.percent(mean);
    if (cells.size() > 1) error.areaStandardErrorPct = error.gross.percent(standardErrorOf(off, mean));
}

}  // namespace

SampledError errorOf(std::span<const ComparedCell> cells, double sunlitMinutesPerDay, double longestDayMin) {
    SampledError error{.receivers = cells.size()};
    error.gross = cellErrorOf(cells, sunlitMinutesPerDay, grossDifference);
    error.continuous = continuousErrorOf(cells, longestDayMin);
    addArea(error, cells);
    return error;
}

namespace {

/// Labels the progress of the reference and hides its partial results from viewers.
class SampleProgress final : public Progress {
public:
    explicit SampleProgress(Progress& progress) : progress_(progress) {}
    void report(double fraction, std::string_view) override {
        progress_.report(fraction, NM_TEXT("measuring the error on a sample"));
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
