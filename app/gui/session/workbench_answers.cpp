#include <algorithm>
#include <iterator>
#include <ranges>
#include <utility>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/workbench.h"
#include "app/questions/saved_question.h"
#include "core/base/progress.h"
#include "core/receivers/made_names.h"
#include "core/receivers/place_names.h"
#include "scenarios/scenario.h"

// The answers of Workbench: which ones are there, which one is displayed, and which are outdated.
namespace noonmark {

namespace {

constexpr std::size_t maxMeasured = 20;  // their maps stay in memory

}  // namespace

// Null: what is behind is displayed again.
void Workbench::bringToFront(SharedAnswer answer) {
    reading_.drop();
    past_.reset();
    front_ = std::move(answer);
    findBase();
    Q_EMIT answered();
}

// The latest comparison of the displayed scenario with its baseline, else the latest study of it.
void Workbench::findBase() {
    const auto study = std::ranges::find(studies_, session_.city(), &KnownAnswer::city);
    base_ = study == studies_.end() ? nullptr : study->answer;
    study_ = contentOf<Study>(base_);
    if (isCompared()) base_ = comparison_.answer;
    if (base_) past_.reset();
    shownOf_ = citiesShown();
    rename(base_);
    rename(front_);
    std::erase_if(listed_, [this](const auto& one) { return one.first != base_ && one.first != front_; });
}

Workbench::CitiesShown Workbench::citiesShown() {
    return {session_.city(), comparing() ? session_.cityOf(session_.baseline()).value_or(nullptr) : nullptr};
}

bool Workbench::isCompared() {
    return comparing() && comparison_.answer && comparison_.city == session_.city() &&
           comparison_.before == session_.cityOf(session_.baseline()).value_or(nullptr);
}

// A copy of a scenario has the same buildings: an answer is valid for it too, and takes its name. So does a
// renamed one. Whether that changed anything.
bool Workbench::rename(SharedAnswer& answer) {
    if (!answer) return false;
    SharedAnswer now = answer->updated(session_.project(), session_.scenario(), session_.baseline());
    if (!now) return false;
    const auto listed = listed_.find(answer);
    listed_[now] = listed == listed_.end() ? answer : listed->second;
    answer = std::move(now);
    return true;
}

void Workbench::attachToAnswer(ContributionTable of) {
    if (const SharedAnswer before = answer()) replace(before, before->withPlace(std::move(of)));
}

void Workbench::setEnough(double hours) {
    if (const SharedAnswer before = answer()) replace(before, before->withEnough(hours));
}

// An answer that was saved under a name is listed beside it again, as it differs now.
void Workbench::replace(const SharedAnswer& before, const SharedAnswer& now) {
    if (!now) return;
    const auto take = [&](SharedAnswer& one) {
        if (one == before) one = now;
    };
    take(front_);
    take(base_);
    take(comparison_.answer);
    for (KnownAnswer& study : studies_) take(study.answer);
    study_ = contentOf<Study>(base_) ? contentOf<Study>(base_) : study_;
    for (auto& measured : measured_) {
        if (measured->known().answer != before) continue;
        KnownAnswer known = measured->known();
        known.answer = now;
        measured = std::make_shared<const MeasuredAnswer>(known, session_, measured->name());
    }
    session_.noteAnswer();
    Q_EMIT answerUpdated();
}

void Workbench::updateAnswers() {
    const bool isOther = contentOf<ImpactAnswer>(base_) && !isCompared();
    const bool base = !isOther && rename(base_), front = rename(front_);
    if (base || front) Q_EMIT answerUpdated();
}

void Workbench::showSaved(const std::string& name) {
    const auto result = findResult(session_.project(), name);
    result ? showResult(*result) : report(result.error());
}

// On the buildings it was computed for, if its scenario still exists.
void Workbench::showResult(const std::shared_ptr<const SavedResult>& result) {
    if (session_.cityOf(result->scenario)) session_.goTo(result->scenario);
    reading_.start<SharedAnswer>(
        tr("Showing %1").arg(shownName(result)),
        [result, project = session_.project(), questions = questions_](Progress&, const std::stop_token&) {
            return readSaved(result, project, questions);
        },
        [this](Result<SharedAnswer> saved) {
            if (!saved) return report(saved.error());
            front_ = *std::move(saved);
            past_.reset();
            shownOf_ = citiesShown();
            Q_EMIT answered();
        });
}

// Answers about other regions, or over more days, may have the same name.
std::string Workbench::freeMeasuredName(const std::string& name) const {
    const auto isTaken = [this](const std::string& one) {
        return std::ranges::any_of(measured_, [&](const auto& other) { return other->name() == one; }) ||
               findResult(session_.project(), one);
    };
    std::string free = name;
    for (std::size_t number = 2; isTaken(free); ++number) free = numberName(name, number);
    return free;
}

void Workbench::adopt(const KnownAnswer& known, const Adopting& how) {
    remember(known, how.isWork);
    const MeasuredPart part = known.answer->part();
    if (how.isShown && isCurrent(part.scenario, known.city) && isCurrent(part.baseline, known.before))
        bringToFront(known.answer);
}

// In place of the last answer to the same question. `isWork`: the user asked for it.
void Workbench::remember(const KnownAnswer& known, bool isWork) {
    const Answer& answer = *known.answer;
    const auto replaced =
        std::erase_if(measured_, [&](const auto& one) { return one->isReplacedBy(answer); });
    if (measured_.size() == maxMeasured) measured_.erase(measured_.begin());
    measured_.push_back(
        std::make_shared<const MeasuredAnswer>(known, session_, freeMeasuredName(storedName(answer))));
    if (replaced == 0 && isWork) session_.noteAnswer();
}

MeasuredAnswers Workbench::measured() const {
    MeasuredAnswers unnamed = measured_;
    std::erase_if(unnamed, [this](const auto& one) { return !savedNameOf(one).empty(); });
    return unnamed;
}

std::shared_ptr<const Answer> Workbench::findAnswer(const std::string& scenario, const Answer& same) {
    const auto city = session_.cityOf(scenario).value_or(nullptr);
    const Question& question = &same.question() == &comparisonQuestion() ? studyQuestion() : same.question();
    const auto isSame = [&](const KnownAnswer& known) {
        const Answer* answer = known.answer.get();
        return answer && known.city == city && !known.before && &answer->question() == &question &&
               answer->settings() && *answer->settings() == *same.settings() &&
               answer->part().weights == same.part().weights;
    };
    for (const auto& measured : measured_ | std::views::reverse)
        if (isSame(measured->known())) return measured->known().answer;
    const auto study = std::ranges::find_if(studies_, isSame);
    return study == studies_.end() ? nullptr : study->answer;
}

// Saving it may have been undone.
std::string Workbench::savedNameOf(const std::shared_ptr<const MeasuredAnswer>& measured) const {
    const auto named = named_.find(measured);
    return named != named_.end() && findResult(session_.project(), named->second) ? named->second
                                                                                  : std::string();
}

std::shared_ptr<const MeasuredAnswer> Workbench::measuredSavedAs(const std::string& name) const {
    const auto at =
        std::ranges::find_if(measured_, [&](const auto& one) { return savedNameOf(one) == name; });
    return at == measured_.end() ? nullptr : *at;
}

std::string Workbench::savedName() const {
    if (const auto measured = measuredShown()) return savedNameOf(measured);
    const auto saved = answerAs<SavedContent>();
    return saved ? saved->result->name : std::string();
}

std::shared_ptr<const MeasuredAnswer> Workbench::measuredShown() const {
    const auto now = answer() ? answer() : past();
    const auto saved = contentOf<SavedContent>(now);
    const auto listed = listed_.find(now);
    const auto shown = listed == listed_.end() ? now : listed->second;
    const auto at = std::ranges::find_if(measured_, [&](const auto& one) {
        const SharedAnswer& known = one->known().answer;
        return known ? known == shown : saved && one->toSave() == saved->result;
    });
    return at == measured_.end() ? nullptr : *at;
}

namespace {

bool arePlacesOutdated(const std::shared_ptr<const SunOfCities>& sun, const Project& project) {
    return sun && !findChangedPlaces(sun->baseline.places, project).empty();
}

}  // namespace

bool Workbench::havePlacesChanged() const { return arePlacesOutdated(sunOf(answer()), session_.project()); }

bool Workbench::isOutdated(const MeasuredAnswer& measured) {
    const KnownAnswer& known = measured.known();
    if (!known.answer) return isOutdated(*measured.toSave());
    const MeasuredPart part = known.answer->part();
    if (arePlacesOutdated(contentOf<SunOfCities>(known.answer), session_.project())) return true;
    return !isCurrent(part.scenario, known.city) ||
           (known.before && !isCurrent(part.baseline, known.before)) ||
           std::ranges::any_of(known.others,
                               [this](const auto& one) { return !isCurrent(one.first, one.second); });
}

bool Workbench::isCurrent(const std::string& scenario, const std::shared_ptr<const City>& city) {
    const auto now = session_.cityOf(scenario);  // an error: it was renamed or removed
    return now ? *now == city : !scenarioOf(city).empty();
}

// Costs a hash of the city of each scenario that a result is about.
void Workbench::findOutdated() {
    const Project& now = session_.project();
    std::vector<std::shared_ptr<const SavedResult>> results = now.results;
    for (const auto& one : measured_)
        if (!one->known().answer) results.push_back(one->toSave());
    Compared asked{now.city, now.scenarios, now.places, now.regions, results};
    if (asked == compared_) return;
    const bool placesChanged = asked.places != compared_.places || asked.regions != compared_.regions;
    compared_ = std::move(asked);
    if (placesChanged) Q_EMIT measuredUpdated();
    if (results.empty()) return checking_.drop();
    using Names = std::set<std::string>;
    checking_.start<Names>(
        tr("Comparing results with the buildings"),
        [results, project = session_.project()](Progress&, const std::stop_token& stop) -> Result<Names> {
            return noonmark::findOutdated(results, project, stop);
        },
        [this](Result<Names> outdated) {
            if (!outdated || *outdated == outdated_) return;
            outdated_ = *std::move(outdated);
            Q_EMIT measuredUpdated();
        });
}

// Empty: no scenario has these buildings.
std::string Workbench::scenarioOf(const std::shared_ptr<const City>& city) {
    if (session_.city() == city) return session_.scenario();
    for (const std::string& name : listNames(session_.project().scenarios))
        if (session_.cityOf(name).value_or(nullptr) == city) return name;
    return {};
}

void Workbench::showMeasured(const MeasuredAnswer& measured) {
    const KnownAnswer known = measured.known();
    if (!known.answer) return showResult(measured.toSave());
    if (!known.answer->question().ofBaseline) return showByItself(known);
    const std::string scenario = scenarioOf(known.city);
    const std::string baseline = known.before ? scenarioOf(known.before) : session_.baseline();
    if (scenario.empty() || (known.before && baseline.empty())) return showPast(known.answer);
    if (known.before) comparison_ = known;
    session_.goTo(scenario);
    if (known.before) session_.setBaseline(baseline);
    if (!contentOf<Study>(known.answer)) return bringToFront(known.before ? nullptr : known.answer);
    session_.setBaseline({});
    adoptStudy(known);
    bringToFront(nullptr);
}

// Of two cities that it names itself.
void Workbench::showByItself(const KnownAnswer& known) {
    const std::string scenario = scenarioOf(known.city);
    if (scenario.empty() || scenarioOf(known.before).empty()) return showPast(known.answer);
    session_.goTo(scenario);
    bringToFront(known.answer);
}

void Workbench::showPast(SharedAnswer answer) {
    forgetAnswers();
    past_ = std::move(answer);
    pastOf_.reset();
    Q_EMIT answered();
}

void Workbench::showStudyAgain() { bringToFront(nullptr); }

}  // namespace noonmark
