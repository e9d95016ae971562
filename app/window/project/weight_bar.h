#pragma once

#include <QStyledItemDelegate>

namespace noonmark {

/// A weight as a number with a bar under it: from the middle to the right where shade is wanted, to the left
/// where shadow is unwanted. Takes the weight, -1 to 1, from Qt::UserRole.
class WeightBar final : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

}  // namespace noonmark
