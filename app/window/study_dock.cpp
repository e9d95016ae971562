#include "app/window/study_dock.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/window/number_fields.h"
#include "app/window/period_form.h"
#include "app/window/progress_strip.h"
#include "app/window/region_words.h"
#include "app/window/study_document.h"

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
      progress_(new ProgressStrip(QBoxLayout::TopToBottom)) {
    run_ = new QPushButton(tr("Run study"));
    run_->setObjectName(QStringLiteral("run"));
    run_->setToolTip(tr("Compute the minutes of shadow of every cell of the region (Ctrl+R)"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(groupOf(tr("Period"), period_));
    column->addWidget(makeRegionGroup());
    column->addWidget(makeCellGroup());
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
    showDocument();
}

QWidget* StudyDock::makeRegionGroup() {
    region_ = new QLabel;
    region_->setWordWrap(true);
    draw_ = new QPushButton(tr("Draw"));
    draw_->setObjectName(QStringLiteral("draw"));
    draw_->setCheckable(true);
    draw_->setToolTip(
        tr("Click the corners of a polygon on the ground.\n"
           "Double click, Enter or the right button finish it, Backspace takes a corner back, Esc cancels."));
    auto* view = new QPushButton(tr("View"));
    view->setToolTip(tr("The ground that the view shows"));
    auto* whole = new QPushButton(tr("City"));
    whole->setToolTip(tr("The box around all buildings"));
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {draw_, view, whole}) buttons->addWidget(button);
    auto* group = new QGroupBox(tr("Region"));
    auto* column = new QVBoxLayout(group);
    column->addWidget(region_);
    column->addLayout(buttons);
    connect(draw_, &QPushButton::toggled, this, &StudyDock::drawRequested);
    connect(view, &QPushButton::clicked, this, &StudyDock::viewRegionRequested);
    connect(whole, &QPushButton::clicked, this, &StudyDock::wholeCityRequested);
    return group;
}

QWidget* StudyDock::makeCellGroup() {
    cell_ = numberField(ReceiverSettings::minCellM, ReceiverSettings::maxCellM, 2, 0.25, tr(" m"));
    cell_->setObjectName(QStringLiteral("cell"));
    cell_->setToolTip(tr("Side of a cell of the ground, metres, 0.25 to 10"));
    engine_ = new QComboBox;
    engine_->setObjectName(QStringLiteral("engine"));
    for (const auto& [engine, make] : coreEngines()) {
        const auto text = [](std::string_view view) {
            return QString::fromUtf8(view.data(), qsizetype(view.size()));
        };
        engine_->addItem(text(engine.name), text(engine.key));
        engine_->setItemData(engine_->count() - 1, text(engine.about), Qt::ToolTipRole);
    }
    engine_->setToolTip(
        tr("How the shadow is computed; the ray reference is the truth that the others are held against"));
    auto* group = new QGroupBox(tr("Accuracy"));
    auto* form = new QFormLayout(group);
    form->addRow(tr("Cell size"), cell_);
    form->addRow(tr("Engine"), engine_);
    connect(cell_, &QDoubleSpinBox::valueChanged, this, [this] { changeCells(tr("cell size")); });
    connect(engine_, &QComboBox::currentIndexChanged, this, [this] { changeCells(tr("engine")); });
    return group;
}

void StudyDock::changeCells(const QString& field) {
    StudySettings settings = document_.settings();
    settings.receivers.cellM = cell_->value();
    settings.engine = engine_->currentData().toString().toStdString();
    document_.change(settings, field);
}

void StudyDock::showDocument() {
    const StudySettings& settings = document_.settings();
    const QSignalBlocker cell(cell_);
    const QSignalBlocker engine(engine_);
    period_->show(settings.period);
    cell_->setValue(settings.receivers.cellM);
    engine_->setCurrentIndex(engine_->findData(QString::fromStdString(settings.engine)));
    region_->setText(regionWords(settings.region, settings.receivers.cellM));
}

void StudyDock::setDrawing(bool drawing) {
    const QSignalBlocker block(draw_);
    draw_->setChecked(drawing);
}

void StudyDock::setRunning(bool running) { run_->setEnabled(!running); }

}  // namespace noonmark
