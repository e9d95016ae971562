#include "core/review/rule/rule_names.h"

#include <fmt/format.h>
#include <charconv>
#include <cmath>

#include "core/base/wording.h"
#include "core/describe/fill_text.h"
#include "core/describe/text.h"
#include "core/sun/civil_time.h"

namespace noonmark {

RuleNames<FigureStatus> figureStatusNames() {
    using enum FigureStatus;
    static constexpr std::array names{std::pair{verified, std::string_view{"V"}},
                                      std::pair{reported, std::string_view{"R"}},
                                      std::pair{unconfirmed, std::string_view{"U"}}};
    return names;
}

RuleNames<DayCombination> combinationNames() {
    using enum DayCombination;
    static constexpr std::array names{std::pair{every, std::string_view{NM_TEXT("every")}},
                                      std::pair{average, std::string_view{NM_TEXT("average")}},
                                      std::pair{chosen, std::string_view{NM_TEXT("chosen")}},
                                      std::pair{sum, std::string_view{NM_TEXT("sum")}}};
    return names;
}

RuleNames<ClockKind> clockNames() {
    using enum ClockKind;
    static constexpr std::array names{std::pair{civil, std::string_view{NM_TEXT("civil")}},
                                      std::pair{standard, std::string_view{NM_TEXT("standard")}},
                                      std::pair{fixed, std::string_view{NM_TEXT("fixed")}},
                                      std::pair{trueSolar, std::string_view{NM_TEXT("true solar")}}};
    return names;
}

RuleNames<SunriseRule> sunriseNames() {
    using enum SunriseRule;
    static constexpr std::array names{std::pair{upperLimb, std::string_view{NM_TEXT("upper limb")}},
                                      std::pair{centre, std::string_view{NM_TEXT("centre")}}};
    return names;
}

RuleNames<RuleSurface> surfaceNames() {
    using enum RuleSurface;
    static constexpr std::array names{std::pair{ground, std::string_view{NM_TEXT("ground")}},
                                      std::pair{plane, std::string_view{NM_TEXT("plane")}},
                                      std::pair{windows, std::string_view{NM_TEXT("windows")}}};
    return names;
}

RuleNames<RuleCasters> casterNames() {
    using enum RuleCasters;
    static constexpr std::array names{std::pair{everything, std::string_view{NM_TEXT("everything")}},
                                      std::pair{proposal, std::string_view{NM_TEXT("proposal")}}};
    return names;
}

RuleNames<RuleTrees> ruleTreesNames() {
    using enum RuleTrees;
    static constexpr std::array names{
        std::pair{without, std::string_view{"without"}},
        std::pair{evergreens, std::string_view{"evergreens"}},
        std::pair{evergreenBelts, std::string_view{"evergreen belts"}},
        std::pair{asEvergreens, std::string_view{"as evergreens"}},
        std::pair{seasonal, std::string_view{"seasonal"}},
        std::pair{existingAndEvergreens, std::string_view{"existing and evergreens"}}};
    return names;
}

RuleNames<BaselineKind> baselineNames() {
    using enum BaselineKind;
    static constexpr std::array names{std::pair{existing, std::string_view{NM_TEXT("existing")}},
                                      std::pair{noAction, std::string_view{NM_TEXT("no action")}},
                                      std::pair{referenceBody, std::string_view{NM_TEXT("reference body")}}};
    return names;
}

RuleNames<Quantity> quantityNames() {
    using enum Quantity;
    static constexpr std::array names{std::pair{shadow, std::string_view{"shadow"}},
                                      std::pair{incremental, std::string_view{"incremental"}},
                                      std::pair{sun, std::string_view{"sun"}}};
    return names;
}

RuleNames<Measure> measureNames() {
    using enum Measure;
    static constexpr std::array names{std::pair{spotTotal, std::string_view{"spot total"}},
                                      std::pair{spotLongestRun, std::string_view{"spot longest run"}},
                                      std::pair{spotLongestRuns, std::string_view{"spot longest runs"}},
                                      std::pair{areaOver, std::string_view{"area over"}},
                                      std::pair{share, std::string_view{"share"}},
                                      std::pair{anywhere, std::string_view{"anywhere"}},
                                      std::pair{span, std::string_view{"span"}},
                                      std::pair{fullCover, std::string_view{"full cover"}},
                                      std::pair{largestArea, std::string_view{"largest area"}},
                                      std::pair{largestShare, std::string_view{"largest share"}},
                                      std::pair{areaHours, std::string_view{"area hours"}},
                                      std::pair{skyComponent, std::string_view{"vsc"}},
                                      std::pair{probableSun, std::string_view{"apsh"}}};
    return names;
}

RuleNames<Comparison> comparisonNames() {
    using enum Comparison;
    static constexpr std::array names{
        std::pair{atMost, std::string_view{"<="}}, std::pair{below, std::string_view{"<"}},
        std::pair{atLeast, std::string_view{">="}}, std::pair{above, std::string_view{">"}}};
    return names;
}

RuleNames<LineBelt> beltNames() {
    using enum LineBelt;
    static constexpr std::array names{std::pair{betweenLines, std::string_view{"between lines"}},
                                      std::pair{beyondLines, std::string_view{"beyond lines"}}};
    return names;
}

RuleNames<PanePlace> panePlaceNames() {
    using enum PanePlace;
    static constexpr std::array names{std::pair{middle, std::string_view{NM_TEXT("mid pane")}},
                                      std::pair{sillMiddle, std::string_view{NM_TEXT("sill middle")}},
                                      std::pair{sillEnds, std::string_view{NM_TEXT("sill ends")}}};
    return names;
}

RuleNames<bool> faceNames() {
    static constexpr std::array names{std::pair{false, std::string_view{NM_TEXT("outside")}},
                                      std::pair{true, std::string_view{NM_TEXT("inside")}}};
    return names;
}

RuleNames<GlazingUnit> unitNames() {
    using enum GlazingUnit;
    static constexpr std::array names{std::pair{window, std::string_view{NM_TEXT("window")}},
                                      std::pair{room, std::string_view{NM_TEXT("room")}},
                                      std::pair{dwelling, std::string_view{NM_TEXT("dwelling")}}};
    return names;
}

std::string_view meaningOf(FigureStatus status) {
    switch (status) {
        case FigureStatus::verified:
            return NM_TEXT("read in the rule's text or on an official page");
        case FigureStatus::reported:
            return NM_TEXT("reported by practice");
        case FigureStatus::unconfirmed:
            return NM_TEXT("not checked against the rule's text");
    }
    return {};
}

std::string_view describe(RuleTrees counted) {
    switch (counted) {
        case RuleTrees::without:
            return NM_TEXT("none counted");
        case RuleTrees::evergreens:
            return NM_TEXT("evergreen trees only");
        case RuleTrees::evergreenBelts:
            return NM_TEXT("dense belts of evergreen trees only");
        case RuleTrees::asEvergreens:
            return NM_TEXT("all, as evergreens");
        case RuleTrees::seasonal:
            return NM_TEXT("all, with their seasons");
        case RuleTrees::existingAndEvergreens:
            return NM_TEXT("existing trees with their seasons, and new evergreens");
    }
    return {};
}

std::string_view unitOf(Measure measure) {
    switch (measure) {
        case Measure::share:
        case Measure::largestShare:
            return {};
        case Measure::skyComponent:
        case Measure::probableSun:
            return "%";
        case Measure::areaOver:
        case Measure::largestArea:
            return "m2";
        case Measure::areaHours:
            return "m2 h";
        default:
            return "min";
    }
}

namespace {

std::optional<double> parseOffset(std::string_view text) {
    if (text.empty()) return 0.0;
    const char sign = text.front(), unit = text.back();
    if ((sign != '+' && sign != '-') || (unit != 'h' && unit != 'm') || text.size() < 3) return std::nullopt;
    double value = 0;
    const char* const end = text.data() + text.size() - 1;
    const auto [rest, error] = std::from_chars(text.data() + 1, end, value, std::chars_format::fixed);
    const double minutes = value * (unit == 'h' ? 60 : 1);
    if (error != std::errc{} || rest != end || !(minutes >= 0 && minutes <= 720)) return std::nullopt;
    return sign == '-' ? -minutes : minutes;
}

std::string joinBounds(const std::vector<HoursBound>& bounds, std::string_view which) {
    if (bounds.size() == 1) return formatText(bounds.front());
    std::string text{which};
    for (const HoursBound& bound : bounds)
        text += fmt::format("{}{}", &bound == &bounds.front() ? " " : ", ", formatText(bound));
    return text;
}

}  // namespace

std::optional<std::chrono::month_day> parseRuleDay(std::string_view text) {
    if (text.size() != 5 || text[2] != '-') return std::nullopt;
    const auto twoDigits = [&](std::size_t at) {
        const auto digit = [&](std::size_t i) {
            return text[i] >= '0' && text[i] <= '9' ? text[i] - '0' : 99;
        };
        return unsigned(digit(at) * 10 + digit(at + 1));
    };
    const unsigned month = twoDigits(0), day = twoDigits(3);
    if (month < 1 || month > 12 || day < 1 || day > 31) return std::nullopt;
    const std::chrono::month_day date{std::chrono::month(month), std::chrono::day(day)};
    return date.ok() ? std::optional(date) : std::nullopt;
}

std::optional<double> parseRuleTime(std::string_view text) {
    if (text.size() != 5) return std::nullopt;
    const auto time = parseTimeOfDay(text);
    return time ? std::optional(double(time->count())) : std::nullopt;
}

std::optional<HoursBound> parseHoursBound(std::string_view text) {
    using enum HoursBound::Kind;
    for (const auto& [word, kind] : {std::pair{std::string_view{"sunrise"}, sunrise}, {"sunset", sunset}}) {
        if (!text.starts_with(word)) continue;
        const auto offset = parseOffset(text.substr(word.size()));
        return offset ? std::optional(HoursBound{kind, *offset}) : std::nullopt;
    }
    const auto time = parseRuleTime(text);
    return time ? std::optional(HoursBound{clock, *time}) : std::nullopt;
}

std::string formatText(std::chrono::month_day day) {
    return fmt::format("{:02}-{:02}", unsigned(day.month()), unsigned(day.day()));
}

std::string formatRuleTime(double minutes) {
    const long whole = std::lround(minutes);
    return fmt::format("{:02}:{:02}", whole / 60, whole % 60);
}

std::string formatText(const HoursBound& bound) {
    if (bound.kind == HoursBound::Kind::clock) return formatRuleTime(bound.minutes);
    const bool halfHours = std::fmod(bound.minutes, 30) == 0;
    const std::string offset = bound.minutes == 0 ? ""
                               : halfHours        ? fmt::format("{:+g}h", bound.minutes / 60)
                                                  : fmt::format("{:+g}m", bound.minutes);
    return localText(bound.kind == HoursBound::Kind::sunrise ? NM_TEXT("sunrise") : NM_TEXT("sunset")) +
           localNumbers(offset);
}

std::string formatText(const HoursOfDay& hours) {
    return fillText(NM_TEXT("%1 to %2"), {joinBounds(hours.from, localText(NM_TEXT("the latest of"))),
                                          joinBounds(hours.to, localText(NM_TEXT("the earliest of")))});
}

}  // namespace noonmark
