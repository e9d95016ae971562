#include "app/input/window_arguments.h"

#include "app/input/build_facts.h"

namespace noonmark {

void addWindowArguments(CLI::App& program, WindowArguments& arguments) {
    program.name("noonmark");
    program.description("Measure the shadows of buildings on a city, in a window.");
    program.set_version_flag("-v,--version", buildFactsText);
    program
        .add_option("files", arguments.files,
                    "City files, one project NAME.noonmark.gpkg, or sample:central-park-south, sample:grid "
                    "(default: sample:central-park-south)")
        ->type_name("FILE");
    program.footer("noonmark park.noonmark.gpkg\nnoonmark buildings.geojson terrain.tif");
}

}  // namespace noonmark
