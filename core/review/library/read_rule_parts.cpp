#include "core/review/library/rule_fields.h"

#include "core/review/rule/rule_names.h"

namespace noonmark {

namespace {

using std::chrono::month_day;

constexpr auto dayAdvice = "Write month and day: 03-21";

month_day dayFrom(const std::string& text, const std::string& path, RuleProblem& problem) {
    const auto day = parseRuleDay(text);
    if (!day && !text.empty()) problem.add(path, "This is not a day of the year", dayAdvice);
    return day.value_or(month_day{std::chrono::January / 1});
}

double timeFrom(const std::string& text, const std::string& path, RuleProblem& problem) {
    const auto time = parseRuleTime(text);
    if (!time && !text.empty())
        problem.add(path, "This is not a time of day", "Write hours and minutes: 09:18");
    return time.value_or(0);
}

std::vector<double> timesFrom(RuleFields& fields, const char* key) {
    std::vector<double> times;
    for (const std::string& text : fields.texts(key))
        times.push_back(timeFrom(text, fields.pathOf(key), fields.problem()));
    return times;
}

/// "03-21", or an object with day, label, same_as, status and source.
RuleDay readDay(const RuleJson& json, const std::string& path, RuleProblem& problem,
                const Evidence& standard) {
    if (json.is_string()) return {dayFrom(json.get<std::string>(), path, problem), {}, {}, standard};
    RuleFields fields(json, path, problem);
    RuleDay day{dayFrom(fields.text("day"), path, problem), {}, fields.textOr("label", {}), standard};
    for (const std::string& text : fields.texts("same_as"))
        day.sameAs.push_back(dayFrom(text, path, problem));
    if (fields.has("status")) day.evidence = readEvidence(fields, standard.source);
    fields.finish();
    return day;
}

void readRange(RuleFields& fields, RuleDays& days) {
    days.first = dayFrom(fields.text("from"), fields.pathOf("from"), fields.problem());
    days.last = dayFrom(fields.text("to"), fields.pathOf("to"), fields.problem());
    days.everyDays = fields.wholeOr("every", 1, 31, 1);
    days.mirrored = fields.flagOr("mirrored", false);
}

void checkDays(RuleFields& fields, const RuleDays& days) {
    for (std::size_t i = 0; i < days.fixed.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (days.fixed[i].day == days.fixed[j].day)
                fields.addProblem("on", "The day " + formatText(days.fixed[i].day) + " is there twice");
    const bool wholeYear = days.first == std::chrono::January / 1 && days.last == std::chrono::December / 31;
    if (days.mirrored && !wholeYear)
        fields.addProblem("mirrored", "Only a whole year is mirrored", "Give from 01-01 and to 12-31");
}

/// One bound, or a list of them.
std::vector<HoursBound> readBounds(RuleFields& fields, const char* key, const RuleJson& json) {
    std::vector<HoursBound> bounds;
    const std::vector<RuleJson> all =
        json.is_array() ? std::vector<RuleJson>(json.begin(), json.end()) : std::vector<RuleJson>(1, json);
    for (const RuleJson& text : all) {
        const auto bound = text.is_string() ? parseHoursBound(text.get<std::string>()) : std::nullopt;
        if (!bound)
            fields.addProblem(key, "A time is needed here", "Write 09:18, sunrise+1.5h or sunset-90m");
        bounds.push_back(bound.value_or(HoursBound{}));
    }
    if (bounds.empty() || bounds.size() > 8) fields.addProblem(key, "One to eight times are needed here");
    return bounds;
}

HoursOfDay readHours(const RuleJson& json, const std::string& path, RuleProblem& problem) {
    RuleFields pair(RuleJson::object(), path, problem);
    if (!json.is_array() || json.size() != 2) {
        problem.add(path, "Two times are needed here", R"(Write ["08:51", "14:53"])");
        return {{HoursBound{}}, {HoursBound{}}};
    }
    return {readBounds(pair, "from", json[0]), readBounds(pair, "to", json[1])};
}

bool isOrdered(const HoursOfDay& hours) {
    for (const HoursBound& from : hours.from)
        for (const HoursBound& to : hours.to)
            if (from.kind == HoursBound::Kind::clock && to.kind == from.kind && from.minutes >= to.minutes)
                return false;
    return true;
}

void checkHours(RuleFields& fields, const CountedHours& window) {
    if (!isOrdered(window.hours)) fields.addProblem("hours", "The hours end before they begin");
    for (const auto& [day, hours] : window.byDay)
        if (!isOrdered(hours))
            fields.addProblem("by_day", "The hours of " + formatText(day) + " end before they begin");
}

std::vector<RuleColumn> readColumns(RuleFields& fields) {
    std::vector<RuleColumn> columns;
    for (const RuleJson& json : fields.elements("columns")) {
        RuleFields column(json, fmt::format("{}[{}]", fields.pathOf("columns"), columns.size()),
                          fields.problem());
        columns.push_back({column.text("title"), column.text("key")});
        column.finish();
    }
    return columns;
}

RuleDiagrams readDiagrams(RuleFields fields, const std::string& source) {
    RuleDiagrams diagrams;
    diagrams.timesMin = timesFrom(fields, "times");
    for (const auto& [key, json] : fields.members("by_day")) {
        RuleFields day(RuleJson{{"times", json}}, fields.pathOf("by_day"), fields.problem());
        diagrams.byDay[dayFrom(key, fields.pathOf("by_day"), fields.problem())] = timesFrom(day, "times");
    }
    diagrams.views = fields.texts("views");
    diagrams.evidence = readEvidence(fields, source);
    fields.finish();
    return diagrams;
}

}  // namespace

RuleDays readDays(RuleFields& rule, const std::string& ruleSource) {
    RuleFields fields = rule.object("days");
    RuleDays days;
    days.evidence = readEvidence(fields, ruleSource);
    for (const RuleJson& json : fields.elements("on"))
        days.fixed.push_back(readDay(json, fmt::format("{}[{}]", fields.pathOf("on"), days.fixed.size()),
                                     fields.problem(), days.evidence));
    if (days.fixed.empty()) readRange(fields, days);
    days.combination = fields.nameOr("must", combinationNames(), DayCombination::every);
    if (fields.has("year")) days.year = fields.wholeOr("year", 1901, 2099, 2026);
    checkDays(fields, days);
    fields.finish();
    return days;
}

CountedHours readRuleHours(RuleFields& rule, const std::string& ruleSource) {
    RuleFields fields = rule.object("window");
    CountedHours window;
    window.hours = readHours(fields.elements("hours"), fields.pathOf("hours"), fields.problem());
    for (const auto& [key, json] : fields.members("by_day"))
        window.byDay[dayFrom(key, fields.pathOf("by_day"), fields.problem())] =
            readHours(json, fields.pathOf("by_day"), fields.problem());
    window.sunrise = fields.nameOr("sunrise", sunriseNames(), SunriseRule::upperLimb);
    window.minSunDeg = fields.numberOr("lowest_sun_deg", 0, 89, 0);
    window.evidence = readEvidence(fields, ruleSource);
    checkHours(fields, window);
    fields.finish();
    return window;
}

RuleClock readClock(RuleFields& rule, const std::string& ruleSource) {
    RuleFields fields = rule.object("clock");
    RuleClock clock;
    clock.settings.kind = fields.name("kind", clockNames());
    if (clock.settings.kind == ClockKind::fixed)
        clock.settings.offsetHours = fields.number("utc_offset_h", -14, 14);
    clock.evidence = readEvidence(fields, ruleSource);
    fields.finish();
    return clock;
}

RuleSampling readSampling(RuleFields& rule, const std::string& ruleSource) {
    RuleFields fields = rule.object("sampling");
    RuleSampling sampling;
    sampling.stepMinutes = fields.number("step_min", 1.0 / 60, 240);
    sampling.roundTo = fields.wholeOr("round_to_min", 1, 60, 0);
    if (sampling.roundTo != 0 && 60 % sampling.roundTo != 0)
        fields.addProblem("round_to_min", "The minutes must divide an hour", "Give 60, 30, 20, 15, 10 or 5");
    sampling.evidence = readEvidence(fields, ruleSource);
    fields.finish();
    return sampling;
}

std::optional<RoadShift> readRoadShift(RuleFields& receivers) {
    if (!receivers.has("road_shift")) return std::nullopt;
    RuleFields fields = receivers.object("road_shift");
    RoadShift shift;
    shift.narrowM = fields.number("narrow_m", 0, 1000);
    shift.share = fields.number("share", 0, 1);
    shift.fromFarSideM = fields.number("far_side_m", 0, 1000);
    fields.finish();
    if (shift.fromFarSideM > shift.narrowM)
        fields.addProblem("far_side_m", "The distance must be at most narrow_m");
    return shift;
}

RuleReceivers readReceivers(RuleFields& rule, const std::string& ruleSource) {
    RuleFields fields = rule.object("receivers");
    RuleReceivers receivers;
    receivers.surface = fields.name("surface", surfaceNames());
    if (receivers.surface == RuleSurface::plane) receivers.planeM = fields.number("plane_m", 0, 1000);
    for (const std::string& text : fields.texts("kinds")) {
        const auto kind = parsePlaceKind(text);
        if (!kind) fields.addProblem("kinds", fmt::format("'{}' is no kind of place", text));
        receivers.kinds.push_back(kind.value_or(PlaceKind::other));
    }
    if (fields.has("lines_m")) {
        RuleFields lines = fields.object("lines_m");
        receivers.innerLineM = lines.number("inner", 0, 1000);
        receivers.outerLineM = lines.number("outer", 0.1, 1000);
        lines.finish();
        if (receivers.innerLineM >= receivers.outerLineM)
            fields.addProblem("lines_m", "The outer line must be farther out than the inner one");
    }
    if (fields.has("road_shift") && !receivers.hasLines())
        fields.addProblem("road_shift", "The field needs lines_m");
    receivers.roads = readRoadShift(fields);
    if (receivers.surface == RuleSurface::windows) receivers.glazing = readRuleGlazing(fields, ruleSource);
    receivers.evidence = readEvidence(fields, ruleSource);
    fields.finish();
    return receivers;
}

namespace {

// A name; an object with a name, status and source; or, in rules of the first releases, true or false.
void readRuleTrees(RuleFields& fields, const std::string& ruleSource, RuleOccluders& occluders) {
    occluders.treesEvidence = occluders.evidence;
    if (fields.isFlag("trees")) {
        occluders.trees = fields.flagOr("trees", false) ? RuleTrees::seasonal : RuleTrees::without;
    } else if (fields.isObject("trees")) {
        RuleFields trees = fields.object("trees");
        occluders.trees = trees.name("count", ruleTreesNames());
        occluders.treesEvidence = readEvidence(trees, ruleSource);
        trees.finish();
    } else {
        occluders.trees = fields.nameOr("trees", ruleTreesNames(), RuleTrees::without);
    }
}

}  // namespace

RuleOccluders readOccluders(RuleFields& rule, const std::string& ruleSource) {
    RuleFields fields = rule.object("occluders");
    RuleOccluders occluders;
    occluders.casters = fields.name("casters", casterNames());
    occluders.terrain = fields.flagOr("terrain", true);
    occluders.evidence = readEvidence(fields, ruleSource);
    readRuleTrees(fields, ruleSource, occluders);
    fields.finish();
    return occluders;
}

RuleBaseline readBaseline(RuleFields& rule, const std::string& ruleSource) {
    RuleFields fields = rule.object("baseline");
    RuleBaseline baseline{fields.name("kind", baselineNames()), readEvidence(fields, ruleSource)};
    fields.finish();
    return baseline;
}

Deliverables readDeliverables(RuleFields& rule, const std::string& ruleSource) {
    RuleFields fields = rule.object("deliverables");
    Deliverables wanted;
    wanted.columns = readColumns(fields);
    wanted.columnsEvidence = readEvidence(fields, ruleSource);
    if (fields.has("diagrams")) wanted.diagrams = readDiagrams(fields.object("diagrams"), ruleSource);
    wanted.scale = fields.textOr("scale", {});
    wanted.stamp = fields.texts("stamp");
    fields.finish();
    return wanted;
}

}  // namespace noonmark
