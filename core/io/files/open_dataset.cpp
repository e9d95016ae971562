#include "core/io/files/open_dataset.h"

#include <fmt/format.h>

namespace noonmark {

std::vector<std::string> makeWarpArguments(const std::string& fromCrs, const std::string& toCrs,
                                           const Grid& grid) {
    const auto number = [](double value) { return fmt::format("{:.6f}", value); };
    return {"-of",
            "MEM",
            "-s_srs",
            fromCrs,
            "-t_srs",
            toCrs,
            "-te",
            number(grid.westM),
            number(grid.southM),
            number(grid.eastM()),
            number(grid.northM()),
            "-ts",
            std::to_string(grid.columns),
            std::to_string(grid.rows),
            "-novshift",
            "-wm",
            "256"};
}

}  // namespace noonmark
