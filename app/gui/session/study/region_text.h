#pragma once

#include <QString>

#include "core/receivers/place.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// "park", "school grounds", ...: the kind of a place in the window.
QString describeKind(PlaceKind kind);

/// "Parks", "Streets", ...: as a heading.
QString describeKinds(PlaceKind kind);

/// Describes a region: name, size in metres, area, and the approximate number of cells in its bounding box.
QString describeRegion(const Region& region, double cellM);

}  // namespace noonmark
