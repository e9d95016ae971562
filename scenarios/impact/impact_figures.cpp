#include "scenarios/impact/impact_figures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

#include "core/describe/command_options.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

// Counts cells and sums minutes of one measure.
class Sum {
public:
    explicit Sum(double thresholdMin) : thresholdMin_(std::max(noChangeMin, thresholdMin)) {}

    void add(double change) {
        figures_.moreShadowM2 += change > thresholdMin_;
        figures_.lessShadowM2 += change < -thresholdMin_;
        figures_.anyMoreShadowM2 += change > noChangeMin;
        figures_.anyLessShadowM2 += change < -noChangeMin;
        figures_.meanMin += change;
        figures_.maxMoreShadowMin = std::max(figures_.maxMoreShadowMin, change);
        figures_.maxLessShadowMin = std::max(figures_.maxLessShadowMin, -change);
    }

    [[nodiscard]] ChangeFigures figures(double cellM2, double receivers) const {
        if (std::isnan(figures_.meanMin)) return notComputed();
        ChangeFigures figures = figures_;
        for (double* areaM2 : {&figures.moreShadowM2, &figures.lessShadowM2, &figures.anyMoreShadowM2,
                               &figures.anyLessShadowM2})
            *areaM2 *= cellM2;
        figures.meanMin = receivers > 0 ? figures.meanMin / receivers : 0;
        return figures;
    }

private:
    double thresholdMin_;
    ChangeFigures figures_;  // areas count cells until figures()
};

template <class CellAt>
ImpactFigures countCells(const Impact& impact, double thresholdMin, std::size_t count, CellAt cellAt) {
    const double cellM2 = impact.grid.cellAreaM2();
    ImpactFigures figures{.thresholdMin = thresholdMin};
    Sum gross(thresholdMin), continuous(thresholdMin);
    double receivers = 0;
    for (std::size_t turn = 0; turn < count; ++turn) {
        const std::size_t i = cellAt(turn);
        figures.becameBuildingM2 += impact.change[i] == CellChange::becameBuilding ? cellM2 : 0;
        figures.becameGroundM2 += impact.change[i] == CellChange::becameGround ? cellM2 : 0;
        if (std::isnan(impact.grossMin[i])) continue;
        gross.add(double(impact.grossMin[i]));
        continuous.add(double(impact.continuousMin[i]));
        ++receivers;
    }
    figures.receiverAreaM2 = receivers * cellM2;
    figures.gross = gross.figures(cellM2, receivers);
    figures.continuous = continuous.figures(cellM2, receivers);
    if (impact.sunlitMinutesPerDay > 0)
        figures.shadowAreaChangeM2 =
            figures.gross.meanMin / impact.sunlitMinutesPerDay * figures.receiverAreaM2;
    return figures;
}

}  // namespace

ImpactFigures computeFigures(const Impact& impact, double thresholdMin) {
    return countCells(impact, thresholdMin, impact.grossMin.size(), std::identity());
}

ImpactFigures computeFigures(const ImpactStudy& study, double thresholdMin) {
    ImpactFigures figures = computeFigures(study.total, thresholdMin);
    for (const ShadeImpact& shade : study.withTrees) {
        const ImpactFigures with = computeFigures(shade.impact, thresholdMin);
        figures.withTrees.push_back({shade.column, with.gross, with.continuous, with.shadowAreaChangeM2});
    }
    return figures;
}

ImpactFigures computeFigures(const Impact& impact, const Region& region, double thresholdMin) {
    return computeFigures(impact, collectCells(region.polygons, impact.grid), thresholdMin);
}

ImpactFigures computeFigures(const Impact& impact, const std::vector<std::uint32_t>& cells,
                             double thresholdMin) {
    return countCells(impact, thresholdMin, cells.size(), [&](std::size_t i) { return cells[i]; });
}

namespace {

// The same change told as sun: less of it where shadow grew. Not set, as the row of shadow is.
Figure asSun(double ChangeFigures::*member, FigureFacts facts) {
    facts.shownWith = ShownWith::sunInstead;
    facts.inFiles = false;
    Figure row = figure(member, facts);
    row.set = [](void*, double) {};
    return row;
}

double sunChangeM2(const ImpactFigures& figures) { return -figures.shadowAreaChangeM2; }
double meanSunChangeMin(const ChangeFigures& figures) { return -figures.meanMin; }

}  // namespace

const Figures<ChangeFigures>& changeFigures() {
    static const Figures<ChangeFigures> figures{
        figure(&ChangeFigures::moreShadowM2,
               {.key = "gained_m2",
                .label = NM_TEXT("More shadow"),
                .definition = NM_TEXT("area where the minutes rose by more than the threshold"),
                .unit = FigureUnit::squareMetres,
                .byThreshold = true,
                .shownWith = ShownWith::shadow}),
        figure(&ChangeFigures::lessShadowM2,
               {.key = "lost_m2",
                .label = NM_TEXT("Less shadow"),
                .definition = NM_TEXT("area where the minutes fell by more than the threshold"),
                .unit = FigureUnit::squareMetres,
                .byThreshold = true,
                .shownWith = ShownWith::shadow}),
        figure(&ChangeFigures::anyMoreShadowM2, {.key = "touched_m2",
                                                 .label = NM_TEXT("Any more shadow"),
                                                 .definition = NM_TEXT("area where the minutes rose at all"),
                                                 .unit = FigureUnit::squareMetres,
                                                 .shownWith = ShownWith::shadow}),
        figure(&ChangeFigures::anyLessShadowM2, {.key = "eased_m2",
                                                 .label = NM_TEXT("Any less shadow"),
                                                 .definition = NM_TEXT("area where the minutes fell at all"),
                                                 .unit = FigureUnit::squareMetres,
                                                 .shownWith = ShownWith::shadow}),
        figure(&ChangeFigures::meanMin, {.key = "mean_min",
                                         .label = NM_TEXT("Mean change"),
                                         .definition = NM_TEXT("mean of the change over the receivers"),
                                         .decimals = 3,
                                         .unit = FigureUnit::minutesADay,
                                         .shownDecimals = 2,
                                         .isChange = true,
                                         .shownWith = ShownWith::shadow}),
        figure(&ChangeFigures::maxMoreShadowMin, {.key = "most_gained_min",
                                                  .label = NM_TEXT("Largest increase"),
                                                  .definition = NM_TEXT("the largest increase of a receiver"),
                                                  .decimals = 2,
                                                  .unit = FigureUnit::minutesADay,
                                                  .shownWith = ShownWith::shadow}),
        figure(&ChangeFigures::maxLessShadowMin, {.key = "most_lost_min",
                                                  .label = NM_TEXT("Largest decrease"),
                                                  .definition = NM_TEXT("the largest decrease of a receiver"),
                                                  .decimals = 2,
                                                  .unit = FigureUnit::minutesADay,
                                                  .shownWith = ShownWith::shadow}),
        asSun(&ChangeFigures::moreShadowM2,
              {.key = "sun_lost_m2",
               .label = NM_TEXT("Less sun"),
               .definition = NM_TEXT("area that lost more minutes of sun than the threshold"),
               .unit = FigureUnit::squareMetres,
               .byThreshold = true}),
        asSun(&ChangeFigures::lessShadowM2,
              {.key = "sun_gained_m2",
               .label = NM_TEXT("More sun"),
               .definition = NM_TEXT("area that gained more minutes of sun than the threshold"),
               .unit = FigureUnit::squareMetres,
               .byThreshold = true}),
        asSun(&ChangeFigures::anyMoreShadowM2, {.key = "sun_any_lost_m2",
                                                .label = NM_TEXT("Any less sun"),
                                                .definition = NM_TEXT("area that lost any sun"),
                                                .unit = FigureUnit::squareMetres}),
        asSun(&ChangeFigures::anyLessShadowM2, {.key = "sun_any_gained_m2",
                                                .label = NM_TEXT("Any more sun"),
                                                .definition = NM_TEXT("area that gained any sun"),
                                                .unit = FigureUnit::squareMetres}),
        derivedFigure(&meanSunChangeMin,
                      {.key = "sun_mean_min",
                       .label = NM_TEXT("Mean change of sun"),
                       .definition = NM_TEXT("mean of the change of sun over the receivers; negative: less "
                                             "sun"),
                       .unit = FigureUnit::minutesADay,
                       .shownDecimals = 2,
                       .isChange = true,
                       .shownWith = ShownWith::sunInstead,
                       .inFiles = false}),
        asSun(&ChangeFigures::maxMoreShadowMin, {.key = "sun_most_lost_min",
                                                 .label = NM_TEXT("Largest loss of sun"),
                                                 .definition = NM_TEXT("the most sun that a receiver loses"),
                                                 .unit = FigureUnit::minutesADay}),
        asSun(&ChangeFigures::maxLessShadowMin, {.key = "sun_most_gained_min",
                                                 .label = NM_TEXT("Largest gain of sun"),
                                                 .definition = NM_TEXT("the most sun that a receiver gains"),
                                                 .unit = FigureUnit::minutesADay}),
    };
    return figures;
}

const Figures<ImpactFigures>& impactFigures() {
    static const Figures<ImpactFigures> figures{
        figure(&ImpactFigures::thresholdMin,
               {.key = "threshold_min",
                .label = NM_TEXT("Threshold"),
                .definition = NM_TEXT("change that counts: minutes a day of gross shadow, minutes of "
                                      "continuous shadow"),
                .decimals = allDigits,
                .unit = FigureUnit::minutes,
                .use = FigureUse::file}),
        figure(&ImpactFigures::receiverAreaM2, findFigure(shadowFigures().rows(), "receiver_area_m2")),
        figure(&ImpactFigures::shadowAreaChangeM2,
               {.key = "shadow_area_change_m2",
                .label = NM_TEXT("Change of the shadow area"),
                .definition = NM_TEXT("change of the sum over the receivers of (share of the sunlit time in "
                                      "shadow x cell area)"),
                .unit = FigureUnit::squareMetres,
                .better = Better::lessShadow,
                .isChange = true,
                .shownWith = ShownWith::shadow}),
        derivedFigure(&sunChangeM2,
                      {.key = "sun_area_change_m2",
                       .label = NM_TEXT("Change of the sunlit area"),
                       .definition = NM_TEXT("change of the sum over the receivers of (share of the sunlit "
                                             "time in the sun x cell area)"),
                       .unit = FigureUnit::squareMetres,
                       .isChange = true,
                       .shownWith = ShownWith::sunInstead,
                       .inFiles = false}),
        figure(&ImpactFigures::becameBuildingM2,
               {.key = "became_building_m2",
                .label = NM_TEXT("Built over"),
                .definition = NM_TEXT("open ground before, under a building after: no receiver"),
                .unit = FigureUnit::squareMetres,
                .use = FigureUse::basis}),
        figure(&ImpactFigures::becameGroundM2,
               {.key = "became_ground_m2",
                .label = NM_TEXT("Became ground"),
                .definition = NM_TEXT("under a building before, open ground after: no receiver"),
                .unit = FigureUnit::squareMetres,
                .use = FigureUse::basis}),
    };
    return figures;
}

const std::vector<Figure>& figuresByThreshold() {
    static const auto figures = [] {
        std::vector<Figure> rows;
        std::ranges::copy_if(changeFigures().rows(), std::back_inserter(rows),
                             [](const Figure& row) { return row.byThreshold && row.inFiles; });
        return rows;
    }();
    return figures;
}

ChangeFigures notComputed() {
    ChangeFigures figures;
    for (const Figure& figure : changeFigures().rows())
        figure.set(&figures, std::numeric_limits<double>::quiet_NaN());
    return figures;
}

const Fields<ImpactSettings>& impactFields() {
    static const Fields<ImpactSettings> fields{
        field(&ImpactSettings::thresholdsMin,
              {.key = "thresholds_min",
               .flag = flags::threshold,
               .label = NM_TEXT("Thresholds of the change"),
               .help = NM_TEXT("Minutes of more or less shadow a day above which area counts; one or more"),
               .hint = "MIN",
               .unit = "min",
               .range = ValueRange{0, ImpactSettings::maxThresholdMin},
               .role = SettingRole::extra,
               .restated = true}),
        field(&ImpactSettings::byBuilding,
              {.key = "each_new_building",
               .flag = flags::byBuilding,
               .label = NM_TEXT("Each new building"),
               .help = NM_TEXT("Also measure the sole contribution of each new building"),
               .role = SettingRole::extra})};
    return fields;
}

}  // namespace noonmark
