#include "app/gui/docks/review/review_form.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/docks/review/glazing/glazing_panel.h"
#include "app/gui/docks/review/glazing/glazing_session.h"
#include "app/gui/docks/review/place_list.h"
#include "app/gui/docks/review/rule_form.h"
#include "app/gui/session/project/project_changes.h"
#include "app/gui/session/project/project_session.h"
#include "core/review/places/place_review.h"

namespace noonmark {

namespace {

constexpr int estimateDelayMs = 600;
constexpr int formWidth = 250;

}  // namespace

ReviewForm::ReviewForm(ReviewSession& review, GlazingSession& windows, ProjectSession& project,
                       QWidget* parent)
    : QWidget(parent),
      review_(review),
      windows_(windows),
      project_(project),
      form_(new RuleForm(review.library())),
      subjects_(new QStackedWidget),
      places_(new PlaceList),
      glazingForm_(new GlazingForm),
      run_(pushButton(tr("Run review"), "runReview",
                      tr("Evaluate the rule on the ticked places, or on the windows"))),
      estimate_(new QLabel),
      progress_(new ProgressStrip(QBoxLayout::TopToBottom)),
      estimateSoon_(new QTimer(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 2, 4, 2);
    column->addWidget(makeChoices(), 1);
    column->addWidget(makeFoot());
    estimateSoon_->setSingleShot(true);
    estimateSoon_->setInterval(estimateDelayMs);
    connect(estimateSoon_, &QTimer::timeout, this,
            [this] { windows_.applies() ? windows_.estimate() : review_.estimate(); });
    connectSessions();
    connectChoices();
}

QWidget* ReviewForm::makeChoices() {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(2, 2, 2, 2);
    column->addWidget(form_);
    for (QWidget* subject : {static_cast<QWidget*>(places_), static_cast<QWidget*>(glazingForm_)})
        subjects_->addWidget(subject);
    column->addWidget(subjects_, 1);
    // It scrolls where the window is low: a rule about windows asks for more than a small screen holds.
    auto* scroll = new QScrollArea;
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(std::max(formWidth, content->minimumSizeHint().width()) +
                            scroll->verticalScrollBar()->sizeHint().width());
    return scroll;
}

QWidget* ReviewForm::makeFoot() {
    estimate_->setObjectName(QStringLiteral("reviewEstimate"));
    estimate_->setWordWrap(true);
    // It must not widen the panel while a review runs.
    progress_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(2, 2, 2, 2);
    // The button stays where it is pressed when progress appears.
    for (QWidget* part :
         {static_cast<QWidget*>(estimate_), static_cast<QWidget*>(progress_), static_cast<QWidget*>(run_)})
        column->addWidget(part);
    return content;
}

void ReviewForm::connectSessions() {
    connect(&review_, &ReviewSession::changed, this, &ReviewForm::showChoice);
    connect(&review_, &ReviewSession::estimated, this,
            [this](const QString& words) { showEstimate(words, false); });
    connect(&windows_, &GlazingSession::estimated, this,
            [this](const QString& words) { showEstimate(words, true); });
    connect(run_, &QPushButton::clicked, this,
            [this] { windows_.applies() ? windows_.run() : review_.run(); });
    for (JobSlot* running : {&review_.running(), &windows_.running()}) progress_->follow(*running);
}

void ReviewForm::connectChoices() {
    connect(form_, &RuleForm::edited, &review_, &ReviewSession::choose);
    connect(glazingForm_, &GlazingForm::edited, this, [this](const ElementSettings& windows) {
        ReviewChoice choice = review_.choice();
        choice.windows = windows;
        review_.choose(choice);
    });
    connect(places_, &PlaceList::screenRequested, &review_, &ReviewSession::screen);
    connect(places_, &PlaceList::highlighted, this, &ReviewForm::placePointedAt);
    connect(places_, &PlaceList::drawRequested, this, &ReviewForm::drawPlaceRequested);
    connect(places_, &PlaceList::renamed, this, &ReviewForm::rename);
    connect(places_, &PlaceList::chosen, this, [this](bool all, const std::vector<std::string>& names) {
        ReviewChoice choice = review_.choice();
        choice.reviewed = all ? ReviewedPlaces::all : ReviewedPlaces::chosen;
        choice.places = names;
        review_.choose(choice);
    });
}

void ReviewForm::takeDrawn(const std::string& place) {
    ReviewChoice choice = review_.choice();
    if (choice.reviewed == ReviewedPlaces::chosen) choice.places.push_back(place);
    review_.choose(choice);
    places_->editName(place);
}

// A name that is taken, or empty, is not adopted: the list shows the old one again.
void ReviewForm::rename(const std::string& from, const std::string& to) {
    if (!to.empty()) project_.rename(ProjectPart::place, from, to);
    showChoice();
}

namespace {

// Of a rule about parcels or windows none.
std::vector<PlaceKind> listDrawnKinds(const Result<Rule>& rule) {
    std::vector<PlaceKind> kinds;
    if (!rule || rule->receivers.hasLines()) return kinds;
    std::ranges::copy_if(placeKinds, std::back_inserter(kinds),
                         [&](PlaceKind kind) { return covers(*rule, kind); });
    return kinds;
}

}  // namespace

void ReviewForm::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showChoice();
}

void ReviewForm::showChoice() {
    if (!isVisible()) return;
    const ReviewChoice& choice = review_.choice();
    form_->setZone(review_.zone());
    form_->show(choice, project_.project().scenarios, project_.scenario());
    places_->setKinds(listDrawnKinds(review_.rule()));
    places_->show(review_.candidates(), choice, review_.reach(), review_.mustFindReach());
    glazingForm_->show(choice.windows);
    subjects_->setCurrentIndex(windows_.applies() ? 1 : 0);
    estimate_->clear();
    estimateSoon_->start();
}

void ReviewForm::showEstimate(const QString& words, bool ofGlazing) {
    if (ofGlazing != windows_.applies()) return;
    estimate_->setText(words.isEmpty() ? QString() : tr("Expected time: %1").arg(words));
    estimate_->setVisible(!words.isEmpty());
}

void ReviewForm::setSelectedBuilding(const QString& id) { glazingForm_->setBuilding(id); }

ElementForm& ReviewForm::elements() { return glazingForm_->elements(); }

}  // namespace noonmark
