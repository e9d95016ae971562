#include "app/gui/docks/weights/weight_bar.h"

#include <QPainter>

#include "app/report/maps/palette.h"

namespace noonmark {

void WeightBar::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QStyledItemDelegate::paint(painter, option, index);
    const double weight = index.data(Qt::UserRole).toDouble();
    const QRectF cell = QRectF(option.rect).adjusted(3, 0, -3, -2);
    const double half = cell.width() / 2 * std::abs(weight);
    const double left = weight < 0 ? cell.center().x() - half : cell.center().x();
    painter->fillRect(QRectF(left, cell.bottom() - 4, half, 4), impactColour(-weight));
}

}  // namespace noonmark
