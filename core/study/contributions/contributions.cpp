#include "core/study/contributions/contributions.h"

#include <fmt/format.h>
#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/csv_text.h"
#include "core/city/trees/tree.h"
#include "core/describe/figure_text.h"
#include "core/describe/shown_as.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/place_names.h"
#include "core/study/contributions/place_contributions.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/text/breakdown_text.h"
#include "core/study/text/error_text.h"

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
    return one;
}

CellDays sumUpColumn(const Study& study, const ShadowField& column) {
    const auto days = double(study.sun.dayCount());
    const double cellM2 = study.receivers.grid.cellAreaM2();
    return {double(study.receivers.cells.size()) * cellM2 * days, sumOf(column.grossMin) * cellM2 * days};
}

}  // namespace

std::vector<TreeContribution> listTreeContributions(const Study& study) {
    std::vector<TreeContribution> rows;
    if (!study.byTree) return rows;
    for (const TreeTaken& taken : study.byTree->evergreen) rows.push_back({taken.tree, {}});
    for (const ShadeColumn& shade : listShadeColumns(study.field)) {
        const CellDays all = sumUpColumn(study, *shade.field);
        const std::vector<TreeTaken>& taken = study.byTree->of(shade.column);
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i].columns.emplace_back(
                shade.column, contributionOf(taken[i], study.city.trees->trees[rows[i].tree], all));
    }
    std::ranges::stable_sort(rows, std::ranges::greater{}, [](const TreeContribution& row) {
        return row.columns.back().second.attributedMinM2;
    });
    return rows;
}

std::string treeContributionsCsv(const Study& study) {
    std::vector<std::string> columns{"source_id", "species", "lon_deg", "lat_deg"};
    for (const ShadeColumn& shade : listShadeColumns(study.field))
        std::ranges::move(listColumns(contributionFiguresWithTrees(shade.column)),
                          std::back_inserter(columns));
    CsvText csv(withSourceColumns(std::move(columns)));
    const SourceValues source = sourceValues(study.provenance);
    for (const TreeContribution& row : listTreeContributions(study)) {
        const Tree& tree = study.city.trees->trees[row.tree];
        const LonLat place = study.city.frame.lonLatFromLocal(tree.place);
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

LayerStyle contributionStyle() {
    std::vector<ColourClass> classes;
    for (std::size_t i = 0; i < contributionClasses.size(); ++i) {
        const auto& [from, colour] = contributionClasses[i];
        const double to = i + 1 < contributionClasses.size() ? contributionClasses[i + 1].from : 1;
        classes.push_back({from, to, colour, fmt::format("{:g} to {:g} %", 100 * from, 100 * to)});
    }
    return {"Share of the shadow", graduatedStyle(StyledShape::polygons, "share", classes)};
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

}  // namespace

ContributionTable makeContributionTable(const PlaceContributions& of) {
    return {.place = of.place.name,
            .kind = std::string(nameOf(of.place.kind)),
            .period = formatText(of.period),
            .engine = of.breakdown.engine,
            .cells = of.cells,
            .sunlitMinutesPerDay = of.sunlitMinutesPerDay,
            .months = of.breakdown.sets.names,
            .rows = of.rows};
}

std::vector<ContributionTable> withContributions(std::vector<ContributionTable> all, ContributionTable more) {
    std::erase_if(all, [&](const ContributionTable& old) {
        return old.place == more.place && (old.period == more.period || old.period.empty());
    });
    all.push_back(std::move(more));
    return all;
}

std::string withContributions(std::string json, const std::vector<ContributionTable>& all) {
    if (all.empty()) return json;
    Json answer = Json::parse(json);
    answer[keptKey] = Json::array();
    for (const ContributionTable& of : all)
        answer[keptKey].push_back({{"place", of.place},
                                   {"kind", of.kind},
                                   {"period", of.period},
                                   {"months", of.months},
                                   {"engine", of.engine},
                                   {"cells", of.cells},
                                   {"sunlit_min_per_day", of.sunlitMinutesPerDay},
                                   {"buildings", rowsJson(of.rows)}});
    return toJsonText(answer);
}

std::vector<ContributionTable> parseContributions(const Json& answer) {
    std::vector<ContributionTable> all;
    for (const Json& of : answer.value(keptKey, Json::array()))
        all.push_back({.place = of.at("place"),
                       .kind = of.at("kind"),
                       .period = of.value("period", std::string()),
                       .engine = of.at("engine"),
                       .cells = of.at("cells"),
                       .sunlitMinutesPerDay = of.at("sunlit_min_per_day"),
                       .months = of.value("months", std::vector<std::string>()),
                       .rows = parseRows(of.at("buildings"))});
    return all;
}

namespace {

std::vector<ElementColumn> layerColumns() {
    std::vector<ElementColumn> columns;
    for (const char* name : {"place", "kind", "period", "source_id", "name"})
        columns.push_back({name, std::string()});
    for (const Figure& figure : contributionFigures().rows())
        if (figure.inFiles) columns.push_back({std::string(figure.key), 0.0, figure.decimals});
    return columns;
}

std::vector<ElementValue> layerRow(const ContributionTable& of, const Contribution& row) {
    std::vector<ElementValue> values{of.place, of.kind, of.period, row.id, row.name};
    for (const Figure& figure : contributionFigures().rows())
        if (figure.inFiles) values.emplace_back(figure.get(&row));
    return values;
}

Place outlineOf(const Building& building) {
    Place outline;
    for (const Part& part : building.parts) outline.polygons.push_back(part.footprint);
    return outline;
}

}  // namespace

ContributionLayer makeContributionLayer(const std::vector<ContributionTable>& all, const City& city) {
    std::map<std::string, const Building*> buildings;
    for (const auto& building : city.buildings) buildings.emplace(building->sourceId, building.get());
    ContributionLayer layer{{}, {.columns = layerColumns(), .rows = {}, .places = {}}, contributionStyle()};
    for (const ContributionTable& of : all)
        for (const Contribution& row : of.rows) {
            const auto found = buildings.find(row.id);
            if (found == buildings.end()) continue;
            layer.outlines.push_back(outlineOf(*found->second));
            layer.table.rows.push_back(layerRow(of, row));
        }
    return layer;
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
            csv.text(of.place).text(of.kind).text(of.period).text(row.id).text(row.name);
            addRow(csv, row, months.size(), source);
        }
    return csv.take();
}

}  // namespace noonmark
