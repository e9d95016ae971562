#include "core/io/files/file_kind.h"

#include <array>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "core/io/files/foreign_format.h"
#include "core/io/files/json_kind.h"
#include "core/io/files/plain_file.h"
#include "core/io/files/stoppable_stream.h"
#include "core/io/meshes/stated_axes.h"

namespace noonmark {

namespace {

constexpr std::size_t headBytes = 4096;
using Head = std::optional<FileKind>;

std::string headOf(std::istream& stream) {
    std::string head(headBytes, '\0');
    stream.read(head.data(), std::streamsize(head.size()));
    head.resize(std::size_t(stream.gcount()));
    return head;
}

struct Magic {
    std::string_view bytes;
    FileKind kind;
};

// Magic bytes by which formats are recognised.
constexpr std::array magics{
    Magic{"glTF", FileKind::mesh},
    Magic{"ply\n", FileKind::mesh},
    Magic{"ply\r", FileKind::mesh},
    Magic{std::string_view("II*\0", 4), FileKind::terrain},
    Magic{std::string_view("MM\0*", 4), FileKind::terrain},
    Magic{std::string_view("II+\0", 4), FileKind::terrain},
    Magic{std::string_view("MM\0+", 4), FileKind::terrain},
    Magic{std::string_view("\0\0\x27\x0a", 4), FileKind::footprints},  // shapefile
};

Head kindFromMagic(std::string_view head) {
    for (const Magic& magic : magics)
        if (head.starts_with(magic.bytes)) return magic.kind;
    return std::nullopt;
}

// OpenStreetMap: the root element of XML says so; PBF begins with the length of a blob header whose type is
// "OSMHeader".
Head kindOfOpenStreetMap(std::string_view head) {
    const bool pbf = head.size() > 15 && head.substr(4, 11) == "\x0a\x09OSMHeader";
    const bool xml = head.find("<osm ") != head.npos || head.find("<osm>") != head.npos;
    return pbf || xml ? Head(FileKind::footprints) : std::nullopt;
}

bool isObjLine(std::string_view line) {
    constexpr std::array starts{"v ", "v\t", "vn ", "vt ", "f ", "o ", "g ", "mtllib ", "usemtl ", "s "};
    for (const std::string_view start : starts)
        if (line.starts_with(start)) return true;
    return false;
}

// OBJ has no magic bytes: it is text whose first line that is neither blank nor a comment is one of its
// statements, and it has vertices.
Head kindOfObj(std::string_view head) {
    if (head.find('\0') != head.npos) return std::nullopt;
    std::istringstream lines{std::string(head)};
    std::string line;
    while (std::getline(lines, line)) {
        const auto start = line.find_first_not_of(" \t\r");
        if (start == line.npos || line[start] == '#') continue;
        return isObjLine(std::string_view(line).substr(start)) ? Head(FileKind::mesh) : std::nullopt;
    }
    return std::nullopt;
}

bool beginsJson(std::string_view head) {
    if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
    const auto start = head.find_first_not_of(" \t\r\n");
    return start != head.npos && head[start] == '{';
}

Head kindFromHead(std::string_view head) {
    if (const Head magic = kindFromMagic(head)) return magic;
    if (const Head map = kindOfOpenStreetMap(head)) return map;
    if (beginsIfc(head) || beginsDxf(head)) return FileKind::mesh;
    return kindOfObj(head);
}

// The kind of a JSON file; nothing if GDAL must decide (TopoJSON, ESRI JSON).
Head kindFromJson(const std::filesystem::path& file) {
    StoppableStream stream(file);
    switch (detectJsonKind(stream)) {
        case JsonKind::cityJson:
            return FileKind::cityJson;
        case JsonKind::gltf:
            return FileKind::mesh;
        case JsonKind::geoJson:
            return FileKind::footprints;
        case JsonKind::other:
            break;
    }
    return std::nullopt;
}

}  // namespace

Result<FileKind> detectFileKind(const std::filesystem::path& file) {
    std::error_code ignored;
    if (const auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    if (std::filesystem::is_directory(file, ignored)) return detectFileKindWithGdal(file);
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return failure("The file cannot be opened", file.string(), "Check that you may read it");
    const std::string head = headOf(stream);
    if (head.empty()) return failure("The file is empty", file.string(), "Export or download it again");
    if (const auto known = refuseForeignFormat(file); !known) return tl::make_unexpected(known.error());
    if (const Head kind = beginsJson(head) ? kindFromJson(file) : kindFromHead(head)) return *kind;
    return detectFileKindWithGdal(file);
}

}  // namespace noonmark
