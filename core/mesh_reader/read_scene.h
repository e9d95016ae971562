#pragma once

// The folder core/mesh_reader is the program noonmark-mesh-reader, which parses one untrusted mesh file in a
// process of its own and writes the scene to its parent (core/io/meshes/mesh_reader_process.h). main.cpp runs
// the steps: own_limits.h limits the process, checkMeshFile() refuses hostile files, and readScene() (this
// file) parses with Assimp, whose access to files is in read_scene_assimp.cpp.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec3.hpp>
#include <string>

#include "core/base/result.h"
#include "core/io/meshes/mesh_scene.h"

namespace noonmark {

/// Reads a mesh file and passes on its objects one by one, with the transformations in the file's tree
/// applied. Points and lines are left out; polygons stay polygons. The polygons of mirrored objects are
/// reversed, so that they still face outward. Backend: read_scene_assimp.cpp, which supports PLY, glTF 2,
/// STL, COLLADA and IFC only. DXF: readDxf(). OBJ: readObj().
Result<void> readScene(const std::filesystem::path& file, const std::function<void(const MeshObject&)>& take);

/// Whether a file begins as a DXF, in text or binary form.
bool isDxf(const std::filesystem::path& file);

/// Reads the masses of a DXF drawing in text form: 3DFACE, SOLID, polyface and polygon meshes, and closed
/// outlines with a thickness, in the drawing and in inserted blocks. One object per layer, in the drawing's
/// unit with z up; then a note for each kind of entity that was left out. Error: the file is binary or holds
/// no mass, with what it holds instead. O(file + polygons).
Result<void> readDxf(const std::filesystem::path& file, const std::function<void(const MeshObject&)>& take);

/// Whether a file begins as an OBJ.
bool isObj(const std::filesystem::path& file);

/// Reads the polygons of an OBJ, with numbers as precise as the file's. One object per object (`o`) or, in
/// files without them, per group (`g`); of an object with several groups one per group, whose name is that of
/// both and whose parent is the object. Corners that refer to no point stay (MeshPiece). Error: numbers with
/// decimal commas. O(file).
Result<void> readObj(const std::filesystem::path& file, const std::function<void(const MeshObject&)>& take);

/// A mesh file with its points moved next to zero.
struct NearPoints {
    std::string content;   ///< the whole file; empty: it needs no move, or its points cannot be found
    glm::dvec3 origin{0};  ///< what was subtracted from every point
};

/// The mesh library stores points as float32, which at map coordinates is half a metre. Text formats and PLY
/// with double numbers hold more: the middle of their first points is subtracted before the library reads
/// them. STL as text, PLY; nothing for other formats, and where that middle is within 10,000 units of
/// zero. Takes twice the memory of the file.
NearPoints movePointsNear(const std::filesystem::path& file);

/// Refuses files on which the mesh library would run for ever or exhaust memory: a PLY whose header does not
/// end or promises more than the file holds, a glb that is shorter than it says. Also refuses an IFC or a
/// DXF in text form without the mark at its end, as part of the model is missing, and a glTF that names
/// files other than plain files in its own folder. Reads the beginning and the end of the file, and all of a
/// glTF's JSON. Returns the size of the file and the files that it names, bytes.
Result<std::uintmax_t> checkMeshFile(const std::filesystem::path& file);

/// Whether `companion`, a file named by a mesh file, is a plain file in the mesh's own folder: no pipe or
/// device, no link that leads elsewhere. `companion` is an absolute path or relative to the working folder.
bool isPlainFileBeside(const std::filesystem::path& companion, const std::filesystem::path& mesh);

}  // namespace noonmark
