#include "core/io/files/check_output.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <system_error>

#include "core/describe/command_options.h"
#include "core/io/files/geopackage_check.h"
#include "core/io/formats/format.h"

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

namespace {

namespace fs = std::filesystem;

constexpr const char* anotherName = "Name another file";

// True if a plain file exists, false if nothing does. Error: something else exists.
Result<bool> isPlainFileThere(const fs::path& file) {
    std::error_code ignored;
    if (fs::symlink_status(file, ignored).type() == fs::file_type::not_found) return false;
    switch (fs::status(file, ignored).type()) {
        case fs::file_type::regular:
            return true;
        // Without permission to look there is none to write either; writing then reports it
        case fs::file_type::none:
            return false;
        case fs::file_type::not_found:
            return failure("This is a link to a file that does not exist", file.string(),
                           "Remove the link, or name another file");
        case fs::file_type::directory:
            return failure("A folder has this name", file.string(), anotherName);
        default:
            return failure("This is a pipe or a device, not a file", file.string(), "Name a file on a disk");
    }
}

bool isSame(const fs::path& one, const fs::path& other) {
    std::error_code ignored;
    return fs::equivalent(one, other, ignored);
}

bool liesInFolder(const fs::path& file, const fs::path& input) {
    std::error_code ignored;
    return fs::is_directory(input, ignored) && isSame(fs::absolute(file, ignored).parent_path(), input);
}

bool belongsTo(const fs::path& file, const fs::path& input) {
    if (liesInFolder(file, input)) return true;
    const auto companions = listCompanionFiles(input);
    return isSame(file, input) || std::ranges::any_of(companions, [&](const fs::path& companion) {
               return isSame(file, companion);
           });
}

Result<void> checkNoInput(const fs::path& file, const std::vector<fs::path>& inputs) {
    const auto input =
        std::ranges::find_if(inputs, [&](const fs::path& one) { return belongsTo(file, one); });
    if (input == inputs.end()) return {};
    std::string where = file.string();
    if (*input != file)
        where +=
            fmt::format(" ({} {})", isSame(file, *input) ? "the same file as" : "read with", input->string());
    return failure("This file is an input, which would be lost", where, anotherName);
}

// A folder that is a data set (a file geodatabase, Shapefiles) is hashed with all its files: with one more it
// would be another, and no result of it could be verified.
Result<void> checkNoInputFolder(const fs::path& file, const std::vector<fs::path>& inputs) {
    const auto input =
        std::ranges::find_if(inputs, [&](const fs::path& one) { return liesInFolder(file, one); });
    if (input == inputs.end()) return {};
    return failure("This folder is an input, which would be changed", input->string(), "Name another folder");
}

Result<void> checkNoProject(const fs::path& file, OutputKind kind) {
    if (kind == OutputKind::project) return {};
    const auto project = holdsProject(file);
    if (!project) return tl::make_unexpected(project.error());
    if (!*project) return {};
    return failure("This file is a Noonmark project, which would be lost", file.string(), anotherName);
}

Result<void> checkKind(const fs::path& file, OutputKind kind) {
    if (isOfKind(file, kind)) return {};
    return failure(fmt::format("There is a file of this name already, and it is not {}", describe(kind)),
                   file.string(), "Name another file, or remove this one first");
}

// SQLite would replay a journal of the old file into the new one.
Result<void> checkNoJournal(const fs::path& file, OutputKind kind) {
    const bool database = kind == OutputKind::geoPackage || kind == OutputKind::project;
    if (!database || !isBeingWritten(file)) return {};
    return failure("Another program is writing to this file, or was stopped while it did", file.string(),
                   "Close the file in that program, remove the journal beside it, or name another file");
}

Result<void> checkReplaceable(const fs::path& file, OutputKind kind, const OutputRules& rules) {
    return checkNoInput(file, rules.inputs)
        .and_then([&] { return checkNoProject(file, kind); })
        .and_then([&] { return checkKind(file, kind); });
}

std::string addOverwrite(const char* what, const char* other) {
    return fmt::format("Add {} to replace {}, or name another {}", flags::overwrite, what, other);
}

Result<void> areThere(const fs::path& folder, const std::vector<std::string>& names) {
    if (names.size() == 1)
        return failure("There is a file of this name already", (folder / names.front()).string(),
                       addOverwrite("it", "folder"));
    return failure(
        fmt::format("{} and {} more of the files to write exist already", names.front(), names.size() - 1),
        folder.string(), addOverwrite("them", "folder"));
}

}  // namespace

std::string nameOf(const std::string& standardName, const OutputRules& rules) {
    for (const auto& [from, to] : rules.renamed)
        if (from == standardName) return to;
    return standardName;
}

Result<void> checkOutput(const fs::path& file, OutputKind kind, const OutputRules& rules) {
    const auto there = isPlainFileThere(file);
    if (!there) return tl::make_unexpected(there.error());
    // Also where the old file is gone and only its journal was left behind.
    if (auto free = checkNoJournal(file, kind); !free) return free;
    if (!*there) return checkNoInputFolder(file, rules.inputs);
    if (auto may = checkReplaceable(file, kind, rules); !may || rules.overwrite) return may;
    return failure("There is a file of this name already", file.string(), addOverwrite("it", "file"));
}

Result<void> checkOutputs(const fs::path& folder, const std::vector<std::string>& names,
                          const OutputRules& rules) {
    OutputRules replacing = rules;
    replacing.overwrite = true;
    for (const std::string& name : names)
        if (auto may = checkOutput(folder / name, detectOutputKind(name), replacing); !may) return may;
    const auto there = findExistingOutputs(folder, names);
    return there.empty() || rules.overwrite ? Result<void>() : areThere(folder, there);
}

std::vector<std::string> findExistingOutputs(const fs::path& folder, const std::vector<std::string>& names) {
    std::vector<std::string> there;
    std::error_code ignored;
    std::ranges::copy_if(names, std::back_inserter(there),
                         [&](const std::string& name) { return fs::exists(folder / name, ignored); });
    return there;
}

}  // namespace noonmark
