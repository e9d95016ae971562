#include "app/cli/options/picture_option.h"

#include "app/cli/options/field_options.h"
#include "app/cli/options/number_range.h"
#include "app/report/sheets/picture_width.h"

namespace noonmark::cli {

void addPictureOption(CLI::App& command, int& widthPx) {
    command
        .add_option("--picture-width", widthPx,
                    "Width of the PNG in pixels; its text grows with it, its height follows the region")
        ->capture_default_str()
        ->check(within(minPictureWidth, maxPictureWidth))
        ->type_name("PX");
}

void addLegendOptions(CLI::App& command, LegendChoice& legend) {
    addFieldOptions(command, legendFields().of(legend));
}

}  // namespace noonmark::cli
