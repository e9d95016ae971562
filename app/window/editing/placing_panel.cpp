#include "app/window/editing/placing_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "app/window/widgets/mesh_fields.h"
#include "app/window/widgets/number_fields.h"
#include "app/window/widgets/number_words.h"

namespace noonmark {

namespace {

constexpr int wordLines = 4;  // room for a long file name and the instruction

}  // namespace

PlacingPanel::PlacingPanel(QWidget* parent)
    : QWidget(parent),
      what_(new QLabel),
      warnings_(new QLabel),
      upAxis_(upAxisField()),
      unit_(meshUnitField()),
      scale_(numberField(0.001, 1000, 3, 0.1, {})),
      turn_(numberField(-360, 360, 1, 5, QStringLiteral("°"))),
      apply_(new QPushButton(tr("Build"))) {
    for (QLabel* words : {what_, warnings_}) {
        words->setWordWrap(true);
        words->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    }
    // A fixed height: the fields must not move under the cursor while the mesh is placed.
    what_->setFixedHeight(wordLines * what_->fontMetrics().lineSpacing());
    scale_->setToolTip(tr("Scale of all three axes"));
    turn_->setToolTip(tr("Clockwise, seen from above"));
    apply_->setObjectName(QStringLiteral("applyMesh"));
    apply_->setToolTip(tr("Adds it to the scenario (Enter over the view)"));
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setObjectName(QStringLiteral("cancelPlacing"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(apply_);
    buttons->addWidget(cancel);
    auto* form = new QFormLayout(this);
    form->addRow(what_);
    form->addRow(tr("Up axis"), upAxis_);
    form->addRow(tr("Unit"), unit_);
    form->addRow(tr("Scale"), scale_);
    form->addRow(tr("Rotation"), turn_);
    form->addRow(buttons);
    form->addRow(warnings_);  // below the fields, since their number varies
    for (QComboBox* field : {upAxis_, unit_})
        connect(field, &QComboBox::activated, this, &PlacingPanel::readingEdited);
    for (QDoubleSpinBox* field : {scale_, turn_})
        connect(field, &QDoubleSpinBox::valueChanged, this, &PlacingPanel::edited);
    connect(apply_, &QPushButton::clicked, this, &PlacingPanel::applied);
    connect(cancel, &QPushButton::clicked, this, &PlacingPanel::cancelled);
}

void PlacingPanel::begin(const QString& file) {
    file_ = file;
    scale_->setValue(1);
    turn_->setValue(0);
    apply_->setEnabled(false);
    what_->setText(tr("%1: click the place on the ground for its middle.").arg(file));
}

void PlacingPanel::showPlaced(double heightM) {
    apply_->setEnabled(true);
    what_->setText(tr("%1, %2 high. Another click moves it.").arg(file_, describeLength(heightM)));
}

void PlacingPanel::showWarnings(const Warnings& warnings) {
    QStringList lines;
    for (const WarningGroup& group : groupWarnings(warnings)) lines << QString::fromStdString(lineOf(group));
    warnings_->setText(lines.mid(0, 1).join(QString()) +
                       (lines.size() > 1 ? tr(" (and %1 more)").arg(lines.size() - 1) : QString()));
    warnings_->setToolTip(lines.join(QLatin1Char('\n')));
    warnings_->setVisible(!lines.isEmpty());
}

ReadSettings PlacingPanel::reading() const {
    ReadSettings settings;
    settings.upAxis = UpAxis(upAxis_->currentData().toInt());
    settings.meshUnit = LengthUnit(unit_->currentData().toInt());
    return settings;
}

double PlacingPanel::scale() const { return scale_->value(); }

double PlacingPanel::clockwiseDeg() const { return turn_->value(); }

}  // namespace noonmark
