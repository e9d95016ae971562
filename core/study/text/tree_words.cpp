#include "core/study/text/tree_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/engines/api/tree_shade.h"
#include "core/io/heights/height_facts.h"
#include "core/measures/statistics.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

std::size_t countTrees(const Trees& trees, TreeSource Tree::*source, TreeSource value) {
    return std::size_t(std::ranges::count(trees.trees, value, source));
}

Json sourcesJson(const Trees& trees, TreeSource Tree::*source) {
    Json json = Json::object();
    for (const TreeSource value : treeSources)
        json[std::string(nameOf(value))] = countTrees(trees, source, value);
    return json;
}

std::string describeSources(const Trees& trees, TreeSource Tree::*source) {
    std::string text;
    for (const TreeSource value : treeSources)
        if (const std::size_t count = countTrees(trees, source, value); count > 0)
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", formatThousands(count), nameOf(value));
    return text;
}

// Of a year that is no leap year.
std::string formatDay(int dayOfYear) {
    using namespace std::chrono;
    const year_month_day date(sys_days(year(2025) / January / 1) + days(dayOfYear - 1));
    return fmt::format("{:02}-{:02}", unsigned(date.month()), unsigned(date.day()));
}

}  // namespace

Json treesJson(const Trees& trees) {
    Json json{{"count", trees.trees.size()},
              {"evergreen", std::ranges::count(trees.trees, true, &Tree::evergreen)},
              {"height_sources", sourcesJson(trees, &Tree::heightSource)},
              {"crown_sources", sourcesJson(trees, &Tree::crownSource)}};
    const LeafDays& leaf = trees.leafDays;
    json["leaf_on"] = leaf.on == leaf.off ? Json() : Json(formatDay(leaf.on));
    json["leaf_off"] = leaf.on == leaf.off ? Json() : Json(formatDay(leaf.off));
    return json;
}

Json treesJson(const Trees& trees, const ShadowField& field) {
    Json json = treesJson(trees);
    json["used"] = field.trees ? field.trees->treesUsed : 0;
    if (!field.trees) return json;
    json["shaded_from"] = field.trees->shadedFrom;
    json["how"] = field.trees->how;
    const double bareMin = computeStatistics(field).meanGrossMin;
    for (const ShadeColumn& shade : listShadeColumns(field)) {
        const double allMin = computeStatistics(*shade.field).meanGrossMin;
        json["share_of_shade" + suffixOf(shade.column)] = allMin > 0 ? Json(1 - bareMin / allMin) : Json();
    }
    return json;
}

std::string describeTrees(const Trees& trees) {
    return fmt::format("{}; heights: {}; crowns: {}", formatThousands(trees.trees.size()),
                       describeSources(trees, &Tree::heightSource),
                       describeSources(trees, &Tree::crownSource));
}

std::string describeTrees(const Trees& trees, const ShadowField& field) {
    return fmt::format("{} can reach a receiver, of {}; trunks are left out",
                       formatThousands(field.trees ? field.trees->treesUsed : 0), describeTrees(trees));
}

}  // namespace noonmark
