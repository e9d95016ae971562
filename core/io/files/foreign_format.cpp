#include "core/io/files/foreign_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>

#include "core/io/meshes/stated_axes.h"

namespace noonmark {

namespace {

using namespace std::string_view_literals;

constexpr std::size_t foreignHeadBytes = 8192;

/// How the beginning of a file is recognised.
struct Mark {
    std::string_view begins;         ///< its first bytes, after blanks and a byte order mark; empty: any
    std::string_view contains = {};  ///< and this somewhere in the head; empty: nothing
    std::string_view ending = {};    ///< and this extension, in small letters; empty: any
};

struct ForeignFormat {
    std::string_view name;
    std::string_view remedy;
    Mark mark;
};

constexpr std::string_view toCityJson =
    "Convert it to CityJSON, for instance with citygml-tools (citygml-tools to-cityjson FILE), and read that";
constexpr std::string_view toMesh = "Export the buildings as glTF, OBJ, IFC or DXF (ASCII, polyface meshes)";
constexpr std::string_view toTerrain =
    "Make a terrain raster of its ground points (PDAL: writers.gdal) and read that GeoTIFF";
constexpr std::string_view toFootprints =
    "Convert it to GeoPackage, for instance with QGIS or ogr2ogr out.gpkg FILE, and read that";
constexpr std::string_view toObj =
    "Convert it to OBJ or glTF, for instance with Blender or MeshLab, and read that";
constexpr std::string_view toSource = "Take the data that it was made of: CityJSON, a mesh or footprints";
constexpr std::string_view fromSketchUp = "Export it from SketchUp as glTF, DXF, OBJ or IFC";
constexpr std::string_view fromRevit = "Export the model from Revit as IFC";
constexpr std::string_view nameShp = "Name its .shp file, which has the outlines";
constexpr std::string_view noWeather =
    "Noonmark computes shadows from the sun's position alone and needs no weather: name files with buildings";
constexpr std::string_view toRaster = "Export its elevations as a GeoTIFF";
constexpr std::string_view unpack = "Unpack it and name the files in it";
constexpr std::string_view toGeoTiff =
    "An aerial photograph must be a GeoTIFF that states its position, a terrain a GeoTIFF of elevations";

constexpr std::array foreignFormats{
    // 3D city models
    ForeignFormat{"CityGML", toCityJson, {"<", "www.opengis.net/citygml"}},
    ForeignFormat{"CityGML", toCityJson, {"<", "CityModel"}},
    ForeignFormat{"3D Tiles", toSource, {"{", "\"geometricError\""}},
    ForeignFormat{"3D Tiles", toSource, {"b3dm"}},
    ForeignFormat{"3D Tiles", toSource, {"i3dm"}},
    ForeignFormat{"3D Tiles", toSource, {"cmpt"}},
    ForeignFormat{"3D Tiles (points)", toTerrain, {"pnts"}},
    ForeignFormat{"LandXML", "Export its surface as a GeoTIFF or its buildings as DXF", {"<", "<LandXML"}},
    ForeignFormat{"gbXML", "Export the model as IFC", {"<", "<gbXML"}},
    // point clouds
    ForeignFormat{"LAS or LAZ, a point cloud", toTerrain, {"LASF"}},
    ForeignFormat{"E57, a point cloud", toTerrain, {"ASTM-E57"}},
    ForeignFormat{"PCD, a point cloud", toTerrain, {"# .PCD"}},
    // drawings and models
    ForeignFormat{"DWG",
                  "Save it as DXF (ASCII) with its masses as meshes, faces or outlines with a thickness",
                  {"AC10"}},
    ForeignFormat{"DGN", "Save it as DXF (ASCII)", {"\x08\x09\xFE"sv}},
    ForeignFormat{"SketchUp (SKP)", fromSketchUp, {"\xFF\xFE\xFF\x0ES\0k\0e\0t\0c\0h\0U\0p\0"sv}},
    ForeignFormat{"SketchUp (SKP)", fromSketchUp, {"SketchUp"}},
    ForeignFormat{"Rhino (3DM)",
                  "Export it from Rhino as OBJ, glTF or DXF, with solids as meshes",
                  {"3D Geometry File Format"}},
    ForeignFormat{"Revit", fromRevit, {"\xD0\xCF\x11\xE0"sv, "", ".rvt"}},
    ForeignFormat{"Revit", fromRevit, {"\xD0\xCF\x11\xE0"sv, "", ".rfa"}},
    ForeignFormat{"3ds Max", toMesh, {"\xD0\xCF\x11\xE0"sv, "", ".max"}},
    ForeignFormat{"SketchUp or another file of compound objects", toMesh, {"\xD0\xCF\x11\xE0"sv}},
    ForeignFormat{"STEP without a building", "Export the buildings as IFC or as a mesh", {"ISO-10303-21"}},
    ForeignFormat{"IFC as XML", "Export it as an IFC text file (.ifc)", {"<", "<ifcXML"}},
    ForeignFormat{"FBX", toObj, {"Kaydara FBX"}},
    ForeignFormat{"FBX", toObj, {"; FBX"}},
    ForeignFormat{"Collada (DAE)", toObj, {"<", "<COLLADA"}},
    ForeignFormat{"Blender", "Export it from Blender as glTF or OBJ", {"BLENDER"}},
    ForeignFormat{"USD", toObj, {"PXR-USDC"}},
    ForeignFormat{"USD", toObj, {"#usda"}},
    ForeignFormat{"VRML", toObj, {"#VRML"}},
    ForeignFormat{"3DS", toObj, {"MM"sv, "", ".3ds"}},
    // maps and tables
    ForeignFormat{"Parquet or GeoParquet", toFootprints, {"PAR1"}},
    ForeignFormat{"Arrow or Feather", toFootprints, {"ARROW1"}},
    ForeignFormat{"MapInfo (TAB)", toFootprints, {"!table"}},
    ForeignFormat{"MapInfo (TAB)", toFootprints, {"!Table"}},
    ForeignFormat{"MapInfo (MIF)", toFootprints, {"Version ", "Columns "}},
    ForeignFormat{"MapInfo (MIF)", toFootprints, {"VERSION ", "COLUMNS "}},
    ForeignFormat{"a table of a Shapefile", nameShp, {"", "", ".dbf"}},
    ForeignFormat{"an index of a Shapefile", nameShp, {"", "", ".shx"}},
    ForeignFormat{"QGIS project", "Name the files of its layers", {"<!DOCTYPE qgis"}},
    ForeignFormat{"Excel", "Save the table as CSV with the outlines as WKT", {"PK\3\4"sv, "", ".xlsx"}},
    ForeignFormat{"KMZ", "Unpack it (it is a ZIP) and read the .kml in it", {"PK\3\4"sv, "", ".kmz"}},
    ForeignFormat{"I3S scene layer", toSource, {"PK\3\4"sv, "", ".slpk"}},
    ForeignFormat{"IFC in a ZIP", "Unpack it and read the .ifc in it", {"PK\3\4"sv, "", ".ifczip"}},
    ForeignFormat{"ZIP", unpack, {"PK\3\4"sv}},
    ForeignFormat{"gzip", unpack, {"\x1F\x8B"sv}},
    ForeignFormat{"7z", unpack, {"7z\xBC\xAF"sv}},
    ForeignFormat{"RAR", unpack, {"Rar!"}},
    ForeignFormat{"bzip2", unpack, {"BZh"}},
    // weather, pictures, documents
    ForeignFormat{"EPW, weather data", noWeather, {"LOCATION,", "DESIGN CONDITIONS"}},
    ForeignFormat{"EPW, weather data", noWeather, {"LOCATION,", "", ".epw"}},
    ForeignFormat{"EnergyPlus model (IDF)", "Export the building as IFC or as a mesh", {"", "", ".idf"}},
    ForeignFormat{"NetCDF", toRaster, {"CDF\1"sv}},
    ForeignFormat{"NetCDF", toRaster, {"CDF\2"sv}},
    ForeignFormat{"HDF5", toRaster, {"\x89HDF"sv}},
    ForeignFormat{"PNG, a picture", toGeoTiff, {"\x89PNG"sv}},
    ForeignFormat{"JPEG, a picture", toGeoTiff, {"\xFF\xD8\xFF"sv}},
    ForeignFormat{"JPEG 2000, a picture", toGeoTiff, {"\0\0\0\x0CjP"sv}},
    ForeignFormat{"PDF", "Export the drawing as DXF, or the buildings as footprints or a mesh", {"%PDF"}},
};

std::string readHead(const std::filesystem::path& file) {
    std::string head(foreignHeadBytes, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), std::streamsize(head.size()));
    head.resize(std::size_t(std::max<std::streamsize>(0, stream.gcount())));
    return head;
}

std::string_view withoutBlanks(std::string_view head) {
    if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
    head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
    return head;
}

// Elevations without any header can begin with the bytes of any format.
bool isRawRaster(const std::string& ending) {
    return ending == ".hgt" || ending == ".bil" || ending == ".flt" || ending == ".raw";
}

std::string smallEnding(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& letter : ending) letter = char(std::tolower(static_cast<unsigned char>(letter)));
    return ending;
}

bool isMarked(std::string_view head, const std::string& ending, const Mark& mark) {
    return head.starts_with(mark.begins) && head.find(mark.contains) != head.npos &&
           (mark.ending.empty() || ending == mark.ending);
}

// A binary STL has no mark but its size: 80 bytes, the number of triangles, 50 bytes for each.
bool isStl(std::string_view head, const std::filesystem::path& file) {
    if (head.starts_with("solid") && head.find("facet") != head.npos) return true;
    std::uint32_t triangles = 0;
    constexpr std::size_t before = 80;
    if (head.size() < before + sizeof triangles) return false;
    std::memcpy(&triangles, head.data() + before, sizeof triangles);
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(file, error);
    return !error && bytes == before + sizeof triangles + std::uintmax_t(50) * triangles;
}

tl::unexpected<Error> refused(std::string_view name, const std::filesystem::path& file,
                              std::string_view remedy) {
    return unsupported(fmt::format("This is {}, which is not read", name), file.string(),
                       std::string(remedy));
}

}  // namespace

Result<void> refuseForeignFormat(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return {};
    const std::string bytes = readHead(file);
    const std::string ending = smallEnding(file);
    if (bytes.empty() || beginsIfc(bytes) || isRawRaster(ending)) return {};
    const std::string_view head = withoutBlanks(bytes);
    for (const ForeignFormat& format : foreignFormats)
        if (isMarked(head, ending, format.mark)) return refused(format.name, file, format.remedy);
    if (isStl(bytes, file)) return refused("STL", file, toObj);
    return {};
}

}  // namespace noonmark
