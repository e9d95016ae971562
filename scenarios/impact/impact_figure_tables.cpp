#include "scenarios/impact/impact_figure_tables.h"

#include "core/measures/shadow_figures.h"

namespace noonmark {

const Figures<ChangeFigures>& changeFigures() {
    static const Figures<ChangeFigures> figures{
        figure(&ChangeFigures::gainedM2,
               {.key = "gained_m2",
                .label = "More shadow",
                .definition = "area where the minutes rose by more than the threshold"}),
        figure(&ChangeFigures::lostM2,
               {.key = "lost_m2",
                .label = "Less shadow",
                .definition = "area where the minutes fell by more than the threshold"}),
        figure(&ChangeFigures::touchedM2, {.key = "touched_m2",
                                           .label = "Any more shadow",
                                           .definition = "area where the minutes rose at all"}),
        figure(&ChangeFigures::easedM2, {.key = "eased_m2",
                                         .label = "Any less shadow",
                                         .definition = "area where the minutes fell at all"}),
        figure(&ChangeFigures::meanMin, {.key = "mean_min",
                                         .label = "Mean change",
                                         .definition = "mean of the change over the receivers",
                                         .decimals = 3}),
        figure(&ChangeFigures::mostGainedMin, {.key = "most_gained_min",
                                               .label = "Most new shadow",
                                               .definition = "the largest increase of a receiver",
                                               .decimals = 2}),
        figure(&ChangeFigures::mostLostMin, {.key = "most_lost_min",
                                             .label = "Most shadow taken away",
                                             .definition = "the largest decrease of a receiver",
                                             .decimals = 2}),
    };
    return figures;
}

const Figures<ImpactFigures>& impactFigures() {
    static const Figures<ImpactFigures> figures{
        figure(&ImpactFigures::thresholdMin,
               {.key = "threshold_min",
                .label = "Threshold",
                .definition = "change that counts: minutes a day of gross shadow, minutes of "
                              "continuous shadow"}),
        figure(&ImpactFigures::receiverAreaM2, findFigure(shadowFigures().rows(), "receiver_area_m2")),
        figure(&ImpactFigures::shadowAreaChangeM2,
               {.key = "shadow_area_change_m2",
                .label = "Change of the shadow area",
                .definition = "change of the sum over the receivers of (share of the sunlit time in "
                              "shadow x cell area)"}),
        figure(&ImpactFigures::becameBuildingM2,
               {.key = "became_building_m2",
                .label = "Ground built over",
                .definition = "open ground before, under a building after: no receiver"}),
        figure(&ImpactFigures::becameGroundM2,
               {.key = "became_ground_m2",
                .label = "Ground opened",
                .definition = "under a building before, open ground after: no receiver"}),
    };
    return figures;
}

ChangeFigures notComputed() {
    ChangeFigures figures;
    for (const Figure& figure : changeFigures().rows())
        figure.set(&figures, std::numeric_limits<double>::quiet_NaN());
    return figures;
}

}  // namespace noonmark
