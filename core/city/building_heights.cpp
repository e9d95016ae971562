#include "core/city/building_heights.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace noonmark {

HeightCounts countHeights(const City& city) {
    HeightCounts counts;
    std::map<long, std::size_t> assumedCm;
    for (const auto& building : city.buildings)
        for (const Part& part : building->parts) {
            ++counts.parts;
            ++counts.bySource[std::size_t(part.heightSource)];
            if (part.heightSource == HeightSource::assumed)
                ++assumedCm[std::lround(100 * (double(part.topM) - double(part.bottomM)))];
        }
    if (assumedCm.empty()) return counts;
    const auto maximum =
        std::ranges::max_element(assumedCm, {}, [](const auto& height) { return height.second; });
    counts.assumedM = double(maximum->first) / 100;
    counts.assumedAlike = assumedCm.size() == 1;
    return counts;
}

bool isProposal(const Building& building) {
    return std::ranges::any_of(building.parts,
                               [](const Part& part) { return part.heightSource == HeightSource::designed; });
}

}  // namespace noonmark
