#include "core/city/trees/tree_facts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/city/trees/crown.h"
#include "core/city/trees/tree_defaults.h"

namespace noonmark {

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

// As dense as a crown of medium density and default size, whose ratios it has.
Tree makeCanopyColumn(const TreeFacts& facts) {
    const TreeGroup& group = listTreeGroups().front();
    const double heightM = facts.heightM.value_or(group.heightM);
    const double baseM = group.crownBaseShare * heightM,
                 radiusM = std::sqrt(*facts.canopyCellM2 / std::numbers::pi);
    const double groupRadiusM = group.heightM / group.heightPerCrown / 2;
    const double groupChordM =
        computeMeanChord(group.shape, groupRadiusM, group.heightM * (1 - group.crownBaseShare));
    const double chords = computeMeanChord(CrownShape::cylinder, radiusM, heightM - baseM) / groupChordM;
    return {.sourceId = facts.sourceId,
            .heightM = float(heightM),
            .crownBaseM = float(baseM),
            .crownDiameterM = float(2 * radiusM),
            .shape = CrownShape::cylinder,
            .heightSource = TreeSource::measured,
            .crownSource = TreeSource::measured,
            .leafOnTransmissivity = float(std::pow(double(group.leafOn), chords)),
            .leafOffTransmissivity = float(std::pow(double(group.leafOff), chords))};
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
                                                       : group.leafOff};
}

bool isPlausibleTreeHeight(double metres) { return metres >= 0.5 && metres <= 120; }
bool isPlausibleCrown(double metres) { return metres >= 0.3 && metres <= 50; }
bool isPlausibleStem(double metres) { return metres >= 0.01 && metres <= 5; }

}  // namespace noonmark
