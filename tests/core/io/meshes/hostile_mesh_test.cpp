#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <random>
#include <thread>

#include "core/io/meshes/mesh_reader_process.h"
#include "core/io/pieces/read_part.h"
#include "tests/core/io/piece_checks.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

Result<FilePiece> readUnsafeMesh(const std::filesystem::path& file) {
    ReadSettings settings;
    settings.upAxis = UpAxis::z;
    settings.meshAnchor = LonLat{-73.98, 40.75};
    NoProgress progress;
    return readMesh(file, settings, progress, {});
}

// The error of a mesh file that cannot be read; empty if it can.
std::string meshError(const std::filesystem::path& file) {
    const auto piece = readUnsafeMesh(file);
    return piece ? "" : piece.error().text();
}

std::string gltfText(const std::string& accessor, const std::string& more = "") {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[)" +
           accessor + "]" + more + "}";
}

// A glTF whose points are in another file.
std::string gltfWithUri(const std::string& uri) {
    return gltfText(R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"})",
                    R"(,"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36}],)"
                    R"("buffers":[{"byteLength":36,"uri":")" +
                        uri + R"("}])");
}

template <class T>
void put(std::string& bytes, std::initializer_list<T> values) {
    for (const T value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// One upright triangle; its corner count has the type `countType`. `headerEnd` is used unchanged.
std::string binaryPly(const std::string& headerEnd, const std::string& countType, const std::string& count) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list " +
        countType + " int vertex_indices\n" + headerEnd;
    put<float>(bytes, {0, 0, 0, 10, 0, 0, 0, 10, 5});
    bytes += count;
    put<std::int32_t>(bytes, {0, 1, 2});
    return bytes;
}

std::string objOfBoxes(int boxes) {
    std::string text;
    for (int i = 0; i < boxes; ++i) {
        const std::string x = std::to_string(i * 20), y = std::to_string(i * 20 + 10);
        text += "o box " + std::to_string(i) + "\n";
        for (const char* z : {" 0", " 9.125"})
            for (const std::string& corner : {x + " 0", y + " 0", y + " 10", x + " 10"})
                text += "v " + corner + z + "\n";
        text += "f -5 -6 -7 -8\nf -4 -3 -2 -1\nf -8 -7 -3 -4\nf -7 -6 -2 -3\nf -6 -5 -1 -2\nf -5 -8 -4 -1\n";
    }
    return text;
}

bool hasNoChild() { return ::waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD; }

TEST(HostileMesh, EmptySparseAccessorsEndTheReaderOnly) {
    const tests::TemporaryFolder folder;
    for (const char* sparse : {"{}", R"({"count":3,"indices":{},"values":{}})"}) {
        const std::string error = meshError(
            folder.file("a.gltf", gltfText(R"({"componentType":5126,"count":3,"type":"VEC3","sparse":)" +
                                           std::string(sparse) + "}")));
        EXPECT_NE(error.find("could not be read: its reader "), std::string::npos) << error;
    }
    EXPECT_TRUE(hasNoChild());
}

TEST(HostileMesh, PlyHeadersThatEndOtherwiseAreErrorsOrRead) {
    const tests::TemporaryFolder folder;
    for (const char* end :
         {"end_header", "end_header\r", "end_headerx\n", "comment end_header\n", "END_HEADER\n"}) {
        const std::string error = meshError(folder.file("a.ply", binaryPly(end, "uchar", "\3")));
        EXPECT_TRUE(error.empty() || error.find("a.ply: The ") != std::string::npos) << end << error;
    }
    EXPECT_EQ(meshError(folder.file("a.ply", binaryPly("end_header\n", "uchar", "\3"))), "");
}

// Sanitizers need the address space that the reader is denied otherwise (own_limits_posix.cpp).
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(HostileMesh, AListOfTwoBillionCornersIsOutOfMemoryForTheReaderOnly) {
    const tests::TemporaryFolder folder;
    for (const char* count : {"\0\0\0\x80", "\xff\xff\xff\x7f"}) {
        const std::string error =
            meshError(folder.file("a.ply", binaryPly("end_header\n", "uint", std::string(count, 4))));
        EXPECT_NE(error.find("its reader ran out of memory"), std::string::npos) << error;
    }
}
#endif

TEST(HostileMesh, DeepAndEndlessTreesOfNodesEndTheReaderOnly) {
    const tests::TemporaryFolder folder;
    const std::string start = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)";
    std::string chain, twins;
    for (int i = 1; i <= 100000; ++i) chain += fmt::format(R"({{"children":[{}]}},)", i);
    for (int i = 1; i <= 40; ++i) twins += fmt::format(R"({{"children":[{0},{0}]}},)", i);  // 2^40 nodes
    const std::string nested =
        R"({"asset":{"version":"2.0"},"extras":)" + std::string(200000, '[') + std::string(200000, ']') + "}";
    for (const std::string& text : {start + chain + "{}]}", start + twins + "{}]}", nested}) {
        const std::string error = meshError(folder.file("a.gltf", text));
        EXPECT_NE(error.find("The mesh could not be read: its reader "), std::string::npos) << error;
    }
}

TEST(HostileMesh, AGltfNamesOnlyPlainFilesInItsOwnFolder) {
    const tests::TemporaryFolder folder;
    const tests::TemporaryFolder elsewhere;
    std::string points;
    put<float>(points, {0, 0, 0, 10, 0, 0, 0, 10, 5});
    const auto outside = elsewhere.file("points.bin", points);
    ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
    std::filesystem::create_symlink(outside, folder.path("link.bin"));
    std::filesystem::create_symlink("/dev/zero", folder.path("zero.bin"));
    const std::string wayOut = "../" + outside.parent_path().filename().string() + "/points.bin";
    for (const std::string& uri :
         {wayOut, outside.string(), std::string("../../../../etc/passwd"), std::string("/dev/zero"),
          std::string("pipe"), std::string("link.bin"), std::string("zero.bin"), std::string(".")}) {
        const std::string error = meshError(folder.file("a.gltf", gltfWithUri(uri)));
        EXPECT_NE(error.find("which is not a file in its own folder"), std::string::npos) << uri << error;
    }
    (void)folder.file("points.bin", points);
    std::filesystem::create_symlink("points.bin", folder.path("inside.bin"));
    for (const char* uri : {"points.bin", "inside.bin", "./points.bin"})
        EXPECT_EQ(meshError(folder.file("a.gltf", gltfWithUri(uri))), "") << uri;
}

TEST(HostileMesh, MaterialsOfAnObjElsewhereAreNotOpened) {
    const tests::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
    for (const char* library : {"pipe", "/dev/zero", "../../../../etc/passwd"})
        EXPECT_EQ(meshError(folder.file("a.obj",
                                        "mtllib " + std::string(library) + "\nusemtl a\n" + objOfBoxes(1))),
                  "");
}

TEST(HostileMesh, PipesAndFoldersAreNoMeshes) {
    const tests::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo(folder.path("a.obj").c_str(), 0600), 0);
    EXPECT_NE(meshError(folder.path("a.obj")), "");
    EXPECT_NE(meshError(folder.path("")), "");
    EXPECT_NE(meshError("/dev/zero"), "");
}

// Formats that the library supports but Noonmark does not, by content or name: OFF, AC3D, VRML.
TEST(HostileMesh, OtherFormatsOfTheLibraryAreNotRead) {
    const tests::TemporaryFolder folder;
    const std::string off = "OFF\n3 1 0\n0 0 0\n9 0 0\n0 9 9\n3 0 1 2\n";
    for (const auto& [name, content] : {std::pair("a.off", off), std::pair("a.ac", std::string("AC3Db\n")),
                                        std::pair("a.wrl", std::string("#VRML V2.0 utf8\n"))})
        EXPECT_NE(meshError(folder.file(name, content)).find("The mesh cannot be read ("), std::string::npos);
}

TEST(MeshReaderProcess, SaysWhichLimitEndedIt) {
    const tests::TemporaryFolder folder;
    const auto file = folder.file("a.obj", objOfBoxes(100000));
    MeshReaderLimits late;
    late.seconds = 0;
    const auto tooLate = readMeshScene(file, late, {});
    ASSERT_FALSE(tooLate);
    EXPECT_NE(tooLate.error().what.find("took too long"), std::string::npos) << tooLate.error().text();
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    MeshReaderLimits small;
    small.memoryBytes = 48 << 20;
    const auto tooLarge = readMeshScene(file, small, {});
    ASSERT_FALSE(tooLarge);
    EXPECT_NE(tooLarge.error().what.find("ran out of memory"), std::string::npos) << tooLarge.error().text();
#endif
    MeshReaderLimits few;
    few.resultBytes = 1000;
    const auto tooMany = readMeshScene(file, few, {});
    ASSERT_FALSE(tooMany);
    EXPECT_NE(tooMany.error().what.find("too large"), std::string::npos) << tooMany.error().text();
    EXPECT_TRUE(hasNoChild());
}

// The child process of this one, found by searching all processes.
pid_t meshReaderChild() {
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        std::ifstream stat(entry.path() / "stat");
        pid_t process = 0, parent = 0;
        std::string name, state;
        if (stat >> process >> name >> state >> parent && parent == ::getpid() &&
            name.find("mesh") != name.npos)
            return process;
    }
    return 0;
}

TEST(MeshReaderProcess, WhichIsKilledIsAnError) {
    const tests::TemporaryFolder folder;
    const auto file = folder.file("a.obj", objOfBoxes(60000));
    std::atomic<bool> killed = false;
    const std::jthread killer([&](const std::stop_token& done) {
        while (!killed && !done.stop_requested())
            if (const pid_t child = meshReaderChild(); child > 0) killed = ::kill(child, SIGKILL) == 0;
    });
    const auto scene = readMeshScene(file, {}, {});
    ASSERT_FALSE(scene);
    EXPECT_TRUE(killed);
    EXPECT_NE(scene.error().what.find("its reader was stopped"), std::string::npos) << scene.error().text();
    EXPECT_TRUE(hasNoChild());
}

TEST(MeshReaderProcess, EndsWhenReadingIsCancelled) {
    const tests::TemporaryFolder folder;
    const auto file = folder.file("a.obj", objOfBoxes(60000));
    std::stop_source stop;
    const std::jthread user([&] {
        while (meshReaderChild() == 0) {
        }
        stop.request_stop();
    });
    const auto scene = readMeshScene(file, {}, stop.get_token());
    ASSERT_FALSE(scene);
    EXPECT_TRUE(isCancelled(scene.error())) << scene.error().text();
    EXPECT_TRUE(hasNoChild());
}

TEST(MeshReaderProcess, HandsOverWhatTheFileHoldsToTheBit) {
    const tests::TemporaryFolder folder;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> number(-500, 500);
    MeshPiece expected;
    std::string ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 300\nproperty float x\n"
        "property float y\nproperty float z\nelement face 100\n"
        "property list uchar int vertex_indices\nend_header\n";
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 point(number(random), number(random), number(random));
        expected.points.push_back(point);
        put<float>(ply, {point.x, point.y, point.z});
    }
    for (std::int32_t i = 0; i < 300; i += 3) {
        ply += '\3';
        put<std::int32_t>(ply, {i, i + 1, i + 2});
        expected.cornerCounts.push_back(3);
        for (std::int32_t j = 0; j < 3; ++j) expected.corners.push_back(std::uint32_t(i + j));
    }
    const auto scene = readMeshScene(folder.file("a.ply", ply), {}, {});
    ASSERT_TRUE(scene) << scene.error().text();
    ASSERT_EQ(scene->size(), 1U);
    ASSERT_EQ(scene->front().pieces.size(), 1U);
    EXPECT_EQ(scene->front().pieces.front(), expected);
}

// --- The output of the reader process is untrusted too.

std::string sceneBytes(const MeshScene& scene) {
    std::string bytes;
    appendSceneHead(bytes);
    for (const MeshObject& object : scene) appendObject(bytes, object);
    appendSceneEnd(bytes);
    return bytes;
}

const MeshScene twoObjects{
    {"a", {{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {0, 0, 1}}, {3, 4}, {0, 1, 2, 0, 1, 2, 3}}}}, {"b", {}}};

TEST(MeshScene, ComesBackAsItWasWritten) {
    bool complete = false;
    const auto scene = parseScene(sceneBytes(twoObjects), complete);
    ASSERT_TRUE(scene && complete);
    EXPECT_EQ(*scene, twoObjects);
    std::string bytes;
    appendSceneHead(bytes);
    appendError(bytes, {"what", "where", "advice"});
    const auto error = parseScene(bytes, complete);
    ASSERT_FALSE(error);
    EXPECT_TRUE(complete);
    EXPECT_EQ(error.error().text(), "where: what. advice");
}

TEST(MeshScene, CutShortOrTooLongIsNotComplete) {
    const std::string bytes = sceneBytes(twoObjects);
    bool complete = true;
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        EXPECT_FALSE(parseScene(bytes.substr(0, length), complete));
        EXPECT_FALSE(complete) << length;
    }
    EXPECT_FALSE(parseScene(bytes + "z", complete));
    EXPECT_FALSE(complete);
}

TEST(MeshScene, SpoiledBytesNeverCrash) {
    const std::string bytes = sceneBytes(twoObjects);
    std::mt19937 random(11);
    for (int i = 0; i < 20000; ++i) {
        std::string spoiled = bytes;
        for (int j = 0; j < 2; ++j) spoiled[random() % spoiled.size()] = char(random() % 256);
        bool complete = false;
        const auto scene = parseScene(spoiled, complete);
        if (!scene) continue;
        for (const MeshObject& object : *scene)
            for (const MeshPiece& piece : object.pieces) {
                std::size_t corners = 0;
                for (const std::uint32_t count : piece.cornerCounts) corners += count;
                EXPECT_EQ(corners, piece.corners.size());
            }
    }
}

}  // namespace
}  // namespace noonmark
