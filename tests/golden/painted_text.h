#pragma once

#include <QStringList>

class QWidget;

namespace noonmark::golden {

/// The words that the widget paints itself, without those of its children, in the order in which they are
/// painted.
QStringList paintedText(QWidget& widget);

}  // namespace noonmark::golden
