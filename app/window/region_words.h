#pragma once

#include <QString>

#include "core/receivers/region.h"

namespace noonmark {

/// A region in words: name, size in metres, area, and about how many cells its box has.
QString regionWords(const Region& region, double cellM);

}  // namespace noonmark
