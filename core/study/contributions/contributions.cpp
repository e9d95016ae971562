#include "core/study/contributions/contributions.h"

#include <fmt/format.h>
#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/csv_text.h"
#include "core/city/trees/tree.h"
#include "core/describe/field_json.h"
#include "core/describe/figure_text.h"
#include "core/describe/shown_as.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/place_names.h"
#include "core/study/contributions/place_contributions.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/text/breakdown_text.h"
#include "core/study/text/error_text.h"
#include "core/sun/period_fields.h"

namespace noonmark {

namespace {

/// What turns sums over cells and days into means.
struct CellDays {
    double areaDays = 0;  ///< area of the cells x days, m2
    double allMinM2 = 0;  ///< of all buildings and the terrain
};

Contribution makeContribution(const BuildingShadow& shadow, const CellDays& of) {
    Contribution one{.shadow = shadow};
    one.attributedMinM2 = sumOf(shadow.attributedMinM2);
    one.soleMinM2 = sumOf(shadow.soleMinM2);
    if (of.areaDays > 0) {
        one.attributedMin = one.attributedMinM2 / of.areaDays;
        one.soleMin = one.soleMinM2 / of.areaDays;
    }
    if (of.allMinM2 > 0) one.share = one.attributedMinM2 / of.allMinM2;
    return one;
}

CellDays sumUpBreakdown(const ShadowBreakdown& breakdown, std::size_t days) {
    CellDays all{computeAreaM2(breakdown) * double(days)};
    if (breakdown.terrain) all.allMinM2 = sumOf(breakdown.terrain->attributedMinM2);
    for (const BuildingShadow& shadow : breakdown.buildings) all.allMinM2 += sumOf(shadow.attributedMinM2);
    return all;
}

double attributedM2h(const Contribution& one) { return one.attributedMinM2 / minutesPerHour; }
double soleM2h(const Contribution& one) { return one.soleMinM2 / minutesPerHour; }

// `first`: what is stated before the figures. A single month is the whole.
std::vector<std::string> columnsOf(std::vector<std::string> first, const std::vector<std::string>& months) {
    std::vector<std::string> columns = std::move(first);
    for (std::string& key : listColumns(contributionFigures().rows())) columns.push_back(std::move(key));
    for (std::size_t set = 0; months.size() > 1 && set < months.size(); ++set)
        columns.insert(columns.end(), {"attributed " + months[set], "sole " + months[set]});
    return withSourceColumns(std::move(columns));
}

// `months`: as many as there are columns for; sums that are not known stay empty.
void addRow(CsvText& csv, const Contribution& row, std::size_t months, const SourceValues& source) {
    addFigures(csv, contributionFigures().of(row));
    const BuildingShadow& shadow = row.shadow;
    for (std::size_t set = 0; months > 1 && set < months; ++set)
        if (set < shadow.soleMinM2.size())
            csv.number(shadow.attributedMinM2[set], 1).number(shadow.soleMinM2[set], 1);
        else
            csv.text({}).text({});
    addSource(csv, source);
    csv.endRow();
}

}  // namespace

const Figures<Contribution>& contributionFigures() {
    static const Figures<Contribution> figures{
        figure(&Contribution::attributedMinM2,
               {.key = "attributed_min_m2",
                .label = NM_TEXT("Attributed shadow"),
                .definition = NM_TEXT("the part of the shadow that one building is charged with; the "
                                      "attributed shadows of all buildings and of the terrain add up to the "
                                      "total"),
                .use = FigureUse::file}),
        figure(&Contribution::soleMinM2, {.key = "sole_min_m2",
                                          .label = NM_TEXT("Sole contribution"),
                                          .definition = NM_TEXT("the shadow that would disappear if only "
                                                                "this building were gone"),
                                          .use = FigureUse::file}),
        figure(&Contribution::share,
               {.key = "share",
                .label = NM_TEXT("Share"),
                .definition = NM_TEXT("attributed shadow, as a share of all shadow on the cells"),
                .decimals = 6,
                .unit = FigureUnit::share}),
        figure(&Contribution::attributedMin,
               {.key = "attributed_min_day",
                .label = NM_TEXT("Attributed"),
                .definition = NM_TEXT("attributed shadow in minutes a day, mean over the cells"),
                .decimals = 4,
                .unit = FigureUnit::minutesADay,
                .shownDecimals = 2}),
        figure(&Contribution::soleMin,
               {.key = "sole_min_day",
                .label = NM_TEXT("Sole"),
                .definition = NM_TEXT("sole contribution in minutes a day, mean over the cells"),
                .decimals = 4,
                .unit = FigureUnit::minutesADay,
                .shownDecimals = 2}),
        derivedFigure(&attributedM2h,
                      {.key = "attributed_m2h",
                       .label = NM_TEXT("Attributed area x hours"),
                       .definition = NM_TEXT("attributed shadow as area x hours of the whole period"),
                       .unit = FigureUnit::squareMetreHours,
                       .inFiles = false}),
        derivedFigure(&soleM2h,
                      {.key = "sole_m2h",
                       .label = NM_TEXT("Sole area x hours"),
                       .definition = NM_TEXT("sole contribution as area x hours of the whole period"),
                       .unit = FigureUnit::squareMetreHours,
                       .inFiles = false})};
    return figures;
}

std::string nameOf(const Contribution& one) {
    if (one.name.empty()) return one.id;
    return one.isTree ? fmt::format("{} ({})", one.name, one.id) : one.name;
}

std::string_view attributedDefinition() {
    return findFigure(contributionFigures().rows(), "attributed_min_m2").definition;
}

std::string_view soleDefinition() {
    return findFigure(contributionFigures().rows(), "sole_min_m2").definition;
}

std::vector<Contribution> listContributions(const City& city, const ShadowBreakdown& breakdown,
                                            std::size_t days) {
    const CellDays all = sumUpBreakdown(breakdown, days);
    std::vector<Contribution> rows;
    for (const BuildingShadow& shadow : sortContributions(breakdown)) {
        const Building& building = *city.buildings[shadow.building];
        rows.push_back(makeContribution(shadow, all));
        rows.back().building = shadow.building;
        rows.back().id = building.sourceId;
        rows.back().name = building.name;
    }
    if (!breakdown.terrain) return rows;
    rows.push_back(makeContribution(*breakdown.terrain, all));
    rows.back().id = rows.back().name = terrainId;
    return rows;
}

std::string contributionsCsv(const std::vector<Contribution>& rows, const StepSets& sets,
                             const Provenance& provenance) {
    const SourceValues source = sourceValues(provenance);
    CsvText csv(columnsOf({"building", "source_id", "name"}, sets.names));
    for (const Contribution& row : rows) {
        csv.text(row.building ? fmt::to_string(*row.building) : std::string()).text(row.id).text(row.name);
        addRow(csv, row, sets.names.size(), source);
    }
    return csv.take();
}

std::string contributionsCsv(const Study& study) {
    const ShadowBreakdown& breakdown = *study.breakdown;
    return contributionsCsv(listContributions(study.city, breakdown, study.sun.dayCount()), breakdown.sets,
                            study.provenance);
}

std::span<const Figure> contributionFiguresWithTrees(TreeColumns column) {
    static const FiguresWithTrees evergreen(contributionFigures().rows(), TreeColumns::evergreen);
    static const FiguresWithTrees seasonal(contributionFigures().rows(), TreeColumns::seasonal);
    return (column == TreeColumns::evergreen ? evergreen : seasonal).rows();
}

namespace {

Contribution contributionOf(const TreeTaken& taken, const Tree& tree, const CellDays& all) {
    Contribution one =
        makeContribution({.attributedMinM2 = {taken.attributedMinM2}, .soleMinM2 = {taken.soleMinM2}}, all);
    one.id = tree.sourceId;
    one.name = tree.species;
    one.isTree = true;
    return one;
}

CellDays sumUpColumn(const Study& study, const ShadowField& column) {
    const auto days = double(study.sun.dayCount());
    const double cellM2 = study.receivers.grid.cellAreaM2();
    return {double(study.receivers.cells.size()) * cellM2 * days, sumOf(column.grossMin) * cellM2 * days};
}

std::vector<TreeContribution> beginTreeRows(const TakenByTree& taken) {
    std::vector<TreeContribution> rows;
    for (const TreeTaken& one : taken.evergreen) rows.push_back({one.tree, {}});
    return rows;
}

// Both lists are of the same trees, in one order.
void addColumn(std::vector<TreeContribution>& rows, TreeColumns column, const TakenByTree& taken,
               const City& city, const CellDays& all) {
    const std::vector<TreeTaken>& of = taken.of(column);
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].columns.emplace_back(column, contributionOf(of[i], city.trees->trees[rows[i].tree], all));
}

void sortTreeRows(std::vector<TreeContribution>& rows) {
    std::ranges::stable_sort(rows, std::ranges::greater{}, [](const TreeContribution& row) {
        return row.columns.back().second.attributedMinM2;
    });
}

const Contribution* findColumn(const TreeContribution& tree, TreeColumns column) {
    for (const auto& [of, one] : tree.columns)
        if (of == column) return &one;
    return nullptr;
}

}  // namespace

std::vector<TreeContribution> listTreeContributions(const Study& study) {
    if (!study.byTree) return {};
    std::vector<TreeContribution> rows = beginTreeRows(*study.byTree);
    for (const ShadeColumn& shade : listShadeColumns(study.field))
        addColumn(rows, shade.column, *study.byTree, study.city, sumUpColumn(study, *shade.field));
    sortTreeRows(rows);
    return rows;
}

std::vector<TreeContribution> listTreeContributions(const City& city, const TakenByTree& taken,
                                                    std::span<const TreeColumns> columns,
                                                    const ShadowBreakdown& breakdown, std::size_t days) {
    std::vector<TreeContribution> rows = beginTreeRows(taken);
    for (const TreeColumns column : columns) {
        CellDays all = sumUpBreakdown(breakdown, days);
        for (const TreeTaken& one : taken.of(column)) all.allMinM2 += one.attributedMinM2;
        addColumn(rows, column, taken, city, all);
    }
    sortTreeRows(rows);
    return rows;
}

TreeColumns chooseRankedColumn(const std::vector<TreeContribution>& trees, TreeColumns wanted) {
    if (trees.empty()) return TreeColumns::without;
    return findColumn(trees.front(), wanted) != nullptr ? wanted : trees.front().columns.back().first;
}

std::vector<Contribution> rankWithTrees(std::vector<Contribution> rows,
                                        const std::vector<TreeContribution>& trees, TreeColumns column) {
    if (trees.empty()) return rows;
    for (const TreeContribution& tree : trees)
        if (const Contribution* const one = findColumn(tree, column);
            one != nullptr && one->attributedMinM2 > 0)
            rows.push_back(*one);
    double all = 0;
    for (const Contribution& row : rows) all += row.attributedMinM2;
    for (Contribution& row : rows) row.share = all > 0 ? row.attributedMinM2 / all : 0;
    std::ranges::stable_sort(rows, [](const Contribution& a, const Contribution& b) {
        const bool isLast = a.id == terrainId, isOtherLast = b.id == terrainId;
        return isLast != isOtherLast ? isOtherLast : a.attributedMinM2 > b.attributedMinM2;
    });
    return rows;
}

std::string treeContributionsCsv(const std::vector<TreeContribution>& rows, const City& city,
                                 const Provenance& provenance) {
    std::vector<std::string> columns{"source_id", "species", "lon_deg", "lat_deg"};
    if (!rows.empty())
        for (const auto& [column, one] : rows.front().columns)
            std::ranges::move(listColumns(contributionFiguresWithTrees(column)), std::back_inserter(columns));
    CsvText csv(withSourceColumns(std::move(columns)));
    const SourceValues source = sourceValues(provenance);
    for (const TreeContribution& row : rows) {
        const Tree& tree = city.trees->trees[row.tree];
        const LonLat place = city.frame.lonLatFromLocal(tree.place);
        csv.text(tree.sourceId).text(tree.species).number(place.lonDeg, 8).number(place.latDeg, 8);
        for (const auto& [column, one] : row.columns)
            addFigures(csv, {contributionFiguresWithTrees(column), &one});
        addSource(csv, source);
        csv.endRow();
    }
    return csv.take();
}

std::vector<BuildingColumn> contributionColumns(const std::vector<Contribution>& rows,
                                                std::size_t buildings) {
    std::vector<BuildingColumn> columns;
    for (const Figure& figure : contributionFigures().rows()) {
        if (!figure.inFiles) continue;
        BuildingColumn column{std::string(figure.key), std::vector<double>(buildings)};
        for (const Contribution& row : rows)
            if (row.building) column.values[*row.building] = figure.get(&row);
        columns.push_back(std::move(column));
    }
    return columns;
}

LayerStyle contributionStyle(std::string_view column) {
    std::vector<ColourClass> classes;
    for (std::size_t i = 0; i < contributionClasses.size(); ++i) {
        const auto& [from, colour] = contributionClasses[i];
        const double to = i + 1 < contributionClasses.size() ? contributionClasses[i + 1].from : 1;
        classes.push_back({from, to, colour, fmt::format("{:g} to {:g} %", 100 * from, 100 * to)});
    }
    return {"Share of the shadow", graduatedStyle(StyledShape::polygons, std::string(column), classes)};
}

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* keptKey = "contributions_of_places";

Json rowsJson(const std::vector<Contribution>& rows) {
    Json json = Json::array();
    for (const Contribution& one : rows) {
        json.push_back({{"source_id", one.id}, {"name", one.name}});
        json.back().update(figuresJson(contributionFigures().of(one)));
        if (one.shadow.soleMinM2.size() < 2) continue;
        json.back()["attributed_min_m2_by_month"] = one.shadow.attributedMinM2;
        json.back()["sole_min_m2_by_month"] = one.shadow.soleMinM2;
    }
    return json;
}

std::vector<Contribution> parseRows(const Json& json) {
    std::vector<Contribution> rows;
    for (const Json& one : json) {
        rows.push_back(readFigures(contributionFigures(), one));
        rows.back().id = one.at("source_id");
        rows.back().name = one.at("name");
        rows.back().shadow.attributedMinM2 = one.value("attributed_min_m2_by_month", std::vector<double>());
        rows.back().shadow.soleMinM2 = one.value("sole_min_m2_by_month", std::vector<double>());
    }
    return rows;
}

std::optional<Contribution> parseTree(const Json& json, TreeColumns column) {
    const std::string suffix = suffixOf(column);
    Json figures;
    for (const auto& [key, value] : json.items())
        if (key.ends_with(suffix)) figures[key.substr(0, key.size() - suffix.size())] = value;
    if (figures.empty()) return std::nullopt;
    Contribution one = readFigures(contributionFigures(), figures);
    one.id = json.at("source_id");
    one.name = json.at("species");
    one.isTree = true;
    return one;
}

StatedPeriod periodOf(const Json& table) {
    return {table.value("period", std::string()),
            readStatedPeriod(table.value("asked_period", Json())).asked};
}

}  // namespace

nlohmann::ordered_json treeContributionsJson(const std::vector<TreeContribution>& trees) {
    Json json = Json::array();
    for (const TreeContribution& tree : trees) {
        const Contribution& first = tree.columns.front().second;
        json.push_back({{"source_id", first.id}, {"species", first.name}});
        for (const auto& [column, one] : tree.columns) {
            const Json figures = figuresJson(contributionFigures().of(one));  // items() refers to it
            for (const auto& [key, value] : figures.items()) json.back()[key + suffixOf(column)] = value;
        }
    }
    return json;
}

std::vector<TreeContribution> parseTreeContributions(const nlohmann::ordered_json& json) {
    std::vector<TreeContribution> trees;
    for (const Json& of : json) {
        TreeContribution tree;
        for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
            if (auto one = parseTree(of, column)) tree.columns.emplace_back(column, *std::move(one));
        if (!tree.columns.empty()) trees.push_back(std::move(tree));
    }
    return trees;
}

ContributionTable makeContributionTable(const PlaceContributions& of) {
    return {.place = of.place.name,
            .kind = std::string(nameOf(of.place.kind)),
            .period = statePeriod(of.period),
            .engine = of.breakdown.engine,
            .cells = of.cells,
            .sunlitMinutesPerDay = of.sunlitMinutesPerDay,
            .months = of.breakdown.sets.names,
            .rows = of.rows,
            .trees = of.trees};
}

std::vector<ContributionTable> withContributions(std::vector<ContributionTable> all, ContributionTable more) {
    std::erase_if(all, [&](const ContributionTable& old) {
        return old.place == more.place && (old.period.words == more.period.words || old.period.words.empty());
    });
    all.push_back(std::move(more));
    return all;
}

std::string withContributions(std::string json, const std::vector<ContributionTable>& all) {
    if (all.empty()) return json;
    Json answer = Json::parse(json);
    answer[keptKey] = Json::array();
    for (const ContributionTable& of : all) {
        answer[keptKey].push_back({{"place", of.place},
                                   {"kind", of.kind},
                                   {"period", of.period.words},
                                   {"months", of.months},
                                   {"engine", of.engine},
                                   {"cells", of.cells},
                                   {"sunlit_min_per_day", of.sunlitMinutesPerDay},
                                   {"buildings", rowsJson(of.rows)}});
        if (of.period.asked)
            answer[keptKey].back()["asked_period"] = fieldsJson(periodFields().of(*of.period.asked));
        if (!of.trees.empty()) answer[keptKey].back()["trees"] = treeContributionsJson(of.trees);
    }
    return toJsonText(answer);
}

std::vector<ContributionTable> parseContributions(const Json& answer) {
    std::vector<ContributionTable> all;
    for (const Json& of : answer.value(keptKey, Json::array()))
        all.push_back({.place = of.at("place"),
                       .kind = of.at("kind"),
                       .period = periodOf(of),
                       .engine = of.at("engine"),
                       .cells = of.at("cells"),
                       .sunlitMinutesPerDay = of.at("sunlit_min_per_day"),
                       .months = of.value("months", std::vector<std::string>()),
                       .rows = parseRows(of.at("buildings")),
                       .trees = parseTreeContributions(of.value("trees", Json::array()))});
    return all;
}

// The months of the place that has most of them: they are those of the answer's period.
std::string contributionsCsv(const std::vector<ContributionTable>& all, const Provenance& provenance) {
    std::vector<std::string> months;
    for (const ContributionTable& of : all)
        if (of.months.size() > months.size()) months = of.months;
    CsvText csv(columnsOf({"place", "kind", "period", "source_id", "name"}, months));
    const SourceValues source = sourceValues(provenance);
    for (const ContributionTable& of : all)
        for (const Contribution& row : of.rows) {
            csv.text(of.place).text(of.kind).text(of.period.words).text(row.id).text(row.name);
            addRow(csv, row, months.size(), source);
        }
    return csv.take();
}

}  // namespace noonmark
