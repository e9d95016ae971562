#include "app/gui/tools/massing/setback_table.h"

#include <QDoubleSpinBox>
#include <QPushButton>
#include <QTableWidget>
#include <array>

#include "app/gui/base/looks/height_reference.h"
#include "app/gui/base/widgets/length_field.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/push_button.h"
#include "app/gui/tools/massing/wall_field.h"

namespace noonmark {

namespace {

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
    : FieldTable(
          4, pushButton(tr("Add setback"), "addSetback", tr("Adds a setback above the others")),
          pushButton(tr("Remove"), "removeSetback", tr("Removes the selected setback, or the last one")),
          parent) {
    showHeader(table());
    table().setToolTip(
        tr("Above each height the walls are set back by the inset, from bottom to top; taper and twist are "
           "those of the volume above it"));
}

std::vector<Setback> SetbackTable::setbacks() const {
    std::vector<Setback> setbacks;
    for (int row = 0; row < table().rowCount(); ++row)
        setbacks.push_back({.aboveM = valueAt(table(), row, aboveColumn),
                            .insetM = valueAt(table(), row, insetColumn),
                            .walls = {.taper = valueAt(table(), row, taperColumn) / 100,
                                      .twistDeg = valueAt(table(), row, twistColumn)}});
    return setbacks;
}

QWidget* SetbackTable::fieldOf(MassingNumber number, std::size_t setback) const {
    switch (number) {
        case MassingNumber::setbackAbove:
            return table().cellWidget(int(setback), aboveColumn);
        case MassingNumber::setbackInset:
            return table().cellWidget(int(setback), insetColumn);
        case MassingNumber::setbackTaper:
            return table().cellWidget(int(setback), taperColumn);
        case MassingNumber::setbackTwist:
            return table().cellWidget(int(setback), twistColumn);
        default:
            return nullptr;
    }
}

// An unchanged table is not rebuilt, so that the field the user is in stays.
void SetbackTable::show(const std::vector<Setback>& setbacks) {
    if (setbacks == this->setbacks()) return;
    removeRows();
    for (const Setback& setback : setbacks) add(setback);
}

void SetbackTable::setZero(double zeroM) {
    zeroM_ = zeroM;
    showHeader(table());
    for (int row = 0; row < table().rowCount(); ++row)
        static_cast<LengthField*>(table().cellWidget(row, aboveColumn))->setZero(zeroM);
}

void SetbackTable::add(const Setback& setback) {
    auto* from = lengthField(0.1, 2000, 1, 3.5);
    from->setZero(zeroM_);
    from->setToolTip(tr("Height from which the walls are set back"));
    auto* depth = lengthField(0.1, 500, 1, 0.5);
    depth->setToolTip(tr("How far every wall is set back, from the top of the volume below"));
    const std::array<QDoubleSpinBox*, 4> fields{from, depth, taperField(), twistField()};
    const std::array<double, 4> values{setback.aboveM, setback.insetM, setback.walls.taper * 100,
                                       setback.walls.twistDeg};
    for (std::size_t column = 0; column < fields.size(); ++column) {
        fields[column]->setValue(values[column]);
        connect(fields[column], &QDoubleSpinBox::valueChanged, this, &SetbackTable::edited);
    }
    addRow({fields[0], fields[1], fields[2], fields[3]});
}

}  // namespace noonmark
