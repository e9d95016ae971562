#include "app/gui/docks/study_form/what_form.h"

#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/base/widgets/translated.h"
#include "app/gui/docks/study_form/element_form.h"
#include "core/receivers/roof_receivers.h"

namespace noonmark {

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
