#include "app/gui/base/widgets/field_table.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace noonmark {

namespace {

constexpr int visibleRows = 3;

QTableWidget* makeTable(int columns) {
    auto* table = new QTableWidget(0, columns);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->verticalHeader()->hide();
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setFixedHeight(table->horizontalHeader()->sizeHint().height() +
                          visibleRows * table->verticalHeader()->defaultSectionSize() + 4);
    return table;
}

}  // namespace

FieldTable::FieldTable(int columns, QPushButton* add, QPushButton* remove, QWidget* parent)
    : QWidget(parent), table_(makeTable(columns)), remove_(remove) {
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(add);
    buttons->addWidget(remove);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(table_);
    column->addLayout(buttons);
    remove->setEnabled(false);
    connect(add, &QPushButton::clicked, this, &FieldTable::addRequested);
    connect(remove, &QPushButton::clicked, this, &FieldTable::removeChosen);
}

void FieldTable::addRow(std::initializer_list<QWidget*> fields) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    int column = 0;
    for (QWidget* field : fields) table_->setCellWidget(row, column++, field);
    remove_->setEnabled(true);
}

void FieldTable::removeRows() {
    table_->setRowCount(0);
    remove_->setEnabled(false);
}

void FieldTable::removeChosen() {
    const int chosen = table_->currentRow() >= 0 ? table_->currentRow() : table_->rowCount() - 1;
    table_->removeRow(chosen);
    remove_->setEnabled(table_->rowCount() > 0);
    Q_EMIT edited();
}

}  // namespace noonmark
