#include "app/cli/load_city.h"

#include "app/cli/interrupt.h"
#include "app/cli/progress_line.h"

namespace noonmark::cli {

Result<LoadedCity> loadCity(const ReadOptions& options, const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    return noonmark::loadCity(options.files, options.settings, progress, interrupt.token());
}

}  // namespace noonmark::cli
