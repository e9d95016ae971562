#include "core/study/text/breakdown_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/study/provenance/source_columns.h"

namespace noonmark {

namespace {

double total(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

// RFC 4180. A leading = + - @ is escaped, since spreadsheets would take it for a formula.
std::string cell(const std::string& text) {
    std::string quoted = "\"";
    if (!text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos) quoted += "'";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

void addLine(std::string& csv, const BuildingShadow& shadow, const std::string& caster,
             const std::string& source) {
    csv += fmt::format("{},{:.1f},{:.1f}", caster, total(shadow.attributedMinM2), total(shadow.soleMinM2));
    for (std::size_t set = 0; shadow.soleMinM2.size() > 1 && set < shadow.soleMinM2.size(); ++set)
        csv += fmt::format(",{:.1f},{:.1f}", shadow.attributedMinM2[set], shadow.soleMinM2[set]);
    csv += source + "\n";
}

}  // namespace

std::vector<MonthShadow> monthsOf(const ShadowBreakdown& breakdown) {
    std::vector<MonthShadow> months;
    for (std::size_t set = 0; set < breakdown.sets.names.size(); ++set) {
        double sum = 0;
        std::size_t cells = 0;
        for (const float minutes : breakdown.minutes[set])
            if (!std::isnan(minutes)) sum += double(minutes), ++cells;
        const double sunlit = breakdown.sunlitMinutes[set];
        months.push_back({breakdown.sets.names[set], sunlit,
                          sunlit > 0 ? sum / sunlit * breakdown.grid.cellAreaM2() : 0,
                          cells > 0 ? sum / double(cells) : 0});
    }
    return months;
}

std::string monthsCsv(const Study& study) {
    std::string csv = fmt::format("month,sunlit_min,shadow_area_m2,mean_shadow_min{}\n", sourceColumns);
    const std::string source = sourceFields(study.provenance);
    for (const MonthShadow& month : monthsOf(*study.breakdown))
        csv += fmt::format("{},{:.1f},{:.2f},{:.2f}{}\n", month.month, month.sunlitMinutes,
                           month.shadowAreaM2, month.meanMinutes, source);
    return csv;
}

std::string contributionsCsv(const Study& study) {
    const ShadowBreakdown& breakdown = *study.breakdown;
    const std::string source = sourceFields(study.provenance);
    std::string csv = "building,source_id,name,attributed_min_m2,sole_min_m2";
    for (std::size_t set = 0; breakdown.sets.names.size() > 1 && set < breakdown.sets.names.size(); ++set)
        csv += fmt::format(",attributed {0},sole {0}", breakdown.sets.names[set]);
    csv += sourceColumns + std::string("\n");
    std::vector<BuildingShadow> shadows = breakdown.buildings;
    std::ranges::stable_sort(shadows, std::ranges::greater{},
                             [](const BuildingShadow& shadow) { return total(shadow.attributedMinM2); });
    for (const BuildingShadow& shadow : shadows) {
        const Building& building = *study.city.buildings[shadow.building];
        addLine(csv, shadow,
                fmt::format("{},{},{}", shadow.building, cell(building.sourceId), cell(building.name)),
                source);
    }
    if (breakdown.terrain) addLine(csv, *breakdown.terrain, ",\"terrain\",\"terrain\"", source);
    return csv;
}

}  // namespace noonmark
