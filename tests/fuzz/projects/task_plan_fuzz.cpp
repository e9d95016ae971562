// The plan of a study in tiles, and the state of its tasks.
#include <fstream>

#include "core/study/tile_tasks/run_task.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark;
    using namespace noonmark::tests;
    fuzzFile(planFileName, formatText(data, size));
    const auto plan = readTaskPlan(fuzzFolder());
    if (!plan) return requireSound(plan.error()), 0;
    for (const District& district : plan->districts) requireSound(district.region.polygons);
    const auto status = findStatus(fuzzFolder(), *plan);
    if (!status) return requireSound(status.error()), 0;
    require(status->doneTiles <= status->allTiles && status->allTiles == plan->tiles.size(),
            "every tile belongs to a task");
    require(!statusJson(*plan, *status).empty(), "a status can be shown");
    return 0;
}
