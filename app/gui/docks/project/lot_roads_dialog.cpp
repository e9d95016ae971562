#include "app/gui/docks/project/lot_roads_dialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <algorithm>
#include <cmath>

#include "app/gui/base/widgets/length_field.h"
#include "app/gui/base/widgets/number_fields.h"

namespace noonmark {

namespace {

QString wordOf(ParcelSide side) {
    switch (side) {
        case ParcelSide::north:
            return LotRoadsDialog::tr("North");
        case ParcelSide::northeast:
            return LotRoadsDialog::tr("Northeast");
        case ParcelSide::east:
            return LotRoadsDialog::tr("East");
        case ParcelSide::southeast:
            return LotRoadsDialog::tr("Southeast");
        case ParcelSide::south:
            return LotRoadsDialog::tr("South");
        case ParcelSide::southwest:
            return LotRoadsDialog::tr("Southwest");
        case ParcelSide::west:
            return LotRoadsDialog::tr("West");
        case ParcelSide::northwest:
            return LotRoadsDialog::tr("Northwest");
    }
    return {};
}

/// Row and column around the lot, which is at 1, 1.
std::pair<int, int> cellOf(ParcelSide side) {
    constexpr std::array<std::pair<int, int>, 8> cells{
        {{0, 1}, {0, 2}, {1, 2}, {2, 2}, {2, 1}, {2, 0}, {1, 0}, {0, 0}}};
    return cells[std::size_t(side)];
}

QDoubleSpinBox* widthField(ParcelSide side, const std::vector<RoadFront>& roads) {
    QDoubleSpinBox* field = lengthField(0, maxRoadM, 2, 0.5);
    field->setObjectName(QString::fromUtf8(nameOf(side).data(), qsizetype(nameOf(side).size())));
    field->setSpecialValueText(LotRoadsDialog::tr("no road"));
    const auto road = std::ranges::find(roads, side, &RoadFront::side);
    field->setValue(road == roads.end() ? 0 : road->widthM);
    return field;
}

}  // namespace

LotRoadsDialog::LotRoadsDialog(const QString& lot, const std::vector<RoadFront>& roads, QWidget* parent)
    : QDialog(parent), before_(roads) {
    setWindowTitle(tr("Roads along %1").arg(lot));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* grid = new QGridLayout(this);
    auto* words = new QLabel(
        tr("How wide are the roads, water or railways on each side? Rules about parcels, as in Japan, move "
           "the parcel's line out along them. A side counts for the outermost edges that face within 45 "
           "degrees of it."));
    words->setWordWrap(true);
    grid->addWidget(words, 0, 0, 1, 3);
    for (const ParcelSide side : parcelSides) {
        const auto [row, column] = cellOf(side);
        widths_[side] = widthField(side, roads);
        auto* label = new QLabel(wordOf(side));
        label->setBuddy(widths_[side]);
        grid->addWidget(label, 1 + 2 * row, column, Qt::AlignCenter);
        grid->addWidget(widths_[side], 2 + 2 * row, column);
    }
    grid->addWidget(new QLabel(lot), 3, 1, 2, 1, Qt::AlignCenter);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    grid->addWidget(buttons, 7, 0, 1, 3);
}

std::vector<RoadFront> LotRoadsDialog::roads() const {
    std::vector<RoadFront> roads;
    for (const auto& [side, field] : widths_) {
        if (field->value() <= 0) continue;
        const auto before = std::ranges::find(before_, side, &RoadFront::side);
        // A field rounds to centimetres: a width that was not touched stays as it is.
        const bool same = before != before_.end() && std::abs(before->widthM - field->value()) < 0.0051;
        roads.push_back({side, same ? before->widthM : field->value()});
    }
    return roads;
}

}  // namespace noonmark
