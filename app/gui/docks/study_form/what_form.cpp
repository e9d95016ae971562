#include "app/gui/docks/study_form/what_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/docks/study_form/element_form.h"
#include "app/input/all_engines.h"
#include "core/lab/lab_engines.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/contributions/contributions.h"
#include "core/study/text/breakdown_text.h"

namespace noonmark {

namespace {

using Ability = bool EngineCapabilities::*;

QCheckBox* makeBox(const QString& text, const char* name, const QString& tip) {
    auto* box = new QCheckBox(text);
    box->setObjectName(QString::fromLatin1(name));
    box->setToolTip(tip);
    return box;
}

// Without those of graphics devices: looking for a graphics device takes a moment, and its engines sum
// neither.
QString listEnginesWith(Ability ability) {
    QStringList names;
    for (const EngineEntry& engine : coreAndLabEngines())
        if (engine.info.capabilities.*ability) names << translated(engine.info.name);
    return names.join(QObject::tr(", "));
}

bool isAble(const StudySettings& settings, Ability ability) {
    const EngineEntry* engine = findEngine(enginesWith(settings.engine), settings.engine);
    return engine != nullptr && engine->info.capabilities.*ability;
}

QString define(const QString& what, std::string_view definition) {
    return what + QStringLiteral(": ") + translated(definition);
}

}  // namespace

QString whyNoMonths(const StudySettings& settings) {
    if (isAble(settings, &EngineCapabilities::sets)) return {};
    return QObject::tr("This method does not sum months. These do: %1.")
        .arg(listEnginesWith(&EngineCapabilities::sets));
}

QString whyNoContributions(const StudySettings& settings) {
    if (isAble(settings, &EngineCapabilities::attribution)) return {};
    return QObject::tr("This method does not tell buildings apart. These do: %1.")
        .arg(listEnginesWith(&EngineCapabilities::attribution));
}

BreakdownForm::BreakdownForm(QWidget* parent)
    : QWidget(parent),
      months_(makeBox(tr("Each month by itself"), "byMonth",
                      tr("Also sums the shadow of each month: bars in the panel Contributions, a table and "
                         "maps in exports"))),
      contributions_(
          makeBox(tr("Contribution of each building"), "byBuilding",
                  tr("Also finds what each building takes, for the panel Contributions and exports; "
                     "takes up to twice as long.") +
                      QLatin1Char('\n') + define(tr("Attributed shadow"), attributedDefinition()) +
                      QLatin1Char('\n') + define(tr("Sole contribution"), soleDefinition()))),
      why_(new QLabel) {
    why_->setObjectName(QStringLiteral("whyNoBreakdown"));
    why_->setWordWrap(true);
    why_->setForegroundRole(QPalette::PlaceholderText);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    for (QWidget* widget : std::initializer_list<QWidget*>{months_, contributions_, why_})
        column->addWidget(widget);
    connect(months_, &QCheckBox::toggled, this, [this](bool on) {
        settings_.byMonth = on;
        Q_EMIT edited(settings_, tr("months"));
    });
    connect(contributions_, &QCheckBox::toggled, this, [this](bool on) {
        settings_.contributions = on;
        Q_EMIT edited(settings_, tr("contributions"));
    });
    enable();
}

void BreakdownForm::show(const StudySettings& settings) {
    settings_ = settings;
    const QSignalBlocker quietMonths(months_), quietContributions(contributions_);
    months_->setChecked(settings.byMonth);
    contributions_->setChecked(settings.contributions);
    enable();
}

void BreakdownForm::setOfCells(bool ofCells) {
    ofCells_ = ofCells;
    enable();
}

// A box that is ticked can be unticked whatever the engine.
void BreakdownForm::enable() {
    setVisible(ofCells_);
    const QString noMonths = whyNoMonths(settings_), noContributions = whyNoContributions(settings_);
    months_->setEnabled(noMonths.isEmpty() || settings_.byMonth);
    contributions_->setEnabled(noContributions.isEmpty() || settings_.contributions);
    why_->setText(noMonths.isEmpty() ? noContributions : noMonths);
    why_->setVisible(!why_->text().isEmpty());
}

namespace {

constexpr double defaultPlaneM = 4;  // Japan's height in most zones

QString aboutOf(StudyKind kind) {
    switch (kind) {
        case StudyKind::shadow:
            return QObject::tr(
                "How many minutes each spot is in shadow on a mean day of the period, and the longest time "
                "without a break");
        case StudyKind::change:
            return QObject::tr(
                "Minutes of shadow that the scenario adds or takes away, against the city chosen under "
                "\"compare with\"");
        case StudyKind::score:
            return QObject::tr(
                "Shadow weighed by hour and month: wanted in summer, unwanted in winter. Choose the weights "
                "in "
                "the panel Weights");
        case StudyKind::review:
            return QObject::tr(
                "Pass or fail of parks and other places by a board's rule. Choose it in the panel Review");
        case StudyKind::places:
            return QObject::tr(
                "Hours of sun a day of each park, street and other place: over the period, by month and on "
                "stated dates, in a table beside the map");
    }
    return {};
}

}  // namespace

WhatForm::WhatForm(QWidget* parent)
    : QWidget(parent),
      kind_(new QComboBox),
      places_(new QComboBox),
      elements_(new ElementForm),
      about_(new QLabel) {
    kind_->setObjectName(QStringLiteral("studyKind"));
    places_->setObjectName(QStringLiteral("places"));
    places_->setToolTip(tr(
        "Where shadow is measured. Changes and scores are measured on the ground only.\nFacades, windows and "
        "planes are measured at points, each with its hours of sun."));
    about_->setWordWrap(true);
    about_->setForegroundRole(QPalette::PlaceholderText);
    fill();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    for (QWidget* widget : std::initializer_list<QWidget*>{kind_, places_, elements_, about_})
        column->addWidget(widget);
    connect(kind_, &QComboBox::activated, this, [this](int chosen) {
        explain();
        Q_EMIT kindChosen(StudyKind(chosen));
    });
    connect(places_, &QComboBox::activated, this, &WhatForm::choosePlaces);
    connect(elements_, &ElementForm::edited, this, &WhatForm::elementsChosen);
    explain();
}

void WhatForm::fill() {
    kind_->addItems({tr("Hours of shadow"), tr("Change by a scenario"), tr("Score of wanted shadow"),
                     tr("Review by a rule"), tr("Sun by place")});
    for (const auto& choice : receiverPlaceChoices) places_->addItem(translated(choice.label));
    for (const auto& choice : elementPlaceChoices) places_->addItem(translated(choice.label));
    for (QComboBox* list : {kind_, places_}) {
        list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        list->setMinimumContentsLength(14);
    }
}

StudyKind WhatForm::kind() const { return StudyKind(kind_->currentIndex()); }

void WhatForm::choosePlaces(int chosen) {
    const auto place = std::size_t(chosen);
    if (place < receiverPlaceChoices.size()) return Q_EMIT placesChosen(receiverPlaceChoices[place].value);
    ElementSettings elements = elements_->settings();
    elements.places = elementPlaceChoices[place - receiverPlaceChoices.size()].value;
    const bool level = elements.places == ElementPlaces::plane || elements.places == ElementPlaces::lines;
    if (level && elements.planeHeightM == 0) elements.planeHeightM = defaultPlaneM;
    Q_EMIT elementsChosen(elements, tr("receivers"));
}

void WhatForm::show(StudyKind kind, ReceiverPlaces places, const std::optional<ElementSettings>& elements) {
    const QSignalBlocker kinds(kind_), surfaces(places_);
    kind_->setCurrentIndex(int(kind));
    places_->setCurrentIndex(elements ? int(receiverPlaceChoices.size()) + int(elements->places)
                                      : int(places));
    if (elements) elements_->show(*elements);
    explain();
}

void WhatForm::setBuilding(const QString& id) { elements_->setBuilding(id); }

void WhatForm::explain() {
    about_->setText(aboutOf(kind()));
    places_->setVisible(kind() == StudyKind::shadow);
    elements_->setVisible(kind() == StudyKind::shadow &&
                          places_->currentIndex() >= int(receiverPlaceChoices.size()));
}

}  // namespace noonmark
