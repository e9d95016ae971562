#include "core/mesh_reader/read_scene.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

namespace noonmark {

namespace {

using Json = nlohmann::json;

constexpr const char* again = "Export or download it again";

std::string contentOf(const std::filesystem::path& file, std::size_t offset, std::size_t bytes) {
    std::string content(bytes, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.seekg(std::streamoff(offset));
    stream.read(content.data(), std::streamsize(content.size()));
    content.resize(std::size_t(stream.gcount()));
    return content;
}

// Every item of an element takes at least one byte, in text two; a header with more items than bytes is
// wrong.
Result<std::uintmax_t> checkPly(const std::string& head, std::uintmax_t fileSize, const std::string& where) {
    const auto end = head.find("end_header");
    if (end == head.npos) return failure("The PLY header does not end", where, again);
    std::istringstream lines(head.substr(0, end));
    std::string line;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string keyword, name;
        std::uint64_t count = 0;
        if (!(words >> keyword >> name) || keyword != "element") continue;
        if (!(words >> count) || count > fileSize)
            return failure("The PLY promises more \"" + name + "\" than the file holds", where, again);
    }
    return fileSize;
}

// Size of the files that a glTF's buffers can come from: the file itself and the files it names beside it.
Result<std::uintmax_t> bytesBehind(const Json& gltf, const std::filesystem::path& file) {
    std::error_code error;
    std::uintmax_t bytes = std::filesystem::file_size(file, error);
    for (const Json& buffer : gltf.value("buffers", Json::array())) {
        const std::string uri = buffer.is_object() ? buffer.value("uri", "") : "";
        if (uri.empty() || uri.starts_with("data:")) continue;
        const std::filesystem::path companion = file.parent_path() / uri;
        if (!isPlainFileBeside(companion, file))
            return failure("The glTF names \"" + uri + "\", which is not a file in its own folder",
                           file.string(), "Put its files into one folder, or export it as .glb");
        const std::uintmax_t size = std::filesystem::file_size(companion, error);
        bytes += error ? 0 : size;
    }
    return bytes;
}

// Every vertex, index and buffer byte must be stored somewhere.
bool promisesMore(const Json& gltf, const char* list, const char* member, std::uintmax_t bytes) {
    for (const Json& item : gltf.value(list, Json::array()))
        if (item.is_object() && item.value(member, 0.0) > double(bytes)) return true;
    return false;
}

Result<std::uintmax_t> checkGltf(const std::string& text, const std::filesystem::path& file) try {
    const Json gltf = Json::parse(text);
    const auto bytes = bytesBehind(gltf, file);
    if (!bytes) return bytes;
    for (const auto& [list, member] :
         {std::pair("buffers", "byteLength"), std::pair("bufferViews", "byteLength"),
          std::pair("bufferViews", "byteOffset"), std::pair("accessors", "count")})
        if (promisesMore(gltf, list, member, *bytes))
            return failure("The glTF promises more than its files hold", file.string(), again);
    return bytes;
} catch (const std::exception&) {
    return failure("The glTF is not valid JSON", file.string(), again);
}

Result<std::uintmax_t> checkGlb(const std::string& head, std::uintmax_t fileSize,
                                const std::filesystem::path& file) {
    std::uint32_t promised = 0;
    std::uint32_t jsonLength = 0;
    constexpr std::size_t headerBytes = 20;
    if (head.size() < headerBytes) return failure("The file ends within its header", file.string(), again);
    std::memcpy(&promised, head.data() + 8, sizeof promised);
    std::memcpy(&jsonLength, head.data() + 12, sizeof jsonLength);
    if (promised > fileSize || jsonLength > fileSize - headerBytes)
        return failure("The file is shorter than it says it is", file.string(), again);
    return checkGltf(contentOf(file, headerBytes, jsonLength), file);
}

// Text formats that end with a mark of their own: without it part of the model is missing, which nothing that
// was read shows.
Result<std::uintmax_t> checkEnd(const std::filesystem::path& file, std::uintmax_t size, const char* mark) {
    constexpr std::uintmax_t tailBytes = 4096;  // room for blank lines and padding
    const std::uintmax_t start = size > tailBytes ? size - tailBytes : 0;
    std::istringstream lines(contentOf(file, start, tailBytes));
    for (std::string line; std::getline(lines, line);)
        if (const auto begin = line.find_first_not_of(" \t"); begin != line.npos && line.find(mark) == begin)
            return size;
    return failure(std::string("The file is cut off: its last line should be ") + mark, file.string(), again);
}

}  // namespace

Result<std::uintmax_t> checkMeshFile(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error)
        return failure("The file cannot be opened", file.string(),
                       "Check that it is there and that you may read it");
    if (size == 0) return failure("The file is empty", file.string(), again);
    constexpr std::size_t headBytes = 65536;
    const std::string head = contentOf(file, 0, headBytes);
    if (head.starts_with("ply")) return checkPly(head, size, file.string());
    if (head.starts_with("ISO-10303-21")) return checkEnd(file, size, "END-ISO-10303-21");
    if (isDxf(file) && !head.starts_with("AutoCAD Binary")) return checkEnd(file, size, "EOF");
    if (head.starts_with("glTF")) return checkGlb(head, size, file);
    if (const auto start = head.find_first_not_of(" \t\r\n"); start != head.npos && head[start] == '{')
        return checkGltf(contentOf(file, 0, size), file);
    return size;
}

bool isPlainFileBeside(const std::filesystem::path& companion, const std::filesystem::path& mesh) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(companion, error)) return false;
    const auto place = std::filesystem::canonical(companion, error);
    if (error) return false;
    const auto folder =
        std::filesystem::canonical(std::filesystem::absolute(mesh, error).parent_path(), error);
    return !error && place.parent_path() == folder;
}

}  // namespace noonmark
