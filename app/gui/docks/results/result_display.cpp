#include "app/gui/docks/results/result_display.h"

#include "app/gui/base/layers/error_notes.h"
#include "app/gui/base/widgets/number_words.h"
#include "app/gui/docks/elements/elements_dock.h"
#include "app/gui/docks/results/results_dock.h"
#include "app/gui/docks/results/warnings_dock.h"
#include "app/gui/docks/scenarios/scenario_table.h"
#include "app/gui/session/answers/comparison_rows.h"
#include "app/gui/session/answers/element_rows.h"
#include "app/gui/session/answers/score_rows.h"
#include "app/gui/tools/preview/edit_preview.h"
#include "app/gui/view/panel/mode_switch.h"
#include "app/gui/view/panel/result_layer.h"

namespace noonmark {

namespace {

std::vector<ResultRow> scoreRows(const ScoreAnswer& score) {
    return makeScoreRows(score.score, score.scenario, score.weights.name, formatText(score.settings.period));
}

}  // namespace

ResultDisplay::ResultDisplay(Workbench& workbench, ModeSwitch& mode, const EditPreview& preview,
                             const Places& places)
    : workbench_(workbench), mode_(mode), preview_(preview), places_(places) {
    connect(&workbench_, &Workbench::studyDone, this, &ResultDisplay::showStudy);
    connect(&workbench_, &Workbench::comparisonDone, this, &ResultDisplay::showComparison);
    connect(&workbench_, &Workbench::scoreDone, this, &ResultDisplay::showScore);
    connect(&workbench_, &Workbench::elementsDone, this, &ResultDisplay::showElements);
    connect(&workbench_, &Workbench::savedShown, this, [this] {
        mode_.showStudies();
        showSaved();
    });
    connect(&workbench_, &Workbench::savedReweighed, this,
            [this] { places_.layer.setInFront(makeGroundAnswer(*workbench_.saved())); });
    connect(&workbench_, &Workbench::studyPartial, this,
            [this](const auto& partial) { places_.layer.setPartial(partial); });
    connect(&workbench_, &Workbench::studyStopped, this, [this] { places_.layer.setPartial(nullptr); });
    connect(&places_.figures, &ResultsDock::studyWanted, &workbench_, &Workbench::showStudyAgain);
    connect(&workbench_.document(), &StudyDocument::changed, this, &ResultDisplay::update);
    connect(&workbench_.session(), &ProjectSession::changed, this, &ResultDisplay::update);
    connect(&workbench_.session(), &ProjectSession::baselineChanged, this, &ResultDisplay::compare);
    connect(&preview_, &EditPreview::shownChanged, this, &ResultDisplay::showOutdated);
}

void ResultDisplay::showCity() {
    places_.warnings.show(workbench_.city()->loaded.read.warnings);
    places_.figures.show({});
    showResult();
    update();
}

void ResultDisplay::forget() { anyShown_ = false; }

void ResultDisplay::setHint(const QString& hint) { places_.figures.setHint(hint); }

// A comparison is computed first and shown when it is done.
void ResultDisplay::compare() {
    places_.layer.setInFront(std::nullopt);
    places_.layer.setElements(std::nullopt);
    if (!workbench_.comparing()) showResult();
}

void ResultDisplay::showResult() {
    if (workbench_.saved()) return showSaved();
    if (workbench_.score()) return showScore();
    if (workbench_.elements()) return showElements();
    workbench_.comparison() ? showComparison() : showStudy();
}

void ResultDisplay::showStudy() {
    places_.scenarios.setStudies(workbench_.studies(), workbench_.document().settings());
    if (workbench_.comparison() || workbench_.score() || workbench_.elements() || workbench_.saved()) return;
    const auto study = workbench_.study();
    hideOthers();
    if (!study) return showPast();
    settings_ = study->settings;
    anyShown_ = true;
    places_.layer.setStudy(study);
    places_.figures.show(makeResultRows(*study));
    places_.warnings.show(study->warnings);
    update();
}

// The result for the buildings before the edit, marked as outdated, so that an edit does not clear the
// display.
void ResultDisplay::showPast() {
    const Workbench::PastAnswer& past = workbench_.past();
    if (!past.any()) return places_.figures.show({});
    const QString outdated = tr("Outdated: buildings have changed");
    if (past.elements) {
        showPoints(past.elements, {.note = outdated, .marked = true});
        return showOutdated();
    }
    GroundAnswer answer = past.score        ? makeGroundAnswer(past.score)
                          : past.comparison ? makeGroundAnswer(past.comparison)
                                            : makeGroundAnswer(past.study);
    const auto mark = [&](QString& note) {
        note = note.isEmpty() ? outdated : tr("%1. Outdated: buildings have changed").arg(note);
    };
    mark(answer.note);
    if (!answer.runNote.isEmpty()) mark(answer.runNote);  // empty: the note holds for both
    answer.marked = true;
    places_.layer.setInFront(answer);
    if (past.score)
        places_.figures.show(scoreRows(*past.score), past.score->score.months);
    else
        places_.figures.show(past.comparison ? makeComparisonRows(computeFigures(*past.comparison))
                                             : makeResultRows(*past.study));
    showOutdated();
}

void ResultDisplay::showComparison() {
    const auto comparison = workbench_.comparison();
    if (workbench_.score() || workbench_.elements() || workbench_.saved()) return;
    hideOthers();
    settings_ = comparison->settings.study;
    anyShown_ = true;
    places_.layer.setInFront(makeGroundAnswer(comparison));
    places_.figures.show(makeComparisonRows(computeFigures(*comparison)));
    places_.warnings.show(comparison->study.total.warnings);
    update();
}

void ResultDisplay::showScore() {
    const auto score = workbench_.score();
    hideOthers();
    settings_ = score->settings;
    places_.layer.setInFront(makeGroundAnswer(score));
    places_.figures.show(scoreRows(*score), score->score.months);
    places_.warnings.show(score->score.warnings);
    Q_EMIT chosen();
    update();
}

void ResultDisplay::showElements() {
    const auto answer = workbench_.elements();
    if (workbench_.saved()) return;
    settings_ = answer->study.settings;
    elements_ = answer->study.elements;
    anyShown_ = true;
    const auto errorOf = [&](ShadowMeasure measure) { return describeError(answer->study, measure); };
    showPoints(answer,
               {.note = errorOf(ShadowMeasure::gross), .runNote = errorOf(ShadowMeasure::continuous)});
    places_.warnings.show(answer->study.warnings);
    update();
    Q_EMIT elementsShown();
}

// `view`: without its map.
void ResultDisplay::showPoints(const std::shared_ptr<const ElementAnswer>& answer, ElementView view) {
    view.map = std::shared_ptr<const ElementMap>(answer, &answer->map);
    places_.elements.show(view.map);
    places_.layer.setInFront(std::nullopt);
    places_.layer.setElements(view);
    places_.figures.show(makeElementRows(answer->study));
}

// Another kind of result is shown.
void ResultDisplay::hideOthers() {
    elements_.reset();
    places_.layer.setInFront(std::nullopt);
    places_.layer.setElements(std::nullopt);
    places_.elements.show(nullptr);
}

void ResultDisplay::showSaved() {
    const auto saved = workbench_.saved();
    hideOthers();
    if (const auto points = makeElementView(*saved)) {
        places_.elements.show(points->map);
        places_.layer.setElements(points);
        Q_EMIT elementsShown();
    } else {
        places_.layer.setInFront(makeGroundAnswer(*saved));
    }
    places_.figures.show(makeRows(*saved), monthsOf(*saved));
    Q_EMIT chosen();
    update();
}

void ResultDisplay::update() {
    places_.scenarios.setStudies(workbench_.studies(), workbench_.document().settings());
    showOutdated();
    Q_EMIT updated();
}

// States whether the displayed figures are up to date.
void ResultDisplay::showOutdated() {
    const auto saved = workbench_.saved();
    const bool otherStudy = workbench_.elements() && (workbench_.study() || workbench_.comparison());
    places_.figures.offerWayBack(saved || workbench_.score() || otherStudy);
    if (saved && !preview_.shown() && !workbench_.past().any())
        return places_.figures.setNote(describeSaved(*saved), !saved->upToDate());
    places_.figures.setNote(whyOutdated());
}

// Empty: the figures are up to date.
QString ResultDisplay::whyOutdated() const {
    if (preview_.shown())
        return tr("These figures do not include the building being designed. Build it, then run.");
    if (workbench_.past().any())
        return tr("Outdated figures: buildings have changed; %1.")
            .arg(workbench_.running().busy() ? tr("new figures are being computed")
                                             : tr("run again (Ctrl+R)"));
    const bool same = workbench_.document().settings() == settings_ &&
                      (!workbench_.elements() || workbench_.document().elements() == elements_);
    if (!same) return tr("Outdated figures: settings have changed; run again (Ctrl+R).");
    const auto score = workbench_.score();
    if (!score) return {};
    const auto weights = findWeights(workbench_.session().project(), score->weights.name);
    const bool sameWeights = weights && *weights == score->weights;
    return sameWeights ? QString() : tr("Outdated score: the weight table has changed; score again.");
}

}  // namespace noonmark
