#include "app/cli/options/sheet_options.h"

#include "app/cli/options/elevation_sheet_options.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/number_range.h"
#include "app/report/book/review/review_book.h"
#include "core/describe/value_text.h"
#include "scenarios/project/title_fields.h"

namespace noonmark::cli {

namespace {

void addLayoutOptions(CLI::App& command, SheetOptions& options, const std::string& file) {
    command.add_option("--paper", options.paper, "Paper of " + file + ": A4, A3, A1, Letter or Tabloid")
        ->capture_default_str()
        ->check(CLI::IsMember({"A4", "A3", "A1", "Letter", "Tabloid"}, CLI::ignore_case))
        ->type_name("PAPER");
    command.add_flag("--landscape", options.landscape, "Sheets are wider than high");
    addFieldOptions(command, titleFields().of(options.title), {.given = &options.given});
    command.add_option("--logo", options.logo, "Title block: a PNG or JPEG picture of at most 1 MiB")
        ->type_name("FILE");
}

void addScaleOption(CLI::App& command, SheetOptions& options, const std::string& drawings) {
    command
        .add_option("--scale", options.scale,
                    "Scale of the " + drawings + ": 2000 for 1:2000 (default: a round one that fits)")
        ->check(within(BookSettings::leastScale, BookSettings::mostScale))
        ->type_name("NUMBER");
}

}  // namespace

void addSheetOptions(CLI::App& command, SheetOptions& options) {
    addLayoutOptions(command, options, "sheets.pdf");
}

void addDiagramScale(CLI::App& command, SheetOptions& options) {
    addScaleOption(command, options, "diagrams and elevations");
}

void addElevationSheetOptions(CLI::App& command, SheetOptions& options) {
    addLayoutOptions(command, options, "elements.pdf");
    addScaleOption(command, options, "elevations");
}

void addSheetSwitch(CLI::App& command, SheetOptions& options) {
    command.add_flag("--sheets", options.wanted,
                     "Also write sheets.pdf: a book of sheets with frame and title block");
}

Result<BookSettings> bookSettingsOf(const SheetOptions& options, const SheetSettings& ofProject) {
    BookSettings settings{
        {*parsePaper(options.paper), options.landscape}, {}, ofProject.titleBlock, ofProject.units};
    if (options.scale > 0) settings.scale = options.scale;
    TitleBlock& block = settings.titleBlock;
    copyFields(titleFields().of(options.title), titleFields().of(block), options.given);
    if (block.date.empty()) block.date = describeToday().toStdString();
    if (!options.logo.empty()) {
        auto logo = readLogo(options.logo);
        if (!logo) return tl::make_unexpected(logo.error());
        block.logo = *std::move(logo);
    }
    return validate(block).map([&] { return settings; });
}

std::vector<CommandOption> makeRepeatOptions(const SheetOptions& options, const BookSettings& settings) {
    std::vector<CommandOption> repeat = noonmark::makeRepeatOptions(settings);
    // The date is among the book's own. A text that was emptied is restated, too.
    for (const Field& field : titleFields().rows())
        if (options.given.contains(field.flag) && field.flag != "--date")
            repeat.push_back({std::string(field.flag), {formatText(field.get(&options.title))}});
    return repeat;
}

}  // namespace noonmark::cli
