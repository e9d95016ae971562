#include "app/input/all_engines.h"

#include "core/lab/lab_engines.h"
#include "render/lab/gl_shadow_maps.h"

namespace noonmark {

const EngineList& allEngines() {
    static const EngineList all = [] {
        EngineList engines = coreAndLabEngines();
        engines.insert(engines.end(), glEngines().begin(), glEngines().end());
        return engines;
    }();
    return all;
}

const EngineList& enginesWith(std::string_view key) {
    return findEngine(coreAndLabEngines(), key) != nullptr ? coreAndLabEngines() : allEngines();
}

bool takesLevelGroundOnly(std::string_view key) {
    const EngineEntry* engine = findEngine(enginesWith(key), key);
    return engine != nullptr && !engine->info.capabilities.terrain;
}

}  // namespace noonmark
