#include "app/gui/tools/massing/further_table.h"

#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>

#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/push_button.h"
#include "app/gui/tools/massing/plate_field.h"
#include "scenarios/massing/massing_fields.h"

namespace noonmark {

FurtherTable::FurtherTable(QWidget* parent)
    : FieldTable(2,
                 pushButton(tr("Add tower"), "addTower",
                            tr("Another tower on the lot, apart from the others: each has a piece of it")),
                 pushButton(tr("Remove"), "removeTower", tr("Removes the selected tower, or the last one")),
                 parent) {
    table().setObjectName(QStringLiteral("furtherTowers"));
    table().setHorizontalHeaderLabels({tr("Storeys"), tr("Plate")});
    table().setToolTip(
        tr("Further towers, which the same step builds; the lot is divided across its longest side"));
}

std::vector<FurtherTower> FurtherTable::towers() const {
    std::vector<FurtherTower> towers;
    for (int row = 0; row < table().rowCount(); ++row)
        towers.push_back({static_cast<const QSpinBox*>(table().cellWidget(row, 0))->value(),
                          static_cast<const PlateField*>(table().cellWidget(row, 1))->plate()});
    return towers;
}

// An unchanged table is not rebuilt, so that the field the user is in stays.
void FurtherTable::show(const std::vector<FurtherTower>& towers) {
    if (towers == this->towers()) return;
    removeRows();
    for (const FurtherTower& tower : towers) add(tower);
}

void FurtherTable::add(const FurtherTower& tower) {
    const ValueRange range = *furtherTowerFields().rows().front().range;
    auto* storeys = wholeField(int(range.min), int(range.max), {});
    storeys->setValue(tower.storeys);
    auto* plate = new PlateField;
    plate->show(tower.plate);
    addRow({storeys, plate});
    connect(storeys, &QSpinBox::valueChanged, this, &FurtherTable::edited);
    connect(plate, &PlateField::edited, this, &FurtherTable::edited);
}

}  // namespace noonmark
