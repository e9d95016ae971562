#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>

#include "app/cli/base/change_project.h"
#include "app/cli/base/command.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/save_city.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/options/sheet_options.h"
#include "app/cli/project/drawn_times.h"
#include "app/cli/project/project_commands.h"
#include "app/input/load_city.h"
#include "app/report/bodies/body_files.h"
#include "core/describe/command_options.h"
#include "scenarios/massing/tower_design.h"
#include "scenarios/project/project_file.h"
#include "scenarios/project/title_fields.h"

namespace noonmark::cli {

namespace {

struct ExportOptions {
    std::string file;
    std::string scenario;
    std::string out;
    BodyFileSettings bodies;
    bool overwrite = false;
    bool json = false;
};

const std::map<std::string, WrittenBuildings> buildingNames{{"all", WrittenBuildings::all},
                                                            {"proposed", WrittenBuildings::proposed}};

int runExport(const ExportOptions& options, const Console& console) {
    const OffscreenQt qt;  // finds the library that writes glTF and OBJ
    const auto disk = ProjectFile::open(options.file);
    if (!disk) return fail(console, disk.error(), exitUsage);
    const OutputRules rules = outputRules({options.file}, disk->project().inputs, options.overwrite);
    if (const auto may = checkOutput(options.out, detectOutputKind(options.out), rules); !may)
        return fail(console, may.error(), exitUsage);
    const auto city = cityOf(disk->project(), options.scenario);
    if (!city) return fail(console, city.error(), exitUsage);
    const auto proposed = listProposed(disk->project().scenarios, options.scenario);
    if (!proposed) return fail(console, proposed.error(), exitUsage);
    auto written = writeBodies(options.out, city->city, *proposed, options.bodies);
    if (!written) return fail(console, written.error(), exitUsage);
    printSaved(
        {options.out, written->buildings, written->parts, written->plane, std::move(written->warnings)},
        options.json, console.out);
    return exitOk;
}

}  // namespace

void addProjectExport(CLI::App& project, Run& run) {
    const auto options = std::make_shared<ExportOptions>();
    CLI::App* command = project.add_subcommand(
        "export", "Write the buildings of a scenario for GIS and CAD: GeoPackage, DXF, OBJ, glTF");
    addProjectFile(*command, options->file);
    command->add_option(flags::scenario, options->scenario, "The scenario to write")
        ->default_val(existingCity)
        ->type_name("NAME");
    command->add_option(flags::out, options->out, "The file to write; its ending chooses the format")
        ->required()
        ->type_name("FILE.gpkg|dxf|obj|glb");
    command->add_option("--buildings", options->bodies.which, "all (default), or those the scenario proposes")
        ->transform(CLI::CheckedTransformer(buildingNames).description(""))
        ->type_name("all|proposed");
    addPlaneOption(*command, options->bodies.plane, "Plane of DXF: local (default) or utm");
    addOverwriteOption(*command, options->overwrite);
    addJsonFlag(*command, options->json, "Report what was written as JSON");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runExport(*options, console); };
    });
}

namespace {

struct TitleBlockOptions {
    ChangeOptions change;
    SheetSettings sheets{};
    std::set<std::string, std::less<>> given{};
    std::optional<std::string> logo;
};

std::string describe(const SheetSettings& sheets) {
    const TitleBlock& block = sheets.titleBlock;
    Table table;
    table.add("project", block.project);
    table.add("author", block.author);
    table.add("client", block.client);
    table.add("date", block.date.empty() ? "the day on which the sheets are made" : block.date);
    table.add("sheets", block.sheetPrefix + "1, " + block.sheetPrefix + "2, ...");
    table.add("logo", block.logo.empty() ? "none" : withCommas(block.logo.size()) + " bytes");
    table.add("units", std::string(nameOf(sheets.units)));
    std::ostringstream words;
    table.print(words);
    return words.str();
}

Result<std::string> change(const TitleBlockOptions& options, Project& project) {
    TitleBlock& block = project.sheets.titleBlock;
    copyFields(sheetFields().of(options.sheets), sheetFields().of(project.sheets), options.given);
    if (options.logo) {
        auto logo = options.logo->empty() ? Result<std::string>(std::string()) : readLogo(*options.logo);
        if (!logo) return tl::make_unexpected(logo.error());
        block.logo = *std::move(logo);
    }
    if (auto sound = validate(block); !sound) return tl::make_unexpected(sound.error());
    return describe(project.sheets);
}

}  // namespace

void addProjectSheets(CLI::App& project, Run& run) {
    const auto options = std::make_shared<TitleBlockOptions>();
    CLI::App* command =
        addChangeCommand(project, "sheets", "Set the title block of the sheets, and the units of results",
                         options, change, run);
    addFieldOptions(*command, sheetFields().of(options->sheets),
                    {.names = {{"--title-project", "--project,--title-project"}}, .given = &options->given});
    command->add_option("--logo", options->logo, "PNG or JPEG picture of at most 1 MiB; \"\" removes it")
        ->type_name("FILE");
    command->footer("noonmark-cli project sheets park.noonmark.gpkg --author \"A. Planner\" --units both");
}

}  // namespace noonmark::cli
