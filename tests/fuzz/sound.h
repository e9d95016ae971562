#pragma once

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/io/read_part.h"

namespace noonmark::tests {

/// What the headers of core/city and core/io promise of all that a reader returns: finite coordinates, rings
/// of three points, indices that are there, parts with a height. Each ends the program where it does not
/// hold.
void requireSound(const Building& building);
void requireSound(const Terrain& terrain);
void requireSound(const City& city);
void requireSound(const FilePiece& piece);
void requireSound(const std::vector<Footprint>& polygons);

/// A planner can tell what is wrong.
void requireSound(const Error& error);

/// Of a reader's piece: sound, and its buildings' bases make a terrain as in readCity().
void use(const Result<FilePiece>& piece);

}  // namespace noonmark::tests
