#include "core/review/library/rule_fields.h"

#include <algorithm>

#include "core/review/rule/rule_names.h"

namespace noonmark {

namespace {

constexpr double longestMinutes = 1440;

SpotCondition readSpot(RuleFields fields) {
    SpotCondition spot;
    spot.unbroken = fields.flagOr("unbroken", false);
    spot.minutes = fields.number("minutes", 0, longestMinutes);
    if (fields.has("broken")) {
        RuleFields broken = fields.object("broken");
        spot.brokenMinutes = broken.number("minutes", 0, longestMinutes);
        spot.partMinutes = broken.numberOr("longest_part", 0, longestMinutes, 0);
        spot.maxParts = broken.wholeOr("most_parts", 1, 8, 0);
        broken.finish();
        if (!spot.unbroken) fields.addProblem("broken", "Only unbroken minutes have a broken alternative");
    }
    fields.finish();
    return spot;
}

Limit readLimit(RuleFields fields, const std::string& source) {
    Limit limit;
    limit.comparison = fields.name("compare", comparisonNames());
    limit.isLoss = fields.has("loss");
    limit.ofFormer = limit.isLoss || fields.has("former_ratio");
    limit.value = fields.number(limit.isLoss ? "loss" : limit.ofFormer ? "former_ratio" : "value", 0, 1e9);
    limit.evidence = readEvidence(fields, source);
    fields.finish();
    return limit;
}

void readSeason(RuleFields& fields, Criterion& criterion) {
    if (!fields.has("season")) return;
    const auto texts = fields.texts("season");
    const auto first = texts.size() == 2 ? parseRuleDay(texts[0]) : std::nullopt;
    const auto last = texts.size() == 2 ? parseRuleDay(texts[1]) : std::nullopt;
    if (!first || !last)
        return fields.addProblem("season", "Two days are needed here", R"(Write ["04-01", "10-31"])");
    criterion.season.emplace(*first, *last);
}

void readFacing(RuleFields& fields, Criterion& criterion) {
    if (!fields.has("facing")) return;
    const auto bounds = fields.elements("facing");
    const auto isAzimuth = [](const RuleJson& json) {
        return json.is_number() && json.get<double>() >= 0 && json.get<double>() <= 360;
    };
    if (bounds.size() != 2 || !isAzimuth(bounds[0]) || !isAzimuth(bounds[1]))
        return fields.addProblem("facing", "Two azimuths from 0 to 360 degrees are needed here",
                                 "Write [90, 270]");
    criterion.facing = FacingRange{bounds[0].get<double>(), bounds[1].get<double>()};
}

void readOwnHours(RuleFields& fields, Criterion& criterion) {
    if (!fields.has("hours")) return;
    const auto texts = fields.texts("hours");
    const auto from = texts.size() == 2 ? parseRuleTime(texts[0]) : std::nullopt;
    const auto to = texts.size() == 2 ? parseRuleTime(texts[1]) : std::nullopt;
    if (!from || !to || *from >= *to)
        return fields.addProblem("hours", "Two times of day are needed here", R"(Write ["09:00", "15:00"])");
    criterion.hours.emplace(*from, *to);
}

bool isShare(Measure measure) { return measure == Measure::share || measure == Measure::largestShare; }

void checkCriterion(RuleFields& fields, const Criterion& criterion) {
    for (const Limit& limit : criterion.limits) {
        if (!limit.ofFormer && isShare(criterion.measure) && limit.value > 1)
            fields.addProblem("limit", "A share is compared with 0 to 1");
        if (limit.ofFormer && criterion.quantity == Quantity::incremental)
            fields.addProblem("limit", "Incremental shadow has no former value",
                              "Use the quantity shadow or sun");
        if (limit.isLoss && criterion.quantity != Quantity::sun)
            fields.addProblem("limit", "Only sun is lost", "Use the quantity sun");
    }
    if (criterion.measure == Measure::areaOver &&
        (criterion.quantity != Quantity::shadow || criterion.spot.unbroken))
        fields.addProblem("measure", "An area over so many minutes is about all shadow of its spots",
                          "Use the quantity shadow, and a spot with minutes only");
    if (criterion.measure == Measure::fullCover && criterion.quantity == Quantity::sun)
        fields.addProblem("measure", "Full cover is about shadow", "Use the quantity incremental");
    if (criterion.quantity == Quantity::sun && criterion.runs > 1 && criterion.measure == Measure::spotTotal)
        fields.addProblem("runs", "Only 'spot longest runs' sums runs");
}

void readLimits(RuleFields& fields, Criterion& criterion, const std::string& source) {
    if (!fields.has("limit")) return;
    criterion.limits.push_back(readLimit(fields.object("limit"), source));
    if (fields.has("otherwise")) criterion.limits.push_back(readLimit(fields.object("otherwise"), source));
}

Criterion readCriterion(RuleFields fields, std::string key, const std::string& source) {
    Criterion criterion;
    criterion.key = std::move(key);
    criterion.name = fields.text("name");
    criterion.quantity = fields.name("quantity", quantityNames());
    criterion.measure = fields.name("measure", measureNames());
    criterion.runs = fields.wholeOr("runs", 1, 8, 1);
    criterion.dropShorterMin = fields.numberOr("drop_shorter_min", 0, 600, 0);
    if (criterion.measure == Measure::share || criterion.measure == Measure::areaOver)
        criterion.spot = readSpot(fields.object("spot"));
    readLimits(fields, criterion, source);
    criterion.advisory = fields.flagOr("advisory", false);
    if (fields.has("days")) criterion.combination = fields.name("days", combinationNames());
    readSeason(fields, criterion);
    readFacing(fields, criterion);
    readOwnHours(fields, criterion);
    criterion.belt = fields.nameOr("belt", beltNames(), LineBelt::none);
    criterion.evidence = readEvidence(fields, source);
    checkCriterion(fields, criterion);
    fields.finish();
    return criterion;
}

}  // namespace

Evidence readEvidence(RuleFields& fields, const std::string& ruleSource) {
    Evidence evidence;
    evidence.status = fields.name("status", figureStatusNames());
    evidence.source = fields.textOr("source", ruleSource);
    return evidence;
}

std::vector<Criterion> readCriteria(RuleFields& rule, const std::string& ruleSource) {
    std::vector<Criterion> criteria;
    for (const auto& [key, json] : rule.members("criteria")) {
        if (!isRuleKey(key)) {
            rule.addProblem("criteria", "A key of a criterion has at most 60 of a to z, 0 to 9 and hyphens");
            return {};
        }
        criteria.push_back(
            readCriterion(RuleFields(json, rule.pathOf("criteria." + key), rule.problem()), key, ruleSource));
    }
    return criteria;
}

namespace {

GlazingPoint readGlazingPoint(RuleFields fields) {
    GlazingPoint point;
    point.place = fields.name("at", panePlaceNames());
    point.insideFace = fields.nameOr("face", faceNames(), false);
    if (point.place != PanePlace::middle) {
        point.aboveSillM = fields.numberOr("above_sill_m", 0, 10, 0);
        point.aboveFloorM = fields.numberOr("above_floor_m", 0, 10, 0);
    } else if (fields.has("above_sill_m") || fields.has("above_floor_m")) {
        fields.addProblem("at", "The middle of a pane has no height above sill or floor",
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

void readSweep(RuleFields fields, RuleGlazing& glazing) {
    glazing.minSweepDeg = fields.numberOr("least_deg", 0, 89, 0);
    glazing.sweepOfOpening = fields.flagOr("wall_over_width", false);
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
        fields.addProblem("by_month", "Twelve probabilities are needed here, one for each month");
    for (std::size_t i = 0; i < std::min(months.size(), table.byMonth.size()); ++i) {
        const double value = months[i].is_number() ? months[i].get<double>() : -1;
        if (!(value >= 0 && value <= 1))
            fields.addProblem("by_month", "A probability from 0 to 1 is needed here");
        else
            table.byMonth[i] = value;
    }
    table.evidence = readEvidence(fields, source);
    if (std::ranges::max(table.byMonth) <= 0)
        fields.addProblem("by_month", "The sun must shine in one month at least");
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
            fields.problem().add(path, "A list of one to 20 keys of criteria is needed here",
                                 R"(Write [["annual", "winter"], ["loss"]])");
            continue;
        }
        for (const RuleJson& key : json) {
            const std::string text = key.is_string() ? key.get<std::string>() : std::string();
            if (!isRuleKey(text) || !canDecide(rule, text))
                fields.problem().add(path, "This is no criterion with a limit", "Give keys of criteria");
            all.push_back(text);
        }
    }
}

void readShares(RuleFields& fields, Rule& rule) {
    for (const RuleJson& json : fields.elements("shares")) {
        const std::string path = fmt::format("shares[{}]", rule.shares.size());
        rule.shares.push_back(readShare(RuleFields(json, path, fields.problem()), rule.source));
        const auto found = std::ranges::find(rule.criteria, rule.shares.back().criterion, &Criterion::key);
        if (found == rule.criteria.end() || found->limits.empty())
            fields.problem().add(path + ".criterion", "This is no criterion with a limit");
    }
}

void refuseOfPlaces(RuleFields& fields, const Rule& rule) {
    for (const char* key : {"holds_if", "shares", "sunshine"})
        if (fields.has(key)) fields.addProblem(key, "The field needs receivers.surface \"windows\"");
    for (const Criterion& criterion : rule.criteria)
        if (isOfGlazing(criterion.measure) || criterion.facing || criterion.hours)
            fields.problem().add(
                "criteria." + criterion.key,
                "Measures vsc and apsh, facing and hours need receivers.surface \"windows\"");
}

void checkOfGlazing(RuleFields& fields, const Rule& rule) {
    for (const Criterion& criterion : rule.criteria) {
        const std::string path = "criteria." + criterion.key;
        if (criterion.quantity != Quantity::sun)
            fields.problem().add(path + ".quantity", "Of windows the quantity is \"sun\"");
        if (!isOfSpots(criterion.measure) && !isOfGlazing(criterion.measure))
            fields.problem().add(path + ".measure", "A window has no area",
                                 "Give one of the spot's measures, share, vsc or apsh");
        if (criterion.measure == Measure::skyComponent && rule.receivers.glazing.unit != GlazingUnit::window)
            fields.problem().add(path + ".measure", "The sky component is of single windows",
                                 "Omit receivers.unit");
    }
}

}  // namespace

RuleGlazing readRuleGlazing(RuleFields& receivers, const std::string& ruleSource) {
    RuleGlazing glazing;
    glazing.point = readGlazingPoint(receivers.object("point"));
    glazing.opening = readOpening(receivers.object("opening"), ruleSource);
    if (receivers.has("sweep")) readSweep(receivers.object("sweep"), glazing);
    glazing.unit = receivers.nameOr("unit", unitNames(), GlazingUnit::window);
    return glazing;
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
