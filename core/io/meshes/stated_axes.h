#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/vec3.hpp>
#include <map>
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

/// The unit of length of an IFC's project, found from its statements, which may come in any order.
class IfcLengthUnit {
public:
    /// `id`: "#6"; `body`: "IFCSIUNIT(...)", without blanks; `words`: its arguments.
    void take(const std::string& id, std::string_view body, const std::vector<std::string>& words);
    /// 1 if the project states none.
    [[nodiscard]] double metres() const;
    /// Whether it is a unit such as the foot, which the mesh library does not convert to metres.
    [[nodiscard]] bool isConversion() const;

private:
    struct Measure {
        double value;
        std::string unit;
    };
    [[nodiscard]] std::optional<double> conversionM(const std::string& id) const;

    std::map<std::string, double> siM_;
    std::map<std::string, std::string> conversions_;  // their measures
    std::map<std::string, Measure> measures_;
    std::vector<std::string> assigned_;
};

/// What a CAD or BIM file states about its coordinates; OBJ, PLY, STL and glTF state nothing that is
/// reliable.
struct StatedAxes {
    bool yUp = false;                     ///< as the reader process returns them
    std::optional<double> metresPerUnit;  ///< nothing: the file states no unit
    std::string unit;                     ///< "millimetres ($INSUNITS 4)", for messages; empty with no unit
};

/// Nothing for other formats. IFC (ISO-10303-21 with an IFC schema) and COLLADA: the mesh library turns them
/// to y up and converts their unit to metres, but for feet and the like of an IFC. DXF: z up, in the unit of
/// the header's $INSUNITS. Reads the header, of an IFC as far as its units.
std::optional<StatedAxes> findStatedAxes(const std::filesystem::path& file);

/// Whether the beginning of a file is that of an IFC, or of a DXF in text or binary form.
bool beginsIfc(std::string_view head);
bool beginsDxf(std::string_view head);

/// What the points of a PLY are counted from, as programs write it into a comment of the header, for which
/// the format has no field: "comment offset 390000 5819000 30". Nothing where no comment states three such
/// numbers, or they are less than 1,000. Backend: ply_offset.cpp.
std::optional<glm::dvec3> readPlyOffset(const std::filesystem::path& file);

}  // namespace noonmark
