#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/receivers/place.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// A name as it may be shown and stored: cleanText() without blanks at both ends; what exceeds 120 characters
/// is cut off.
std::string cleanName(std::string_view text);

/// Gives every place a name of its own: an empty one becomes "park (way 123)" by kind and source, and a name
/// used before gets a number: "Community Garden (2)".
void makeNamesUnique(std::vector<Place>& places);

/// The place with this name, in any case. Error: there is none; the advice names those spelled alike, or
/// those that contain the text.
Result<Place> findPlace(const std::vector<Place>& places, std::string_view name);

Region regionOf(const Place& place);
/// The region as a place of the kind "other", with the source "region".
Place makePlace(const Region& region);

/// Square metres of its polygons.
double area(const Place& place);
Box2 bounds(const Place& place);
Box2 bounds(std::span<const Place> places);

/// Whether the data names the place; else its name was made from its kind and source ("park (OSM way 12)").
bool hasOwnName(const Place& place);

}  // namespace noonmark
