#include "core/review/library/read_criteria.h"

#include "core/review/rule/rule_times.h"

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
        if (!spot.unbroken) fields.trouble("broken", "Only unbroken minutes have a broken alternative");
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
        return fields.trouble("season", "Two days are needed here", R"(Write ["04-01", "10-31"])");
    criterion.season.emplace(*first, *last);
}

void readFacing(RuleFields& fields, Criterion& criterion) {
    if (!fields.has("facing")) return;
    const auto bounds = fields.elements("facing");
    const auto isAzimuth = [](const RuleJson& json) {
        return json.is_number() && json.get<double>() >= 0 && json.get<double>() <= 360;
    };
    if (bounds.size() != 2 || !isAzimuth(bounds[0]) || !isAzimuth(bounds[1]))
        return fields.trouble("facing", "Two azimuths from 0 to 360 degrees are needed here",
                              "Write [90, 270]");
    criterion.facing = FacingRange{bounds[0].get<double>(), bounds[1].get<double>()};
}

void readOwnHours(RuleFields& fields, Criterion& criterion) {
    if (!fields.has("hours")) return;
    const auto texts = fields.texts("hours");
    const auto from = texts.size() == 2 ? parseRuleTime(texts[0]) : std::nullopt;
    const auto to = texts.size() == 2 ? parseRuleTime(texts[1]) : std::nullopt;
    if (!from || !to || *from >= *to)
        return fields.trouble("hours", "Two times of day are needed here", R"(Write ["09:00", "15:00"])");
    criterion.hours.emplace(*from, *to);
}

bool isShare(Measure measure) { return measure == Measure::share || measure == Measure::largestShare; }

void checkCriterion(RuleFields& fields, const Criterion& criterion) {
    for (const Limit& limit : criterion.limits) {
        if (!limit.ofFormer && isShare(criterion.measure) && limit.value > 1)
            fields.trouble("limit", "A share is compared with 0 to 1");
        if (limit.ofFormer && criterion.quantity == Quantity::incremental)
            fields.trouble("limit", "Incremental shadow has no former value",
                           "Use the quantity shadow or sun");
        if (limit.isLoss && criterion.quantity != Quantity::sun)
            fields.trouble("limit", "Only sun is lost", "Use the quantity sun");
    }
    if (criterion.measure == Measure::areaOver &&
        (criterion.quantity != Quantity::shadow || criterion.spot.unbroken))
        fields.trouble("measure", "An area over so many minutes is about all shadow of its spots",
                       "Use the quantity shadow, and a spot with minutes only");
    if (criterion.measure == Measure::fullCover && criterion.quantity == Quantity::sun)
        fields.trouble("measure", "Full cover is about shadow", "Use the quantity incremental");
    if (criterion.quantity == Quantity::sun && criterion.runs > 1 && criterion.measure == Measure::spotTotal)
        fields.trouble("runs", "Only 'spot longest runs' sums runs");
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
            rule.trouble("criteria", "A key of a criterion has at most 60 of a to z, 0 to 9 and hyphens");
            return {};
        }
        criteria.push_back(readCriterion(RuleFields(json, rule.pathOf("criteria." + key), rule.troubles()),
                                         key, ruleSource));
    }
    return criteria;
}

}  // namespace noonmark
