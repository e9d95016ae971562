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

// Of a city that lacks the column its errors without trees hold, too.
void putInFront(SunByPlace& sun, TreeColumns column) {
    if (const auto index = findTreeColumn(sun, column)) {
        sun.sun = std::move(sun.withTrees[*index].sun);
        keepColumn(sun.errors, describeTrees(column));
        keepColumn(sun.sampledShares, describeTrees(column));
    }
    sun.withTrees.clear();
}

// `baseline` has it in front. Where the scenario lacks it, its changes are those to its sun without trees.
void putInFront(ComparedSun& compared, const SunByPlace& baseline, TreeColumns column) {
    const auto own = findTreeColumn(compared.sun, column);
    putInFront(compared.sun, column);
    compared.changes = own && *own < compared.changesWithTrees.size()
                           ? std::move(compared.changesWithTrees[*own])
                           : computeChanges(baseline, compared.sun);
    compared.changesWithTrees.clear();
}

}  // namespace

std::vector<TreeColumns> listSunColumns(const SunByPlace& baseline, std::span<const ComparedSun> compared) {
    std::vector<TreeColumns> columns{TreeColumns::without};
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
        if (findTreeColumn(baseline, column) || std::ranges::any_of(compared, [&](const ComparedSun& one) {
                return findTreeColumn(one.sun, column).has_value();
            }))
            columns.push_back(column);
    return columns;
}

std::vector<TreeColumns> listSunColumns(const SunOfCities& sun) {
    return listSunColumns(sun.baseline, sun.compared);
}

const std::vector<SunOfPlace>& sunInColumn(const SunByPlace& city, TreeColumns column) {
    const auto index = findTreeColumn(city, column);
    return index ? city.withTrees[*index].sun : city.sun;
}

std::optional<SunOfCities> inColumn(const SunOfCities& sun, TreeColumns column) {
    const std::vector<TreeColumns> columns = listSunColumns(sun);
    if (column == TreeColumns::without || std::ranges::find(columns, column) == columns.end())
        return std::nullopt;
    SunOfCities made = sun;
    putInFront(made.baseline, column);
    for (ComparedSun& compared : made.compared) putInFront(compared, made.baseline, column);
    return made;
}

SunShown showColumn(const std::shared_ptr<const SunOfCities>& all, PlaceColours colours) {
    if (listSunColumns(*all).size() == 1) return {all, std::move(colours)};
    auto made = inColumn(*all, colours.legend.trees);
    colours.column = made ? colours.legend.trees : TreeColumns::without;
    return {made ? std::make_shared<const SunOfCities>(*std::move(made)) : all, std::move(colours)};
}

}  // namespace noonmark
