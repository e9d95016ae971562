#include <memory>
#include <optional>
#include <set>
#include <sstream>

#include "app/cli/base/change_project.h"
#include "app/cli/base/table.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/sheet_options.h"
#include "app/cli/project/project_commands.h"
#include "scenarios/project/title_fields.h"

namespace noonmark::cli {

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
