#include "app/cli/base/open_project.h"

#include "app/cli/base/interrupt.h"
#include "app/cli/base/table.h"
#include "app/input/load_photograph.h"

namespace noonmark::cli {

Result<ProjectFile> openProject(const std::string& file, const Console& console) {
    auto disk = ProjectFile::open(file);
    if (!disk) return disk;
    const Interrupt interrupt;
    NoProgress progress;
    Warnings warnings;
    disk->setCityAtHand(withPhotographAtHand(disk->project(), warnings, progress, interrupt.token()).city);
    if (interrupt.token().stop_requested()) return cancelled();
    printWarnings(console.err, warnings);
    return disk;
}

}  // namespace noonmark::cli
