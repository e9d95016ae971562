#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

namespace noonmark {

/// Takes the next statement of an IFC text file up to its semicolon, which texts may contain too; of one
/// longer than `longest` bytes its beginning. False at the end of the file.
bool takeIfcStatement(std::streambuf& bytes, std::string& statement, std::size_t longest);

/// The arguments of "IFCSITE('a',#12,(49,6),$)": texts may contain commas and parentheses. One empty word
/// for none.
std::vector<std::string> ifcArguments(std::string_view statement);

/// Without blanks and ends of lines outside of texts.
std::string withoutIfcBlanks(std::string_view statement);

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
