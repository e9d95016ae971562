#pragma once

#include <QString>

#include "core/receivers/region.h"

namespace noonmark {

/// "12,345 m²", "67.8 ha" from ten hectares on.
QString areaWords(double areaM2);

/// A region in words: name, size in metres, area, and about how many cells its box has.
QString regionWords(const Region& region, double cellM);

}  // namespace noonmark
