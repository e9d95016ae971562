#pragma once

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/city/map_context.h"
#include "core/io/pieces/read_part.h"

namespace noonmark::tests {

/// Check what the headers of core/city and core/io promise about all results of readers: finite coordinates,
/// rings of at least three points, indices in range, parts with a height. Each ends the program on a
/// violation.
void requireSound(const Building& building);
void requireSound(const Terrain& terrain);
void requireSound(const City& city);
void requireSound(const FilePiece& piece);
void requireSound(const std::vector<Footprint>& polygons);
void requireSound(const MapContext& context);

/// Checks that the error states what is wrong and is not a cancellation.
void requireSound(const Error& error);

/// Checks a reader's piece, and that its buildings' bases make a terrain as in readCity().
void use(const Result<FilePiece>& piece);

}  // namespace noonmark::tests
