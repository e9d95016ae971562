#include "core/measures/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/describe/shown_as.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"
#include "core/measures/shown_quantity.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

void addCell(ShadowSums& sums, const ShadowField& field, std::size_t cell) {
    const float gross = field.grossMin[cell];
    if (std::isnan(gross)) return;
    const float continuous = field.continuousMin[cell];
    sums.add({1, gross, continuous, gross, continuous});
}

}  // namespace

void ShadowSums::add(const ShadowSums& piece) {
    receivers += piece.receivers;
    grossMin += piece.grossMin;
    continuousMin += piece.continuousMin;
    maxGrossMin = std::max(maxGrossMin, piece.maxGrossMin);
    maxContinuousMin = std::max(maxContinuousMin, piece.maxContinuousMin);
}

ShadowSums computeSums(const ShadowField& field) {
    ShadowSums sums;
    for (std::size_t cell = 0; cell < field.grossMin.size(); ++cell) addCell(sums, field, cell);
    return sums;
}

ShadowStatistics computeStatistics(const ShadowSums& sums, double sunlitMinutesPerDay, double cellAreaM2) {
    if (sums.receivers == 0) return {};
    const auto count = double(sums.receivers);
    ShadowStatistics statistics{.receivers = sums.receivers, .receiverAreaM2 = count * cellAreaM2};
    statistics.meanGrossMin = sums.grossMin / count;
    statistics.meanSunMin = std::max(sunlitMinutesPerDay - statistics.meanGrossMin, 0.0);
    statistics.meanContinuousMin = sums.continuousMin / count;
    statistics.maxGrossMin = sums.maxGrossMin;
    statistics.maxContinuousMin =
        hasRuns(statistics) ? sums.maxContinuousMin : std::numeric_limits<double>::quiet_NaN();
    if (sunlitMinutesPerDay > 0) statistics.shadowAreaM2 = sums.grossMin / sunlitMinutesPerDay * cellAreaM2;
    return statistics;
}

ShadowStatistics computeStatistics(const ShadowField& field) {
    ShadowStatistics statistics =
        computeStatistics(computeSums(field), field.sunlitMinutesPerDay, field.grid.cellAreaM2());
    statistics.waterM2 = findWaterM2(field);
    return statistics;
}

ShadowStatistics computeStatistics(const ShadowField& field, const Region& region) {
    ShadowSums sums;
    for (const std::uint32_t cell : collectCells(region.polygons, field.grid)) addCell(sums, field, cell);
    return computeStatistics(sums, field.sunlitMinutesPerDay, field.grid.cellAreaM2());
}

namespace {

constexpr double maxClasses = 14;

/// Classes of equal width: the first one begins at `first` widths.
struct Classes {
    double width = 1;
    int first = 0;
    std::size_t count = 0;

    [[nodiscard]] std::size_t of(double value) const {
        const double index = std::floor(value / width) - first;
        return std::size_t(std::clamp(index, 0.0, double(count - 1)));
    }
    [[nodiscard]] double limit(std::size_t index) const { return width * double(first + int(index)); }
};

/// A round width: the smallest of `widths`, times ten as often as needed, that makes at most 14 classes.
Classes classify(double low, double high, std::span<const double> widths) {
    for (double scale = 1;; scale *= 10)
        for (const double width : widths) {
            const int first = int(std::floor(low / (width * scale)));
            const int last = std::max(first + 1, int(std::ceil(high / (width * scale))));
            if (last - first <= maxClasses) return {width * scale, first, std::size_t(last - first)};
        }
}

void addGroups(Bars& bars, const Classes& classes, const std::vector<double>& sums, double unit) {
    for (std::size_t i = 0; i < classes.count; ++i)
        bars.groups.push_back({Bars::Class{classes.limit(i) / unit, classes.limit(i + 1) / unit}, {sums[i]}});
}

}  // namespace

Bars makeSunHistogram(std::span<const double> sunMin, double possibleMin, std::string_view title) {
    constexpr std::array widths{15.0, 30.0, 60.0, 120.0};
    Bars bars{.title = title, .groupName = NM_TEXT("hours of sun a day")};
    const Classes classes = classify(0, possibleMin, widths);
    std::vector<double> sums(classes.count);
    double whole = 0;
    for (const double minutes : sunMin)
        if (!std::isnan(minutes)) {
            ++sums[classes.of(minutes)];
            ++whole;
        }
    if (whole == 0 || possibleMin <= 0) return bars;
    for (double& sum : sums) sum *= 100 / whole;
    addGroups(bars, classes, sums, minutesPerHour);
    for (Bars::Group& group : bars.groups) group.tone = BarTone::sun;
    return bars;
}

Bars makeSunHistogram(const ShadowField& field) {
    std::vector<double> sunMin;
    sunMin.reserve(field.grossMin.size());
    for (const float gross : field.grossMin) sunMin.push_back(field.sunlitMinutesPerDay - double(gross));
    return makeSunHistogram(sunMin, field.sunlitMinutesPerDay, NM_TEXT("Share of the area, %"));
}

Bars makeChangeHistogram(std::span<const float> minutes, double cellAreaM2, double noChangeMin,
                         ShownAs show) {
    constexpr std::array widths{1.0, 2.0, 5.0};
    const ShownQuantity quantity{show, 0};
    Bars bars{.title = NM_TEXT("Area that changes, m²"),
              .groupName = quantity.isSun() ? NM_TEXT("minutes of sun a day, more than before")
                                            : NM_TEXT("minutes of shadow a day, more than before")};
    const auto changes = [&](float value) { return std::abs(double(value)) > noChangeMin; };  // not of NaN
    double low = 0, high = 0;
    for (const float value : minutes)
        if (changes(value)) {
            low = std::min(low, quantity.ofChange(double(value)));
            high = std::max(high, quantity.ofChange(double(value)));
        }
    if (low == high) return bars;
    const Classes classes = classify(low, high, widths);
    std::vector<double> sums(classes.count);
    for (const float value : minutes)
        if (changes(value)) sums[classes.of(quantity.ofChange(double(value)))] += cellAreaM2;
    addGroups(bars, classes, sums, 1);
    for (std::size_t i = 0; i < classes.count; ++i)
        bars.groups[i].tone = (classes.limit(i) < 0) == quantity.isSun() ? BarTone::loss : BarTone::gain;
    return bars;
}

}  // namespace noonmark
