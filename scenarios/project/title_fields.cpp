#include "scenarios/project/title_fields.h"

#include <array>

#include "core/describe/text.h"

namespace noonmark {

const Fields<TitleBlock>& titleFields() {
    static const Fields<TitleBlock> fields{
        field(&TitleBlock::project, {.key = "project",
                                     .flag = "--title-project",
                                     .label = NM_TEXT("Project"),
                                     .help = NM_TEXT("Title block: the project"),
                                     .hint = "TEXT",
                                     .whenEmpty = NM_TEXT("left out")}),
        field(&TitleBlock::author, {.key = "author",
                                    .flag = "--author",
                                    .label = NM_TEXT("Author"),
                                    .help = NM_TEXT("Title block: the author"),
                                    .hint = "TEXT",
                                    .whenEmpty = NM_TEXT("left out")}),
        field(&TitleBlock::client, {.key = "client",
                                    .flag = "--client",
                                    .label = NM_TEXT("Client"),
                                    .help = NM_TEXT("Title block: the client"),
                                    .hint = "TEXT",
                                    .whenEmpty = NM_TEXT("left out")}),
        field(&TitleBlock::date, {.key = "date",
                                  .flag = "--date",
                                  .label = NM_TEXT("Date"),
                                  .help = NM_TEXT("Title block: the date as printed (default: today)"),
                                  .hint = "TEXT"}),
        field(&TitleBlock::sheetPrefix, {.key = "sheet_prefix",
                                         .flag = "--sheet-prefix",
                                         .label = NM_TEXT("Sheet numbers"),
                                         .help = NM_TEXT("Title block: A- numbers the sheets A-1, A-2, ..."),
                                         .hint = "TEXT",
                                         .whenEmpty = NM_TEXT("example: A- for A-1, A-2...")}),
    };
    return fields;
}

const Fields<SheetSettings>& sheetFields() {
    static constexpr std::array<Choice<UnitSystem>, unitSystems.size()> units{
        {{UnitSystem::metric, "metric", NM_TEXT("Metric")},
         {UnitSystem::imperial, "imperial", NM_TEXT("Imperial")},
         {UnitSystem::both, "both", NM_TEXT("Metric and imperial")}}};
    static const auto fields =
        Fields<SheetSettings>{}
            .embed(&SheetSettings::titleBlock, titleFields())
            .with({choiceField(&SheetSettings::units, units,
                               {.key = "units",
                                .flag = "--units",
                                .label = NM_TEXT("Units"),
                                .help = NM_TEXT("Units of lengths and areas in tables and sheets"),
                                .hint = "UNITS",
                                .hasDefault = false})});
    return fields;
}

}  // namespace noonmark
