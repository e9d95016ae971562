#include "app/cli/options/sheet_options.h"

#include "app/cli/base/change_project.h"
#include "app/cli/base/command.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/project_options.h"
#include "app/cli/options/shared_options.h"
#include "app/input/load_city.h"
#include "app/report/book/review/review_book.h"
#include "app/report/maps/sheet_text.h"
#include "core/describe/field_values.h"
#include "scenarios/project/title_fields.h"

namespace noonmark::cli {

void addSheetOptions(CLI::App& command, SheetOptions& options, const FlagNames& names) {
    addFieldOptions(command, pageFields().of(options.layout.setup));
    addFieldOptions(command, bookFields().of(options.layout));
    addFieldOptions(command, titleFields().of(options.layout.titleBlock),
                    {.names = names, .given = &options.given});
    command.add_option("--logo", options.logo, "Title block: a PNG or JPEG picture of at most 1 MiB")
        ->type_name("FILE");
}

void addDiagramScale(CLI::App& command, SheetOptions& options) {
    addFieldOptions(command, scaleFields().of(options.layout));
}

void addBookExtent(CLI::App& command, SheetOptions& options) {
    addFieldOptions(command, extentFields().of(options.layout));
}

void addElevationSheetOptions(CLI::App& command, SheetOptions& options) {
    addSheetOptions(command, options);
    addDiagramScale(command, options);
}

void addSheetSwitch(CLI::App& command, SheetOptions& options) {
    command.add_flag("--sheets", options.wanted,
                     "Also write sheets.pdf: a book of sheets with frame and title block");
}

Result<BookSettings> bookSettingsOf(const SheetOptions& options, const SheetSettings& ofProject) {
    BookSettings settings = options.layout;
    settings.titleBlock = ofProject.titleBlock;
    settings.units = ofProject.units;
    TitleBlock& block = settings.titleBlock;
    copyFields(titleFields().of(options.layout.titleBlock), titleFields().of(block), options.given);
    const SheetScope words(settings.language);
    if (block.date.empty()) block.date = describeToday().toStdString();
    if (!options.logo.empty()) {
        auto logo = readLogo(options.logo);
        if (!logo) return tl::make_unexpected(logo.error());
        block.logo = *std::move(logo);
    }
    return validate(block).map([&] { return settings; });
}

std::vector<CommandOption> makeRepeatOptions(const SheetOptions& options) {
    std::vector<CommandOption> repeat;  // a text that was emptied, too
    for (const Field& field : titleFields().rows())
        if (options.given.contains(field.flag) && field.flag != "--date")
            repeat.push_back({std::string(field.flag), {formatText(field.get(&options.layout.titleBlock))}});
    return repeat;
}

void addMeasureOptions(CLI::App& command, MeasureOptions& options) {
    addProjectFile(command, options.file);
    command
        .add_option("--region", options.region,
                    "Where to measure: a region of the project, west,south,east,north in degrees, POLYGON "
                    "((lon lat, ...)), a polygon file, or city: the box around all buildings")
        ->required()
        ->type_name("NAME|W,S,E,N|WKT|FILE|city");
    const std::vector<CLI::Option*> before = command.get_options();
    addPeriodOptions(command, options.period);
    addNamedPeriod(command, before, options.periodName);
    addCellOptions(command, options.settings);
    addEngineOptions(command, options.settings);
    command.add_option(flags::out, options.out, "Folder for GeoTIFF, picture, PDF page, CSV and JSON")
        ->required()
        ->type_name("DIR");
    addOverwriteOption(command, options.overwrite);
    addJsonFlag(command, options.json, "Print only the JSON to standard output");
}

void addSaveOption(CLI::App& command, MeasureOptions& options) {
    addProjectCopyOption(command, options.withProject);
    command.add_option("--save,--keep", options.keep, "Save the result in the project under this name")
        ->type_name("NAME");
}

Result<StudySettings> settingsFrom(const MeasureOptions& options, const Project& project) {
    StudySettings settings = options.settings;
    const auto period = periodIn(project, options.periodName, options.period);
    if (!period) return tl::make_unexpected(period.error());
    settings.period = *period;
    auto region = regionIn(project, *project.city, options.region);
    if (!region) return tl::make_unexpected(region.error());
    settings.region = *std::move(region);
    return settings;
}

OutputRules outputRulesOf(const MeasureOptions& options, const Project& project) {
    OutputRules rules = outputRules({options.file}, project.inputs, options.overwrite);
    addPlace(rules, options.region);
    return rules;
}

}  // namespace noonmark::cli
