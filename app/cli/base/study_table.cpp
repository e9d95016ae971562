#include "app/cli/base/study_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "app/cli/base/table.h"
#include "app/report/maps/shadow_measure.h"
#include "core/measures/has_runs.h"
#include "core/measures/shadow_figures.h"
#include "core/study/text/error_words.h"
#include "core/study/text/height_words.h"
#include "core/study/text/terrain_text.h"

namespace noonmark::cli {

namespace {

std::string secondsText(const Study& study) {
    std::string stages;
    for (const auto& [stage, seconds] : study.seconds)
        if (stage != "total")
            stages += fmt::format("{}{} {:.2f}", stages.empty() ? "" : ", ", stage, seconds);
    return fmt::format("{:.2f} s ({})", study.seconds.at("total"), stages);
}

void addCost(Table& table, const Study& study) {
    const Cost& cost = study.field.cost;
    table.add("buildings", fmt::format("{} of {} can reach a receiver", withCommas(cost.buildingsUsed),
                                       withCommas(study.city.buildings.size())));
    for (const auto& [reason, count] : cost.skipped)
        if (count > 0) table.add("skipped", fmt::format("{} {}", withCommas(count), reason));
    if (cost.rays > 0)
        table.add("rays",
                  fmt::format("{} ({:.1f} million/s)", withCommas(cost.rays),
                              double(cost.rays) * 1e-6 / std::max(1e-9, study.seconds.at("accumulate"))));
    table.add("time", secondsText(study));
}

}  // namespace

void printStudy(const Study& study, const std::vector<std::filesystem::path>& files, std::ostream& out) {
    Table table;
    if (const auto headline = makeAssumedHeadline(countHeights(study.city))) table.add("heights", *headline);
    if (const auto headline = makeDoubtHeadline(study.heights)) table.add("unit of heights", *headline);
    if (const auto headline = makeStandHeadline(study.heights)) table.add("bases", *headline);
    table.add("period", formatText(study.settings.period));
    table.add("engine", study.field.engine);
    table.add("steps",
              fmt::format("{} with the sun up, {} left out below the horizon; each counts {:.6g} min",
                          withCommas(study.sun.steps.size()), withCommas(study.sun.belowHorizon),
                          study.field.stepMinutes));
    table.add("cells", fmt::format("{:g} m", study.receivers.grid.cellM));
    table.add("sunlit time", fmt::format("{:.1f} min a day", study.field.sunlitMinutesPerDay));
    addFigures(table, listLines(shadowFigures().of(study.statistics),
                                {study.statistics.receiverAreaM2, study.field.sunlitMinutesPerDay,
                                 isInstant(study.field)}));
    for (const ShadeColumn& shade : listShadeColumns(study.field)) {
        const ShadowStatistics statistics = computeStatistics(*shade.field);
        addFigures(table, listLines({treeFigures(shade.column), &statistics},
                                    {statistics.receiverAreaM2, study.field.sunlitMinutesPerDay,
                                     isInstant(study.field)}));
    }
    if (study.city.trees) table.add("trees", describeTrees(*study.city.trees, study.field));
    if (study.city.terrain) table.add("terrain", formatText(*study.city.terrain));
    for (const ErrorLine& line : makeErrorLines(study)) table.add(line.name, line.value);
    if (study.monthError) addErrors(table, std::span(&*study.monthError, 1));
    addCost(table, study);
    table.print(out);
    out << "\nFiles\n";
    for (const auto& file : files) out << "  " << file.string() << '\n';
    printWarnings(out, study.warnings);
}

}  // namespace noonmark::cli
