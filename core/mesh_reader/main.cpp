// noonmark-mesh-reader: reads one mesh file under limits and writes its scene to a pipe. Noonmark starts it
// for each mesh (core/io/meshes/mesh_reader_process.h), so that a file that crashes the mesh library does not
// end the program and lose unsaved work.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/io/meshes/mesh_reader_process.h"
#include "core/mesh_reader/own_limits.h"
#include "core/mesh_reader/read_scene.h"

namespace noonmark {

namespace {

// Upper bound for well-formed files: an OBJ takes about forty bytes of memory for each of its own, plus the
// library itself.
constexpr std::uint64_t memoryPerByte = 128;
constexpr std::uint64_t memoryAnyway = std::uint64_t(512) << 20;

void writeOut(std::FILE* out, std::string& bytes) {
    std::fwrite(bytes.data(), 1, bytes.size(), out);
    bytes.clear();
}

Result<void> writeScene(const std::filesystem::path& file, std::FILE* out) {
    const auto bytesBehind = checkMeshFile(file);
    if (!bytesBehind) return tl::make_unexpected(bytesBehind.error());
    constexpr std::uintmax_t maximum = std::uintmax_t(1) << 40;  // keeps the product in range
    limitMemory(memoryAnyway + memoryPerByte * std::min(*bytesBehind, maximum));
    const auto take = [&, bytes = std::string()](const MeshObject& object) mutable {
        appendObject(bytes, object);
        writeOut(out, bytes);
    };
    if (isDxf(file)) return readDxf(file, take);
    return isObj(file) ? readObj(file, take) : readScene(file, take);
}

// Exits without freeing memory: the kernel is faster.
[[noreturn]] void readInto(const std::filesystem::path& file, std::FILE* out) {
    std::string bytes;
    appendSceneHead(bytes);
    writeOut(out, bytes);
    if (const auto written = writeScene(file, out); written)
        appendSceneEnd(bytes);
    else
        appendError(bytes, written.error());
    writeOut(out, bytes);
    std::_Exit(std::fflush(out) == 0 ? EXIT_SUCCESS : EXIT_FAILURE);
}

}  // namespace

}  // namespace noonmark

int main(int argc, char** argv) {
    std::FILE* out = argc == 4 ? ::fdopen(noonmark::sceneDescriptor, "wb") : nullptr;
    if (out == nullptr) {
        std::fputs("noonmark-mesh-reader is started by Noonmark and is not meant to be run directly.\n",
                   stderr);
        return EXIT_FAILURE;
    }
    noonmark::limitThisProcess(std::strtoull(argv[1], nullptr, 10), std::strtoull(argv[2], nullptr, 10));
    noonmark::readInto(argv[3], out);
}
