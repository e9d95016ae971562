#include "core/study/study_cost.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/cgroup_limits.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

// Kind 1, ground 4, list of receivers 4, gross and continuous 8; and the same again while a map is drawn.
constexpr double bytesPerCell = 32;
// Vertices and indices take 36; the rest is their copy in the acceleration structure and its nodes; measured
// with Embree 3.
constexpr double bytesPerTriangle = 250;
constexpr double bytesPerStep = 2 * sizeof(SunStep);

double cellCount(const StudySettings& settings) {
    const Box2 box = bounds(settings.region);
    if (box.empty()) return 0;
    const glm::dvec2 cells = glm::dvec2(box.high - box.low) / settings.receivers.cellM;
    return std::ceil(cells.x) * std::ceil(cells.y);
}

double estimatedTriangles(const Part& part) {
    if (part.mesh) return double(part.mesh->triangles.size());
    std::size_t points = part.footprint.outer.size();
    for (const Ring& hole : part.footprint.holes) points += hole.size();
    return 4 * double(points);  // two per wall, about one per point in each cap
}

double countTriangles(const City& city) {
    double count = city.terrain ? 2 * double(city.terrain->grid.size()) : 0;
    for (const auto& building : city.buildings)
        for (const Part& part : building->parts) count += estimatedTriangles(part);
    return count;
}

double stepCount(const Period& period) {
    const double hours = period.window ? 24 : period.hours;
    return period.days * std::max(1.0, hours * 60 / period.stepMinutes);
}

double engineBytesPerCell(const EngineList& engines, const std::string& key) {
    const EngineEntry* engine = findEngine(engines, key);
    return engine == nullptr ? 0 : engine->info.bytesPerCell;
}

double gigabytes(std::uint64_t bytes) { return double(bytes) * 1e-9; }

}  // namespace

std::uint64_t estimateMemory(const City& city, const StudySettings& settings, const EngineList& engines) {
    const double bytes = cellCount(settings) * (bytesPerCell + engineBytesPerCell(engines, settings.engine)) +
                         countTriangles(city) * bytesPerTriangle + stepCount(settings.period) * bytesPerStep;
    constexpr double maximum = double(std::numeric_limits<std::int64_t>::max());
    return bytes < maximum ? std::uint64_t(bytes) : std::uint64_t(maximum);
}

Result<void> checkMemory(const City& city, const StudySettings& settings, const EngineList& engines) {
    std::uint64_t limit = settings.memoryLimit;
    if (limit == 0)
        limit = measureAvailableMemory().value_or(std::numeric_limits<std::uint64_t>::max()) / 4 * 3;
    const std::uint64_t need = estimateMemory(city, settings, engines);
    if (need <= limit) return {};
    return failure(fmt::format("The study would need {:.2f} GB of memory; {:.2f} GB may be used",
                               gigabytes(need), gigabytes(limit)),
                   "", NM_TEXT("Choose larger cells, a smaller region or fewer steps"));
}

std::string describeDuration(double seconds) {
    if (seconds < 100) return fmt::format("about {:.0f} s", std::max(1.0, std::round(seconds)));
    if (seconds < 100 * 60) return fmt::format("about {:.0f} min", std::round(seconds / 60));
    return fmt::format("about {:.1f} h", seconds / 3600);
}

std::string describeRemaining(double seconds) {
    if (seconds < 100)
        return fmt::format("about {:.0f} s left", std::max(10.0, std::ceil(seconds / 10) * 10));
    if (seconds < 100 * 60) return fmt::format("about {:.0f} min left", std::ceil(seconds / 60));
    return fmt::format("about {:.1f} h left", seconds / 3600);
}

void PiecewiseProgress::begin(std::string name, double size) {
    name_ = std::move(name);
    size_ = size;
}

void PiecewiseProgress::end() { done_ += std::exchange(size_, 0); }

void PiecewiseProgress::report(double fraction, std::string_view stage) {
    const double here = done_ + std::clamp(fraction, 0.0, 1.0) * size_;
    const double left = whole_ - before_ - here;
    // The first seconds do not show the speed.
    const std::string time = here > 0 && watch_.seconds() > 2
                                 ? ", " + describeRemaining(watch_.seconds() / here * left)
                                 : std::string();
    progress_.report((before_ + here) / whole_, fmt::format("{}{}: {}", name_, time, stage));
}

namespace {

std::string enginesThatSum(bool byBuilding, const EngineList& engines) {
    std::vector<std::string_view> keys;
    for (const EngineEntry& engine : engines)
        if (byBuilding ? engine.info.capabilities.attribution : engine.info.capabilities.sets)
            keys.push_back(engine.info.key);
    return fmt::format("{}", fmt::join(keys, ", "));
}

}  // namespace

Result<void> checkBreakdown(const StudySettings& settings, const EngineCapabilities& able,
                            const EngineList& engines) {
    const bool byBuilding = settings.contributions;
    const bool wanted = settings.byMonth || byBuilding;
    if (!wanted || (byBuilding ? able.attribution : able.sets)) return {};
    return unsupported(fmt::format("The engine '{}' does not sum shadow by {}", settings.engine,
                                   byBuilding ? "building" : "month"),
                       "engine", fmt::format("Choose one of: {}", enginesThatSum(byBuilding, engines)));
}

}  // namespace noonmark
