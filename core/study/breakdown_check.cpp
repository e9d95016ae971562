#include "core/study/breakdown_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace noonmark {

namespace {

std::string enginesThatSum(bool byBuilding, const EngineList& engines) {
    std::vector<std::string_view> keys;
    for (const EngineEntry& engine : engines)
        if (byBuilding ? engine.info.capabilities.attribution : engine.info.capabilities.sets)
            keys.push_back(engine.info.key);
    return fmt::format("{}", fmt::join(keys, ", "));
}

}  // namespace

Result<void> checkBreakdown(const StudySettings& settings, const EngineCapabilities& able,
                            const EngineList& engines) {
    const bool byBuilding = settings.contributions;
    const bool wanted = settings.byMonth || byBuilding;
    if (!wanted || (byBuilding ? able.attribution : able.sets)) return {};
    return unsupported(fmt::format("The engine '{}' does not sum shadow by {}", settings.engine,
                                   byBuilding ? "building" : "month"),
                       "engine", fmt::format("Choose one of: {}", enginesThatSum(byBuilding, engines)));
}

}  // namespace noonmark
