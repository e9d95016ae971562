#include "core/io/footprints/feature_facts.h"

#include <charconv>

#include "core/describe/text.h"

namespace noonmark {

namespace {

// Takes a quoted word from the front of `text`; nothing if there is none.
std::optional<std::string> takeQuoted(std::string_view& text) {
    if (!text.starts_with('"')) return std::nullopt;
    std::string word;
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] == '"') {
            text.remove_prefix(i + 1);
            return word;
        }
        if (text[i] == '\\' && i + 1 < text.size()) ++i;
        word += text[i];
    }
    return std::nullopt;
}

bool take(std::string_view& text, std::string_view mark) {
    if (!text.starts_with(mark)) return false;
    text.remove_prefix(mark.size());
    return true;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> parseTags(std::string_view text) {
    std::vector<std::pair<std::string, std::string>> tags;
    do {
        auto key = takeQuoted(text);
        if (!key || !take(text, "=>")) break;
        auto value = takeQuoted(text);
        if (!value) break;
        tags.emplace_back(*std::move(key), *std::move(value));
    } while (take(text, ","));
    return tags;
}

namespace {

std::string_view formatText(const FeatureValues& values, FieldRole role) {
    const FeatureValue* value = firstOf(values, role);
    return value != nullptr ? std::string_view(value->text) : std::string_view();
}

bool isNo(std::string_view text) { return text == "no" || text == "false" || text == "0"; }
bool isYes(std::string_view text) { return text == "yes" || text == "true" || text == "1"; }
bool isTagged(std::string_view text) { return !text.empty() && !isNo(text); }

double numberOf(std::string_view text) {
    double number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

enum class Place { surface, underground, contradictory };

// OpenStreetMap's layer is the order of things above each other, in places counted from the level of a plaza
// or a deck: -1 alone says nothing about the ground, unless no storey is above it. level is the number of a
// floor.
bool liesBelow(const FeatureValues& values) {
    const double layer = numberOf(formatText(values, FieldRole::layer));
    const std::string_view storeys = formatText(values, FieldRole::levels);
    const bool noStorey = !storeys.empty() && numberOf(storeys) == 0;
    return layer < -1 || (layer < 0 && noStorey) || numberOf(formatText(values, FieldRole::level)) < 0 ||
           formatText(values, FieldRole::tunnel) == "yes";
}

// What lies below is underground, unless a height, storeys, an entrance or a location indicate a building
// above ground.
Place placeOf(const FeatureValues& values, bool tagged) {
    if (isYes(formatText(values, FieldRole::underground))) return Place::underground;
    if (!tagged) return Place::surface;  // in other data, fields of these names have other meanings
    const std::string_view location = formatText(values, FieldRole::location);
    if (location == "underground") return Place::underground;
    if (!liesBelow(values))
        return numberOf(formatText(values, FieldRole::layer)) < 0 ? Place::contradictory : Place::surface;
    const auto isAbove0 = [&](FieldRole role) { return numberOf(formatText(values, role)) > 0; };
    const bool above = isAbove0(FieldRole::height) || isAbove0(FieldRole::levels) ||
                       isAbove0(FieldRole::minHeight) || isAbove0(FieldRole::minLevel) ||
                       isTagged(formatText(values, FieldRole::entrance)) || !location.empty();
    return above ? Place::contradictory : Place::underground;
}

bool hasShapedRoof(const FeatureValues& values) {
    const std::string_view shape = formatText(values, FieldRole::roofShape);
    return !shape.empty() && shape != "flat" && shape != "no";
}

// Placeholders for "no id" would join many buildings into one.
std::string buildingIdOf(const FeatureValues& values) {
    const std::string_view id = formatText(values, FieldRole::buildingId);
    return id == "0" || id == "-1" ? "" : std::string(id);
}

std::string statusOf(const FeatureValues& values) {
    if (formatText(values, FieldRole::building) == "construction") return "under construction";
    return std::string(formatText(values, FieldRole::status));
}

// Classifies the feature; false if it is left out.
bool classify(FeatureFacts& facts, const FeatureValues& values, const LayerRules& rules, Warnings& warnings) {
    const std::string_view building = formatText(values, FieldRole::building);
    const std::string_view part = formatText(values, FieldRole::buildingPart);
    facts.part = isTagged(part);
    facts.outline = rules.tagged ? isTagged(building) : !facts.part;
    if (!facts.outline && !facts.part) {
        if (rules.sayNoBuilding || isNo(building) || isNo(part))
            warnings.push_back({WarningKind::leftOut, NM_TEXT("is not tagged as a building"), facts.id});
        return false;
    }
    const Place place = placeOf(values, rules.tagged);
    if (place == Place::underground)
        warnings.push_back({WarningKind::leftOut, NM_TEXT("lies underground"), facts.id});
    if (place == Place::contradictory)
        warnings.push_back({WarningKind::assumed,
                            "its layer lies below the ground, but nothing else does; it stands on the ground",
                            facts.id});
    return place != Place::underground;
}

}  // namespace

std::optional<FeatureFacts> collectFacts(const FeatureValues& values, const LayerRules& rules, std::string id,
                                         Warnings& warnings) {
    FeatureFacts facts;
    facts.id = std::move(id);
    if (!classify(facts, values, rules, warnings)) return std::nullopt;
    facts.name = formatText(values, FieldRole::name);
    facts.status = statusOf(values);
    facts.buildingId = buildingIdOf(values);
    const bool canopy = rules.tagged && (formatText(values, FieldRole::building) == "roof" ||
                                         formatText(values, FieldRole::buildingPart) == "roof");
    facts.heights = readHeights(values, rules.heights, canopy, facts.id, warnings);
    if (const auto source = parseHeightSource(formatText(values, FieldRole::heightSource)))
        facts.heights.source = *source;
    if (const std::string_view isOverhanging = formatText(values, FieldRole::isOverhanging);
        !isOverhanging.empty())
        facts.isOverhanging = isYes(isOverhanging);
    if (hasShapedRoof(values))
        warnings.push_back({WarningKind::assumed,
                            NM_TEXT("its roof is not flat; it is drawn flat at its full height"), facts.id});
    return facts;
}

}  // namespace noonmark
