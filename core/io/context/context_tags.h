#pragma once

// The folder core/io/context reads what maps draw for orientation (core/city/map_context.h): context_tags.h
// (this file) holds the rules of OpenStreetMap's tags, read_context.h reads files.

#include "core/city/map_context.h"
#include "core/io/places/place_tags.h"

namespace noonmark {

/// The kind of an area, a line or a point by its OpenStreetMap tags
/// (https://wiki.openstreetmap.org/wiki/Map_features); nothing for what is not drawn: buildings, car parks,
/// anything underground or proposed.
std::optional<ContextKind> classifyContextArea(const PlaceTags& tags);
std::optional<ContextKind> classifyContextLine(const PlaceTags& tags);
std::optional<ContextKind> classifyContextPoint(const PlaceTags& tags);

/// Whether a line is a coastline: the edge of the sea, which lies on its right.
bool isCoastline(const PlaceTags& tags);

/// The width to draw a line with, metres: as tagged, else the usual one of its class.
double widthOfLine(ContextKind kind, const PlaceTags& tags);

}  // namespace noonmark
