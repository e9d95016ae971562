#include "app/gui/docks/results/result_display.h"

#include <algorithm>

#include "app/gui/docks/elements/elements_dock.h"
#include "app/gui/docks/results/results_dock.h"
#include "app/gui/docks/scenarios/scenario_table.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/workbench.h"
#include "app/gui/tools/preview/edit_preview.h"
#include "app/gui/view/panel/legend_strip.h"
#include "app/gui/view/panel/result_layer.h"
#include "app/gui/view/panel/view_presets.h"
#include "app/questions/saved_question.h"
#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

namespace {

// So that an edit does not clear the display.
void markOutdated(QString& note) {
    note = note.isEmpty() ? QObject::tr("Outdated: buildings have changed")
                          : QObject::tr("%1. Outdated: buildings have changed").arg(note);
}

std::optional<AnswerLayer> outdated(std::optional<AnswerLayer> layer) {
    if (!layer) return layer;
    std::visit(
        [](auto& view) {
            markOutdated(view.note);
            if (!view.runNote.isEmpty()) markOutdated(view.runNote);  // empty: the note holds for both
            view.marked = true;
        },
        *layer);
    return layer;
}

}  // namespace

ResultDisplay::ResultDisplay(Workbench& workbench, ModeSwitch& mode, const EditPreview& preview,
                             const Places& places)
    : workbench_(workbench), mode_(mode), preview_(preview), places_(places) {
    connect(&workbench_, &Workbench::answered, this, &ResultDisplay::showAnswered);
    connect(&workbench_, &Workbench::answerUpdated, this, &ResultDisplay::show);
    connect(&workbench_, &Workbench::measuredUpdated, this, [this] {
        listAnswers();
        showOutdated();
    });
    connect(&workbench_, &Workbench::studyPartial, this,
            [this](const auto& partial) { places_.layer.setPartial(partial); });
    connect(&workbench_, &Workbench::studyStopped, this, [this] { places_.layer.setPartial(nullptr); });
    connect(&places_.figures, &ResultsDock::studyRequested, &workbench_, &Workbench::showStudyAgain);
    connect(&places_.figures, &ResultsDock::answerChosen, this, &ResultDisplay::showListed);
    connect(&places_.figures, &ResultsDock::allPlacesRequested, this, &ResultDisplay::showAllPlaces);
    connect(&places_.figures, &ResultsDock::treesChosen, &places_.legend, &LegendStrip::chooseTrees);
    connect(&places_.figures, &ResultsDock::contributorsRequested, this, [this] {
        const auto sun = sunOf(workbench_.answer());
        if (sun && place_) Q_EMIT contributorsRequested(sun->baseline.places[*place_].name);
    });
    connect(&workbench_.document(), &StudyDocument::changed, this, &ResultDisplay::update);
    connect(&workbench_.session(), &ProjectSession::changed, this, &ResultDisplay::update);
    connect(&workbench_.session(), &ProjectSession::baselineChanged, this, &ResultDisplay::show);
    connect(&places_.legend, &LegendStrip::choiceChanged, this, &ResultDisplay::followLegend);
    connect(&places_.legend, &LegendStrip::placesShownChanged, this, &ResultDisplay::followLegend);
    connect(&preview_, &EditPreview::shownChanged, this, &ResultDisplay::showOutdated);
}

void ResultDisplay::showCity() {
    places_.warnings.show(workbench_.city()->loaded.read.warnings);
    show();
    update();
}

void ResultDisplay::forget() { anyShown_ = false; }

void ResultDisplay::setHint(const QString& hint) { places_.figures.setHint(hint); }

void ResultDisplay::showAnswered() {
    const auto answer = workbench_.answer();
    if (contentOf<SavedContent>(answer)) mode_.showStudies();
    place_.reset();
    show();
    if (answer && answer->points()) Q_EMIT elementsShown();
    if (answer && !answer->question().ofRun) Q_EMIT chosen();
}

void ResultDisplay::show() {
    const auto answer = workbench_.answer();
    if (!answer) return showPast();
    showInView(viewerOf(*answer).layer ? answer : workbench_.behind());
    showFigures(answer);
    anyShown_ = anyShown_ || answer->question().ofRun;
    if (const StudySettings* settings = answer->settings()) settings_ = *settings;
    if (!answer->isSaved()) places_.warnings.show(answer->warnings());
    update();
}

void ResultDisplay::showPast() {
    const auto past = workbench_.past();
    if (!past) {
        places_.layer.setAnswer(std::nullopt);
        places_.elements.show(nullptr);
        places_.figures.setWarningCount(0);
        places_.figures.show({}, {});
        places_.figures.setTrees({}, TreeColumns::without);
        return update();  // the list of answers offers the one that was hidden
    }
    const auto layerOf = viewerOf(*past).layer;
    showLayer(layerOf ? outdated(layerOf(past)) : std::nullopt, false);
    showFigures(past);
    showOutdated();
}

void ResultDisplay::showInView(const std::shared_ptr<const Answer>& answer) {
    if (!answer) return showLayer(std::nullopt, false);
    showLayer(viewerOf(*answer).layer(answer), contentOf<Study>(answer) != nullptr);
}

void ResultDisplay::showLayer(const std::optional<AnswerLayer>& layer, bool isStudy) {
    const auto* points = layer ? std::get_if<ElementView>(&*layer) : nullptr;
    places_.elements.show(points ? points->map : nullptr);
    places_.layer.setAnswer(layer, isStudy);
}

void ResultDisplay::showFigures(const std::shared_ptr<const Answer>& answer) {
    shown_ = choiceFor(answer);
    const auto sun = sunOf(answer);
    if (!sun || (place_ && *place_ >= sun->baseline.places.size())) place_.reset();
    if (place_) {
        places_.figures.show(makePage(*sun, *place_, shown_.show), rowsOfPlace(*answer, *sun));
        places_.figures.offerAllPlaces(sun->baseline.places.size());
    } else {
        places_.figures.show(answer->page(shown_), viewerOf(*answer).rows(*answer, shown_.show));
    }
    places_.figures.setTrees(listColumns(answer), shown_.trees);
    places_.figures.setWarningCount(answer->warnings().size());
}

LegendChoice ResultDisplay::choiceFor(const std::shared_ptr<const Answer>& answer) const {
    LegendChoice choice = places_.legend.choice();
    if (sunOf(answer)) choice.show = places_.legend.shownOfPlaces();
    return choice;
}

// Those that the view can show of it beside that without trees.
std::vector<TreeColumns> ResultDisplay::listColumns(const std::shared_ptr<const Answer>& answer) {
    const auto layerOf = viewerOf(*answer).layer;
    const auto layer = layerOf ? layerOf(answer) : std::nullopt;
    const auto* ground = layer ? std::get_if<GroundAnswer>(&*layer) : nullptr;
    std::vector<TreeColumns> columns;
    if (ground)
        for (const GroundAnswer::Column& with : ground->withTrees) columns.push_back(with.column);
    return columns;
}

// How it was made is the same for all places.
std::vector<ResultRow> ResultDisplay::rowsOfPlace(const Answer& answer, const SunOfCities& sun) const {
    const auto& all = answer.ofPlaces();
    const auto kept = std::ranges::find(all, sun.baseline.places[*place_].name, &ContributionTable::place);
    auto rows = makePlaceRows(sun, *place_, shown_.show, kept == all.end() ? nullptr : &*kept);
    for (const ResultRow& row : viewerOf(answer).rows(answer, shown_.show))
        if (row.isMethod) rows.push_back(row);
    return rows;
}

void ResultDisplay::showPlace(std::size_t place) {
    if (place_ == place) return;
    place_ = place;
    repeatFigures();
    places_.figures.showTop();
}

void ResultDisplay::showAllPlaces() {
    place_.reset();
    repeatFigures();
    places_.figures.showTop();
}

void ResultDisplay::repeatFigures() {
    const auto answer = workbench_.answer() ? workbench_.answer() : workbench_.past();
    if (!answer) return;
    showFigures(answer);
    showOutdated();
}

// The figures speak of shadow or of sun, with trees or without, as the legend does.
void ResultDisplay::followLegend() {
    const LegendChoice now = choiceFor(workbench_.answer() ? workbench_.answer() : workbench_.past());
    if (now.show != shown_.show || now.trees != shown_.trees) repeatFigures();
}

// The measured ones, newest first, then those saved under a name, in the project's order.
void ResultDisplay::listAnswers() {
    listed_.clear();
    QStringList names;
    int shown = -1;
    const auto list = [&](const QString& name, bool isShown, bool isOutdated, std::function<void()> show) {
        if (isShown) shown = int(names.size());
        names << (isOutdated ? tr("%1 (outdated)").arg(name) : name);
        listed_.push_back(std::move(show));
    };
    const auto measured = workbench_.measured();
    for (auto one = measured.rbegin(); one != measured.rend(); ++one)
        list(shownName(**one), *one == workbench_.measuredShown(), workbench_.isOutdated(**one),
             [this, one = *one] { workbench_.showMeasured(*one); });
    const std::string saved = workbench_.savedName();
    for (const auto& result : workbench_.session().project().results)
        list(tr("Saved: %1").arg(shownName(result)), result->name == saved, workbench_.isOutdated(*result),
             [this, result] { showNamed(result->name); });
    places_.figures.setAnswers(names, shown);
}

// As it was computed, where that was in this session: it can be explored and is quicker to show.
void ResultDisplay::showNamed(const std::string& name) {
    const auto measured = workbench_.measuredSavedAs(name);
    measured ? workbench_.showMeasured(*measured) : workbench_.showSaved(name);
}

void ResultDisplay::showListed(int answer) {
    const auto show = listed_.at(std::size_t(answer));  // which lists them anew
    show();
}

void ResultDisplay::update() {
    listAnswers();
    places_.scenarios.setStudies(workbench_.studies(), workbench_.document().settings());
    showOutdated();
    Q_EMIT updated();
}

// States whether the displayed figures are up to date.
void ResultDisplay::showOutdated() {
    places_.figures.showBackButton(workbench_.canShowStudyAgain(), workbench_.behind() != nullptr);
    const auto answer = workbench_.answer();
    const auto describe = answer ? viewerOf(*answer).note : nullptr;
    if (describe && !preview_.shown()) {
        const AnswerNote note = describe(*answer);
        return places_.figures.setNote(note.text, note.warns);
    }
    places_.figures.setNote(whyOutdated());
}

// Empty: the figures are up to date.
QString ResultDisplay::whyOutdated() const {
    if (preview_.shown())
        return tr("These figures do not include the building being designed. Build it, then run.");
    if (workbench_.past())
        return tr("Outdated figures: buildings have changed; %1.")
            .arg(workbench_.running().busy() ? tr("new figures are being computed")
                                             : tr("run again (Ctrl+R)"));
    const auto answer = workbench_.answer();
    if (workbench_.havePlacesChanged())
        return tr("Outdated figures: places have changed; run again (Ctrl+R).");
    if (answer && !answer->settings()) return {};
    const StudyDocument& document = workbench_.document();
    const bool samePoints = !answer || !answer->points() || document.elements() == *answer->points();
    if (document.settings() != settings_ || !samePoints)
        return tr("Outdated figures: settings have changed; run again (Ctrl+R).");
    const auto then = answer ? answer->part().weights : std::nullopt;
    if (!then) return {};
    const auto now = findWeights(workbench_.session().project(), then->name);
    return now && *now == *then ? QString()
                                : tr("Outdated score: the weight table has changed; score again.");
}

}  // namespace noonmark
