#include <algorithm>
#include <iterator>
#include <ranges>
#include <set>
#include <utility>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/workbench.h"
#include "app/input/load_project.h"
#include "app/questions/saved_question.h"
#include "core/base/progress.h"
#include "core/receivers/made_names.h"
#include "core/receivers/place_names.h"
#include "scenarios/scenario.h"

// The questions of Workbench: which one a run asks, and how one, or that of each scenario, is asked.
namespace noonmark {

namespace {

constexpr std::ptrdiff_t maxStudies = 64;  // cached; ScenarioCities caches as many cities

// The kinds of the project's places that were chosen, and the regions.
std::vector<CommandOption> listPlaceOptions(const std::vector<Place>& chosen, const Project& project) {
    std::set<std::string> own, kinds;
    for (const Place& place : project.places) own.insert(place.name);
    std::vector<CommandOption> options, regions;
    for (const Place& place : chosen) {
        if (own.contains(place.name))
            kinds.emplace(nameOf(place.kind));
        else
            regions.push_back({"--region", {place.name}});
    }
    for (const std::string& kind : kinds) options.push_back({"--kind", {kind}});
    options.insert(options.end(), regions.begin(), regions.end());
    return options;
}

}  // namespace

std::map<std::string, std::shared_ptr<const Study>> Workbench::studies() {
    std::map<std::string, std::shared_ptr<const Study>> valid;
    for (const std::string& scenario : listNames(session_.project().scenarios)) {
        const auto city = session_.cityOf(scenario).value_or(nullptr);
        const auto known = std::ranges::find(studies_, city, &KnownAnswer::city);
        if (known != studies_.end()) valid[scenario] = contentOf<Study>(known->answer);
    }
    return valid;
}

bool Workbench::comparing() const {
    return !session_.baseline().empty() && session_.baseline() != session_.scenario();
}

const Question& Workbench::questionOfRun() const {
    if (comparing()) return comparisonQuestion();
    return document_.elements() ? pointsQuestion() : studyQuestion();
}

bool Workbench::isAnswered() const {
    const Question& question = questionOfRun();
    const SharedAnswer& answer = question.ofPoints ? front_ : base_;
    return answer && &answer->question() == &question;
}

bool Workbench::canShowStudyAgain() const { return front_ && (base_ || !front_->question().ofRun); }

void Workbench::run() { ask(questionOfRun()); }

void Workbench::runAgain() {
    run();
    again_ = true;
}

void Workbench::ask(const Question& question, const std::string& weights) {
    if (!city_) return report(noCityError());
    again_ = false;
    const Start start = [this, &question, weights] { askNow(question, weights); };
    question.ofPoints ? startPoints(start) : startUnlessLong(question.fields, start);
}

// Estimating takes up to a second, so only runs that may be long are estimated first.
void Workbench::startUnlessLong(double fields, Start start) {
    if (!mayBeLong(document_.settings())) return start();
    runningOn_.clear();
    running_.start<RunEstimate>(
        tr("Estimating"),
        [city = session_.city(), settings = document_.settings()](Progress&, const std::stop_token& stop) {
            return estimateRun(*city, settings, stop);
        },
        [this, fields, start = std::move(start)](const Result<RunEstimate>& one) {
            announceIfLong(one, fields, start);
        });
}

// The number of points is known only once they are placed, so each run is estimated first.
void Workbench::startPoints(Start start) {
    const auto points = findElementParts(*document_.elements(), session_.project(), *session_.city());
    if (!points) return report(points.error());
    runningOn_.clear();
    running_.start<RunEstimate>(
        tr("Estimating"),
        [city = session_.city(), settings = document_.settings(), points = *points](
            Progress& progress, const std::stop_token& stop) {
            return estimateRun(*city, settings, points, progress, stop);
        },
        [this, start = std::move(start)](const Result<RunEstimate>& one) { announceIfLong(one, 1, start); });
}

void Workbench::announceIfLong(const Result<RunEstimate>& one, double fields, const Start& start) {
    if (!one && isCancelled(one.error())) return Q_EMIT studyStopped(true);
    if (!one || one->seconds * fields < longRunSeconds) return start();
    long_ = start;
    Q_EMIT studyStopped(false);
    RunEstimate all = *one;
    for (double* seconds : {&all.seconds, &all.raySeconds, &all.quickerSeconds}) *seconds *= fields;
    Q_EMIT longRun(all);
}

void Workbench::runAnyway() {
    if (const Start start = std::exchange(long_, nullptr)) start();
}

void Workbench::runQuicker() {
    StudySettings settings = document_.settings();
    settings.engine = StudySettings().engine;
    settings.engineSettings.clear();
    document_.change(settings, tr("engine"));
    runAnyway();
}

// Without the city, which is copied in the job.
Result<Asked> Workbench::makeAsked(const Question& question, const std::string& weights) {
    Asked asked{.scenario = session_.scenario(),
                .baseline = session_.baseline(),
                .settings = document_.settings(),
                .impact = {.byBuilding = true}};
    if (&question == &comparisonQuestion() || (&question == &byPlaceQuestion() && comparing())) {
        auto before = session_.cityOf(asked.baseline);
        if (!before) return tl::make_unexpected(before.error());
        asked.before = *std::move(before);
    }
    if (question.ofPoints) {
        auto points = findElementParts(*document_.elements(), session_.project(), *session_.city());
        if (!points) return tl::make_unexpected(points.error());
        asked.points = *std::move(points);
    }
    if (!weights.empty()) {
        auto table = findWeights(session_.project(), weights);
        if (!table) return tl::make_unexpected(table.error());
        asked.weights = *std::move(table);
    }
    return asked;
}

void Workbench::askNow(const Question& question, const std::string& weights) {
    if (&question == &studyQuestion())
        return measure(translated(question.label), {{session_.city(), {}, {}}});
    const auto asked = makeAsked(question, weights);
    asked ? compute(question, *asked) : report(asked.error());
}

// Those that are neither displayed nor the baseline.
std::vector<std::string> Workbench::listOtherScenarios() const {
    std::vector<std::string> names = listNames(session_.project().scenarios);
    std::erase(names, session_.scenario());
    std::erase(names, session_.baseline());
    return names;
}

// Scenarios whose base is missing have no city.
std::vector<NamedCity> Workbench::listOthers() {
    std::vector<NamedCity> others;
    for (const std::string& name : listOtherScenarios())
        if (const auto city = session_.cityOf(name)) others.push_back({name, **city});
    return others;
}

std::vector<std::shared_ptr<const City>> Workbench::listPlaceCities(bool allScenarios) {
    std::vector<std::string> names{session_.scenario()};
    if (comparing()) names.insert(names.begin(), session_.baseline());
    if (comparing() && allScenarios) std::ranges::move(listOtherScenarios(), std::back_inserter(names));
    std::vector<std::shared_ptr<const City>> cities;
    for (const std::string& name : names)
        if (const auto city = session_.cityOf(name)) cities.push_back(*city);
    return cities;
}

void Workbench::compareAnyScenario() {
    if (comparing() || session_.project().scenarios.empty()) return;
    if (session_.scenario() == existingCity) session_.goTo(session_.project().scenarios.back().name);
    session_.setBaseline(existingCity);
}

void Workbench::runByPlace(std::vector<Place> places, const SunByPlaceSettings& settings, bool allScenarios) {
    if (!city_) return report(noCityError());
    auto asked = makeAsked(byPlaceQuestion(), {});
    if (!asked) return report(asked.error());
    again_ = false;
    asked->placesAsked = {listPlaceOptions(places, session_.project()), true};
    asked->places = std::move(places);
    asked->byPlace = settings;
    if (allScenarios && comparing()) asked->others = listOthers();
    compute(byPlaceQuestion(), *std::move(asked));
}

void Workbench::compute(const Question& question, Asked asked) {
    KnownAnswer known{session_.city(), asked.before, {}, {}};
    for (const NamedCity& other : asked.others)
        known.others.emplace_back(other.name, session_.cityOf(other.name).value_or(nullptr));
    runningOn_ = {known.city, known.before};
    running_.start<SharedAnswer>(
        translated(question.label),
        [&question, asked = std::move(asked), shown = city_, city = session_.city()](
            Progress& progress, const std::stop_token& stop) mutable {
            asked.loaded = withCity(shown->loaded, *city);
            return question.compute(asked, progress, stop);
        },
        [this, known = std::move(known)](Result<SharedAnswer> answer) {
            adoptAnswer(known, std::move(answer));
        });
}

// An answer about buildings that have changed meanwhile is dropped; of scenarios that are not displayed, or
// not compared, any more it is listed.
void Workbench::adoptAnswer(KnownAnswer known, Result<SharedAnswer> answer) {
    if (!answer) {
        Q_EMIT studyStopped(isCancelled(answer.error()));
        return report(answer.error());
    }
    if (known.before && scenarioOf(known.before).empty()) return Q_EMIT studyStopped(false);
    const Question& question = (*answer)->question();
    if (question.ofRun) answerSeconds_ = (*answer)->seconds();
    known.answer = *std::move(answer);
    remember(known, !again_);
    if (!isOfShown(known)) {
        Q_EMIT studyStopped(false);
        return Q_EMIT noted(tr("%1 is in the list of answers").arg(listedName(*known.answer)));
    }
    const bool isComparison = &question == &comparisonQuestion();
    if (isComparison) comparison_ = known;
    bringToFront(isComparison ? nullptr : std::move(known.answer));
    if (!again_) Q_EMIT ran();
}

bool Workbench::isOfShown(const KnownAnswer& known) {
    return known.city == session_.city() &&
           (!known.before || session_.cityOf(session_.baseline()).value_or(nullptr) == known.before);
}

void Workbench::measure(const QString& what, std::vector<KnownAnswer> wanted) {
    const auto asked = makeAsked(studyQuestion(), {});
    if (!asked) return report(asked.error());
    using Made = std::vector<Measured>;
    const std::size_t count = wanted.size();
    runningOn_.clear();
    for (const KnownAnswer& one : wanted) runningOn_.push_back(one.city);
    running_.start<Made>(
        what,
        [wanted = std::move(wanted), shown = city_, asked = *asked](
            Progress& progress, const std::stop_token& stop) mutable -> Result<Made> {
            Made made;
            RisingProgress rising(progress);  // a study begins anew where its engine is too far off
            for (std::size_t i = 0; i < wanted.size(); ++i) {
                ProgressShare share(rising, i, wanted.size());
                asked.loaded = withCity(shown->loaded, *wanted[i].city);
                // Of one study alone the partial results are shown, which a share does not pass on.
                auto study = studyQuestion().compute(asked, wanted.size() > 1 ? share : progress, stop);
                if (!study && isCancelled(study.error()) && !made.empty()) return made;
                if (!study && (wanted.size() == 1 || isCancelled(study.error())))
                    return tl::make_unexpected(study.error());
                if (study) wanted[i].answer = *std::move(study);
                made.push_back({wanted[i], study ? std::nullopt : std::optional(study.error())});
            }
            return made;
        },
        [this, count](Result<Made> made) {
            const bool isCutShort = made && made->size() < count;
            adoptStudies(std::move(made));
            if (isCutShort) Q_EMIT studyStopped(true);
        });
}

void Workbench::adoptStudies(Result<std::vector<Measured>> made) {
    if (!made) {
        Q_EMIT studyStopped(isCancelled(made.error()));
        return report(made.error());
    }
    for (const auto& [study, error] : *made) {
        if (error) continue;
        adoptStudy(study);
        remember(study, !again_);
        answerSeconds_ = study.answer->seconds();
    }
    // The table of scenarios has several; of one alone another scenario may be displayed by now.
    const bool isOfOthers =
        std::ranges::none_of(*made, [this](const Measured& one) { return isOfShown(one.study); });
    const bool staysInFront = (made->size() > 1 && sunOf(front_)) || isOfOthers;
    bringToFront(staysInFront ? front_ : nullptr);
    if (!again_) Q_EMIT ran();
    reportAll(*made);
}

void Workbench::reportAll(const std::vector<Measured>& made) {
    ScenarioErrors errors;
    for (const auto& [study, error] : made)
        if (error) errors.emplace_back(scenarioOf(study.city), *error);
    for (const auto& [scenario, error] : errors) Q_EMIT scenarioFailed(scenario, error);
    if (errors.empty()) return;
    if (errors.size() == made.size()) Q_EMIT studyStopped(false);
    report(sumUp(errors, made.size()));
}

// In place of an earlier one of the same buildings.
void Workbench::adoptStudy(const KnownAnswer& study) {
    std::erase_if(studies_, [&](const KnownAnswer& old) { return old.city == study.city; });
    studies_.push_back(study);
    if (std::ssize(studies_) > maxStudies) studies_.erase(studies_.begin());
}

std::vector<KnownAnswer> Workbench::listUnmeasured() {
    std::vector<KnownAnswer> unmeasured;
    const auto known = studies();
    for (const std::string& name : listNames(session_.project().scenarios)) {
        const auto study = known.find(name);
        if (study != known.end() && study->second->settings == document_.settings()) continue;
        if (const auto city = session_.cityOf(name)) unmeasured.push_back({*city, {}, {}});
    }
    return unmeasured;
}

void Workbench::measureAllByMonth() {
    if (!city_) return;
    StudySettings settings = document_.settings();
    settings.byMonth = true;
    document_.change(settings, tr("months"));
    measureAll();
}

void Workbench::measureAll() {
    if (!city_) return;
    again_ = false;
    startUnlessLong(double(listUnmeasured().size()),
                    [this] { measure(tr("All scenarios"), listUnmeasured()); });
}

}  // namespace noonmark
