#include "app/window/study/study_dock.h"

#include <QComboBox>
#include <QCompleter>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "app/input/all_engines.h"
#include "app/window/study/region_words.h"
#include "app/window/study/study_document.h"
#include "app/window/widgets/accuracy_form.h"
#include "app/window/widgets/period_form.h"
#include "app/window/widgets/progress_strip.h"
#include "core/receivers/roof_receivers.h"

namespace noonmark {

namespace {

QGroupBox* groupOf(const QString& title, QWidget* content) {
    auto* group = new QGroupBox(title);
    (new QVBoxLayout(group))->addWidget(content);
    return group;
}

}  // namespace

StudyDock::StudyDock(StudyDocument& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      period_(new PeriodForm),
      accuracy_(new AccuracyForm(allEngines())),
      refusal_(new QLabel),
      progress_(new ProgressStrip(QBoxLayout::TopToBottom)) {
    refusal_->setObjectName(QStringLiteral("engineRefusal"));
    refusal_->setWordWrap(true);
    refusal_->setStyleSheet(QStringLiteral("color: #a02410;"));
    run_ = new QPushButton(tr("Run study"));
    run_->setObjectName(QStringLiteral("run"));
    run_->setToolTip(tr("Compute the minutes of shadow in every cell of the region (Ctrl+R)"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(groupOf(tr("Period"), period_));
    column->addWidget(makeRegionGroup());
    column->addWidget(groupOf(tr("Accuracy"), accuracy_));
    column->addWidget(refusal_);
    column->addWidget(run_);
    column->addWidget(progress_);
    column->addStretch(1);
    connect(run_, &QPushButton::clicked, this, &StudyDock::runRequested);
    connect(&document_, &StudyDocument::changed, this, &StudyDock::showDocument);
    connect(period_, &PeriodForm::edited, this, [this](const QString& field) {
        StudySettings settings = document_.settings();
        settings.period = period_->period();
        document_.change(settings, field);
    });
    connect(accuracy_, &AccuracyForm::edited, this, [this](const QString& field) {
        document_.change(accuracy_->applied(document_.settings()), field);
    });
    showDocument();
}

QWidget* StudyDock::makeRegionGroup() {
    region_ = new QLabel;
    region_->setWordWrap(true);
    draw_ = new QPushButton(tr("Draw"));
    draw_->setObjectName(QStringLiteral("draw"));
    draw_->setCheckable(true);
    draw_->setToolTip(
        tr("Click the corners of a polygon on the ground.\nDouble click, Enter or right click finishes, "
           "Backspace removes the last corner, Esc cancels."));
    auto* view = new QPushButton(tr("View"));
    view->setToolTip(tr("The ground visible in the view"));
    auto* whole = new QPushButton(tr("City"));
    whole->setToolTip(tr("The bounding box of all buildings"));
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {draw_, view, whole}) buttons->addWidget(button);
    auto* group = new QGroupBox(tr("Region"));
    auto* column = new QVBoxLayout(group);
    column->addWidget(makeRegionList());
    column->addWidget(region_);
    column->addLayout(buttons);
    column->addWidget(makePlaces());
    connect(draw_, &QPushButton::toggled, this, &StudyDock::drawRequested);
    connect(view, &QPushButton::clicked, this, &StudyDock::viewRegionRequested);
    connect(whole, &QPushButton::clicked, this, &StudyDock::wholeCityRequested);
    return group;
}

// Editable, so that one of hundreds of places is found by a part of its name.
QWidget* StudyDock::makeRegionList() {
    regions_ = new QComboBox;
    regions_->setObjectName(QStringLiteral("regionList"));
    regions_->setEditable(true);
    regions_->setInsertPolicy(QComboBox::NoInsert);
    regions_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    regions_->setMinimumContentsLength(8);
    regions_->completer()->setFilterMode(Qt::MatchContains);
    regions_->completer()->setCompletionMode(QCompleter::PopupCompletion);
    regions_->lineEdit()->setPlaceholderText(tr("Region or place by name"));
    regions_->setToolTip(tr("A region or a place of the project. Type a part of its name."));
    const auto name = [this] {
        if (!regions_->currentText().isEmpty()) Q_EMIT regionNamed(regions_->currentText());
    };
    connect(regions_, &QComboBox::activated, this, name);
    connect(regions_->lineEdit(), &QLineEdit::returnPressed, this, name);
    return regions_;
}

void StudyDock::setRegions(const QStringList& names) {
    QStringList before;
    for (int i = 0; i < regions_->count(); ++i) before << regions_->itemText(i);
    if (before != names) {
        const QSignalBlocker block(regions_);
        regions_->clear();
        regions_->addItems(names);
    }
    showRegionName();
}

void StudyDock::showRegionName() {
    const QSignalBlocker block(regions_);
    const int found = regions_->findText(QString::fromStdString(document_.settings().region.name));
    regions_->setCurrentIndex(found);
    if (found < 0) regions_->clearEditText();
}

QWidget* StudyDock::makePlaces() {
    places_ = new QComboBox;
    places_->setObjectName(QStringLiteral("places"));
    places_->setToolTip(
        tr("Where shadow is measured.\nRoofs: with the horizon sweep, the ray reference or the automatic "
           "engine;\ncomparisons and scores are for the ground only."));
    for (const ReceiverPlaces places : allReceiverPlaces) {
        const std::string_view words = describe(places);
        places_->addItem(tr("On %1").arg(QString::fromUtf8(words.data(), qsizetype(words.size()))));
    }
    connect(places_, &QComboBox::activated, this, [this](int chosen) {
        StudySettings settings = document_.settings();
        settings.receivers.places = allReceiverPlaces[std::size_t(chosen)];
        document_.change(settings, tr("receivers"));
    });
    return places_;
}

void StudyDock::showDocument() {
    const StudySettings& settings = document_.settings();
    period_->show(settings.period);
    accuracy_->show(settings);
    places_->setCurrentIndex(
        int(std::ranges::find(allReceiverPlaces, settings.receivers.places) - allReceiverPlaces.begin()));
    showRegionName();
    region_->setText(describeRegion(settings.region, settings.receivers.cellM));
    showRefusal();
}

void StudyDock::setTerrain(bool terrain) {
    terrain_ = terrain;
    showRefusal();
}

// Shown at once, not only on Run.
void StudyDock::showRefusal() {
    const StudySettings& settings = document_.settings();
    const bool roofs = settings.receivers.places != ReceiverPlaces::ground;
    const bool refused = (roofs || terrain_) && takesLevelGroundOnly(settings.engine);
    refusal_->setVisible(refused);
    refusal_->setText(tr("This engine supports level ground only, but %1. Choose the horizon sweep, the ray "
                         "reference or automatic.")
                          .arg(roofs ? tr("receivers on roofs are selected") : tr("this city has terrain")));
}

void StudyDock::setDrawing(bool drawing) {
    const QSignalBlocker block(draw_);
    draw_->setChecked(drawing);
}

void StudyDock::setRunning(bool running) { run_->setText(running ? tr("Run again") : tr("Run study")); }

}  // namespace noonmark
