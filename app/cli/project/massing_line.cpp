#include "app/cli/project/massing_line.h"

#include <fmt/format.h>

#include <cmath>

#include "app/cli/base/table.h"

namespace noonmark::cli {

std::string lineOf(const MassingFigures& figures) {
    return fmt::format("{} storeys, {:.1f} m; gross floor area {} m2, ratio {:.1f}, coverage {:.0f} %",
                       figures.storeys, figures.heightM,
                       withCommas(std::size_t(std::llround(figures.grossFloorM2))), figures.floorAreaRatio,
                       figures.coverage * 100);
}

std::string linesOf(const std::vector<UseArea>& uses) {
    std::string lines;
    for (const UseArea& area : uses)
        lines += fmt::format("  {}: {} storeys, {} m2\n", area.use.empty() ? "use not stated" : area.use,
                             area.storeys, withCommas(std::size_t(std::llround(area.grossFloorM2))));
    return lines;
}

}  // namespace noonmark::cli
