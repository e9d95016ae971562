#pragma once

#include "app/report/maps/legend_painter.h"

namespace noonmark {

/// The legend, whose words app/report writes in English for sheets and files, in the language of the window.
/// Words without a translation stay as they are.
Legend translateLegend(Legend legend);
QString translateLegendWord(const QString& word);  ///< one of its titles or labels

}  // namespace noonmark
