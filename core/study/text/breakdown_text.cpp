#include "core/study/text/breakdown_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/csv_field.h"
#include "core/study/provenance/source_columns.h"

namespace noonmark {

namespace {

void addLine(std::string& csv, const BuildingShadow& shadow, const std::string& caster,
             const std::string& source) {
    csv += fmt::format("{},{:.1f},{:.1f}", caster, sumOf(shadow.attributedMinM2), sumOf(shadow.soleMinM2));
    for (std::size_t set = 0; shadow.soleMinM2.size() > 1 && set < shadow.soleMinM2.size(); ++set)
        csv += fmt::format(",{:.1f},{:.1f}", shadow.attributedMinM2[set], shadow.soleMinM2[set]);
    csv += source + "\n";
}

}  // namespace

double sumOf(const std::vector<float>& minutes) {
    double sum = 0;
    for (const float value : minutes)
        if (!std::isnan(value)) sum += double(value);
    return sum;
}

double sumOf(const std::vector<double>& minM2) { return std::accumulate(minM2.begin(), minM2.end(), 0.0); }

std::vector<BuildingShadow> sortContributions(const ShadowBreakdown& breakdown) {
    std::vector<BuildingShadow> shadows = breakdown.buildings;
    std::ranges::stable_sort(shadows, std::ranges::greater{},
                             [](const BuildingShadow& shadow) { return sumOf(shadow.attributedMinM2); });
    return shadows;
}

std::vector<MonthShadow> monthsFromSums(const StepSets& sets, const std::vector<double>& sunlitMinutes,
                                        const std::vector<double>& minutes, std::size_t receivers,
                                        double cellAreaM2) {
    std::vector<MonthShadow> months;
    for (std::size_t set = 0; set < sets.names.size(); ++set) {
        const double sunlit = sunlitMinutes.at(set), sum = minutes.at(set);
        months.push_back({sets.names[set], sunlit, sunlit > 0 ? sum / sunlit * cellAreaM2 : 0,
                          receivers > 0 ? sum / double(receivers) : 0});
    }
    return months;
}

std::vector<MonthShadow> monthsOf(const ShadowBreakdown& breakdown) {
    if (breakdown.minutes.empty()) return {};
    std::vector<double> sums;
    for (const std::vector<float>& minutes : breakdown.minutes) sums.push_back(sumOf(minutes));
    const auto nothing =
        std::ranges::count_if(breakdown.minutes.front(), [](float value) { return std::isnan(value); });
    const std::size_t receivers = breakdown.minutes.front().size() - std::size_t(nothing);
    return monthsFromSums(breakdown.sets, breakdown.sunlitMinutes, sums, receivers,
                          breakdown.grid.cellAreaM2());
}

std::string monthsCsv(const std::vector<MonthShadow>& months, const Provenance& provenance) {
    std::string csv = fmt::format("month,sunlit_min,shadow_area_m2,mean_shadow_min{}\n", sourceColumns);
    const std::string source = sourceFields(provenance);
    for (const MonthShadow& month : months)
        csv += fmt::format("{},{:.1f},{:.2f},{:.2f}{}\n", month.month, month.sunlitMinutes,
                           month.shadowAreaM2, month.meanMinutes, source);
    return csv;
}

std::string monthsCsv(const Study& study) { return monthsCsv(monthsOf(*study.breakdown), study.provenance); }

std::string contributionsCsv(const Study& study) {
    const ShadowBreakdown& breakdown = *study.breakdown;
    const std::string source = sourceFields(study.provenance);
    std::string csv = "building,source_id,name,attributed_min_m2,sole_min_m2";
    for (std::size_t set = 0; breakdown.sets.names.size() > 1 && set < breakdown.sets.names.size(); ++set)
        csv += fmt::format(",attributed {0},sole {0}", breakdown.sets.names[set]);
    csv += sourceColumns + std::string("\n");
    for (const BuildingShadow& shadow : sortContributions(breakdown)) {
        const Building& building = *study.city.buildings[shadow.building];
        addLine(
            csv, shadow,
            fmt::format("{},{},{}", shadow.building, csvField(building.sourceId), csvField(building.name)),
            source);
    }
    if (breakdown.terrain) addLine(csv, *breakdown.terrain, ",\"terrain\",\"terrain\"", source);
    return csv;
}

}  // namespace noonmark
