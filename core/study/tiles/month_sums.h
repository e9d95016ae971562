#pragma once

#include "core/study/text/breakdown_text.h"
#include "core/study/tiles/tile_result.h"

namespace noonmark {

/// The shadow of the months of a study, added up over its tiles.
class MonthSums {
public:
    void add(const TileResult& tile);

    /// Nothing unless the settings ask for months. `sun`: of the study.
    [[nodiscard]] std::vector<MonthShadow> months(const StudySettings& settings, const SunSteps& sun,
                                                  double cellAreaM2) const;

private:
    std::vector<double> minutes_;
    std::size_t receivers_ = 0;
};

}  // namespace noonmark
