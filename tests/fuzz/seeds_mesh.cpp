#include <fmt/format.h>

#include <array>
#include <initializer_list>

#include "core/io/meshes/mesh_scene.h"
#include "tests/fuzz/seeds.h"
#include "tests/shared/box_obj.h"

namespace noonmark::tests {

namespace {

// A box of 10 x 8 x 6.
constexpr std::array<glm::vec3, 8> corners{
    {{0, 0, 0}, {10, 0, 0}, {10, 8, 0}, {0, 8, 0}, {0, 0, 6}, {10, 0, 6}, {10, 8, 6}, {0, 8, 6}}};
constexpr std::array<std::array<std::uint32_t, 4>, 6> faces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

MeshObject box(const std::string& name, const std::string& parent) {
    MeshPiece piece;
    piece.points.assign(corners.begin(), corners.end());
    for (const auto& face : faces) {
        piece.cornerCounts.push_back(4);
        piece.corners.insert(piece.corners.end(), face.begin(), face.end());
    }
    return {name, {piece}, parent};
}

// A box at map coordinates that float32 does not hold.
MeshObject boxOnMap(double easting, double northing) {
    MeshObject object = box("house", "");
    MeshPiece& piece = object.pieces.front();
    piece.points.clear();
    for (const glm::vec3 corner : corners)
        addPoint(piece, glm::dvec3(corner) + glm::dvec3(easting, northing, 34));
    return object;
}

std::string makeMapScene(std::initializer_list<MeshObject> objects) {
    std::string bytes;
    appendSceneHead(bytes);
    for (const MeshObject& object : objects) appendObject(bytes, object);
    appendSceneEnd(bytes);
    return bytes;
}

std::string binaryPly() {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
        "property float z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n";
    for (const glm::vec3 corner : corners)
        for (int i = 0; i < 3; ++i) put(bytes, corner[i]);
    for (const auto& face : faces) {
        put(bytes, std::uint8_t(4));
        for (const std::uint32_t corner : face) put(bytes, corner);
    }
    return bytes;
}

// The buffer: corners as float32, then two triangles per face as uint16.
std::string gltfBuffer() {
    std::string bytes;
    for (const glm::vec3 corner : corners)
        for (int i = 0; i < 3; ++i) put(bytes, corner[i]);
    for (const auto& face : faces)
        for (const int i : {0, 1, 2, 0, 2, 3}) put(bytes, std::uint16_t(face[std::size_t(i)]));
    return bytes;
}

std::string gltfJson() {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"house","mesh":0,)"
           R"("translation":[1,2,3],"children":[1]},{"name":"WallSurface","mesh":0,"scale":[1,1,2]}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[0,0,0],)"
           R"("max":[10,8,6]},{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],)"
           R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":96},{"buffer":0,"byteOffset":96,)"
           R"("byteLength":72}],"buffers":[{"byteLength":168}]})";
}

std::string glb() {
    std::string json = gltfJson();
    while (json.size() % 4 != 0) json += ' ';
    const std::string buffer = gltfBuffer();
    std::string bytes = "glTF";
    put(bytes, std::uint32_t(2));
    put(bytes, std::uint32_t(12 + 8 + json.size() + 8 + buffer.size()));
    put(bytes, std::uint32_t(json.size()));
    bytes += "JSON" + json;
    put(bytes, std::uint32_t(buffer.size()));
    return bytes + std::string("BIN\0", 4) + buffer;
}

}  // namespace

void makeMeshSeeds(const SeedFolder& seeds) {
    seeds.write("mesh_scene", "box", makeMapScene({box("house", "")}));
    seeds.write("mesh_scene", "surfaces",
                makeMapScene({box("WallSurface", "a"), box("RoofSurface", "a"), box("", "")}));
    // The first byte chooses the system and the unit, as fuzz_mesh_on_map reads it.
    seeds.write("mesh_on_map", "metres", std::string(1, '\0') + makeMapScene({boxOnMap(391800, 5819500)}));
    seeds.write("mesh_on_map", "feet", '\1' + makeMapScene({boxOnMap(987000, 212000)}));
    seeds.write("mesh_on_map", "dutch",
                '\2' + makeMapScene({boxOnMap(91000, 437000), boxOnMap(91040, 437000)}));
    seeds.write("mesh_on_map", "millimetres",
                std::string(1, char(12)) + makeMapScene({boxOnMap(391800e3, 5819500e3)}));
    std::string error;
    appendSceneHead(error);
    appendError(error, {"what", "where", "advice"});
    seeds.write("mesh_scene", "error", error);
    for (const char* target : {"mesh_obj", "mesh_check"}) seeds.write(target, "box.obj", boxObj(10, 8, 6));
    for (const char* target : {"mesh_ply", "mesh_check"}) seeds.write(target, "box.ply", binaryPly());
    for (const char* target : {"mesh_gltf", "mesh_check"}) seeds.write(target, "box.glb", glb());
}

}  // namespace noonmark::tests
