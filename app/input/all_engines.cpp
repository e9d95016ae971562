#include "app/input/all_engines.h"

#include "core/engines/engine_ground.h"
#include "render/gl/gl_engines.h"

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

// All OpenGL engines require level ground.
bool isOnLevelGroundOnly(std::string_view key) {
    return onLevelGroundOnly(key) || findEngine(coreEngines(), key) == nullptr;
}

}  // namespace noonmark
