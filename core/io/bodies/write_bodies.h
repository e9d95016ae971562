#pragma once

#include <filesystem>

#include "core/io/bodies/bodies.h"

namespace noonmark {

/// Creates a DXF (R12, ASCII, metres) with a 3DFACE for each triangle, on the layers `buildings` and
/// `buildings_proposed`, and the plane as a comment at its head. Error: the file cannot be written. Backend:
/// write_bodies_dxflib.cpp.
Result<void> writeBodiesDxf(const std::filesystem::path& file, const BodySet& set);

}  // namespace noonmark
