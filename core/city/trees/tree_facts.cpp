#include "core/city/trees/tree_facts.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/describe/field_values.h"
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
    double stemGrowthM = 0;                                        // of the diameter, a year
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
    shipped.stemGrowthM = json.at("stem_growth_m_per_year");
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

namespace {

// Leaf type and leaf cycle say more than nothing where the genus is unknown.
const TreeGroup& groupOf(const TreeFacts& facts) {
    if (const TreeGroup* known = findTreeGroup(facts.species)) return *known;
    if (facts.needles.value_or(false))
        return treeGroup(facts.evergreen.value_or(true) ? "conifer" : "bald conifer");
    if (facts.evergreen.value_or(false)) return treeGroup("evergreen");
    return listTreeGroups().front();
}

struct SizedTree {
    double metres;
    TreeSource source;
};

SizedTree sizeCrown(const TreeFacts& facts, const TreeGroup& group) {
    if (facts.crownDiameterM) return {*facts.crownDiameterM, TreeSource::measured};
    if (facts.stemDiameterM) return {*facts.stemDiameterM * group.crownPerStem, TreeSource::estimated};
    if (facts.heightM) return {*facts.heightM / group.heightPerCrown, TreeSource::estimated};
    return {group.heightM / group.heightPerCrown, TreeSource::assumed};
}

// A tree higher than this by an estimate would be a record.
constexpr double minEstimatedM = 2, maxEstimatedM = 35;

SizedTree sizeHeight(const TreeFacts& facts, const TreeGroup& group, const SizedTree& crown) {
    if (facts.heightM) return {*facts.heightM, TreeSource::measured};
    const double fromCrown = std::clamp(crown.metres * group.heightPerCrown, minEstimatedM, maxEstimatedM);
    if (facts.crownDiameterM || facts.stemDiameterM) return {fromCrown, TreeSource::estimated};
    return {group.heightM, TreeSource::assumed};
}

double findCrownBase(const TreeFacts& facts, const TreeGroup& group, double heightM) {
    const bool isBelowTop = facts.crownBaseM && *facts.crownBaseM >= 0 && *facts.crownBaseM < heightM;
    return isBelowTop ? *facts.crownBaseM : group.crownBaseShare * heightM;
}

// As dense as a crown of its group (medium where nothing is known) and default size, whose ratios it has. A
// wood's outline measures no crown.
Tree makeCanopyColumn(const TreeFacts& facts) {
    const TreeGroup& group = groupOf(facts);
    const bool evergreen = facts.evergreen.value_or(group.evergreen);
    const double heightM = facts.heightM.value_or(group.heightM);
    const double baseM = findCrownBase(facts, group, heightM),
                 radiusM = std::sqrt(*facts.canopyCellM2 / std::numbers::pi);
    const double groupRadiusM = group.heightM / group.heightPerCrown / 2;
    const double groupChordM =
        computeMeanChord(group.shape, groupRadiusM, group.heightM * (1 - group.crownBaseShare));
    const double chords = computeMeanChord(CrownShape::cylinder, radiusM, heightM - baseM) / groupChordM;
    return {
        .sourceId = facts.sourceId,
        .species = facts.species,
        .heightM = float(heightM),
        .crownBaseM = float(baseM),
        .crownDiameterM = float(2 * radiusM),
        .shape = CrownShape::cylinder,
        .evergreen = evergreen,
        .heightSource = facts.heightM ? TreeSource::measured : TreeSource::assumed,
        .crownSource = facts.sourceId == canopyRasterId ? TreeSource::measured : TreeSource::assumed,
        .leafOnTransmissivity = float(std::pow(double(group.leafOn), chords)),
        .leafOffTransmissivity = float(std::pow(double(evergreen ? group.leafOn : group.leafOff), chords)),
        .leafOnDay = facts.leafOnDay,
        .leafOffDay = facts.leafOffDay};
}

}  // namespace

Tree completeTree(const TreeFacts& facts) {
    if (facts.canopyCellM2) return makeCanopyColumn(facts);
    const TreeGroup& group = groupOf(facts);
    const SizedTree crown = sizeCrown(facts, group), height = sizeHeight(facts, group, crown);
    const bool evergreen = facts.evergreen.value_or(group.evergreen);
    return {.sourceId = facts.sourceId,
            .species = facts.species,
            .heightM = float(height.metres),
            .crownBaseM = float(findCrownBase(facts, group, height.metres)),
            .crownDiameterM = float(crown.metres),
            .shape = group.shape,
            .evergreen = evergreen,
            .heightSource = height.source,
            .crownSource = crown.source,
            .leafOnTransmissivity = group.leafOn,
            .leafOffTransmissivity = evergreen         ? group.leafOn
                                     : group.evergreen ? listTreeGroups().front().leafOff
                                                       : group.leafOff,
            .leafOnDay = facts.leafOnDay,
            .leafOffDay = facts.leafOffDay};
}

Tree growTree(const Tree& tree, double years) {
    const TreeGroup& group = groupOf(
        {.species = tree.species, .evergreen = tree.evergreen, .needles = tree.shape == CrownShape::cone});
    const double crownGrowthM = years * shippedTrees().stemGrowthM * group.crownPerStem;
    const double heightM = double(tree.heightM);
    const double grownM = std::min(heightM + crownGrowthM * group.heightPerCrown, maxEstimatedM);
    Tree grown = tree;
    const bool isCanopyCell = tree.shape == CrownShape::cylinder;  // wider, it would cover its neighbours
    if (isCanopyCell || !(grownM > heightM)) return grown;
    const double share = (grownM - heightM) / (crownGrowthM * group.heightPerCrown);
    grown.heightM = float(grownM);
    grown.crownBaseM = float(double(tree.crownBaseM) * grownM / heightM);
    grown.crownDiameterM = float(double(tree.crownDiameterM) + share * crownGrowthM);
    grown.heightSource = grown.crownSource = TreeSource::estimated;
    return grown;
}

namespace {

bool isInRange(std::string_view key, double metres) {
    return fieldWithKey(treeFactFields().rows(), key).range->holds(metres);
}

}  // namespace

bool isPlausibleTreeHeight(double metres) { return isInRange("height_m", metres); }

bool isPlausibleCrown(double metres) { return isInRange("crown_diameter_m", metres); }

bool isPlausibleStem(double metres) { return isInRange("stem_diameter_m", metres); }

}  // namespace noonmark
