#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace noonmark {

/// What a CAD or BIM file states about its coordinates; OBJ, PLY, STL and glTF state nothing that is
/// reliable.
struct StatedAxes {
    bool yUp = false;                     ///< as the reader process returns them
    std::optional<double> metresPerUnit;  ///< nothing: the file states no unit
    std::string unit;                     ///< "millimetres ($INSUNITS 4)", for messages; empty with no unit
};

/// Nothing for other formats. IFC (ISO-10303-21 with an IFC schema) and COLLADA: the mesh library converts
/// their unit to metres and turns them to y up. DXF: z up, in the unit of the header's $INSUNITS. Reads the
/// header.
std::optional<StatedAxes> findStatedAxes(const std::filesystem::path& file);

/// Whether the beginning of a file is that of an IFC, or of a DXF in text or binary form.
bool beginsIfc(std::string_view head);
bool beginsDxf(std::string_view head);

}  // namespace noonmark
