#pragma once

#include <QImage>
#include <optional>

#include "app/report/legend_painter.h"

namespace noonmark {

/// A picture to keep: the view with a foot that holds the legend, and the owner of the data.
QImage viewPicture(const QImage& view, const std::optional<Legend>& legend, const QString& credit);

}  // namespace noonmark
