#include "core/io/files/output_kind.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>

#include "core/io/files/geopackage_check.h"
#include "core/io/formats/json_kind.h"

namespace noonmark {

namespace {

using namespace std::string_view_literals;

constexpr std::streamsize contentHeadBytes = 4096;

struct KindOfEnding {
    std::string_view ending;
    OutputKind kind;
};
constexpr std::array kindsOfEndings{
    KindOfEnding{".gpkg", OutputKind::geoPackage}, KindOfEnding{".geojson", OutputKind::geoJson},
    KindOfEnding{".tif", OutputKind::geoTiff},     KindOfEnding{".png", OutputKind::picture},
    KindOfEnding{".pdf", OutputKind::pdf},         KindOfEnding{".city.json", OutputKind::cityJson},
    KindOfEnding{".json", OutputKind::json},       KindOfEnding{".dxf", OutputKind::dxf},
    KindOfEnding{".svg", OutputKind::svg},         KindOfEnding{".mp4", OutputKind::movie},
    KindOfEnding{".gif", OutputKind::movie},       KindOfEnding{".glb", OutputKind::glb},
    KindOfEnding{".qml", OutputKind::style},       KindOfEnding{".obj", OutputKind::obj},
};

bool beginsWithOneOf(std::string_view head, std::initializer_list<std::string_view> magics) {
    return std::ranges::any_of(magics, [&](std::string_view magic) { return head.starts_with(magic); });
}

// The GeoPackage standard, requirement 2: an SQLite file with this application id at byte 68.
bool beginsGeoPackage(std::string_view head) {
    return head.starts_with("SQLite format 3\0"sv) && head.size() >= 72 && head.substr(68, 4) == "GPKG";
}

std::string_view withoutMarkAndBlanks(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    const auto start = text.find_first_not_of(" \t\r\n");
    return start == text.npos ? std::string_view() : text.substr(start);
}

bool beginsWithBracket(std::string_view head) {
    const std::string_view text = withoutMarkAndBlanks(head);
    return text.starts_with('{') || text.starts_with('[');
}

// CSV has no magic bytes: it is text whose first line has columns, and that is not markup.
bool looksLikeTable(std::string_view head) {
    const std::string_view text = withoutMarkAndBlanks(head);
    const std::string_view line = text.substr(0, text.find('\n'));
    return head.find('\0') == head.npos && line.find_first_of(",;\t") != line.npos &&
           line.find_first_of("{[<%") != 0;
}

// Pairs of lines: group code 0 begins a section, 999 is a comment.
bool looksLikeDxf(std::string_view head) {
    const std::string_view text = withoutMarkAndBlanks(head);
    return (text.starts_with("0\n") || text.starts_with("0\r\n") || text.starts_with("999")) &&
           head.find("SECTION") != head.npos;
}

// Text whose first statement is one of those that an OBJ begins with, after comments.
bool looksLikeObj(std::string_view head) {
    std::string_view text = withoutMarkAndBlanks(head);
    while (text.starts_with('#')) {
        const auto end = text.find('\n');
        if (end == text.npos) return false;
        text = withoutMarkAndBlanks(text.substr(end));
    }
    return head.find('\0') == head.npos &&
           beginsWithOneOf(text, {"v "sv, "o "sv, "g "sv, "mtllib "sv, "usemtl "sv, "vt "sv, "vn "sv});
}

JsonKind jsonKindOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return detectJsonKind(stream);
}

bool hasHeadOf(std::string_view head, OutputKind kind) {
    switch (kind) {
        case OutputKind::geoPackage:
        case OutputKind::project:
            return beginsGeoPackage(head);
        case OutputKind::geoJson:
        case OutputKind::json:
        case OutputKind::cityJson:
            return beginsWithBracket(head);
        case OutputKind::geoTiff:
            return beginsWithOneOf(head, {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv});
        case OutputKind::picture:
            return beginsWithOneOf(head, {"\x89PNG\r\n\x1a\n"sv, "\xFF\xD8\xFF"sv});
        case OutputKind::pdf:
            return head.starts_with("%PDF-");
        case OutputKind::table:
            return looksLikeTable(head);
        case OutputKind::dxf:
            return looksLikeDxf(head);
        case OutputKind::svg:
            return beginsWithOneOf(withoutMarkAndBlanks(head), {"<svg", "<?xml"}) &&
                   head.find("<svg") != head.npos;
        case OutputKind::glb:
            return head.starts_with("glTF");
        case OutputKind::obj:
            return looksLikeObj(head);
        case OutputKind::style:
            return withoutMarkAndBlanks(head).starts_with("<!DOCTYPE qgis");
        case OutputKind::movie:
            return head.starts_with("GIF8") || (head.size() >= 8 && head.substr(4, 4) == "ftyp");
    }
    return false;
}

bool holdsWhatFollows(const std::filesystem::path& file, OutputKind kind) {
    if (kind == OutputKind::geoJson) return jsonKindOf(file) == JsonKind::geoJson;
    if (kind == OutputKind::json) return jsonKindOf(file) == JsonKind::other;
    if (kind == OutputKind::cityJson) return jsonKindOf(file) == JsonKind::cityJson;
    if (kind == OutputKind::geoPackage) return !holdsProject(file).value_or(true);
    if (kind == OutputKind::project) return holdsProject(file).value_or(false);
    return true;
}

}  // namespace

std::string_view describe(OutputKind kind) {
    switch (kind) {
        case OutputKind::geoPackage:
            return "a GeoPackage";
        case OutputKind::geoJson:
            return "GeoJSON";
        case OutputKind::geoTiff:
            return "a GeoTIFF";
        case OutputKind::picture:
            return "a picture (PNG, JPEG)";
        case OutputKind::pdf:
            return "a PDF";
        case OutputKind::table:
            return "a CSV table";
        case OutputKind::json:
            return "JSON with figures";
        case OutputKind::cityJson:
            return "CityJSON";
        case OutputKind::dxf:
            return "a DXF drawing";
        case OutputKind::svg:
            return "an SVG picture";
        case OutputKind::glb:
            return "a binary glTF file";
        case OutputKind::obj:
            return "an OBJ file";
        case OutputKind::style:
            return "a style of QGIS";
        case OutputKind::movie:
            return "a movie (MP4, GIF)";
        case OutputKind::project:
            return "a Noonmark project";
    }
    return "a file";
}

OutputKind detectOutputKind(const std::filesystem::path& name) {
    const std::string text = name.filename().string();  // ".city.json" stands before ".json" in the list
    const auto* const found = std::ranges::find_if(
        kindsOfEndings, [&](const KindOfEnding& one) { return text.ends_with(one.ending); });
    return found == kindsOfEndings.end() ? OutputKind::table : found->kind;
}

bool isOfKind(const std::filesystem::path& file, OutputKind kind) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return false;
    std::string head(std::size_t(contentHeadBytes), '\0');
    stream.read(head.data(), contentHeadBytes);
    head.resize(std::size_t(stream.gcount()));
    if (head.empty()) return !stream.bad();
    return hasHeadOf(head, kind) && holdsWhatFollows(file, kind);
}

}  // namespace noonmark
