#pragma once

#include <QString>
#include <string>

#include "core/receivers/place.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// "park", "school grounds", ...: the kind of a place in the window.
QString describeKind(PlaceKind kind);

/// "Parks", "Streets", ...: as a heading.
QString describeKinds(PlaceKind kind);

/// A name of a place as people read it: what reading made of it ("Rue Grimaldi, sidewalks", "park (OSM way
/// 12)") in the language of the window, other names as they are.
QString placeName(const std::string& name);

/// Describes a region: name, size in metres, area, and the approximate number of cells in its bounding box.
QString describeRegion(const Region& region, double cellM);

}  // namespace noonmark
