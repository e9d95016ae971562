#pragma once

#include <QDialog>
#include <map>
#include <vector>

#include "core/receivers/parcels/parcel_roads.h"

class QDoubleSpinBox;

namespace noonmark {

/// The roads, water and railways along the sides of a lot: a field for the width on each side, arranged as on
/// a map.
class LotRoadsDialog final : public QDialog {
    Q_OBJECT
public:
    LotRoadsDialog(const QString& lot, const std::vector<RoadFront>& roads, QWidget* parent = nullptr);

    [[nodiscard]] std::vector<RoadFront> roads() const;  ///< clockwise from north

private:
    std::map<ParcelSide, QDoubleSpinBox*> widths_;  ///< 0: no road
    std::vector<RoadFront> before_;
};

}  // namespace noonmark
