#include <memory>
#include <optional>
#include <sstream>

#include "app/cli/options/sheet_options.h"
#include "app/cli/project/change_project.h"
#include "app/cli/project/project_commands.h"
#include "app/cli/table.h"

namespace noonmark::cli {

namespace {

struct TitleBlockOptions {
    ChangeOptions change;
    std::optional<std::string> project, author, client, date, sheetPrefix, units, logo;
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
    if (options.project) block.project = *options.project;
    if (options.author) block.author = *options.author;
    if (options.client) block.client = *options.client;
    if (options.date) block.date = *options.date;
    if (options.sheetPrefix) block.sheetPrefix = *options.sheetPrefix;
    if (options.units) project.sheets.units = parseUnitSystem(*options.units).value_or(project.sheets.units);
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
    command->add_option("--project", options->project, "Name of the project")->type_name("TEXT");
    command->add_option("--author", options->author, "Author")->type_name("TEXT");
    command->add_option("--client", options->client, "Client")->type_name("TEXT");
    command->add_option("--date", options->date, "Date as printed; \"\": the day on which sheets are made")
        ->type_name("TEXT");
    command->add_option("--sheet-prefix", options->sheetPrefix, "Text before the number of each sheet: A-")
        ->type_name("TEXT");
    command->add_option("--logo", options->logo, "PNG or JPEG picture of at most 1 MiB; \"\" removes it")
        ->type_name("FILE");
    command->add_option("--units", options->units, "Units of lengths and areas in tables and sheets")
        ->check(CLI::IsMember({"metric", "imperial", "both"}))
        ->type_name("UNITS");
    command->footer("noonmark-cli project sheets park.noonmark.gpkg --author \"A. Planner\" --units both");
}

}  // namespace noonmark::cli
