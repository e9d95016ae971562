#include "core/city/trees/tree_defaults.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "generated/shipped_tree_defaults.h"

namespace noonmark {

namespace {

constexpr double daysOfYear = 365;

struct LeafRow {
    double lat, on, off;
};

struct ShippedTrees {
    std::vector<TreeGroup> groups;
    std::map<std::string, std::size_t, std::less<>> groupOfGenus;  // in small letters
    std::vector<LeafRow> leafRows;                                 // by latitude
};

std::string inSmallLetters(std::string_view text) {
    std::string small(text);
    for (char& letter : small) letter = char(std::tolower(static_cast<unsigned char>(letter)));
    return small;
}

TreeGroup parseGroup(const nlohmann::json& json) {
    return {.key = json.at("key"),
            .shape = parseCrownShape(json.at("shape").get<std::string>()).value(),
            .evergreen = json.at("evergreen"),
            .leafOn = json.at("leaf_on"),
            .leafOff = json.at("leaf_off"),
            .crownPerStem = json.at("crown_per_stem"),
            .heightPerCrown = json.at("height_per_crown"),
            .crownBaseShare = json.at("crown_base_share"),
            .heightM = json.at("height_m"),
            .genera = json.at("genera")};
}

ShippedTrees parseShipped() {
    const auto json = nlohmann::json::parse(shippedTreeDefaults);
    ShippedTrees shipped;
    for (const auto& group : json.at("groups")) {
        for (const auto& genus : group.at("genera"))
            shipped.groupOfGenus[inSmallLetters(genus.get<std::string>())] = shipped.groups.size();
        shipped.groups.push_back(parseGroup(group));
    }
    for (const auto& row : json.at("leaf_days"))
        shipped.leafRows.push_back({row.at("lat"), row.at("on"), row.at("off")});
    return shipped;
}

const ShippedTrees& shippedTrees() {
    static const ShippedTrees shipped = parseShipped();
    return shipped;
}

// Between the rows; beyond them the nearest one.
LeafRow interpolateLeafRow(double lat) {
    const std::vector<LeafRow>& rows = shippedTrees().leafRows;
    const auto next = std::ranges::upper_bound(rows, lat, {}, &LeafRow::lat);
    if (next == rows.begin()) return rows.front();
    if (next == rows.end()) return rows.back();
    const LeafRow &low = *std::prev(next), &high = *next;
    const double share = (lat - low.lat) / (high.lat - low.lat);
    return {lat, low.on + share * (high.on - low.on), low.off + share * (high.off - low.off)};
}

int halfAYearLater(double day) { return int(std::fmod(day - 1 + daysOfYear / 2, daysOfYear)) + 1; }

}  // namespace

const std::vector<TreeGroup>& listTreeGroups() { return shippedTrees().groups; }

const TreeGroup* findTreeGroup(std::string_view species) {
    const auto first = species.find_first_not_of(" \t\"'");
    if (first == species.npos) return nullptr;
    species.remove_prefix(first);
    const auto& genera = shippedTrees().groupOfGenus;
    const auto found = genera.find(inSmallLetters(species.substr(0, species.find_first_of(" \t,;:_'\"-"))));
    return found == genera.end() ? nullptr : &listTreeGroups()[found->second];
}

const TreeGroup& treeGroup(std::string_view key) {
    return *std::ranges::find(listTreeGroups(), key, &TreeGroup::key);
}

LeafDays assumeLeafDays(double latDeg) {
    const LeafRow row = interpolateLeafRow(std::abs(latDeg));
    if (row.on <= 1 && row.off > daysOfYear) return {};
    if (latDeg < 0) return {halfAYearLater(row.on), halfAYearLater(row.off)};
    return {int(std::lround(row.on)), int(std::lround(row.off))};
}

}  // namespace noonmark
