#include "core/study/not_checked.h"

namespace noonmark {

std::vector<std::string> listUnchecked(const Rule& rule, const City& city) {
    std::vector<std::string> all = rule.notChecked;
    if (!city.terrain) all.emplace_back("Slopes: there is no terrain, so the ground is taken as flat");
    if (!rule.occluders.terrain && city.terrain)
        all.emplace_back("The rule leaves terrain out; here terrain casts shadow");
    if (rule.occluders.trees) all.emplace_back("The rule counts trees; the city has none");
    return all;
}

}  // namespace noonmark
