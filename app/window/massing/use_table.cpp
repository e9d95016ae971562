#include "app/window/massing/use_table.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/window/widgets/number_fields.h"

namespace noonmark {

namespace {

constexpr int usesInSight = 3;
constexpr int longestUse = 30;  // letters: the project file takes 60 bytes

}  // namespace

UseTable::UseTable(QWidget* parent)
    : QWidget(parent), table_(new QTableWidget(0, 2)), remove_(new QPushButton(tr("Remove"))) {
    table_->setObjectName(QStringLiteral("uses"));
    table_->setHorizontalHeaderLabels({tr("Use"), tr("Storeys")});
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->verticalHeader()->hide();
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setToolTip(
        tr("What the storeys are used for, from the ground floor up: retail 2, offices 10, homes the rest"));
    table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                           usesInSight * table_->verticalHeader()->defaultSectionSize() + 4);
    auto* add = new QPushButton(tr("Add use"));
    add->setObjectName(QStringLiteral("addUse"));
    add->setToolTip(tr("Adds a use for the storeys above the others"));
    remove_->setObjectName(QStringLiteral("removeUse"));
    remove_->setToolTip(tr("Removes the selected use, or the last one"));
    remove_->setEnabled(false);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(add);
    buttons->addWidget(remove_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(table_);
    column->addLayout(buttons);
    connect(add, &QPushButton::clicked, this, &UseTable::addNext);
    connect(remove_, &QPushButton::clicked, this, &UseTable::removeChosen);
}

QStringList UseTable::usualUses() const {
    return {tr("Retail"),    tr("Offices"), tr("Homes"), tr("Hotel"),
            tr("Community"), tr("Parking"), tr("Plant")};
}

std::vector<FloorUse> UseTable::uses() const {
    std::vector<FloorUse> uses;
    for (int row = 0; row < table_->rowCount(); ++row) {
        const auto* use = static_cast<const QComboBox*>(table_->cellWidget(row, 0));
        const auto* storeys = static_cast<const QSpinBox*>(table_->cellWidget(row, 1));
        uses.push_back({use->currentText().trimmed().toStdString(), storeys->value()});
    }
    return uses;
}

// An unchanged table is not rebuilt, so that the field the user is in stays.
void UseTable::show(const std::vector<FloorUse>& uses) {
    if (uses == this->uses()) return;
    table_->setRowCount(0);
    for (const FloorUse& use : uses) add(use);
    remove_->setEnabled(!uses.empty());
}

void UseTable::add(const FloorUse& use) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    auto* name = new QComboBox;
    name->setEditable(true);
    name->setInsertPolicy(QComboBox::NoInsert);
    name->addItems(usualUses());
    name->setCurrentText(QString::fromStdString(use.use));
    name->lineEdit()->setMaxLength(longestUse);
    name->setToolTip(tr("A use of the list, or any other text"));
    auto* storeys = wholeField(0, 500, {});
    storeys->setSpecialValueText(tr("the rest"));
    storeys->setValue(use.storeys);
    storeys->setToolTip(tr("How many storeys; 0: all storeys above, for the last use"));
    table_->setCellWidget(row, 0, name);
    table_->setCellWidget(row, 1, storeys);
    connect(name, &QComboBox::activated, this, &UseTable::edited);
    connect(name->lineEdit(), &QLineEdit::editingFinished, this, &UseTable::edited);
    connect(storeys, &QSpinBox::valueChanged, this, &UseTable::edited);
}

// The last use took all storeys above; now it must have a number.
void UseTable::addNext() {
    std::vector<FloorUse> now = uses();
    if (!now.empty() && now.back().storeys == 0) now.back().storeys = 1;
    const QStringList usual = usualUses();
    now.push_back({usual[int(now.size()) % usual.size()].toStdString(), 0});
    show(now);
    Q_EMIT edited();
}

void UseTable::removeChosen() {
    const int chosen = table_->currentRow() >= 0 ? table_->currentRow() : table_->rowCount() - 1;
    table_->removeRow(chosen);
    remove_->setEnabled(table_->rowCount() > 0);
    Q_EMIT edited();
}

}  // namespace noonmark
