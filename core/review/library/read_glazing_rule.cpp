#include "core/review/library/read_glazing_rule.h"

#include <algorithm>

#include "core/review/library/read_criteria.h"

namespace noonmark {

namespace {

GlazingPoint readGlazingPoint(RuleFields fields) {
    GlazingPoint point;
    point.place = fields.name("at", panePlaceNames());
    point.insideFace = fields.nameOr("face", faceNames(), false);
    if (point.place != PanePlace::middle) {
        point.aboveSillM = fields.numberOr("above_sill_m", 0, 10, 0);
        point.aboveFloorM = fields.numberOr("above_floor_m", 0, 10, 0);
    } else if (fields.has("above_sill_m") || fields.has("above_floor_m")) {
        fields.trouble("at", "The middle of a pane has no height above sill or floor",
                       "Give \"sill middle\" or \"sill ends\"");
        fields.numberOr("above_sill_m", 0, 10, 0), fields.numberOr("above_floor_m", 0, 10, 0);
    }
    fields.finish();
    return point;
}

GlazingOpening readOpening(RuleFields fields, const std::string& source) {
    GlazingOpening opening;
    opening.sillM = fields.number("sill_m", 0, 10);
    opening.widthM = fields.number("width_m", 0.1, 20);
    opening.heightM = fields.number("height_m", 0.1, 20);
    opening.wallM = fields.number("wall_m", 0, 3);
    opening.evidence = readEvidence(fields, source);
    fields.finish();
    return opening;
}

void readSweep(RuleFields fields, RuleGlazing& windows) {
    windows.minSweepDeg = fields.numberOr("least_deg", 0, 89, 0);
    windows.sweepOfOpening = fields.flagOr("wall_over_width", false);
    fields.finish();
}

bool isOfGlazing(Measure measure) {
    return measure == Measure::skyComponent || measure == Measure::probableSun;
}

bool isOfSpots(Measure measure) {
    using enum Measure;
    return measure == spotTotal || measure == spotLongestRun || measure == spotLongestRuns ||
           measure == share;
}

UnitShare readShare(RuleFields fields, const std::string& source) {
    UnitShare share;
    share.name = fields.text("name");
    share.criterion = fields.text("criterion");
    share.atLeast = fields.number("at_least", 0, 1);
    share.evidence = readEvidence(fields, source);
    fields.finish();
    return share;
}

SunshineTable readSunshine(RuleFields fields, const std::string& source) {
    SunshineTable table;
    const auto months = fields.elements("by_month");
    if (months.size() != table.byMonth.size())
        fields.trouble("by_month", "Twelve probabilities are needed here, one for each month");
    for (std::size_t i = 0; i < std::min(months.size(), table.byMonth.size()); ++i) {
        const double value = months[i].is_number() ? months[i].get<double>() : -1;
        if (!(value >= 0 && value <= 1))
            fields.trouble("by_month", "A probability from 0 to 1 is needed here");
        else
            table.byMonth[i] = value;
    }
    table.evidence = readEvidence(fields, source);
    if (std::ranges::max(table.byMonth) <= 0)
        fields.trouble("by_month", "The sun must shine in one month at least");
    fields.finish();
    return table;
}

/// Whether a criterion of that key can decide: it exists, has a limit and is not only stated.
bool canDecide(const Rule& rule, const std::string& key) {
    const auto found = std::ranges::find(rule.criteria, key, &Criterion::key);
    return found != rule.criteria.end() && !found->limits.empty() && !found->advisory;
}

void readAlternatives(RuleFields& fields, Rule& rule) {
    for (const RuleJson& json : fields.elements("holds_if")) {
        const std::string path = fmt::format("holds_if[{}]", rule.alternatives.size());
        auto& all = rule.alternatives.emplace_back();
        if (!json.is_array() || json.empty() || json.size() > 20) {
            fields.troubles().add(path, "A list of one to 20 keys of criteria is needed here",
                                  R"(Write [["annual", "winter"], ["loss"]])");
            continue;
        }
        for (const RuleJson& key : json) {
            const std::string text = key.is_string() ? key.get<std::string>() : std::string();
            if (!isRuleKey(text) || !canDecide(rule, text))
                fields.troubles().add(path, "This is no criterion with a limit", "Give keys of criteria");
            all.push_back(text);
        }
    }
}

void readShares(RuleFields& fields, Rule& rule) {
    for (const RuleJson& json : fields.elements("shares")) {
        const std::string path = fmt::format("shares[{}]", rule.shares.size());
        rule.shares.push_back(readShare(RuleFields(json, path, fields.troubles()), rule.source));
        const auto found = std::ranges::find(rule.criteria, rule.shares.back().criterion, &Criterion::key);
        if (found == rule.criteria.end() || found->limits.empty())
            fields.troubles().add(path + ".criterion", "This is no criterion with a limit");
    }
}

void refuseOfPlaces(RuleFields& fields, const Rule& rule) {
    for (const char* key : {"holds_if", "shares", "sunshine"})
        if (fields.has(key)) fields.trouble(key, "The field needs receivers.surface \"windows\"");
    for (const Criterion& criterion : rule.criteria)
        if (isOfGlazing(criterion.measure) || criterion.facing || criterion.hours)
            fields.troubles().add(
                "criteria." + criterion.key,
                "Measures vsc and apsh, facing and hours need receivers.surface \"windows\"");
}

void checkOfGlazing(RuleFields& fields, const Rule& rule) {
    for (const Criterion& criterion : rule.criteria) {
        const std::string path = "criteria." + criterion.key;
        if (criterion.quantity != Quantity::sun)
            fields.troubles().add(path + ".quantity", "Of windows the quantity is \"sun\"");
        if (!isOfSpots(criterion.measure) && !isOfGlazing(criterion.measure))
            fields.troubles().add(path + ".measure", "A window has no area",
                                  "Give one of the spot's measures, share, vsc or apsh");
        if (criterion.measure == Measure::skyComponent && rule.receivers.windows.unit != GlazingUnit::window)
            fields.troubles().add(path + ".measure", "The sky component is of single windows",
                                  "Omit receivers.unit");
    }
}

}  // namespace

RuleGlazing readRuleGlazing(RuleFields& receivers, const std::string& ruleSource) {
    RuleGlazing windows;
    windows.point = readGlazingPoint(receivers.object("point"));
    windows.opening = readOpening(receivers.object("opening"), ruleSource);
    if (receivers.has("sweep")) readSweep(receivers.object("sweep"), windows);
    windows.unit = receivers.nameOr("unit", unitNames(), GlazingUnit::window);
    return windows;
}

void readGlazingVerdicts(RuleFields& fields, Rule& rule) {
    if (rule.receivers.surface != RuleSurface::windows) {
        refuseOfPlaces(fields, rule);
        return;
    }
    checkOfGlazing(fields, rule);
    readAlternatives(fields, rule);
    readShares(fields, rule);
    if (fields.has("sunshine")) rule.sunshine = readSunshine(fields.object("sunshine"), rule.source);
}

}  // namespace noonmark
