#pragma once

#include <filesystem>
#include <string>

namespace noonmark {

/// The text of an IFC4 file as the mesh library reads it, which knows IFC 2x3 only; empty for a file of that
/// edition, and beyond 20 million faces. Faceted sets of IFC4 become faceted breps, indexed curves become
/// polylines (arcs as two chords), and what IFC4 leaves out though 2x3 asks for it (histories of owners,
/// kinds of composition) is filled in. Reads the file twice, and holds its lists of points.
std::string ifcAs2x3(const std::filesystem::path& file);

}  // namespace noonmark
