#include "core/review/library/rule_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "core/base/wording.h"
#include "core/describe/fill_text.h"
#include "core/describe/text.h"
#include "core/review/places/verdict_text.h"
#include "core/review/rule/rule_names.h"

namespace noonmark {

namespace {

std::string statusText(const Evidence& evidence) {
    return fmt::format("[{}: {}]", ruleNameOf(figureStatusNames(), evidence.status), evidence.source);
}

/// A number as the language writes it.
std::string numberText(double value) { return localNumbers(fmt::format("{:g}", value)); }

template <class E>
std::string localName(RuleNames<E> names, E value) {
    return localText(ruleNameOf(names, value));
}

std::string line(std::string_view label, const std::string& text, const Evidence& evidence) {
    return fmt::format("{:<12} {}  {}\n", localText(label), text, statusText(evidence));
}

std::string dayOf(std::chrono::month_day day) {
    return isEnglishInUse() ? formatText(day)
                            : fillText(NM_TEXT("day %1 of %2"), {fmt::format("{}", unsigned(day.day())),
                                                                 wordingInUse().month(day.month(), false)});
}

std::string daysText(const RuleDays& days) {
    std::string text;
    for (const RuleDay& day : days.fixed) {
        text += fmt::format("{}{}", text.empty() ? "" : ", ", dayOf(day.day));
        for (const auto same : day.sameAs) text += fmt::format(" (= {})", dayOf(same));
        if (!day.label.empty()) text += " (" + localRuleText(day.label) + ")";
        if (day.evidence.status != days.evidence.status)
            text += fmt::format(" [{}]", ruleNameOf(figureStatusNames(), day.evidence.status));
    }
    if (days.fixed.empty()) text = fillText(NM_TEXT("%1 to %2"), {dayOf(days.first), dayOf(days.last)});
    if (days.everyDays > 1) text += fillText(NM_TEXT(", one day in %1"), {fmt::format("{}", days.everyDays)});
    if (days.mirrored) text += localText(NM_TEXT(", half a year mirrored at 21 June"));
    return text + ", " + localName(combinationNames(), days.combination);
}

std::string ruleHoursText(const CountedHours& window) {
    std::string text = formatText(window.hours);
    for (const auto& [day, hours] : window.byDay)
        text += fmt::format("; {}: {}", dayOf(day), formatText(hours));
    if (window.minSunDeg > 0) text += fillText(NM_TEXT("; sun above %1 deg"), {numberText(window.minSunDeg)});
    return text + fillText(NM_TEXT("; sunrise: %1"), {localName(sunriseNames(), window.sunrise)});
}

std::string clockText(const RuleClock& clock) {
    std::string text = localName(clockNames(), clock.settings.kind);
    if (clock.settings.kind == ClockKind::fixed)
        text += fmt::format(", UTC{:+g} h", clock.settings.offsetHours);
    return text;
}

std::string glazingText(const RuleGlazing& glazing) {
    const GlazingPoint& point = glazing.point;
    std::string text = fillText(NM_TEXT(", %1, %2 face"), {localName(panePlaceNames(), point.place),
                                                           localName(faceNames(), point.insideFace)});
    if (point.aboveSillM > 0)
        text += fillText(NM_TEXT(", %1 m above the sill"), {numberText(point.aboveSillM)});
    if (point.aboveFloorM > 0)
        text += fillText(NM_TEXT(", %1 m above the floor"), {numberText(point.aboveFloorM)});
    if (glazing.minSweepDeg > 0)
        text += fillText(NM_TEXT(", sun at least %1 deg from the pane"), {numberText(glazing.minSweepDeg)});
    if (glazing.sweepOfOpening)
        text += localText(NM_TEXT(", sun at least arctan(wall / width) from the pane"));
    text += fillText(NM_TEXT("; by %1"), {localName(unitNames(), glazing.unit)});
    const GlazingOpening& opening = glazing.opening;
    return text +
           fillText(NM_TEXT("; sill %1 m, wall %2 m, windows without a size %3 x %4 m"),
                    {numberText(opening.sillM), numberText(opening.wallM), numberText(opening.widthM),
                     numberText(opening.heightM)}) +
           ' ' + statusText(opening.evidence);
}

std::string receiversText(const RuleReceivers& receivers) {
    std::string text = localName(surfaceNames(), receivers.surface);
    if (receivers.surface == RuleSurface::windows) return text + glazingText(receivers.glazing);
    if (receivers.surface == RuleSurface::plane)
        text += fillText(NM_TEXT(" %1 m above mean ground"), {numberText(receivers.planeM)});
    if (receivers.hasLines())
        text += fillText(NM_TEXT("; lines %1 and %2 m from the parcel"),
                         {numberText(receivers.innerLineM), numberText(receivers.outerLineM)});
    if (receivers.roads)
        text += fillText(NM_TEXT(", whose line moves out by %1 of the width of roads up to %2 m, to %3 m "
                                 "inside the far side of wider ones"),
                         {numberText(receivers.roads->share), numberText(receivers.roads->narrowM),
                          numberText(receivers.roads->fromFarSideM)});
    std::vector<std::string> kinds;
    for (const PlaceKind kind : receivers.kinds) kinds.push_back(localText(nameOf(kind)));
    return text +
           (kinds.empty() ? localText(NM_TEXT("; all places")) : fmt::format("; {}", fmt::join(kinds, ", ")));
}

std::string criterionText(const Criterion& criterion) {
    std::string text = localRuleText(criterion.name);
    for (const Limit& limit : criterion.limits)
        text += fmt::format(
            "{} {} [{}]", &limit == &criterion.limits.front() ? ":" : localText(NM_TEXT(" or")),
            describeLimit(criterion, limit), ruleNameOf(figureStatusNames(), limit.evidence.status));
    if (criterion.limits.empty()) text += localText(NM_TEXT(": stated, no limit"));
    if (criterion.facing)
        text += fillText(NM_TEXT("; windows facing %1 to %2 deg"),
                         {numberText(criterion.facing->fromDeg), numberText(criterion.facing->toDeg)});
    if (criterion.hours)
        text += "; " + fillText(NM_TEXT("%1 to %2"), {formatRuleTime(criterion.hours->first),
                                                      formatRuleTime(criterion.hours->second)});
    return text + (criterion.advisory ? localText(NM_TEXT(" (does not decide)")) : "");
}

std::string listOf(std::string_view heading, const std::vector<std::string>& texts) {
    std::string all = texts.empty() ? "" : fmt::format("{}\n", localText(heading));
    for (const std::string& text : texts) all += fmt::format("  - {}\n", text);
    return all;
}

std::vector<std::string> localTexts(const std::vector<std::string>& texts) {
    std::vector<std::string> local;
    for (const std::string& text : texts) local.push_back(localRuleText(text));
    return local;
}

// The labels of lines and lists below.
[[maybe_unused]] constexpr std::array labels{NM_TEXT("days"),
                                             NM_TEXT("clock"),
                                             NM_TEXT("step"),
                                             NM_TEXT("receivers"),
                                             NM_TEXT("casters"),
                                             NM_TEXT("trees"),
                                             NM_TEXT("baseline"),
                                             NM_TEXT("criterion"),
                                             NM_TEXT("holds if"),
                                             NM_TEXT("or"),
                                             NM_TEXT("share"),
                                             NM_TEXT("sunshine"),
                                             NM_TEXT("sum"),
                                             NM_TEXT("table"),
                                             NM_TEXT("diagrams"),
                                             NM_TEXT("choice"),
                                             NM_TEXT("Figures"),
                                             NM_TEXT("Not checked"),
                                             NM_TEXT("How the rule is read")};

// The names of diagrams in rule files.
[[maybe_unused]] constexpr std::array viewNames{NM_TEXT("plan"), NM_TEXT("fan"), NM_TEXT("isochrones"),
                                                NM_TEXT("view from the sun")};

std::string diagramsText(const RuleDiagrams& diagrams) {
    const auto joined = [](const std::vector<double>& times) {
        std::string text;
        for (const double time : times)
            text += fmt::format("{}{}", text.empty() ? "" : " ", formatRuleTime(time));
        return text;
    };
    std::string text = joined(diagrams.timesMin);
    for (const auto& [day, times] : diagrams.byDay)
        text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", dayOf(day), joined(times));
    std::vector<std::string> views;
    for (const std::string& view : diagrams.views) views.push_back(localText(view));
    return text + fmt::format("{}{}", text.empty() ? "" : "; ", fmt::join(views, ", "));
}

std::string partsText(const Rule& rule) {
    std::string text = line("days", daysText(rule.days), rule.days.evidence);
    // The word of rule files; in other languages it would read as a window of glass.
    text += line(isEnglishInUse() ? "window" : NM_TEXT("hours"), ruleHoursText(rule.window),
                 rule.window.evidence);
    text += line("clock", clockText(rule.clock), rule.clock.evidence);
    text += line("step",
                 numberText(rule.sampling.stepMinutes) + " min" +
                     (rule.sampling.roundTo > 0
                          ? fillText(NM_TEXT(", on full %1 min"), {fmt::format("{}", rule.sampling.roundTo)})
                          : ""),
                 rule.sampling.evidence);
    text += line("receivers", receiversText(rule.receivers), rule.receivers.evidence);
    text += line("casters", localName(casterNames(), rule.occluders.casters), rule.occluders.evidence);
    text += line("trees", localText(describe(rule.occluders.trees)), rule.occluders.treesEvidence);
    text += line("baseline", localName(baselineNames(), rule.baseline.kind), rule.baseline.evidence);
    for (const Criterion& criterion : rule.criteria)
        text += line("criterion", criterionText(criterion), criterion.evidence);
    for (const auto& keys : rule.alternatives)
        text += fmt::format("{:<12} {}\n", localText(&keys == &rule.alternatives.front() ? "holds if" : "or"),
                            fmt::join(keys, localText(NM_TEXT(" and "))));
    for (const UnitShare& share : rule.shares)
        text += line("share",
                     fillText(NM_TEXT("%1: %2 for at least %3 %"),
                              {localRuleText(share.name), share.criterion, numberText(share.atLeast * 100)}),
                     share.evidence);
    if (rule.sunshine)
        text += line("sunshine", localNumbers(fmt::format("{:g}", fmt::join(rule.sunshine->byMonth, " "))),
                     rule.sunshine->evidence);
    if (rule.theoreticalHours)
        text += line("sum", fillText(NM_TEXT("area x %1 h a year"), {numberText(*rule.theoreticalHours)}),
                     rule.theoreticalEvidence);
    std::vector<std::string> titles;
    for (const RuleColumn& column : rule.deliverables.columns) titles.push_back(localRuleText(column.title));
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
        all.push_back({{NM_TEXT("the day %1"), {dayOf(day.day)}}, day.evidence.status});
    for (const Criterion& criterion : rule.criteria)
        for (const Limit& limit : criterion.limits)
            if (!criterion.advisory)
                all.push_back({{NM_TEXT("the limit of \"%1\""), {localRuleText(criterion.name)}},
                               limit.evidence.status});
    for (const UnitShare& share : rule.shares)
        all.push_back({{NM_TEXT("the share of \"%1\""), {localRuleText(share.name)}}, share.evidence.status});
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
        if (std::string text = fillIn(localText(name.source), of);
            std::ranges::find(names, text) == names.end())
            names.push_back(std::move(text));
    }
    const FigureStatus status = findLeastCertain(rule);
    return fillText(NM_TEXT("Least certain of what the verdicts rest on: %1 (%2: %3)."),
                    {fmt::format("{}", fmt::join(names, ", ")),
                     std::string(ruleNameOf(figureStatusNames(), status)), localText(meaningOf(status))});
}

std::string describeRule(const Rule& rule) {
    std::string text =
        fmt::format("{}: {}\n{}\n\n", rule.key, localRuleText(rule.name), localRuleText(rule.summary));
    text += partsText(rule);
    for (const auto& [choice, options] : rule.choices)
        text += fmt::format(
            "{:<12} {}\n", localText("choice"),
            fillText(NM_TEXT("%1: %2; now %3"),
                     {localRuleText(choice), fmt::format("{}", fmt::join(localTexts(options), " | ")),
                      localRuleText(rule.chosen.at(choice))}));
    std::vector<std::string> figures;
    for (const StatedFigure& figure : rule.figures)
        figures.push_back(fmt::format("{}  {}", localRuleText(figure.text), statusText(figure.evidence)));
    text += fmt::format("\n{}", listOf("Figures", figures)) +
            listOf("How the rule is read", localTexts(rule.readings));
    text += listOf("Not checked", localTexts(rule.notChecked));
    text += '\n' +
            localText(NM_TEXT("V: read in the rule's text or on an official page; R: reported by practice; "
                              "U: not checked against the rule's text.")) +
            '\n';
    return text;
}

}  // namespace noonmark
