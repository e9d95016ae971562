#pragma once

#include <span>
#include <string_view>

#include "app/gui/session/answers/result_rows.h"
#include "core/describe/figure.h"

namespace noonmark {

/// The row of the figure with this key: its label, `value`, and its definition as a tooltip.
ResultRow figureRow(std::span<const Figure> figures, std::string_view key, const QString& value);

}  // namespace noonmark
