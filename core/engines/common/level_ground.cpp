#include "core/engines/common/level_ground.h"

#include <fmt/format.h>

namespace noonmark {

Result<void> checkLevelGround(const City& city, const Receivers& receivers, std::string_view engineFalls) {
    if (!city.terrain && receivers.flat()) return {};
    const char* why = city.terrain ? "this city has terrain" : "receivers on roofs are asked for";
    return failure(fmt::format("{} on flat ground only, and {}", engineFalls, why), "engine",
                   "Choose the horizon sweep or the ray reference");
}

}  // namespace noonmark
