#include <algorithm>
#include <utility>

#include "app/gui/session/answers/answer_origin.h"
#include "app/gui/session/workbench.h"
#include "app/input/all_engines.h"
#include "core/base/progress_share.h"
#include "core/base/stopwatch.h"
#include "scenarios/project/results/save_result.h"
#include "scenarios/scenario_list.h"

// The results of Workbench: studies, comparisons, scores, and the display of saved results.
namespace noonmark {

namespace {

constexpr std::ptrdiff_t mostKnown = 64;  // cached studies; ScenarioCities caches as many cities

}  // namespace

std::map<std::string, std::shared_ptr<const Study>> Workbench::studies() {
    std::map<std::string, std::shared_ptr<const Study>> valid;
    for (const std::string& scenario : listNames(session_.project().scenarios)) {
        const auto city = session_.cityOf(scenario).value_or(nullptr);
        const auto known = std::ranges::find(known_, city, &KnownStudy::city);
        if (known != known_.end()) valid[scenario] = known->study;
    }
    return valid;
}

void Workbench::run() {
    if (!city_) return tell({"No city is open", {}, "Open a file or a sample first"});
    if (measuresElements()) return startElements();
    startUnlessLong(comparing() ? 2 : 1, [this] { runNow(); });
}

bool Workbench::comparing() const {
    return !session_.baseline().empty() && session_.baseline() != session_.scenario();
}

// Estimating takes up to a second, so only runs that may be long are estimated first.
void Workbench::startUnlessLong(double fields, Start start) {
    if (!mayBeLong(document_.settings())) return start();
    running_.start<RunEstimate>(
        tr("Estimating"),
        [city = session_.city(), settings = document_.settings()](Progress&, const std::stop_token& stop) {
            return estimateRun(*city, settings, stop);
        },
        [this, fields, start = std::move(start)](const Result<RunEstimate>& one) {
            announceIfLong(one, fields, start);
        });
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

void Workbench::runNow() {
    if (comparing()) return runComparison();
    comparison_.reset();
    measure(tr("Study"), {{session_.city(), nullptr}});
}

void Workbench::measure(const QString& what, std::vector<KnownStudy> wanted, bool toSave) {
    using Made = std::vector<KnownStudy>;
    running_.start<Made>(
        what,
        [wanted = std::move(wanted), shown = city_, settings = document_.settings()](
            Progress& progress, std::stop_token stop) -> Result<Made> {
            Made made = wanted;
            for (std::size_t i = 0; i < made.size(); ++i) {
                ProgressShare share(progress, i, made.size());
                auto study = studyOf(withCity(shown->loaded, *made[i].city), settings,
                                     made.size() > 1 ? share : progress, stop);
                if (!study) return tl::make_unexpected(study.error());
                made[i].study = std::make_shared<const Study>(*std::move(study));
            }
            return made;
        },
        [this, toSave](Result<Made> made) {
            if (made && !made->empty() && toSave) session_.noteFigures();
            takeStudies(std::move(made));
        });
}

void Workbench::takeStudies(Result<std::vector<KnownStudy>> made) {
    if (!made) {
        Q_EMIT studyStopped(isCancelled(made.error()));
        return tell(made.error());
    }
    for (const KnownStudy& one : *made) {
        std::erase_if(known_, [&](const KnownStudy& old) { return old.city == one.city; });
        known_.push_back(one);
    }
    if (std::ssize(known_) > mostKnown) known_.erase(known_.begin(), known_.end() - mostKnown);
    if (!made->empty()) answerSeconds_ = made->back().study->seconds.at("total");
    takeKnown();
    standBack();
    Q_EMIT studyDone();
}

// Takes the cached study of the displayed scenario, if there is one.
void Workbench::takeKnown() {
    const auto known = studies();
    const auto study = known.find(session_.scenario());
    study_ = study == known.end() ? nullptr : study->second;
    if (study_) past_ = {};
}

std::vector<Workbench::KnownStudy> Workbench::wanted() {
    std::vector<KnownStudy> wanted;
    const auto known = studies();
    for (const std::string& name : listNames(session_.project().scenarios)) {
        const auto study = known.find(name);
        if (study != known.end() && study->second->settings == document_.settings()) continue;
        if (const auto city = session_.cityOf(name)) wanted.push_back({*city, nullptr});
    }
    return wanted;
}

void Workbench::measureAll() {
    if (city_)
        startUnlessLong(double(wanted().size()), [this] { measure(tr("All scenarios"), wanted(), true); });
}

void Workbench::runComparison() {
    const auto before = session_.cityOf(session_.baseline());
    if (!before) return tell(before.error());
    ImpactAnswer question{session_.baseline(),
                          session_.scenario(),
                          {document_.settings(), true},
                          {usualThresholdsMin.begin(), usualThresholdsMin.end()},
                          {}};
    running_.start<ImpactAnswer>(
        tr("Comparison"),
        [question, before = *before, after = session_.city(), warnings = city_->loaded.read.warnings](
            Progress& progress, std::stop_token stop) {
            return runImpact(*before, *after, question.settings, progress, std::move(stop),
                             enginesWith(question.settings.study.engine))
                .map([&](ImpactStudy study) {
                    ImpactAnswer answer = question;
                    answer.study = std::move(study);
                    putBefore(answer.study.total.warnings, warnings);
                    return answer;
                });
        },
        [this, watch = Stopwatch(), before = *before, after = session_.city()](Result<ImpactAnswer> answer) {
            const auto still = session_.cityOf(session_.baseline());
            if (after != session_.city() || !still || *still != before) return Q_EMIT studyStopped(false);
            if (answer) answerSeconds_ = watch.seconds();
            comparedWith_ = before;
            takeComparison(std::move(answer));
        });
}

void Workbench::takeComparison(Result<ImpactAnswer> answer) {
    if (!answer) {
        Q_EMIT studyStopped(isCancelled(answer.error()));
        return tell(answer.error());
    }
    answer->from = session_.baseline();  // they may have been renamed meanwhile
    answer->to = session_.scenario();
    comparison_ = std::make_shared<const ImpactAnswer>(*std::move(answer));
    standBack();
    Q_EMIT comparisonDone();
}

// A renamed scenario stays in the comparison under its new name.
void Workbench::rename(ProjectPart part, const std::string& from, const std::string& to) {
    if (part != ProjectPart::scenario || !comparison_) return;
    if (comparison_->from != from && comparison_->to != from) return;
    auto renamed = std::make_shared<ImpactAnswer>(*comparison_);
    for (std::string* name : {&renamed->from, &renamed->to})
        if (*name == from) *name = to;
    comparison_ = std::move(renamed);
    Q_EMIT comparisonDone();
}

// A copy of a scenario has the same buildings: the displayed result is valid for it too, and takes its name.
void Workbench::nameAnswers() {
    const std::string &from = session_.baseline(), &to = session_.scenario();
    if (score_ && score_->scenario != to) {
        auto named = std::make_shared<ScoreAnswer>(*score_);
        named->scenario = to;
        score_ = std::move(named);
        Q_EMIT scoreDone();
    }
    if (!comparison_ || (comparison_->from == from && comparison_->to == to)) return;
    if (from.empty() || session_.cityOf(from).value_or(nullptr) != comparedWith_.lock()) return;
    auto named = std::make_shared<ImpactAnswer>(*comparison_);
    named->from = from;
    named->to = to;
    comparison_ = std::move(named);
    Q_EMIT comparisonDone();
}

void Workbench::runScore(const std::string& weights) {
    if (!city_) return tell({"No city is open", {}, "Open a file or a sample first"});
    startUnlessLong(1, [this, weights] { scoreNow(weights); });
}

void Workbench::scoreNow(const std::string& weights) {
    const auto table = findWeights(session_.project(), weights);
    if (!table) return tell(table.error());
    running_.start<ScoreAnswer>(
        tr("Score"),
        [question = ScoreAnswer{session_.scenario(), document_.settings(), *table, {}},
         city = session_.city(),
         warnings = city_->loaded.read.warnings](Progress& progress, const std::stop_token& stop) {
            // forwards no partial results: they would cover one month only
            ProgressShare whole(progress, 0, 1);
            return noonmark::runScore(*city, question.settings, question.weights, whole, stop,
                                      enginesWith(question.settings.engine))
                .map([&](Score score) {
                    ScoreAnswer answer = question;
                    answer.score = std::move(score);
                    putBefore(answer.score.warnings, warnings);
                    return answer;
                });
        },
        [this](Result<ScoreAnswer> answer) { takeScore(std::move(answer)); });
}

void Workbench::takeScore(Result<ScoreAnswer> answer) {
    if (!answer) {
        Q_EMIT studyStopped(isCancelled(answer.error()));
        return tell(answer.error());
    }
    answer->scenario = session_.scenario();  // it may have been renamed meanwhile
    standBack();
    score_ = std::make_shared<const ScoreAnswer>(*std::move(answer));
    Q_EMIT scoreDone();
}

// Shows the result on the buildings it was computed for, if its scenario still exists.
void Workbench::showSaved(const std::string& name) {
    const auto result = findResult(session_.project(), name);
    if (!result) return tell(result.error());
    if (session_.cityOf((*result)->scenario)) session_.goTo((*result)->scenario);
    reading_.start<ShownResult>(
        tr("Showing %1").arg(QString::fromStdString(name)),
        [result = *result, project = session_.project()](Progress&, const std::stop_token&) {
            return shownResult(*result, project);
        },
        [this](Result<ShownResult> shown) {
            if (!shown) return tell(shown.error());
            saved_ = std::make_shared<const ShownResult>(*std::move(shown));
            Q_EMIT savedShown();
        });
}

// A score or saved result is no longer displayed once a new result is ready.
void Workbench::standBack() {
    reading_.drop();
    past_ = {};
    score_.reset();
    elements_.reset();
    saved_.reset();
}

void Workbench::showStudyAgain() {
    standBack();
    Q_EMIT comparison_ ? comparisonDone() : studyDone();
}

void Workbench::reweigh() {
    auto now = saved_ ? noonmark::reweigh(*saved_, session_.project()) : std::nullopt;
    if (!now) return;
    saved_ = std::make_shared<const ShownResult>(*std::move(now));
    Q_EMIT savedReweighed();
}

void Workbench::keepAnswer(const QString& name) {
    if (saved_) return tell({"This result is already saved", saved_->name, {}});
    if (keeping_.busy()) return tell({"Another result is being saved", {}, "Wait until it is saved"});
    if (const Keep keep = whatToKeep()) return this->keep(keep, name);
    tell({"There is no result to save", {}, "Press Run first"});
}

// Captures the result displayed now, since another may be displayed when it is saved. Empty if there is none.
Workbench::Keep Workbench::whatToKeep() const {
    const AnswerOrigin origin(session_);
    if (score_)
        return [score = score_, origin](const Project& project) {
            return makeSavedResult(project, origin.stated(*score));
        };
    if (elements_)
        return [elements = elements_, origin, scenario = session_.scenario()](const Project& project) {
            return makeSavedResult(project, scenario, origin.stated(elements->study));
        };
    if (comparison_)
        return [comparison = comparison_, origin](const Project& project) {
            return makeSavedResult(project, origin.stated(*comparison));
        };
    if (!study_) return {};
    return [study = study_, origin, scenario = session_.scenario()](const Project& project) {
        return makeSavedResult(project, scenario, origin.stated(*study));
    };
}

void Workbench::keep(const Keep& keep, const QString& name) {
    keeping_.start<SavedResult>(
        tr("Saving %1").arg(name),
        [keep, project = session_.project()](Progress&, const std::stop_token&) -> Result<SavedResult> {
            return keep(project);
        },
        [this, name](Result<SavedResult> result) {
            if (!result) return tell(result.error());
            result->name = freeName(session_.project(), ProjectPart::result, name.toStdString());
            const QString what = tr("save result %1").arg(QString::fromStdString(result->name));
            session_.change(addResult(session_.project(), *std::move(result)), what);
        });
}

}  // namespace noonmark
