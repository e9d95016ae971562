#pragma once

#include <filesystem>
#include <stop_token>
#include <string>

#include "core/io/read_city.h"
#include "scenarios/edits/edit.h"

namespace noonmark {

/// Reads a mesh file (OBJ, PLY, glTF, IFC, DXF) or CityJSON file as one new building whose id and name are
/// `id`; the user places it. A mesh keeps its own metres, with its origin at local (0, 0) and its own zero
/// height. CityJSON gets its place in `frame`, with its lowest point at z = 0. `settings`: axes, unit, north,
/// CRS. Error: the file cannot be read or contains no solid. Warnings are appended to `warnings`.
Result<ImportMesh> readShape(const std::filesystem::path& file, const std::string& id,
                             const ReadSettings& settings, const Frame& frame, Warnings& warnings,
                             Progress& progress, std::stop_token stop);

}  // namespace noonmark
