#include "core/study/study_fields.h"

#include "core/describe/text.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/review_study.h"
#include "core/sun/period_fields.h"

namespace noonmark {

namespace {

constexpr std::array setChoices{KeyedLabel{"month", "month"}};

Value getSet(const StudySettings& settings) {
    return settings.byMonth ? Value(std::string(setChoices.front().key)) : Value();
}

Result<void> chooseSet(StudySettings& settings, const Value& value) {
    settings.byMonth = value != Value();
    return {};
}

const Fields<ReceiverSettings>& cellSizes() {
    static const Fields<ReceiverSettings> fields{field(&ReceiverSettings::cellM, cellSizeFacts())};
    return fields;
}

const Fields<ReceiverSettings>& surfaces() {
    static const Fields<ReceiverSettings> fields{choiceField(
        &ReceiverSettings::places, receiverPlaceChoices,
        {.key = "receivers_on",
         .flag = "--receivers",
         .label = "Receivers",
         .help = "Where shadow is measured: cells on the ground, roofs or both (roofs: engines horizon, "
                 "ray, auto)",
         .hint = "PLACES"})};
    return fields;
}

const Fields<Region>& regionFields() {
    static const Fields<Region> fields{field(&Region::name, {.key = "region",
                                                             .flag = "--region",
                                                             .label = "Region",
                                                             .role = SettingRole::none,
                                                             .restated = true})};
    return fields;
}

const Fields<StudySettings>& limitFields() {
    static const Fields<StudySettings> fields{
        field(&StudySettings::memoryLimit, {.key = "memory_limit_bytes", .role = SettingRole::none})};
    return fields;
}

}  // namespace

FieldFacts cellSizeFacts() {
    return {.key = "cell_m",
            .flag = "--cell",
            .label = "Cell",
            .help = "Size of a cell, m",
            .unit = "m",
            .range = ValueRange{ReceiverSettings::minCellM, ReceiverSettings::maxCellM},
            .restated = true};
}

const Fields<ErrorSampleSettings>& sampleFields() {
    static const Fields<ErrorSampleSettings> fields{
        field(&ErrorSampleSettings::receivers,
              {.key = "error_sample",
               .flag = "--error-sample",
               .label = "Receivers compared with rays",
               .help = "Receivers that the ray reference recomputes to measure the error; 0: none",
               .hint = "N",
               .range = ValueRange{0, ErrorSampleSettings::maxReceivers},
               .role = SettingRole::extra}),
        field(&ErrorSampleSettings::seed, {.key = "error_sample_seed", .role = SettingRole::extra}),
    };
    return fields;
}

const Fields<StudySettings>& cellFields() {
    static const auto fields = Fields<StudySettings>{}.embed(&StudySettings::receivers, cellSizes());
    return fields;
}

const Fields<StudySettings>& surfaceFields() {
    static const auto fields = Fields<StudySettings>{}.embed(&StudySettings::receivers, surfaces());
    return fields;
}

const Fields<StudySettings>& monthFields() {
    static const Fields<StudySettings> fields{
        derivedField(ValueKind::choice, &getSet, &chooseSet,
                     {.key = "by",
                      .flag = "--by",
                      .label = "Each month by itself",
                      .help = "month: the shadow of each month, as bands and a table (engines horizon, "
                              "projected)",
                      .hint = "SET",
                      .role = SettingRole::extra})
            .among(setChoices)};
    return fields;
}

const Fields<StudySettings>& contributionFields() {
    static const Fields<StudySettings> fields{field(
        &StudySettings::contributions,
        {.key = "contributions",
         .flag = "--contributions",
         .label = "Contribution of each building",
         .help = "Attributed shadow and sole contribution of each building, as a table, a map and sheets "
                 "(engine horizon)",
         .role = SettingRole::extra})};
    return fields;
}

const Fields<StudySettings>& treeFields() {
    static const Fields<StudySettings> fields{
        choiceField(&StudySettings::trees, treeColumnChoices,
                    {.key = "tree_shade",
                     .flag = "--tree-shade",
                     .label = NM_TEXT("Shade of trees"),
                     .help = NM_TEXT("What is measured beside the shadow without trees, where the city has "
                                     "some: without, evergreen, seasonal or all (default)"),
                     .hint = "WHAT",
                     .role = SettingRole::extra})};
    return fields;
}

const Fields<StudySettings>& airFields() {
    static const Fields<StudySettings> fields{
        field(&StudySettings::pressureHPa, {.key = "pressure_hpa",
                                            .flag = "--pressure",
                                            .label = "Air pressure",
                                            .help = "Air pressure for refraction, hPa",
                                            .unit = "hPa",
                                            .range = Observer::pressureRangeHPa}),
        field(&StudySettings::temperatureC, {.key = "temperature_c",
                                             .flag = "--temperature",
                                             .label = "Air temperature",
                                             .help = "Air temperature for refraction, deg C",
                                             .hint = "C",
                                             .unit = "deg C",
                                             .range = Observer::temperatureRangeC}),
    };
    return fields;
}

const Fields<StudySettings>& engineFields() {
    static const Fields<StudySettings> fields{
        field(&StudySettings::engine, {.key = "engine",
                                       .flag = "--engine",
                                       .label = "Engine",
                                       .help = "Engine to compute with: see noonmark-cli engines",
                                       .hint = "ENGINE",
                                       .restated = true}),
        field(&StudySettings::engineSettings,
              {.key = "options",
               .flag = "--option",
               .label = "Options of the engine",
               .help = "A setting of the engine: levels=4, check=yes; may be repeated",
               .hint = "NAME=VALUE"}),
    };
    return fields;
}

const Fields<StudySettings>& studyFields() {
    static const auto fields = Fields<StudySettings>{}
                                   .embed(&StudySettings::period, periodFields(), "period")
                                   .with(airFields())
                                   .embed(&StudySettings::region, regionFields())
                                   .with(cellFields())
                                   .with(surfaceFields())
                                   .with(engineFields())
                                   .with(monthFields())
                                   .with(contributionFields())
                                   .with(treeFields())
                                   .embed(&StudySettings::errorSample, sampleFields())
                                   .with(limitFields());
    return fields;
}

const Fields<ReviewSettings>& reviewFields() {
    static const Fields<ReviewSettings> fields{
        field(&ReviewSettings::year, {.key = "year",
                                      .flag = "--year",
                                      .label = "Year",
                                      .help = "Year of the days (default: that of the first period, or 2026)",
                                      .hint = "YEAR",
                                      .range = ValueRange{1901, 2099},
                                      .restated = true}),
        field(&ReviewSettings::zone, {.key = "zone",
                                      .flag = "--zone",
                                      .label = "Time zone",
                                      .help = "Time zone (default: that of the project's periods)",
                                      .hint = "ZONE",
                                      .entry = TextEntry::zone,
                                      .restated = true}),
        field(&ReviewSettings::cellM, cellSizeFacts())};
    return fields;
}

}  // namespace noonmark
