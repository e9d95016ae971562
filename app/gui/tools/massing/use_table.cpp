#include "app/gui/tools/massing/use_table.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>

#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/push_button.h"

namespace noonmark {

namespace {

constexpr int longestUse = 30;  // letters: the project file takes 60 bytes

}  // namespace

UseTable::UseTable(QWidget* parent)
    : FieldTable(2, pushButton(tr("Add use"), "addUse", tr("Adds a use for the storeys above the others")),
                 pushButton(tr("Remove"), "removeUse", tr("Removes the selected use, or the last one")),
                 parent) {
    table().setObjectName(QStringLiteral("uses"));
    table().setHorizontalHeaderLabels({tr("Use"), tr("Storeys")});
    table().setToolTip(
        tr("What the storeys are used for, from the ground floor up: retail 2, offices 10, homes the rest"));
    connect(this, &UseTable::addRequested, this, &UseTable::addNext);
}

QStringList UseTable::defaultUses() const {
    return {tr("Retail"),    tr("Offices"), tr("Homes"), tr("Hotel"),
            tr("Community"), tr("Parking"), tr("Plant")};
}

std::vector<FloorUse> UseTable::uses() const {
    std::vector<FloorUse> uses;
    for (int row = 0; row < table().rowCount(); ++row) {
        const auto* use = static_cast<const QComboBox*>(table().cellWidget(row, 0));
        const auto* storeys = static_cast<const QSpinBox*>(table().cellWidget(row, 1));
        uses.push_back({use->currentText().trimmed().toStdString(), storeys->value()});
    }
    return uses;
}

// An unchanged table is not rebuilt, so that the field the user is in stays.
void UseTable::show(const std::vector<FloorUse>& uses) {
    if (uses == this->uses()) return;
    removeRows();
    for (const FloorUse& use : uses) add(use);
}

void UseTable::add(const FloorUse& use) {
    auto* name = new QComboBox;
    name->setEditable(true);
    name->setInsertPolicy(QComboBox::NoInsert);
    name->addItems(defaultUses());
    name->setCurrentText(QString::fromStdString(use.use));
    name->lineEdit()->setMaxLength(longestUse);
    name->setToolTip(tr("A use of the list, or any other text"));
    auto* storeys = wholeField(0, 500, {});
    storeys->setSpecialValueText(tr("the rest"));
    storeys->setValue(use.storeys);
    storeys->setToolTip(tr("How many storeys; 0: all storeys above, for the last use"));
    addRow({name, storeys});
    connect(name, &QComboBox::activated, this, &UseTable::edited);
    connect(name->lineEdit(), &QLineEdit::editingFinished, this, &UseTable::edited);
    connect(storeys, &QSpinBox::valueChanged, this, &UseTable::edited);
}

// The last use took all storeys above; now it must have a number.
void UseTable::addNext() {
    std::vector<FloorUse> now = uses();
    if (!now.empty() && now.back().storeys == 0) now.back().storeys = 1;
    const QStringList usual = defaultUses();
    now.push_back({usual[int(now.size()) % usual.size()].toStdString(), 0});
    show(now);
    Q_EMIT edited();
}

}  // namespace noonmark
