#include "core/io/feature_facts.h"

#include <charconv>
#include <string_view>

namespace noonmark {

namespace {

std::string_view textOf(const FeatureValues& values, FieldRole role) {
    const FeatureValue* value = firstOf(values, role);
    return value != nullptr ? std::string_view(value->text) : std::string_view();
}

bool isNo(std::string_view text) { return text == "no" || text == "false" || text == "0"; }
bool isYes(std::string_view text) { return text == "yes" || text == "true" || text == "1"; }
bool isTagged(std::string_view text) { return !text.empty() && !isNo(text); }

bool isUnderground(const FeatureValues& values, bool tagged) {
    if (isYes(textOf(values, FieldRole::underground))) return true;
    if (!tagged) return false;  // elsewhere fields of these names mean other things
    if (textOf(values, FieldRole::location) == "underground") return true;
    const std::string_view layer = textOf(values, FieldRole::layer);
    int number = 0;
    std::from_chars(layer.data(), layer.data() + layer.size(), number);
    return number < 0;
}

bool hasShapedRoof(const FeatureValues& values) {
    const std::string_view shape = textOf(values, FieldRole::roofShape);
    return !shape.empty() && shape != "flat" && shape != "no";
}

// Placeholders for "no id" would make one building of many.
std::string buildingIdOf(const FeatureValues& values) {
    const std::string_view id = textOf(values, FieldRole::buildingId);
    return id == "0" || id == "-1" ? "" : std::string(id);
}

std::string statusOf(const FeatureValues& values) {
    if (textOf(values, FieldRole::building) == "construction") return "under construction";
    return std::string(textOf(values, FieldRole::status));
}

// What the feature is; false where it is left out.
bool classify(FeatureFacts& facts, const FeatureValues& values, const LayerRules& rules, Warnings& warnings) {
    const std::string_view building = textOf(values, FieldRole::building);
    const std::string_view part = textOf(values, FieldRole::buildingPart);
    facts.part = isTagged(part);
    facts.outline = rules.tagged ? isTagged(building) : !facts.part;
    if (!facts.outline && !facts.part) {
        if (rules.sayNoBuilding || isNo(building) || isNo(part))
            warnings.push_back({WarningKind::leftOut, "says that it is no building", facts.id});
        return false;
    }
    if (!isUnderground(values, rules.tagged)) return true;
    warnings.push_back({WarningKind::leftOut, "lies underground", facts.id});
    return false;
}

}  // namespace

std::optional<FeatureFacts> factsOf(const FeatureValues& values, const LayerRules& rules, std::string id,
                                    Warnings& warnings) {
    FeatureFacts facts;
    facts.id = std::move(id);
    if (!classify(facts, values, rules, warnings)) return std::nullopt;
    facts.name = textOf(values, FieldRole::name);
    facts.status = statusOf(values);
    facts.buildingId = buildingIdOf(values);
    const bool canopy = rules.tagged && (textOf(values, FieldRole::building) == "roof" ||
                                         textOf(values, FieldRole::buildingPart) == "roof");
    facts.heights = readHeights(values, rules.heights, canopy, facts.id, warnings);
    if (const auto source = heightSourceNamed(textOf(values, FieldRole::heightSource)))
        facts.heights.source = *source;
    if (const std::string_view hangs = textOf(values, FieldRole::hangs); !hangs.empty())
        facts.hangs = isYes(hangs);
    if (hasShapedRoof(values))
        warnings.push_back(
            {WarningKind::assumed, "its roof is not flat; it is drawn flat at its full height", facts.id});
    return facts;
}

}  // namespace noonmark
