#include "core/mesh_reader/read_scene.h"

#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/mesh_reader/ifc_objects.h"

namespace Assimp {
class IOSystem;
}

namespace noonmark {

namespace {

/// File access for Assimp: the mesh itself (or `content` in its place, where that is not empty) and plain
/// files in its folder, read only; all other files appear not to exist. Reading always ends: it throws (which
/// Assimp turns into its error) if a reader loops at the end of a file, as Assimp's PLY reader does on a
/// broken one. Backend: read_scene_assimp.cpp.
std::unique_ptr<Assimp::IOSystem> guardedFiles(const std::filesystem::path& mesh, std::string content = {});

constexpr std::size_t maxReadsAtEnd = 100;
constexpr std::size_t maxTimesOver =
    100;  // a reader may read a file a few times, to find its format and then its content

class GuardedStream final : public Assimp::IOStream {
public:
    GuardedStream(std::unique_ptr<std::istream> stream, std::size_t size)
        : source_(std::move(stream)), stream_(*source_), size_(size) {}

    size_t Read(void* buffer, size_t size, size_t count) override {
        stream_.clear();
        stream_.read(static_cast<char*>(buffer), std::streamsize(size * count));
        const auto got = std::size_t(stream_.gcount());
        countRead(got);
        return size == 0 ? 0 : got / size;
    }
    size_t Write(const void*, size_t, size_t) override { return 0; }
    aiReturn Seek(size_t offset, aiOrigin origin) override {
        stream_.clear();
        const auto from = origin == aiOrigin_SET   ? std::ios::beg
                          : origin == aiOrigin_CUR ? std::ios::cur
                                                   : std::ios::end;
        if (origin == aiOrigin_SET && offset > size_) return aiReturn_FAILURE;
        stream_.seekg(std::streamoff(offset), from);
        return stream_ ? aiReturn_SUCCESS : aiReturn_FAILURE;
    }
    [[nodiscard]] size_t Tell() const override { return std::size_t(stream_.tellg()); }
    [[nodiscard]] size_t FileSize() const override { return size_; }
    void Flush() override {}

private:
    void countRead(std::size_t got) {
        readInAll_ += got;
        readsAtEnd_ += got == 0 ? 1 : 0;
        const bool readsInCircles = readsAtEnd_ > maxReadsAtEnd || readInAll_ / maxTimesOver > size_ + 65536;
        if (readsInCircles) throw std::runtime_error("the file ends early");
    }

    std::unique_ptr<std::istream> source_;
    std::istream& stream_;
    std::size_t size_ = 0;
    std::size_t readInAll_ = 0;
    std::size_t readsAtEnd_ = 0;
};

class GuardedFiles final : public Assimp::IOSystem {
public:
    GuardedFiles(std::filesystem::path mesh, std::string content)
        : mesh_(std::move(mesh)), content_(std::move(content)) {}
    bool Exists(const char* path) const override { return path == mesh_ || isPlainFileBeside(path, mesh_); }
    [[nodiscard]] char getOsSeparator() const override {
        return char(std::filesystem::path::preferred_separator);
    }
    Assimp::IOStream* Open(const char* path, const char*) override {
        if (!Exists(path)) return nullptr;
        if (path == mesh_ && !content_.empty())
            return new GuardedStream(std::make_unique<std::istringstream>(content_), content_.size());
        auto stream = std::make_unique<std::ifstream>(path, std::ios::binary);
        if (!stream->is_open()) return nullptr;
        std::error_code error;
        const auto size = std::filesystem::file_size(path, error);
        return new GuardedStream(std::move(stream), error ? 0 : std::size_t(size));
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

private:
    std::filesystem::path mesh_;
    std::string content_;
};

std::unique_ptr<Assimp::IOSystem> guardedFiles(const std::filesystem::path& mesh, std::string content) {
    return std::make_unique<GuardedFiles>(mesh, std::move(content));
}

// Names as in the library. It supports some fifty more formats, which a file could select by its content.
constexpr std::array<std::string_view, 5> allowedImporters{
    "Stanford Polygon Library (PLY) Importer", "glTF2 Importer", "Stereolithography (STL) Importer",
    "Collada Importer", "Industry Foundation Classes (IFC) Importer"};

void keepAllowedImporters(Assimp::Importer& importer) {
    std::vector<Assimp::BaseImporter*> others;
    for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
        const aiImporterDesc* description = importer.GetImporterInfo(i);
        const std::string_view name = description != nullptr ? description->mName : "";
        if (std::ranges::find(allowedImporters, name) == allowedImporters.end())
            others.push_back(importer.GetImporter(i));
    }
    for (Assimp::BaseImporter* other : others) {
        importer.UnregisterLoader(other);
        delete other;  // the importer has released it
    }
}

// Nodes lift their meshes into map coordinates, which float32 would round.
glm::dmat4 inDouble(const aiMatrix4x4& matrix) {
    glm::dmat4 result;
    for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column)
            result[int(column)][int(row)] = double(matrix[row][column]);
    return result;
}

// The distance of float32 numbers at the mesh's farthest point, in its unit; 0 near its origin.
double roundingOf(const aiMesh& mesh) {
    constexpr float farUnits = 10'000;
    float maximum = 0;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i)
        for (unsigned axis = 0; axis < 3; ++axis)
            maximum = std::max(maximum, std::abs(mesh.mVertices[i][axis]));
    const bool isFar = maximum > farUnits && std::isfinite(maximum);
    return isFar ? double(std::nextafter(maximum, std::numeric_limits<float>::max()) - maximum) : 0;
}

// Polygons are not triangulated here: Assimp's own step crashes on some broken files.
MeshPiece pieceOf(const aiMesh& mesh, const glm::dmat4& toScene) {
    MeshPiece piece;
    piece.points.reserve(mesh.mNumVertices);
    piece.rounding = roundingOf(mesh);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D& point = mesh.mVertices[i];
        addPoint(piece, glm::dvec3(toScene * glm::dvec4(point.x, point.y, point.z, 1)));
    }
    const bool mirrored = glm::determinant(toScene) < 0;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices < 3 || face.mIndices == nullptr) continue;  // points and lines are not surfaces
        piece.cornerCounts.push_back(face.mNumIndices);
        piece.corners.insert(piece.corners.end(), face.mIndices, face.mIndices + face.mNumIndices);
        if (mirrored) std::reverse(piece.corners.end() - face.mNumIndices, piece.corners.end());
    }
    return piece;
}

struct SceneWalk {
    const aiScene& scene;
    std::function<void(MeshObject, const IfcLocation&)> take;

    // A node that a COLLADA does not name is called by its shape, not by what the library makes up.
    [[nodiscard]] std::string nameOf(const aiNode& node) const {
        const std::string_view own = node.mName.C_Str();
        if (!own.starts_with("$ColladaAutoName$")) return std::string(own);
        return node.mNumMeshes > 0 ? scene.mMeshes[node.mMeshes[0]]->mName.C_Str() : "";
    }

    void visit(const aiNode& node, const glm::dmat4& parent, IfcLocation within = {}) const {
        const glm::dmat4 toScene = parent * inDouble(node.mTransformation);
        // The root is named after the file.
        const bool isNested = node.mParent != nullptr && node.mParent->mParent != nullptr;
        MeshObject object{nameOf(node), {}, isNested ? nameOf(*node.mParent) : ""};
        for (unsigned i = 0; i < node.mNumMeshes; ++i)
            object.pieces.push_back(pieceOf(*scene.mMeshes[node.mMeshes[i]], toScene));
        within.enter(object.name, toScene[3].y);
        if (!object.pieces.empty()) take(std::move(object), within);
        for (unsigned i = 0; i < node.mNumChildren; ++i) visit(*node.mChildren[i], toScene, within);
    }
};

// Of Assimp's reasons some are names of exceptions.
std::string explain(std::string_view reason) {
    if (reason.find("bad_cast") != reason.npos) return "an entity refers to one of another kind";
    if (reason.find("bad_alloc") != reason.npos) return "it needs too much memory";
    return std::string(reason);
}

Result<void> takeIfc(const aiScene& scene, const std::function<void(const MeshObject&)>& take) {
    IfcObjects objects;
    SceneWalk{scene,
              [&](MeshObject object, const IfcLocation& within) { objects.add(std::move(object), within); }}
        .visit(*scene.mRootNode, glm::dmat4(1));
    for (const MeshObject& object : objects.take()) take(object);
    return {};
}

}  // namespace

Result<void> readScene(const std::filesystem::path& file,
                       const std::function<void(const MeshObject&)>& take) try {
    Assimp::Importer importer;
    keepAllowedImporters(importer);
    const bool ifc = isIfc(file.string());
    NearPoints near = ifc ? NearPoints{ifcAs2x3(file)} : movePointsNear(file);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);    // not their ids
    importer.SetIOHandler(guardedFiles(file, std::move(near.content)).release());  // the importer owns it
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (scene == nullptr)
        return failure(fmt::format("The mesh cannot be read ({})", explain(importer.GetErrorString())),
                       file.string(),
                       ifc ? "Export it as IFC 2x3, without spaces and zones" : "Export it again");
    if (scene->mRootNode == nullptr)
        return failure("The file holds no triangles", file.string(), trianglesAdvice);
    if (ifc) return takeIfc(*scene, take);
    SceneWalk{*scene, [&](const MeshObject& object, const IfcLocation&) { take(object); }}.visit(
        *scene->mRootNode, glm::translate(glm::dmat4(1), near.origin));
    return {};
} catch (const std::exception& exception) {
    return failure(fmt::format("The mesh cannot be read ({})", explain(exception.what())), file.string(),
                   "Export it again");
}

}  // namespace noonmark
