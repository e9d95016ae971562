#include "app/cli/options/sheet_options.h"

#include "app/cli/options/field_options.h"
#include "app/report/book/review/review_book.h"
#include "core/describe/value_text.h"
#include "scenarios/project/title_fields.h"

namespace noonmark::cli {

void addSheetOptions(CLI::App& command, SheetOptions& options, const FlagNames& names) {
    addFieldOptions(command, pageFields().of(options.layout.setup));
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

}  // namespace noonmark::cli
