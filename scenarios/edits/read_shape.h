#pragma once

#include <filesystem>
#include <stop_token>
#include <string>

#include "core/io/read_city.h"
#include "scenarios/edits/edit.h"

namespace noonmark {

/// A mesh file (OBJ, PLY, glTF) or CityJSON as one new building with id and name `id`, to be placed by the
/// user. A mesh comes in its own metres, its origin at local (0, 0), its heights from its own zero; CityJSON
/// at its place in `frame`, its lowest point at z = 0. `settings`: axes, unit, north, CRS. Error: the file
/// cannot be read, or holds no solid. Warnings are added to `warnings`.
Result<ImportMesh> readShape(const std::filesystem::path& file, const std::string& id,
                             const ReadSettings& settings, const Frame& frame, Warnings& warnings,
                             Progress& progress, std::stop_token stop);

}  // namespace noonmark
