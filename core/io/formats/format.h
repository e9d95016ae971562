#pragma once

// The folder core/io/formats says which formats are read, and which are recognised only to say what to do
// instead. A Format (this file) is one row; coreFormats() lists them (core/io/core_formats.cpp). Detection
// (core/io/files/plain_file.h), GDAL's drivers (core/io/files/open_dataset.h), readers (core/io/read_city.h),
// file dialogs, help, messages, hashes of inputs and plans of tiles loop over them.

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <iosfwd>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace noonmark {

enum class JsonKind {
    cityJson,  ///< CityJSON, or CityJSONSeq (its first line is CityJSON)
    geoJson,
    gltf,
    other,  ///< something else, or not JSON
};

/// What kind of JSON a stream holds, from the keys of its outermost object. Reads as far as the first key
/// that identifies the kind; keys may come in any order, and the rest may be broken.
JsonKind detectJsonKind(std::istream& stream);

class Progress;
struct FilePiece;
struct FootprintScan;
struct ListedLayer;
struct LonLatBox;
struct ReadSettings;

/// What a file holds.
enum class FileKind {
    footprints,  ///< vector maps: buildings, also places, regions, windows
    cityJson,    ///< 3D city models
    mesh,        ///< solids without a place of their own
    terrain,     ///< rasters of elevations
};

/// The beginning of a file.
struct FileHead {
    std::string bytes;        ///< at most 8 KiB; empty if the file cannot be read
    std::string ending;       ///< ".shp", in small letters
    std::uintmax_t size = 0;  ///< of the whole file, bytes
    JsonKind json = JsonKind::other;

    /// Without a byte order mark and blanks before it.
    [[nodiscard]] std::string_view text() const;
};

/// Everything but `json`, for which a file may have to be read further.
FileHead readFileHead(const std::filesystem::path& file);

/// How the beginning of a file is recognised.
struct Mark {
    std::string_view begins;         ///< first bytes of its text(); empty: any
    std::string_view contains = {};  ///< and this somewhere in the head; empty: nothing
    std::string_view ending = {};    ///< and this ending of its name; empty: any
};

/// What reads the files of a format.
struct FormatReader {
    using Read = Result<FilePiece>(const std::filesystem::path&, const ReadSettings&, Progress&,
                                   std::stop_token, const LonLatBox*);
    using Scan = Result<FootprintScan>(const std::filesystem::path&, const ReadSettings&, Progress&,
                                       std::stop_token);
    FileKind kind = FileKind::footprints;
    Read* read = nullptr;  ///< null: not read. Takes the extent that is wanted; null: everything
    Scan* scan = nullptr;  ///< in one pass that stores nothing; null: it has to be read whole
    using List = Result<std::vector<ListedLayer>>(const std::filesystem::path&, std::stop_token);
    List* list = nullptr;  ///< its layers and fields; null: none to choose from
};

/// A file format: one row for each.
struct Format {
    std::string_view name;                       ///< in words: "Shapefile", "LAS or LAZ, a point cloud"
    FormatReader reader = {};                    ///< {}: recognised, but not read
    std::vector<std::string_view> endings = {};  ///< ".shp"; for dialogs and dropped files only
    std::vector<Mark> marks = {};                ///< any of them; none: GDAL tells
    bool (*begins)(const FileHead&) = nullptr;   ///< the same where marks do not suffice
    JsonKind json = JsonKind::other;             ///< the same of JSON
    std::string_view driver = {};                ///< of GDAL ("ESRI Shapefile"); empty: GDAL may not read it
    /// Endings of the files that are read along with it, and hashed and protected with it.
    std::vector<std::string_view> companions = {};
    std::vector<std::string_view> opened = {};  ///< endings of other files that GDAL may open beside it
    /// Endings of files that begin with the values themselves, and so with the bytes of any other format.
    std::vector<std::string_view> headless = {};
    bool readsExtent = false;        ///< reads only what touches an extent, of files with a spatial index
    bool isPicture = false;          ///< aerial photographs too
    std::string_view reported = {};  ///< the name that results state; empty: the same
    std::string_view instead = {};   ///< of what is not read: what to do

    [[nodiscard]] bool isRead() const { return reader.read != nullptr; }
    [[nodiscard]] std::string_view nameInResults() const { return reported.empty() ? name : reported; }
};

using Formats = std::span<const Format>;

/// All of them. What is not read comes first, then by kind, the commonest first. Defined in
/// core/io/core_formats.cpp.
Formats coreFormats();

/// The first format that a file begins as, among those that are read or among the others; null: none.
const Format* findReadFormat(const FileHead& head, Formats formats = coreFormats());
const Format* findForeignFormat(const FileHead& head, Formats formats = coreFormats());

/// An Error of kind `unsupported` for a plain file of a format that is recognised but not read: which one,
/// and what to do. Reads the beginning of the file.
Result<void> refuseForeignFormat(const std::filesystem::path& file, Formats formats = coreFormats());

/// The format of this kind with a GDAL driver, or with an ending of a file's name; null: none.
const Format* findByDriver(std::string_view driver, FileKind kind, Formats formats = coreFormats());
const Format* findByEnding(const std::filesystem::path& file, FileKind kind, Formats formats = coreFormats());

/// The files that are read along with a file, whether they exist or not: .dbf of a Shapefile, .bin of a glTF;
/// with the ending in capitals where only that one exists. Determined by the file's ending; nothing is
/// opened.
std::vector<std::filesystem::path> listCompanionFiles(const std::filesystem::path& file,
                                                      Formats formats = coreFormats());

/// Names or endings of the formats of these kinds that are read, each once: "GeoPackage, GeoJSON, OBJ".
std::string listNames(std::initializer_list<FileKind> kinds, Formats formats = coreFormats());
std::vector<std::string_view> listEndings(std::initializer_list<FileKind> kinds,
                                          Formats formats = coreFormats());

}  // namespace noonmark
