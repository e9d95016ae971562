#include "app/cli/tiles/tiles_command.h"

namespace noonmark::cli {

void addTilesCommand(CLI::App& app, Run& run) {
    CLI::App* tiles =
        app.add_subcommand("tiles", "Divide a study into tiles for many machines, run and merge them");
    tiles->require_subcommand(1);
    tiles->footer(
        "A study on a cluster:\n"
        "  noonmark-cli tiles plan country.fgb --start 2026-01-01 --days 365 \\\n"
        "    --window sunrise+1.5h..sunset-1.5h --zone Europe/Berlin --region city --out plan\n"
        "  sbatch --array=0-99 --wrap 'noonmark-cli tiles run plan'\n"
        "  noonmark-cli tiles merge plan");
    addPlanTiles(*tiles, run);
    addRunTiles(*tiles, run);
    addTilesStatus(*tiles, run);
    addMergeTiles(*tiles, run);
}

}  // namespace noonmark::cli
