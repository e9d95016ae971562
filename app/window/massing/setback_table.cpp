#include "app/window/massing/setback_table.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <array>

#include "app/window/looks/height_reference.h"
#include "app/window/massing/wall_field.h"
#include "app/window/widgets/length_field.h"
#include "app/window/widgets/number_fields.h"

namespace noonmark {

namespace {

constexpr int rowsInSight = 3;
enum Column { aboveColumn, insetColumn, taperColumn, twistColumn };

void showHeader(QTableWidget& table) {
    const bool datum = heightReferenceInUse() == HeightReference::datum;
    table.setHorizontalHeaderLabels({datum ? QObject::tr("From, above datum") : QObject::tr("From height"),
                                     QObject::tr("Inset"), QObject::tr("Taper"), QObject::tr("Twist")});
}

double valueAt(const QTableWidget& table, int row, int column) {
    return static_cast<const QDoubleSpinBox*>(table.cellWidget(row, column))->value();
}

}  // namespace

SetbackTable::SetbackTable(QWidget* parent)
    : QWidget(parent), table_(new QTableWidget(0, 4)), remove_(new QPushButton(tr("Remove"))) {
    remove_->setObjectName(QStringLiteral("removeSetback"));
    showHeader(*table_);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->verticalHeader()->hide();
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setToolTip(
        tr("Above each height the walls are set back by the inset, from bottom to top; taper and twist are "
           "those "
           "of the volume above it"));
    table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                           rowsInSight * table_->verticalHeader()->defaultSectionSize() + 4);
    auto* add = new QPushButton(tr("Add setback"));
    add->setObjectName(QStringLiteral("addSetback"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(add);
    buttons->addWidget(remove_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(table_);
    column->addLayout(buttons);
    remove_->setEnabled(false);
    connect(add, &QPushButton::clicked, this, &SetbackTable::addRequested);
    connect(remove_, &QPushButton::clicked, this, &SetbackTable::removeChosen);
}

std::vector<Setback> SetbackTable::setbacks() const {
    std::vector<Setback> setbacks;
    for (int row = 0; row < table_->rowCount(); ++row)
        setbacks.push_back({.aboveM = valueAt(*table_, row, aboveColumn),
                            .insetM = valueAt(*table_, row, insetColumn),
                            .walls = {.taper = valueAt(*table_, row, taperColumn) / 100,
                                      .twistDeg = valueAt(*table_, row, twistColumn)}});
    return setbacks;
}

// An unchanged table is not rebuilt, so that the field the user is in stays.
void SetbackTable::show(const std::vector<Setback>& setbacks) {
    if (setbacks == this->setbacks()) return;
    table_->setRowCount(0);
    for (const Setback& setback : setbacks) add(setback);
    remove_->setEnabled(!setbacks.empty());
}

void SetbackTable::setZero(double zeroM) {
    zeroM_ = zeroM;
    showHeader(*table_);
    for (int row = 0; row < table_->rowCount(); ++row)
        static_cast<LengthField*>(table_->cellWidget(row, aboveColumn))->setZero(zeroM);
}

void SetbackTable::add(const Setback& setback) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    auto* from = lengthField(0.1, 2000, 1, 3.5);
    from->setZero(zeroM_);
    from->setToolTip(tr("Height from which the walls are set back"));
    auto* depth = lengthField(0.1, 500, 1, 0.5);
    depth->setToolTip(tr("How far every wall is set back, from the top of the volume below"));
    const std::array<QDoubleSpinBox*, 4> fields{from, depth, taperField(), twistField()};
    const std::array<double, 4> values{setback.aboveM, setback.insetM, setback.walls.taper * 100,
                                       setback.walls.twistDeg};
    for (int column = 0; column < int(fields.size()); ++column) {
        QDoubleSpinBox* field = fields[std::size_t(column)];
        field->setValue(values[std::size_t(column)]);
        table_->setCellWidget(row, column, field);
        connect(field, &QDoubleSpinBox::valueChanged, this, &SetbackTable::edited);
    }
}

// Removes the selected row, or the last one.
void SetbackTable::removeChosen() {
    const int chosen = table_->currentRow() >= 0 ? table_->currentRow() : table_->rowCount() - 1;
    table_->removeRow(chosen);
    remove_->setEnabled(table_->rowCount() > 0);
    Q_EMIT edited();
}

}  // namespace noonmark
