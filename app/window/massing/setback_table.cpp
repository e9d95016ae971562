#include "app/window/massing/setback_table.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/window/widgets/length_field.h"
#include "app/window/widgets/number_fields.h"

namespace noonmark {

namespace {

constexpr int rowsInSight = 3;

double valueAt(const QTableWidget& table, int row, int column) {
    return static_cast<const QDoubleSpinBox*>(table.cellWidget(row, column))->value();
}

}  // namespace

SetbackTable::SetbackTable(QWidget* parent)
    : QWidget(parent), table_(new QTableWidget(0, 2)), remove_(new QPushButton(tr("Remove"))) {
    remove_->setObjectName(QStringLiteral("removeSetback"));
    table_->setHorizontalHeaderLabels({tr("From height"), tr("Inset")});
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->verticalHeader()->hide();
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setToolTip(tr("Above each height the walls are set back by the inset, from bottom to top"));
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
        setbacks.push_back({.aboveM = valueAt(*table_, row, 0), .insetM = valueAt(*table_, row, 1)});
    return setbacks;
}

// An unchanged table is not rebuilt, so that the field the user is in stays.
void SetbackTable::show(const std::vector<Setback>& setbacks) {
    if (setbacks == this->setbacks()) return;
    table_->setRowCount(0);
    for (const Setback& setback : setbacks) add(setback);
    remove_->setEnabled(!setbacks.empty());
}

void SetbackTable::add(const Setback& setback) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    auto* above = lengthField(0.1, 2000, 1, 3.5);
    auto* inset = lengthField(0.1, 500, 1, 0.5);
    above->setValue(setback.aboveM);
    inset->setValue(setback.insetM);
    table_->setCellWidget(row, 0, above);
    table_->setCellWidget(row, 1, inset);
    for (QDoubleSpinBox* field : {above, inset})
        connect(field, &QDoubleSpinBox::valueChanged, this, &SetbackTable::edited);
}

// Removes the selected row, or the last one.
void SetbackTable::removeChosen() {
    const int chosen = table_->currentRow() >= 0 ? table_->currentRow() : table_->rowCount() - 1;
    table_->removeRow(chosen);
    remove_->setEnabled(table_->rowCount() > 0);
    Q_EMIT edited();
}

}  // namespace noonmark
