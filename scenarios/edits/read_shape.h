#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <stop_token>
#include <string>

#include "core/io/read_city.h"
#include "scenarios/edits/edit.h"

namespace noonmark {

/// The settings that an import remembers of how its file was read, into those of its next edition.
void applyReading(const ImportMesh& import, ReadSettings& settings);

/// The edition in the place of an earlier one: under its id and name, so that the edits that follow hold.
ImportMesh asEditionOf(ImportMesh edition, const ImportMesh& earlier);

/// Reads a mesh file or CityJSON file as one new building whose id and name are
/// `id`; the user places it. A mesh keeps its own metres, with its origin at local (0, 0) and its own zero
/// height, unless it begins more than 2 m above that, or more than 20 m and more than half of it lie below:
/// then its lowest point gets to z = 0, with a warning, as that of CityJSON does, which gets its place in
/// `frame`. `settings`: axes, unit, north, CRS, and stand (terrain: the lowest point at z = 0 in any case;
/// absolute: a mesh keeps its zero). Error: the file cannot be read or contains no solid. Warnings are
/// appended to `warnings`. The import remembers the settings that the user chose of these.
Result<ImportMesh> readShape(const std::filesystem::path& file, const std::string& id,
                             const ReadSettings& settings, const Frame& frame, Warnings& warnings,
                             Progress& progress, std::stop_token stop);

/// What an IFC states of its place: nothing of other files, or where it states nothing.
struct OwnPlace {
    std::optional<double> clockwiseDeg;  ///< how its +y is turned from true north
    std::optional<glm::dvec2>
        originM{};        ///< its own origin in the frame, where that is within 20 km of the frame's
    std::string words{};  ///< where the latter is stated: "IfcSite"
};
OwnPlace findOwnPlace(const std::filesystem::path& file, const Frame& frame, const std::stop_token& stop);

}  // namespace noonmark
