#include "core/describe/text.h"
#include "core/measures/legend_choice.h"

namespace noonmark {

const Fields<LegendChoice>& legendFields() {
    static const Fields<LegendChoice> fields{
        choiceField(&LegendChoice::show, shownChoices(),
                    {.key = "show",
                     .flag = "--show",
                     .label = NM_TEXT("Show"),
                     .help = NM_TEXT("What maps and sheets show: minutes of shadow, hours of sun, or the "
                                     "share of the sunlit time in the sun"),
                     .role = SettingRole::none}),
        choiceField(
            &LegendChoice::ramp, rampChoices(),
            {.key = "ramp",
             .flag = "--ramp",
             .label = NM_TEXT("Colours"),
             .help = NM_TEXT("Colours of maps; all but traffic-light are safe for colour-blind readers. "
                             "Maps of sun by place take violet-orange unless another is named"),
             .role = SettingRole::none}),
        field(&LegendChoice::reversed,
              {.key = "reversed",
               .flag = "--reverse-ramp",
               .label = NM_TEXT("Reversed"),
               .help = NM_TEXT("Turn the colours round: bright where there is much shadow"),
               .role = SettingRole::none}),
        textField(&LegendChoice::range, +[](const LegendRange& range) { return formatText(range); },
                  &parseLegendRange,
                  {.key = "range",
                   .flag = "--range",
                   .label = NM_TEXT("Range"),
                   .help = NM_TEXT("Values at the ends of the legend, in the unit shown: 0:8; without it "
                                   "fitted to each map"),
                   .hint = "LOW:HIGH",
                   .whenEmpty = NM_TEXT("fitted"),
                   .role = SettingRole::none}),
        textField(&LegendChoice::classes,
                  +[](LegendClasses classes) { return formatText(std::move(classes)); }, &parseLegendClasses,
                  {.key = "classes",
                   .flag = "--classes",
                   .label = NM_TEXT("Classes"),
                   .help = NM_TEXT("Classes of the legend: continuous, equal:5, quantiles:5, or the numbers "
                                   "between them: 2,4,6; one number is a threshold"),
                   .hint = "CLASSES",
                   .role = SettingRole::none}),
        choiceField(
            &LegendChoice::changeRamp, changeRampChoices(),
            {.key = "change_ramp",
             .flag = "--change-ramp",
             .label = NM_TEXT("Colours of changes"),
             .help = NM_TEXT("Colours of differences and scores; all but green-red are safe for colour-blind "
                             "readers"),
             .role = SettingRole::none}),
        field(&LegendChoice::changeReversed,
              {.key = "change_reversed",
               .flag = "--reverse-change-ramp",
               .label = NM_TEXT("Changes reversed"),
               .help = NM_TEXT("Turn the colours of differences and scores round"),
               .role = SettingRole::none}),
        textField(
            &LegendChoice::changeClasses,
            +[](LegendClasses classes) { return formatText(std::move(classes)); }, &parseLegendClasses,
            {.key = "change_classes",
             .flag = "--change-classes",
             .label = NM_TEXT("Classes of changes"),
             .help = NM_TEXT("Classes of the legend of differences and scores, as of --classes; numbers "
                             "in minutes of a difference: -30,-10,10,30"),
             .hint = "CLASSES",
             .role = SettingRole::none}),
        choiceField(&LegendChoice::trees, mappedTreeChoices(),
                    {.key = "map_trees",
                     .flag = "--map-trees",
                     .label = NM_TEXT("Trees on maps"),
                     .help = NM_TEXT("Which shadow maps and sheets show where trees reach; files of "
                                     "values hold all that were measured"),
                     .role = SettingRole::none}),
    };
    return fields;
}

}  // namespace noonmark
