#include "app/input/all_engines.h"

#include "render/gl/gl_shadow_maps.h"

namespace noonmark {

const EngineList& allEngines() {
    static const EngineList all = [] {
        EngineList engines = coreEngines();
        engines.insert(engines.end(), glEngines().begin(), glEngines().end());
        return engines;
    }();
    return all;
}

const EngineList& enginesWith(std::string_view key) {
    return findEngine(coreEngines(), key) != nullptr ? coreEngines() : allEngines();
}

bool takesLevelGroundOnly(std::string_view key) {
    const EngineEntry* engine = findEngine(enginesWith(key), key);
    return engine != nullptr && !engine->info.capabilities.terrain;
}

}  // namespace noonmark
