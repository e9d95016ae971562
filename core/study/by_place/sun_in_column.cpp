#include "core/study/by_place/sun_by_place.h"

#include <algorithm>
#include <utility>

#include "core/measures/shadow_figures.h"

namespace noonmark {

namespace {

std::optional<std::size_t> findTreeColumn(const SunByPlace& sun, TreeColumns column) {
    const auto found = std::ranges::find(sun.withTrees, column, &SunWithTrees::column);
    if (found == sun.withTrees.end()) return std::nullopt;
    return std::size_t(found - sun.withTrees.begin());
}

// Errors name the column last: "2026-12-21, trees by their seasons".
std::optional<std::string> withoutColumn(const std::string& of, std::string_view column) {
    if (!of.ends_with(column)) return std::nullopt;
    std::string rest = of.substr(0, of.size() - column.size());
    if (rest.ends_with(", ")) rest.resize(rest.size() - 2);
    return rest;
}

template <class Stated>
void keepColumn(std::vector<Stated>& all, std::string_view column) {
    std::vector<Stated> kept;
    for (Stated& one : all)
        if (auto rest = withoutColumn(one.of, column)) {
            one.of = *std::move(rest);
            kept.push_back(std::move(one));
        }
    all = std::move(kept);
}

void putInFront(SunByPlace& sun, std::size_t index) {
    const std::string_view words = describeTrees(sun.withTrees[index].column);
    sun.sun = std::move(sun.withTrees[index].sun);
    sun.withTrees.clear();
    keepColumn(sun.errors, words);
    keepColumn(sun.sampledShares, words);
}

}  // namespace

std::vector<TreeColumns> listSunColumns(const SunOfCities& sun) {
    std::vector<TreeColumns> columns{TreeColumns::without};
    for (const SunWithTrees& with : sun.baseline.withTrees) columns.push_back(with.column);
    return columns;
}

std::optional<SunOfCities> inColumn(const SunOfCities& sun, TreeColumns column) {
    const auto index = findTreeColumn(sun.baseline, column);
    if (!index) return std::nullopt;
    SunOfCities made = sun;
    putInFront(made.baseline, *index);
    for (ComparedSun& compared : made.compared) {
        if (const auto own = findTreeColumn(compared.sun, column)) putInFront(compared.sun, *own);
        if (*index < compared.changesWithTrees.size())
            compared.changes = std::move(compared.changesWithTrees[*index]);
        compared.changesWithTrees.clear();
    }
    return made;
}

SunShown showColumn(const std::shared_ptr<const SunOfCities>& all, PlaceColours colours) {
    if (all->baseline.withTrees.empty()) return {all, std::move(colours)};
    auto made = inColumn(*all, colours.legend.trees);
    colours.column = made ? colours.legend.trees : TreeColumns::without;
    return {made ? std::make_shared<const SunOfCities>(*std::move(made)) : all, std::move(colours)};
}

}  // namespace noonmark
