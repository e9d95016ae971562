#include <algorithm>
#include <array>
#include <cstring>
#include <sstream>

#include "core/io/footprints/footprint_scan.h"
#include "core/io/formats/format.h"
#include "core/io/meshes/stated_axes.h"
#include "core/io/osm/read_osm_buildings.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

namespace {

using namespace std::string_view_literals;

using WholeReader = Result<FilePiece>(const std::filesystem::path&, const ReadSettings&, Progress&,
                                      std::stop_token);

/// A reader that knows no extents.
template <WholeReader* reader>
Result<FilePiece> readWhole(const std::filesystem::path& file, const ReadSettings& settings,
                            Progress& progress, std::stop_token stop, const LonLatBox*) {
    return reader(file, settings, progress, std::move(stop));
}

constexpr FormatReader maps{FileKind::footprints, readFootprints, scanFootprints, listMapLayers};
constexpr FormatReader osmMaps{FileKind::footprints, readWhole<readOsmFootprints>, scanOsmFootprints};
constexpr FormatReader cities{FileKind::cityJson, readWhole<readCityJson>};
constexpr FormatReader gmlCities{FileKind::cityJson, readWhole<readCityGml>};
// What is in an archive is known only when it is unpacked: it is found where any city may be named.
constexpr FormatReader archives{FileKind::cityJson, readArchive};
constexpr FormatReader meshes{FileKind::mesh, readWhole<readMesh>};
constexpr FormatReader terrains{FileKind::terrain, readWhole<readTerrain>};

constexpr std::string_view toMesh = "Export the buildings as glTF, OBJ, IFC or DXF (ASCII, polyface meshes)";
constexpr std::string_view toTerrain =
    "Make a GeoTIFF of its ground points and read that: in PDAL filters.range (class 2) and then "
    "writers.gdal, in "
    "QGIS the processing tool Export to raster of point clouds";
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

// The files of compound objects that many programs write, and ZIP.
constexpr std::string_view compound = "\xD0\xCF\x11\xE0"sv;
constexpr std::string_view zip = "PK\3\4"sv;

bool beginsIfcFile(const FileHead& head) { return beginsIfc(head.bytes); }
bool beginsDxfFile(const FileHead& head) { return beginsDxf(head.bytes); }
bool beginsOpenStreetMap(const FileHead& head) { return osmFormatOf(head.bytes).has_value(); }

bool beginsStep(const FileHead& head) {
    return head.text().starts_with("ISO-10303-21") && !beginsIfc(head.bytes);
}

// A binary STL has no mark but its size: 80 bytes, the number of triangles, 50 bytes for each.
bool beginsStl(const FileHead& head) {
    if (head.bytes.starts_with("solid") && head.bytes.find("facet") != std::string::npos) return true;
    std::uint32_t triangles = 0;
    constexpr std::size_t before = 80;
    if (head.bytes.size() < before + sizeof triangles) return false;
    std::memcpy(&triangles, head.bytes.data() + before, sizeof triangles);
    return head.size == before + sizeof triangles + std::uintmax_t(50) * triangles;
}

// KML's reader gives such files up, since what an entity stands for may grow without end.
bool beginsKmlWithEntities(const FileHead& head) {
    const std::string_view text = head.text();
    return text.starts_with("<") && text.find("<!ENTITY") != text.npos && text.find("<kml") != text.npos;
}

bool isObjLine(std::string_view line) {
    constexpr std::array starts{"v ", "v\t", "vn ", "vt ", "f ", "o ", "g ", "mtllib ", "usemtl ", "s "};
    return std::ranges::any_of(starts, [&](std::string_view start) { return line.starts_with(start); });
}

// OBJ has no magic bytes: it is text whose first line that is neither blank nor a comment is one of its
// statements.
bool beginsObj(const FileHead& head) {
    if (head.bytes.find('\0') != std::string::npos) return false;
    std::istringstream lines{head.bytes};
    std::string line;
    while (std::getline(lines, line)) {
        const auto start = line.find_first_not_of(" \t\r");
        if (start != line.npos && line[start] != '#') return isObjLine(std::string_view(line).substr(start));
    }
    return false;
}

}  // namespace

Formats coreFormats() {
    static const std::vector<Format> formats{
        // Not read: 3D city models
        {.name = "3D Tiles",
         .marks = {{"{", "\"geometricError\""}, {"b3dm"}, {"i3dm"}, {"cmpt"}},
         .instead = toSource},
        {.name = "3D Tiles (points)", .marks = {{"pnts"}}, .instead = toTerrain},
        {.name = "LandXML",
         .marks = {{"<", "<LandXML"}},
         .instead = "Export its surface as a GeoTIFF or its buildings as DXF"},
        {.name = "gbXML", .marks = {{"<", "<gbXML"}}, .instead = "Export the model as IFC"},
        // point clouds
        {.name = "LAS or LAZ, a point cloud", .marks = {{"LASF"}}, .instead = toTerrain},
        {.name = "E57, a point cloud", .marks = {{"ASTM-E57"}}, .instead = toTerrain},
        {.name = "PCD, a point cloud", .marks = {{"# .PCD"}}, .instead = toTerrain},
        // drawings and models
        {.name = "DWG",
         .marks = {{"AC10"}},
         .instead = "Save it as DXF (ASCII) with its masses as meshes, faces or outlines with a thickness"},
        {.name = "DGN", .marks = {{"\x08\x09\xFE"sv}}, .instead = "Save it as DXF (ASCII)"},
        {.name = "SketchUp (SKP)",
         .marks = {{"\xFF\xFE\xFF\x0ES\0k\0e\0t\0c\0h\0U\0p\0"sv}, {"SketchUp"}},
         .instead = fromSketchUp},
        {.name = "a text in UTF-16",
         .marks = {{"\xFF\xFE"}, {"\xFE\xFF"}},
         .instead = "Save it as UTF-8; Excel calls that CSV UTF-8"},
        {.name = "Rhino (3DM)",
         .marks = {{"3D Geometry File Format"}},
         .instead = "Export it from Rhino as OBJ, glTF or DXF, with solids as meshes"},
        {.name = "Revit", .marks = {{compound, "", ".rvt"}, {compound, "", ".rfa"}}, .instead = fromRevit},
        {.name = "3ds Max", .marks = {{compound, "", ".max"}}, .instead = toMesh},
        {.name = "SketchUp or another file of compound objects", .marks = {{compound}}, .instead = toMesh},
        {.name = "STEP without a building",
         .begins = beginsStep,
         .instead = "Export the buildings as IFC or as a mesh"},
        {.name = "IFC as XML",
         .marks = {{"<", "<ifcXML"}},
         .instead = "Export it as an IFC text file (.ifc)"},
        {.name = "FBX", .marks = {{"Kaydara FBX"}, {"; FBX"}}, .instead = toObj},
        {.name = "Blender", .marks = {{"BLENDER"}}, .instead = "Export it from Blender as glTF or OBJ"},
        {.name = "USD", .marks = {{"PXR-USDC"}, {"#usda"}}, .instead = toObj},
        {.name = "VRML", .marks = {{"#VRML"}}, .instead = toObj},
        {.name = "3DS", .marks = {{"MM", "", ".3ds"}}, .instead = toObj},
        // maps and tables
        {.name = "Parquet or GeoParquet", .marks = {{"PAR1"}}, .instead = toFootprints},
        {.name = "Arrow or Feather", .marks = {{"ARROW1"}}, .instead = toFootprints},
        {.name = "MapInfo (TAB)", .marks = {{"!table"}, {"!Table"}}, .instead = toFootprints},
        {.name = "MapInfo (MIF)",
         .marks = {{"Version ", "Columns "}, {"VERSION ", "COLUMNS "}},
         .instead = toFootprints},
        {.name = "a table of a Shapefile", .marks = {{"", "", ".dbf"}}, .instead = nameShp},
        {.name = "an index of a Shapefile", .marks = {{"", "", ".shx"}}, .instead = nameShp},
        {.name = "KML that declares entities",
         .begins = beginsKmlWithEntities,
         .instead = "Remove its DOCTYPE, and write the values themselves"},
        {.name = "QGIS project", .marks = {{"<!DOCTYPE qgis"}}, .instead = "Name the files of its layers"},
        {.name = "Excel",
         .marks = {{zip, "", ".xlsx"}},
         .instead = "Save the table as CSV with the outlines as WKT"},
        {.name = "OpenDocument",
         .marks = {{zip, "", ".ods"}, {zip, "", ".odt"}},
         .instead = "Save the table as CSV with the outlines as WKT"},
        {.name = "3MF", .marks = {{zip, "", ".3mf"}}, .instead = toObj},
        {.name = "OpenJUMP (JML)", .marks = {{"<", "JCSDataFile"}}, .instead = toFootprints},
        {.name = "I3S scene layer", .marks = {{zip, "", ".slpk"}}, .instead = toSource},
        {.name = "IFC in a ZIP",
         .marks = {{zip, "", ".ifczip"}},
         .instead = "Unpack it and read the .ifc in it"},
        {.name = "7z", .marks = {{"7z\xBC\xAF"sv}}, .instead = unpack},
        {.name = "RAR", .marks = {{"Rar!"}}, .instead = unpack},
        {.name = "tar", .marks = {{"", "ustar", ".tar"}}, .instead = unpack},
        {.name = "bzip2", .marks = {{"BZh"}}, .instead = unpack},
        // weather, pictures, documents
        {.name = "EPW, weather data",
         .marks = {{"LOCATION,", "DESIGN CONDITIONS"}, {"LOCATION,", "", ".epw"}},
         .instead = noWeather},
        {.name = "EnergyPlus model (IDF)",
         .marks = {{"", "", ".idf"}},
         .instead = "Export the building as IFC or as a mesh"},
        {.name = "NetCDF", .marks = {{"CDF\1"sv}, {"CDF\2"sv}}, .instead = toRaster},
        {.name = "HDF5", .marks = {{"\x89HDF"sv}}, .instead = toRaster},
        {.name = "PNG, a picture", .marks = {{"\x89PNG"sv}}, .instead = toGeoTiff},
        {.name = "JPEG, a picture", .marks = {{"\xFF\xD8\xFF"sv}}, .instead = toGeoTiff},
        {.name = "JPEG 2000, a picture", .marks = {{"\0\0\0\x0CjP"sv}}, .instead = toGeoTiff},
        {.name = "PDF",
         .marks = {{"%PDF"}},
         .instead = "Export the drawing as DXF, or the buildings as footprints or a mesh"},

        // Read: maps
        {.name = "GeoPackage",
         .reader = maps,
         .endings = {".gpkg"},
         .driver = "GPKG",
         .opened = {"-wal", "-journal", "-shm"},
         .readsExtent = true},
        {.name = "GeoJSON",
         .reader = maps,
         .endings = {".geojson"},
         .json = JsonKind::geoJson,
         .driver = "GeoJSON"},
        {.name = "GeoJSON sequence",
         .reader = maps,
         .endings = {".geojsonl", ".geojsons"},
         .driver = "GeoJSONSeq",
         .reported = "GeoJSONSeq"},
        {.name = "Shapefile",
         .reader = maps,
         .endings = {".shp"},
         .marks = {{"\0\0\x27\x0a"sv}},
         .driver = "ESRI Shapefile",
         .companions = {".dbf", ".shx", ".prj", ".cpg"},
         .opened = {".shp", ".qix", ".sbn", ".sbx", ".idm", ".ind"},
         .readsExtent = true},
        {.name = "FlatGeobuf",
         .reader = maps,
         .endings = {".fgb"},
         .driver = "FlatGeobuf",
         .readsExtent = true},
        {.name = "GML", .reader = maps, .endings = {".gml"}, .driver = "GML", .companions = {".xsd", ".gfs"}},
        {.name = "OpenStreetMap",
         .reader = osmMaps,
         .endings = {".osm", ".pbf"},
         .begins = beginsOpenStreetMap,
         .driver = "OSM"},
        {.name = "KML", .reader = maps, .endings = {".kml"}, .driver = "KML"},
        {.name = "CSV", .reader = maps, .endings = {".csv"}, .driver = "CSV"},
        {.name = "TopoJSON", .reader = maps, .endings = {".topojson"}, .driver = "TopoJSON"},
        {.name = "Esri JSON",
         .reader = maps,
         .endings = {".json"},
         .driver = "ESRIJSON",
         .reported = "ESRIJSON"},
        {.name = "file geodatabase", .reader = maps, .driver = "OpenFileGDB", .readsExtent = true},
        // 3D city models
        {.name = "CityJSON", .reader = cities, .endings = {".json", ".jsonl"}, .json = JsonKind::cityJson},
        {.name = "CityGML",
         .reader = gmlCities,
         .endings = {".gml", ".citygml", ".xml"},
         .marks = {{"<", "www.opengis.net/citygml"}, {"<", "CityModel"}}},
        // archives
        {.name = "KMZ", .reader = archives, .endings = {".kmz"}, .marks = {{zip, "", ".kmz"}}},
        {.name = "ZIP", .reader = archives, .endings = {".zip"}, .marks = {{zip}}},
        {.name = "gzip", .reader = archives, .endings = {".gz"}, .marks = {{"\x1F\x8B"sv}}},
        // meshes
        {.name = "OBJ",
         .reader = meshes,
         .endings = {".obj"},
         .begins = beginsObj,
         .reported = "Wavefront OBJ"},
        {.name = "PLY", .reader = meshes, .endings = {".ply"}, .marks = {{"ply\n"}, {"ply\r"}}},
        {.name = "glTF",
         .reader = meshes,
         .endings = {".gltf"},
         .json = JsonKind::gltf,
         .companions = {".bin"}},
        {.name = "GLB", .reader = meshes, .endings = {".glb"}, .marks = {{"glTF"}}, .reported = "glTF"},
        {.name = "STL", .reader = meshes, .endings = {".stl"}, .begins = beginsStl},
        {.name = "COLLADA", .reader = meshes, .endings = {".dae"}, .marks = {{"<", "<COLLADA"}}},
        {.name = "IFC", .reader = meshes, .endings = {".ifc"}, .begins = beginsIfcFile},
        {.name = "DXF", .reader = meshes, .endings = {".dxf"}, .begins = beginsDxfFile},
        // terrain
        {.name = "GeoTIFF",
         .reader = terrains,
         .endings = {".tif", ".tiff"},
         .marks = {{"II*\0"sv}, {"MM\0*"sv}, {"II+\0"sv}, {"MM\0+"sv}},
         .driver = "GTiff",
         .companions = {".prj", ".tfw"},
         .opened = {".wld", ".aux", ".rrd", ".ovr", ".msk", ".aux.xml"},
         .isPicture = true},
        {.name = "Esri ASCII grid",
         .reader = terrains,
         .endings = {".asc"},
         .driver = "AAIGrid",
         .companions = {".prj", ".tfw"}},
        {.name = "GRASS ASCII grid", .reader = terrains, .endings = {".grd"}, .driver = "GRASSASCIIGrid"},
        {.name = "Erdas Imagine",
         .reader = terrains,
         .endings = {".img"},
         .driver = "HFA",
         .opened = {".ige", ".rrd"},
         .isPicture = true},
        {.name = "SRTM", .reader = terrains, .endings = {".hgt"}, .driver = "SRTMHGT", .headless = {".hgt"}},
        {.name = "USGS DEM", .reader = terrains, .endings = {".dem"}, .driver = "USGSDEM"},
        {.name = "DTED", .reader = terrains, .endings = {".dt0", ".dt1", ".dt2"}, .driver = "DTED"},
        {.name = "EHdr",
         .reader = terrains,
         .endings = {".bil", ".flt"},
         .driver = "EHdr",
         .companions = {".hdr", ".prj"},
         .opened = {".clr", ".stx"},
         .headless = {".bil", ".flt", ".raw"}},
        {.name = "XYZ", .reader = terrains, .endings = {".xyz"}, .driver = "XYZ"},
        {.name = "GeoPackage", .reader = terrains, .endings = {".gpkg"}, .driver = "GPKG"},
    };
    return formats;
}

}  // namespace noonmark
