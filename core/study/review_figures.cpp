#include "core/study/review_figures.h"

#include <algorithm>

#include "core/describe/text.h"
#include "core/review/places/verdict_text.h"

namespace noonmark {

namespace {

// %1: how many, %2: of how many, %3: the rule, %4: the scenario.
struct Headlines {
    std::string_view fail, borderline, pass, none;
};

constexpr Headlines placeHeadlines{
    NM_TEXT("%1 of %2 places fail %3 in %4"), NM_TEXT("No place fails %3 in %4, but %1 of %2 are borderline"),
    NM_TEXT("All of the %2 places judged pass %3 in %4"), NM_TEXT("%3 judges none of the places in %4")};
constexpr Headlines glazingHeadlines{NM_TEXT("%1 of %2 windows fail %3 in %4"),
                                     NM_TEXT("No window fails %3 in %4, but %1 of %2 are borderline"),
                                     NM_TEXT("All of the %2 windows judged pass %3 in %4"),
                                     NM_TEXT("%3 judges none of the windows in %4")};

Amount amountOf(std::size_t count) { return {double(count), FigureUnit::none, 0}; }

Sentence chooseHeadline(const Headlines& headlines, const VerdictCounts& counts, const std::string& rule,
                        const std::string& scenario) {
    const auto say = [&](std::string_view source, std::size_t count) {
        return Sentence{source, {amountOf(count), amountOf(counts.judged()), rule, scenario}};
    };
    if (counts.fail > 0) return say(headlines.fail, counts.fail);
    if (counts.borderline > 0) return say(headlines.borderline, counts.borderline);
    return say(counts.pass > 0 ? headlines.pass : headlines.none, counts.pass);
}

Figure figureOfCount(double (*get)(const VerdictChanges&), const FigureFacts& facts) {
    Figure row = derivedFigure(get, facts);
    row.isCount = true;
    return row;
}

}  // namespace

const Figures<VerdictCounts>& placeVerdictFigures() {
    static const Figures<VerdictCounts> figures{
        figure(&VerdictCounts::fail, {.key = "places_failing",
                                      .label = NM_TEXT("Places that fail"),
                                      .definition = NM_TEXT("a limit of the rule is exceeded by more than "
                                                            "the error of what was measured")}),
        figure(&VerdictCounts::borderline,
               {.key = "places_borderline",
                .label = NM_TEXT("Borderline places"),
                .definition = NM_TEXT("within the error of a limit of the rule")}),
        figure(&VerdictCounts::pass, {.key = "places_passing",
                                      .label = NM_TEXT("Places that pass"),
                                      .definition = NM_TEXT("they keep all limits of the rule")}),
        figure(&VerdictCounts::notApplicable,
               {.key = "places_not_applicable",
                .label = NM_TEXT("Places without a limit"),
                .definition = NM_TEXT("the rule does not cover them, or states figures only")}),
        figure(&VerdictCounts::notChecked, {.key = "places_not_checked",
                                            .label = NM_TEXT("Places not checked"),
                                            .definition = NM_TEXT("nothing could be measured there")})};
    return figures;
}

const Figures<VerdictChanges>& glazingVerdictFigures() {
    using Changes = VerdictChanges;
    static const Figures<Changes> figures{
        figureOfCount(
            [](const Changes& all) { return double(all.after.fail); },
            {.key = "windows_failing",
             .label = NM_TEXT("Windows that fail"),
             .definition = NM_TEXT("in the scenario; rooms or dwellings where the rule judges those")}),
        figureOfCount([](const Changes& all) { return double(all.after.borderline); },
                      {.key = "windows_borderline",
                       .label = NM_TEXT("Borderline windows"),
                       .definition = NM_TEXT("within the error of a limit of the rule")}),
        figureOfCount([](const Changes& all) { return double(all.after.pass); },
                      {.key = "windows_passing",
                       .label = NM_TEXT("Windows that pass"),
                       .definition = NM_TEXT("they keep all limits of the rule")}),
        figureOfCount([](const Changes& all) { return double(all.after.notJudged()); },
                      {.key = "windows_not_judged",
                       .label = NM_TEXT("Windows not judged"),
                       .definition = NM_TEXT("the rule does not apply to them, or they were not checked")}),
        figureOfCount([](const Changes& all) { return double(all.before.fail); },
                      {.key = "windows_failing_before",
                       .label = NM_TEXT("Windows that failed before"),
                       .definition = NM_TEXT("in the baseline, of those that stand in both")}),
        figureOfCount([](const Changes& all) { return double(all.worse); },
                      {.key = "windows_worse",
                       .label = NM_TEXT("Windows that get worse"),
                       .definition = NM_TEXT("from pass to borderline or fail, or from borderline to fail")}),
        figureOfCount(
            [](const Changes& all) { return double(all.better); },
            {.key = "windows_better",
             .label = NM_TEXT("Windows that get better"),
             .definition = NM_TEXT("from fail to borderline or pass, or from borderline to pass")})};
    return figures;
}

VerdictCounts countVerdicts(const ReviewStudy& study) {
    VerdictCounts counts;
    for (const PlaceReview& place : study.places) counts.add(place.verdict);
    return counts;
}

std::vector<CriticalPlace> listDoubtful(const ReviewStudy& study) {
    std::vector<CriticalPlace> places;
    for (const Verdict verdict : {Verdict::fail, Verdict::borderline})
        for (const PlaceReview& place : study.places)
            if (place.verdict == verdict) places.push_back({place.name, describeReason(place)});
    return places;
}

AnswerPage makeReviewPage(const VerdictCounts& counts, const std::string& rule, const std::string& scenario,
                          const std::vector<CriticalPlace>& doubtful) {
    constexpr std::size_t maxNamed = 4;  // the table of the review has them all
    AnswerPage page{chooseHeadline(placeHeadlines, counts, rule, scenario)};
    const std::size_t named = std::min(doubtful.size(), maxNamed);
    for (std::size_t i = 0; i < named; ++i)
        page.findings.push_back({NM_TEXT("%1: %2."), {doubtful[i].name, doubtful[i].reason}});
    if (doubtful.size() > named)
        page.findings.push_back(
            {NM_TEXT("%1 more places fail or are borderline."), {amountOf(doubtful.size() - named)}});
    return page;
}

AnswerPage makeGlazingPage(const VerdictChanges& changes, const std::string& rule, const std::string& from,
                           const std::string& scenario) {
    return {chooseHeadline(glazingHeadlines, changes.after, rule, scenario),
            {{NM_TEXT("%1 windows get worse than in %2, %3 get better."),
              {amountOf(changes.worse), from, amountOf(changes.better)}}}};
}

}  // namespace noonmark
