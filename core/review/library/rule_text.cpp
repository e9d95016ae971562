#include "core/review/library/rule_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/describe/text.h"
#include "core/review/places/verdict_text.h"
#include "core/review/rule/rule_names.h"

namespace noonmark {

namespace {

std::string statusText(const Evidence& evidence) {
    return fmt::format("[{}: {}]", ruleNameOf(figureStatusNames(), evidence.status), evidence.source);
}

std::string line(std::string_view label, const std::string& text, const Evidence& evidence) {
    return fmt::format("{:<12} {}  {}\n", label, text, statusText(evidence));
}

std::string daysText(const RuleDays& days) {
    std::string text;
    for (const RuleDay& day : days.fixed) {
        text += fmt::format("{}{}", text.empty() ? "" : ", ", formatText(day.day));
        for (const auto same : day.sameAs) text += fmt::format(" (= {})", formatText(same));
        if (!day.label.empty()) text += " (" + day.label + ")";
        if (day.evidence.status != days.evidence.status)
            text += fmt::format(" [{}]", ruleNameOf(figureStatusNames(), day.evidence.status));
    }
    if (days.fixed.empty()) text = formatText(days.first) + " to " + formatText(days.last);
    if (days.everyDays > 1) text += fmt::format(", one day in {}", days.everyDays);
    if (days.mirrored) text += ", half a year mirrored at 21 June";
    return text + fmt::format(", {}", ruleNameOf(combinationNames(), days.combination));
}

std::string ruleHoursText(const CountedHours& window) {
    std::string text = formatText(window.hours);
    for (const auto& [day, hours] : window.byDay)
        text += fmt::format("; {}: {}", formatText(day), formatText(hours));
    if (window.minSunDeg > 0) text += fmt::format("; sun above {:g} deg", window.minSunDeg);
    return text + fmt::format("; sunrise: {}", ruleNameOf(sunriseNames(), window.sunrise));
}

std::string clockText(const RuleClock& clock) {
    std::string text{ruleNameOf(clockNames(), clock.settings.kind)};
    if (clock.settings.kind == ClockKind::fixed)
        text += fmt::format(", UTC{:+g} h", clock.settings.offsetHours);
    return text;
}

std::string glazingText(const RuleGlazing& glazing) {
    const GlazingPoint& point = glazing.point;
    std::string text = fmt::format(", {}, {} face", ruleNameOf(panePlaceNames(), point.place),
                                   ruleNameOf(faceNames(), point.insideFace));
    if (point.aboveSillM > 0) text += fmt::format(", {:g} m above the sill", point.aboveSillM);
    if (point.aboveFloorM > 0) text += fmt::format(", {:g} m above the floor", point.aboveFloorM);
    if (glazing.minSweepDeg > 0)
        text += fmt::format(", sun at least {:g} deg from the pane", glazing.minSweepDeg);
    if (glazing.sweepOfOpening) text += ", sun at least arctan(wall / width) from the pane";
    text += fmt::format("; by {}", ruleNameOf(unitNames(), glazing.unit));
    const GlazingOpening& opening = glazing.opening;
    return text + fmt::format("; sill {:g} m, wall {:g} m, windows without a size {:g} x {:g} m {}",
                              opening.sillM, opening.wallM, opening.widthM, opening.heightM,
                              statusText(opening.evidence));
}

std::string receiversText(const RuleReceivers& receivers) {
    std::string text{ruleNameOf(surfaceNames(), receivers.surface)};
    if (receivers.surface == RuleSurface::windows) return text + glazingText(receivers.glazing);
    if (receivers.surface == RuleSurface::plane)
        text += fmt::format(" {:g} m above mean ground", receivers.planeM);
    if (receivers.hasLines())
        text += fmt::format("; lines {:g} and {:g} m from the parcel", receivers.innerLineM,
                            receivers.outerLineM);
    if (receivers.roads)
        text += fmt::format(
            ", whose line moves out by {:g} of the width of roads up to {:g} m, to {:g} m "
            "inside the far side of wider ones",
            receivers.roads->share, receivers.roads->narrowM, receivers.roads->fromFarSideM);
    std::vector<std::string_view> kinds;
    for (const PlaceKind kind : receivers.kinds) kinds.push_back(nameOf(kind));
    return text + (kinds.empty() ? "; all places" : fmt::format("; {}", fmt::join(kinds, ", ")));
}

std::string criterionText(const Criterion& criterion) {
    std::string text = criterion.name;
    for (const Limit& limit : criterion.limits)
        text += fmt::format("{} {} [{}]", &limit == &criterion.limits.front() ? ":" : " or",
                            describeLimit(criterion, limit),
                            ruleNameOf(figureStatusNames(), limit.evidence.status));
    if (criterion.limits.empty()) text += ": stated, no limit";
    if (criterion.facing)
        text += fmt::format("; windows facing {:g} to {:g} deg", criterion.facing->fromDeg,
                            criterion.facing->toDeg);
    if (criterion.hours)
        text += fmt::format("; {} to {}", formatRuleTime(criterion.hours->first),
                            formatRuleTime(criterion.hours->second));
    return text + (criterion.advisory ? " (does not decide)" : "");
}

std::string listOf(std::string_view heading, const std::vector<std::string>& texts) {
    std::string all = texts.empty() ? "" : fmt::format("{}\n", heading);
    for (const std::string& text : texts) all += fmt::format("  - {}\n", text);
    return all;
}

std::string diagramsText(const RuleDiagrams& diagrams) {
    const auto joined = [](const std::vector<double>& times) {
        std::string text;
        for (const double time : times)
            text += fmt::format("{}{}", text.empty() ? "" : " ", formatRuleTime(time));
        return text;
    };
    std::string text = joined(diagrams.timesMin);
    for (const auto& [day, times] : diagrams.byDay)
        text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", formatText(day), joined(times));
    return text + fmt::format("{}{}", text.empty() ? "" : "; ", fmt::join(diagrams.views, ", "));
}

std::string partsText(const Rule& rule) {
    std::string text = line("days", daysText(rule.days), rule.days.evidence);
    text += line("window", ruleHoursText(rule.window), rule.window.evidence);
    text += line("clock", clockText(rule.clock), rule.clock.evidence);
    text += line(
        "step",
        fmt::format("{:g} min{}", rule.sampling.stepMinutes,
                    rule.sampling.roundTo > 0 ? fmt::format(", on full {} min", rule.sampling.roundTo) : ""),
        rule.sampling.evidence);
    text += line("receivers", receiversText(rule.receivers), rule.receivers.evidence);
    text += line("casters", std::string(ruleNameOf(casterNames(), rule.occluders.casters)),
                 rule.occluders.evidence);
    text += line("trees", std::string(describe(rule.occluders.trees)), rule.occluders.treesEvidence);
    text += line("baseline", std::string(ruleNameOf(baselineNames(), rule.baseline.kind)),
                 rule.baseline.evidence);
    for (const Criterion& criterion : rule.criteria)
        text += line("criterion", criterionText(criterion), criterion.evidence);
    for (const auto& keys : rule.alternatives)
        text += fmt::format("{:<12} {}\n", &keys == &rule.alternatives.front() ? "holds if" : "or",
                            fmt::join(keys, " and "));
    for (const UnitShare& share : rule.shares)
        text +=
            line("share",
                 fmt::format("{}: {} for at least {:g} %", share.name, share.criterion, share.atLeast * 100),
                 share.evidence);
    if (rule.sunshine)
        text += line("sunshine", fmt::format("{:g}", fmt::join(rule.sunshine->byMonth, " ")),
                     rule.sunshine->evidence);
    if (rule.theoreticalHours)
        text += line("sum", fmt::format("area x {:g} h a year", *rule.theoreticalHours),
                     rule.theoreticalEvidence);
    std::vector<std::string> titles;
    for (const RuleColumn& column : rule.deliverables.columns) titles.push_back(column.title);
    if (!titles.empty())
        text += line("table", fmt::format("{}", fmt::join(titles, " | ")), rule.deliverables.columnsEvidence);
    if (rule.deliverables.diagrams)
        text +=
            line("diagrams", diagramsText(*rule.deliverables.diagrams), rule.deliverables.diagrams->evidence);
    return text;
}

struct DecidingFigure {
    Sentence name;
    FigureStatus status;
};

/// The figures that a verdict rests on.
std::vector<DecidingFigure> listDeciding(const Rule& rule) {
    std::vector<DecidingFigure> all{{{NM_TEXT("the days")}, rule.days.evidence.status},
                                    {{NM_TEXT("the hours")}, rule.window.evidence.status},
                                    {{NM_TEXT("the clock")}, rule.clock.evidence.status}};
    for (const RuleDay& day : rule.days.fixed)
        all.push_back({{NM_TEXT("the day %1"), {formatText(day.day)}}, day.evidence.status});
    for (const Criterion& criterion : rule.criteria)
        for (const Limit& limit : criterion.limits)
            if (!criterion.advisory)
                all.push_back({{NM_TEXT("the limit of \"%1\""), {criterion.name}}, limit.evidence.status});
    for (const UnitShare& share : rule.shares)
        all.push_back({{NM_TEXT("the share of \"%1\""), {share.name}}, share.evidence.status});
    if (rule.sunshine) all.push_back({{NM_TEXT("the hours of sunshine")}, rule.sunshine->evidence.status});
    return all;
}

}  // namespace

FigureStatus findLeastCertain(const Rule& rule) {
    return std::ranges::max(listDeciding(rule), {}, &DecidingFigure::status).status;
}

std::vector<Sentence> listLeastCertain(const Rule& rule) {
    const FigureStatus least = findLeastCertain(rule);
    std::vector<Sentence> names;
    for (DecidingFigure& figure : listDeciding(rule))
        if (figure.status == least) names.push_back(std::move(figure.name));
    return names;
}

std::string describeLeastCertain(const Rule& rule) {
    std::vector<std::string> names;
    for (const Sentence& name : listLeastCertain(rule)) {
        std::vector<std::string> of;
        for (const auto& argument : name.arguments) of.push_back(std::get<std::string>(argument));
        if (std::string text = fillIn(name.source, of); std::ranges::find(names, text) == names.end())
            names.push_back(std::move(text));
    }
    const FigureStatus status = findLeastCertain(rule);
    return fmt::format("Least certain of what the verdicts rest on: {} ({}: {}).", fmt::join(names, ", "),
                       ruleNameOf(figureStatusNames(), status), meaningOf(status));
}

std::string describeRule(const Rule& rule) {
    std::string text = fmt::format("{}: {}\n{}\n\n", rule.key, rule.name, rule.summary);
    text += partsText(rule);
    for (const auto& [choice, options] : rule.choices)
        text += fmt::format("{:<12} {}: {}; now {}\n", "choice", choice, fmt::join(options, " | "),
                            rule.chosen.at(choice));
    std::vector<std::string> figures;
    for (const StatedFigure& figure : rule.figures)
        figures.push_back(fmt::format("{}  {}", figure.text, statusText(figure.evidence)));
    text += fmt::format("\n{}", listOf("Figures", figures)) + listOf("How the rule is read", rule.readings);
    text += listOf("Not checked", rule.notChecked);
    text +=
        "\nV: read in the rule's text or on an official page; R: reported by practice; "
        "U: not checked against the rule's text.\n";
    return text;
}

}  // namespace noonmark
