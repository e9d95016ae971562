#include "app/gui/docks/study_form/study_dock.h"

#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/docks/study_form/accuracy_section.h"
#include "app/gui/docks/study_form/places_form.h"
#include "app/gui/docks/study_form/what_form.h"
#include "app/gui/docks/study_form/when_form.h"
#include "app/gui/docks/study_form/where_form.h"
#include "app/gui/session/study/run_estimate.h"
#include "app/gui/session/study/study_document.h"
#include "app/input/all_engines.h"

namespace noonmark {

namespace {

constexpr int minScreenPx = 248;  // of the forms; where they need more, they scroll

QGroupBox* groupOf(const QString& title, std::initializer_list<QWidget*> content) {
    auto* group = new QGroupBox(title);
    auto* column = new QVBoxLayout(group);
    for (QWidget* widget : content) column->addWidget(widget);
    return group;
}

Period wholeYear(const Period& period) { return withPresetDays(PeriodPreset::year, period, period.start, 0); }

QLabel* lineOf(const char* name) {
    auto* line = new QLabel;
    line->setObjectName(QString::fromLatin1(name));
    line->setWordWrap(true);
    return line;
}

}  // namespace

StudyDock::StudyDock(StudyDocument& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      what_(new WhatForm),
      breakdown_(new BreakdownForm),
      when_(new WhenForm),
      where_(new WhereForm),
      places_(new PlacesForm),
      accuracy_(new AccuracySection),
      forecast_(new RunForecast(this)),
      forecastLine_(lineOf("forecast")),
      refusal_(lineOf("engineRefusal")),
      run_(pushButton({}, "run", tr("Compute the minutes of shadow in every cell of the region (Ctrl+R)"))),
      progress_(new ProgressStrip(QBoxLayout::TopToBottom)) {
    forecastLine_->setMinimumHeight(2 * fontMetrics().lineSpacing());
    showAsError(*refusal_);
    placeForms();
    connectForms();
    connectRegion();
    connect(&document_, &StudyDocument::changed, this, &StudyDock::showDocument);
    connect(forecast_, &RunForecast::changed, this, &StudyDock::showForecast);
    connect(run_, &QPushButton::clicked, this, &StudyDock::run);
    showDocument();
}

void StudyDock::placeForms() {
    auto* forms = new QWidget;
    auto* questions = new QVBoxLayout(forms);
    what_->layout()->addWidget(breakdown_);
    questions->addWidget(groupOf(tr("What"), {what_}));
    questions->addWidget(groupOf(tr("When"), {when_}));
    questions->addWidget(groupOf(tr("Where"), {where_, places_}));
    questions->addWidget(groupOf(tr("How exactly"), {accuracy_}));
    questions->addStretch(1);
    // The button and what it will do stay in sight on any screen.
    auto* scroll = new QScrollArea;
    scroll->setWidget(forms);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    formsWidth_ = forms->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width();
    scroll->setMinimumWidth(std::min(minScreenPx, formsWidth_));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 0, 4, 4);
    column->addWidget(scroll, 1);
    // The button stays where it is pressed when progress appears.
    for (QWidget* widget : {static_cast<QWidget*>(refusal_), static_cast<QWidget*>(forecastLine_),
                            static_cast<QWidget*>(progress_), static_cast<QWidget*>(run_)})
        column->addWidget(widget);
}

QSize StudyDock::sizeHint() const {
    const QMargins margins = layout()->contentsMargins();
    return {formsWidth_ + margins.left() + margins.right(), QWidget::sizeHint().height()};
}

void StudyDock::connectForms() {
    connect(what_, &WhatForm::placesChosen, this, [this](ReceiverPlaces places) {
        StudySettings settings = document_.settings();
        settings.receivers.places = places;
        document_.change(settings, std::nullopt, tr("receivers"));
    });
    connect(what_, &WhatForm::elementsChosen, this,
            [this](const ElementSettings& elements, const QString& field) {
                document_.change(document_.settings(), elements, field);
            });
    connect(what_, &WhatForm::kindChosen, this, &StudyDock::takeKind);
    connect(places_, &PlacesForm::streetsRequested, this, &StudyDock::streetsRequested);
    connect(places_, &PlacesForm::edited, this, &StudyDock::showDocument);
    connect(when_, &WhenForm::edited, this, [this](const Period& period, const QString& field) {
        StudySettings settings = document_.settings();
        settings.period = period;
        document_.change(settings, field);
    });
    connect(
        accuracy_, &AccuracySection::edited, this,
        [this](const StudySettings& settings, const QString& field) { document_.change(settings, field); });
    connect(
        breakdown_, &BreakdownForm::edited, this,
        [this](const StudySettings& settings, const QString& field) { document_.change(settings, field); });
    connect(accuracy_, &AccuracySection::paperRequested, this, &StudyDock::paperRequested);
}

void StudyDock::connectRegion() {
    connect(where_, &WhereForm::drawRequested, this, &StudyDock::drawRequested);
    connect(where_, &WhereForm::viewRequested, this, &StudyDock::viewRegionRequested);
    connect(where_, &WhereForm::wholeCityRequested, this, &StudyDock::wholeCityRequested);
    connect(where_, &WhereForm::surroundingsRequested, this, &StudyDock::surroundingsRequested);
    connect(where_, &WhereForm::named, this, &StudyDock::regionNamed);
}

void StudyDock::takeKind(StudyKind kind) {
    Q_EMIT kindChosen(kind);
    usePeriodOf(kind);
    showDocument();
}

void StudyDock::choose(StudyKind kind) {
    what_->show(kind, document_.settings().receivers.places, document_.elements());
    takeKind(kind);
}

void StudyDock::restore(StudyKind kind) {
    what_->show(kind, document_.settings().receivers.places, document_.elements());
    showDocument();
}

void StudyDock::beginAnew() {
    periodBefore_.reset();
    usePeriodOf(what_->kind());
    showDocument();
}

// Reviews have a panel of their own, with its own button.
void StudyDock::run() {
    const StudyKind kind = what_->kind();
    if (kind == StudyKind::score) return Q_EMIT scoreRequested();
    if (kind == StudyKind::review) return Q_EMIT kindChosen(kind);
    kind == StudyKind::places ? runByPlace() : Q_EMIT runRequested();
}

// What is wrong with the settings is said in the form.
void StudyDock::runByPlace() {
    if (const auto settings = places_->settings())
        Q_EMIT sunByPlaceRequested(places_->chosen(), *settings, places_->allScenarios());
}

void StudyDock::runByPlaceInAll() {
    if (const auto settings = places_->settings(); settings && run_->isEnabled())
        Q_EMIT sunByPlaceRequested(places_->chosen(), *settings, true);
}

// The sun of places and scores, whose weights differ by month, are asked for over a year, until the user
// chooses other days; other questions get their days back.
void StudyDock::usePeriodOf(StudyKind kind) {
    StudySettings settings = document_.settings();
    const Period year = wholeYear(settings.period);
    const bool wantsYear = kind == StudyKind::places || kind == StudyKind::score;
    if (wantsYear && settings.period != year && !periodBefore_) {
        periodBefore_ = settings.period;
        settings.period = year;
    } else if (!wantsYear && periodBefore_) {
        if (settings.period == year) settings.period = *periodBefore_;
        periodBefore_.reset();
    }
    document_.change(settings, tr("period"));
}

void StudyDock::setPlaces(const std::vector<Place>& places, const std::vector<Region>& regions) {
    places_->setPlaces(places, regions);
}

void StudyDock::setEnough(double hours) { places_->setEnough(hours); }

void StudyDock::setScenarioCount(std::size_t count) { places_->setScenarioCount(count); }

void StudyDock::setRegions(const QStringList& names) { where_->setNames(names); }
void StudyDock::setDrawing(bool drawing) { where_->setDrawing(drawing); }
void StudyDock::setRules(const std::vector<Rule>& rules) { when_->setRules(rules); }

void StudyDock::setBuilding(const QString& id) {
    where_->setBuilding(!id.isEmpty());
    what_->setBuilding(id);
}

void StudyDock::setCity(std::shared_ptr<const City> city) {
    terrain_ = city && city->terrain != nullptr;
    hasCity_ = city != nullptr;
    if (city) when_->setLatitude(city->frame.origin().latDeg);
    accuracy_->setTerrain(terrain_);
    forecast_->setCity(std::move(city));
    askForecast();
    showRefusal();
}

void StudyDock::setElementFinder(ElementFinder find) { find_ = std::move(find); }
void StudyDock::setCityFinder(CityFinder find) { findCities_ = std::move(find); }

void StudyDock::setComparing(bool comparing) {
    if (comparing == comparing_) return;
    comparing_ = comparing;
    places_->setComparing(comparing);
    StudyKind kind = what_->kind();
    if (kind == StudyKind::shadow || kind == StudyKind::change)
        kind = comparing ? StudyKind::change : StudyKind::shadow;
    what_->show(kind, document_.settings().receivers.places, document_.elements());
    askForecast();
    showRefusal();
    showKind();
}

void StudyDock::showDocument() {
    changedSinceRun_ = true;
    const StudySettings& settings = document_.settings();
    what_->show(what_->kind(), settings.receivers.places, document_.elements());
    when_->show(settings.period);
    where_->show(settings);
    breakdown_->show(settings);
    accuracy_->show(settings);
    places_->setYear(settings.period.start.year());
    askForecast();
    showRefusal();
    showKind();
}

// What is wrong with the settings of places is shown in their form.
void StudyDock::askForecast() {
    if (what_->kind() != StudyKind::places)
        return forecast_->setSettings(document_.settings(), measuredElements());
    auto settings = places_->settings();
    if (!settings || !findCities_) return;
    settings->study = document_.settings();
    forecast_->setPlaces({findCities_(places_->allScenarios()), places_->chosen(), *std::move(settings)});
}

// Comparisons and places are of cells.
std::optional<ElementSettings> StudyDock::measuredElements() const {
    if (comparing_ || what_->kind() == StudyKind::places || !document_.elements()) return std::nullopt;
    return find_ ? find_(*document_.elements()) : *document_.elements();
}

// Shown at once, not only on Run.
void StudyDock::showRefusal() {
    const QString words = measuredElements() ? whyNotPoints() : whyNotCells();
    refusal_->setVisible(!words.isEmpty());
    refusal_->setText(words);
    showForecast();
}

QString StudyDock::whyNotCells() const {
    const StudySettings& settings = document_.settings();
    const bool roofs =
        what_->kind() != StudyKind::places && settings.receivers.places != ReceiverPlaces::ground;
    if (!comparing_ && settings.byMonth && !whyNoMonths(settings).isEmpty()) return whyNoMonths(settings);
    if (!comparing_ && settings.contributions && !whyNoContributions(settings).isEmpty())
        return whyNoContributions(settings);
    if (!(roofs || terrain_) || !takesLevelGroundOnly(settings.engine)) return {};
    return tr("This method works on level ground only, but %1. Choose Quick or Reference.")
        .arg(roofs ? tr("roofs are to be measured") : tr("this city has terrain"));
}

QString StudyDock::whyNotPoints() const {
    const StudySettings& settings = document_.settings();
    if (measuresPoints(settings)) return {};
    return tr("This method measures no facades, windows or planes. Choose Quick or Reference.");
}

// Without a region or a place there is nothing to estimate.
bool StudyDock::hasQuestion() const {
    return what_->kind() == StudyKind::places ? places_->settings() && !places_->chosen().empty()
                                              : !document_.settings().region.polygons.empty();
}

void StudyDock::showForecast() {
    const auto& estimate = forecast_->estimate();
    const QString words = estimate ? describe(*estimate) : forecast_->refusal();
    // It keeps its place while it is computed anew, so that nothing moves below the mouse.
    forecastLine_->setText(words.isEmpty() && hasQuestion() ? tr("The time that it takes is being estimated")
                                                            : words);
    forecastLine_->setVisible(refusal_->isHidden() && hasCity_);
    if (what_->kind() == StudyKind::places) showKind();
}

void StudyDock::showKind() {
    const bool ofPlaces = what_->kind() == StudyKind::places;
    breakdown_->setOfCells(what_->kind() == StudyKind::shadow && !document_.elements());
    where_->setVisible(!ofPlaces);
    places_->setVisible(ofPlaces);
    run_->setText(runText());
    const bool isAsked = running_ && !changedSinceRun_;
    const bool canRun = !ofPlaces || (hasQuestion() && forecast_->refusal().isEmpty());
    run_->setEnabled(!isAsked && canRun);
}

QString StudyDock::runText() const {
    const StudyKind kind = what_->kind();
    if (kind == StudyKind::score) return tr("Compute score");
    if (kind == StudyKind::review) return tr("Choose a rule");
    if (running_) return tr("Run again");
    if (kind == StudyKind::change) return tr("Compare");
    if (kind == StudyKind::shadow) return tr("Run study");
    const auto& estimate = forecast_->estimate();
    return estimate ? tr("Run (%1)").arg(describeAbout(estimate->seconds)) : tr("Run");
}

void StudyDock::setRunning(bool running) {
    running_ = running;
    changedSinceRun_ = false;
    showKind();
}

}  // namespace noonmark
