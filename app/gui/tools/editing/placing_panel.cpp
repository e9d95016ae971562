#include "app/gui/tools/editing/placing_panel.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "app/gui/base/widgets/error_words.h"
#include "app/gui/base/widgets/field_rows.h"
#include "app/gui/base/widgets/height_words.h"
#include "app/gui/base/widgets/length_field.h"
#include "app/gui/base/widgets/number_fields.h"
#include "core/io/settings/read_fields.h"

namespace noonmark {

namespace {

constexpr int wordLines = 4;  // room for a long file name and the instruction

}  // namespace

PlacingPanel::PlacingPanel(QWidget* parent)
    : QWidget(parent),
      what_(new QLabel),
      warnings_(new QLabel),
      axes_(new FieldRows(meshAxesFields().rows(), this)),
      scale_(numberField(0.001, 1000, 3, 0.1, {})),
      turn_(numberField(-360, 360, 1, 5, QStringLiteral("°"))),
      storeyHeight_(lengthField(0, 10, 2, 0.1)),
      apply_(new QPushButton(tr("Build"))) {
    for (QLabel* words : {what_, warnings_}) {
        words->setWordWrap(true);
        words->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    }
    // A fixed height: the fields must not move under the cursor while the mesh is placed.
    what_->setFixedHeight(wordLines * what_->fontMetrics().lineSpacing());
    scale_->setToolTip(tr("Scale of all three axes"));
    turn_->setToolTip(tr("Clockwise, seen from above"));
    storeyHeight_->setObjectName(QStringLiteral("meshStoreyHeight"));
    storeyHeight_->setToolTip(tr("Floor to floor, 2 to 10 m, for lines at its floors; 0: not known"));
    storeyHeight_->setSpecialValueText(tr("not known"));
    apply_->setObjectName(QStringLiteral("applyMesh"));
    apply_->setToolTip(tr("Adds it to the scenario (Enter over the view)"));
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setObjectName(QStringLiteral("cancelPlacing"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(apply_);
    buttons->addWidget(cancel);
    auto* form = new QFormLayout(this);
    form->addRow(what_);
    axes_->addRows(*form, {"--up", "--mesh-unit"});
    form->addRow(tr("Scale"), scale_);
    form->addRow(tr("Rotation"), turn_);
    form->addRow(tr("Storey height"), storeyHeight_);
    form->addRow(buttons);
    form->addRow(warnings_);  // below the fields, since their number varies
    connect(axes_, &FieldRows::edited, this, &PlacingPanel::readingEdited);
    for (QDoubleSpinBox* field : {scale_, turn_, storeyHeight_})
        connect(field, &QDoubleSpinBox::valueChanged, this, &PlacingPanel::edited);
    connect(apply_, &QPushButton::clicked, this, &PlacingPanel::applied);
    connect(cancel, &QPushButton::clicked, this, &PlacingPanel::cancelled);
}

void PlacingPanel::begin(const QString& file) {
    file_ = file;
    scale_->setValue(1);
    turn_->setValue(0);
    storeyHeight_->setValue(0);
    apply_->setEnabled(false);
    what_->setText(tr("%1: click the place on the ground for its middle.").arg(file));
}

void PlacingPanel::setStated(bool axes, bool unit) {
    axes_->widget("--up")->setEnabled(!axes);
    axes_->widget("--mesh-unit")->setEnabled(!unit);
}

void PlacingPanel::showPlaced(double heightM, double groundElevationM) {
    apply_->setEnabled(true);
    what_->setText(
        tr("%1, top %2. Another click moves it.").arg(file_, describeHeight(heightM, groundElevationM)));
}

void PlacingPanel::showWarnings(const Warnings& warnings) {
    QStringList lines;
    for (const WarningGroup& group : groupWarnings(warnings)) lines << describeWarningWithPlaces(group);
    warnings_->setText(lines.mid(0, 1).join(QString()) +
                       (lines.size() > 1 ? tr(" (and %1 more)").arg(lines.size() - 1) : QString()));
    warnings_->setToolTip(lines.join(QLatin1Char('\n')));
    warnings_->setVisible(!lines.isEmpty());
}

ReadSettings PlacingPanel::reading() const {
    ReadSettings settings;
    axes_->take(meshAxesFields().of(settings));
    return settings;
}

double PlacingPanel::scale() const { return scale_->value(); }

double PlacingPanel::clockwiseDeg() const { return turn_->value(); }

// Less than 2 m is no storey.
double PlacingPanel::storeyHeightM() const {
    constexpr double minM = 2;
    return storeyHeight_->value() < minM ? 0 : storeyHeight_->value();
}

}  // namespace noonmark
