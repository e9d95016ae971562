#pragma once

#include <QStyledItemDelegate>

namespace noonmark {

/// Draws a weight as a number with a bar: from the middle to the right if shade is wanted, to the left if
/// shadow is unwanted. Reads the weight, -1 to 1, from Qt::UserRole.
class WeightBar final : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

}  // namespace noonmark
