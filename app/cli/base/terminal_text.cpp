#include "app/cli/base/terminal_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <ostream>

#include "app/report/maps/shadow_measure.h"
#include "core/base/safe_text.h"
#include "core/base/units.h"
#include "core/measures/shadow_figures.h"
#include "core/study/contributions/contributions.h"
#include "core/study/text/error_text.h"
#include "core/study/text/height_facts_text.h"
#include "core/study/text/terrain_text.h"
#include "core/study/tiles/tiled_study.h"

namespace noonmark::cli {

void Table::print(std::ostream& out) const {
    std::size_t width = 0;
    for (const auto& [label, value] : rows_) width = std::max(width, label.size());
    for (const auto& [label, value] : rows_)
        out << fmt::format("{:<{}}  {}\n", cleanText(label), width, cleanText(value));
}

namespace {

// Terminals may know ASCII only.
std::string plainUnits(std::string text) {
    constexpr std::string_view square = "m²";
    for (std::size_t at = text.find(square); at != std::string::npos; at = text.find(square, at))
        text.replace(at, square.size(), "m2");
    return text;
}

}  // namespace

void addFigures(Table& table, const std::vector<FigureLine>& lines) {
    for (const FigureLine& line : lines)
        table.add(plainUnits(lowered(labelOf(line))), plainUnits(valueOf(line)));
}

void addFigures(Table& table, std::string label, const std::vector<FigureLine>& lines) {
    table.add(std::move(label), plainUnits(joinLines(lines)));
}

void addErrors(Table& table, std::span<const ShownError> errors) {
    for (const ShownError& error : errors)
        table.add("error: " + lowered(labelOf(error)), plainUnits(formatText(describe(error))));
}

std::string withCommas(std::size_t number) { return formatNumber(double(number)); }

void printWarnings(std::ostream& out, const Warnings& warnings) {
    if (warnings.empty()) return;
    out << "\n"
           "Warnings (--json lists all of them)\n";
    for (const WarningGroup& group : groupWarnings(warnings)) out << "  " << lineOf(group) << '\n';
}

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

/// What is printed of a study's trees.
struct PrintedTrees {
    std::size_t used = 0;
    std::vector<std::pair<TreeColumns, ShadowStatistics>> columns{};
};

// Those that are charged with most: "Tower A 31.2 %, tree Tilia cordata (node/12) 4.0 %; 212 more".
std::string shadersText(const Study& study) {
    constexpr std::size_t maximum = 5;
    const std::vector<TreeContribution> trees = listTreeContributions(study);
    const TreeColumns column = chooseRankedColumn(trees, TreeColumns::seasonal);
    const std::vector<Contribution> rows =
        rankWithTrees(listContributions(study.city, *study.breakdown, study.sun.dayCount()), trees, column);
    if (rows.empty()) return "nothing";
    std::string text;
    for (std::size_t i = 0; i < std::min(maximum, rows.size()); ++i)
        text += fmt::format("{}{}{} {:.1f} %", i > 0 ? ", " : "", rows[i].isTree ? "tree " : "",
                            nameOf(rows[i]), 100 * rows[i].share);
    if (rows.size() > maximum) text += fmt::format("; {} more", rows.size() - maximum);
    if (!trees.empty()) text += fmt::format(" ({})", describeTrees(column));
    return text;
}

void print(const Study& study, const PrintedTrees& trees, const std::vector<std::filesystem::path>& files,
           std::ostream& out) {
    Table table;
    for (const GeometryHeadline& headline : listGeometryHeadlines(study.city, study.heights))
        table.add(headline.of, headline.text);
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
    for (const auto& [column, statistics] : trees.columns)
        addFigures(table, listLines({treeFigures(column), &statistics},
                                    {statistics.receiverAreaM2, study.field.sunlitMinutesPerDay,
                                     isInstant(study.field)}));
    if (study.city.trees) table.add("trees", describeTrees(*study.city.trees, trees.used));
    if (study.breakdown && study.settings.contributions) table.add("shaded by", shadersText(study));
    if (study.city.terrain) table.add("terrain", formatText(*study.city.terrain));
    for (const ErrorLine& line : makeErrorLines(study)) table.add(line.name, line.value);
    if (study.monthError) addErrors(table, std::span(&*study.monthError, 1));
    addCost(table, study);
    table.print(out);
    out << "\nFiles\n";
    for (const auto& file : files) out << "  " << file.string() << '\n';
    printWarnings(out, study.warnings);
}

}  // namespace

void printStudy(const Study& study, const std::vector<std::filesystem::path>& files, std::ostream& out) {
    PrintedTrees trees{study.field.trees ? study.field.trees->treesUsed : 0};
    for (const ShadeColumn& shade : listShadeColumns(study.field))
        trees.columns.emplace_back(shade.column, computeStatistics(*shade.field));
    print(study, trees, files, out);
}

void printStudy(const TiledStudy& tiled, const std::vector<std::filesystem::path>& files, std::ostream& out) {
    PrintedTrees trees{tiled.treesUsed};
    for (const ShadedTiles& with : tiled.withTrees) trees.columns.emplace_back(with.column, with.statistics);
    print(tiled.study, trees, files, out);
}

namespace {
constexpr std::string_view wipe = "\r\x1b[K";
constexpr int barCells = 30;
}  // namespace

ProgressLine::~ProgressLine() {
    if (shown_) console_.err << wipe << std::flush;
}

void ProgressLine::report(double fraction, std::string_view stage) {
    if (!console_.watched) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    const auto now = std::chrono::steady_clock::now();
    if (!lock || (shown_ && now - *shown_ < std::chrono::milliseconds(100))) return;
    shown_ = now;
    const double share = std::clamp(fraction, 0.0, 1.0);
    const int filled = int(share * barCells);
    console_.err << wipe
                 << fmt::format("[{:=<{}}{:<{}}] {:3.0f} %  {}", "", filled, "", barCells - filled,
                                share * 100, cleanText(stage))
                 << std::flush;
}

}  // namespace noonmark::cli
