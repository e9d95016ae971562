#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "core/base/gdal_calls.h"
#include "core/base/stop_scope.h"
#include "core/io/files/geopackage_check.h"
#include "core/io/files/open_dataset.h"
#include "core/io/files/plain_file.h"
#include "core/io/formats/format.h"

namespace noonmark {

namespace {

namespace fs = std::filesystem;
constexpr const char* mapDriver = "GTiff";

FileKind kindOf(DatasetContent content) {
    return content == DatasetContent::vectors ? FileKind::footprints : FileKind::terrain;
}

// A raster that Noonmark wrote is a GeoTIFF.
bool mayHold(const Format& format, DatasetContent content) {
    if (!format.isRead() || format.reader.kind != kindOf(content)) return false;
    if (content == DatasetContent::maps) return format.driver == mapDriver;
    return !format.driver.empty() && (content != DatasetContent::pictures || format.isPicture);
}

CPLStringList driversOf(DatasetContent content) {
    CPLStringList drivers;
    for (const Format& format : coreFormats())
        if (mayHold(format, content)) drivers.AddString(std::string(format.driver).c_str());
    return drivers;
}

std::string adviceOf(DatasetContent content) {
    if (content != DatasetContent::vectors) return "Export it as a GeoTIFF";
    return "Export it in a format that is read: " + listNames({FileKind::footprints});
}

unsigned flagsOf(DatasetContent content) {
    return content == DatasetContent::vectors ? GDAL_OF_VECTOR : GDAL_OF_RASTER;
}

// Shapefiles and file geodatabases may be folders. Reading a pipe among their files would block for ever.
Result<void> checkFolder(const fs::path& folder) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (!entry->is_regular_file(error) && !entry->is_directory(error))
            return failure("The folder holds a pipe or a device", entry->path().string(), "Remove it");
    if (!error) return {};
    return failure("The folder cannot be read: " + error.message(), folder.string());
}

std::string inCapitals(std::string text) {
    for (char& letter : text) letter = char(std::toupper(static_cast<unsigned char>(letter)));
    return text;
}

// Whatever GDAL may open beside a file: the same name with another ending, or with one more.
std::vector<fs::path> companionsOf(const fs::path& file) {
    std::vector<fs::path> companions;
    const auto add = [&](const std::string& ending) {
        companions.push_back(fs::path(file).replace_extension(ending));
        companions.emplace_back(file.string() + ending);
    };
    for (const Format& format : coreFormats())
        for (const auto* endings : {&format.companions, &format.opened})
            for (const std::string_view ending : *endings)
                add(std::string(ending)), add(inCapitals(std::string(ending)));
    return companions;
}

Result<void> checkCompanions(const fs::path& file) {
    for (const fs::path& companion : companionsOf(file)) {
        std::error_code error;
        const fs::file_status status = fs::status(companion, error);
        if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
            return failure("A file beside it is a pipe or a device", companion.string(), "Remove it");
    }
    return {};
}

Result<void> checkOnDisk(const fs::path& file, DatasetContent content) {
    std::error_code error;
    if (content == DatasetContent::vectors && fs::is_directory(file, error)) return checkFolder(file);
    return checkPlainFile(file).and_then([&] { return checkCompanions(file); });
}

// XML that refers GDAL to data elsewhere: in other files, in databases, on servers.
bool isVirtual(const fs::path& file) {
    const std::string head = readFileHead(file).bytes;
    constexpr std::array roots{"<VRTDataset", "<OGRVRTDataSource", "<OGRVRTLayer",      "<GDAL_WMS",
                               "<WCS_GDAL",   "<GDAL_WMTS",        "<OGRWFSDataSource", "<WMS_",
                               "<WMT_MS",     "<Capabilities"};
    return std::ranges::any_of(roots, [&](const char* root) { return head.find(root) != head.npos; });
}

bool isGeoPackage(GDALDataset& dataset) { return dataset.GetDriverName() == std::string_view("GPKG"); }

bool lacksShapeIndex(const fs::path& file) {
    std::error_code error;
    const auto has = [&](const char* ending) {
        return fs::exists(fs::path(file).replace_extension(ending), error);
    };
    return (file.extension() == ".shp" || file.extension() == ".SHP") && !has(".shx") && !has(".SHX");
}

tl::unexpected<Error> notOpened(const fs::path& file, DatasetContent content, const std::string& why) {
    if (isVirtual(file))
        return failure("It is a virtual dataset: it holds no data, and names files, databases or addresses",
                       file.string(), adviceOf(content));
    if (lacksShapeIndex(file))
        return failure("Its index is missing: the file of the same name that ends in .shx", file.string(),
                       "Copy it beside it, or open the .shp in QGIS and save it as GeoPackage");
    if (why.empty())
        return unsupported("It is of no format that is read here", file.string(), adviceOf(content));
    return failure(fmt::format("It cannot be read ({})", why), file.string(),
                   "Check that it is complete, or export it again");
}

// A block is read whole, and its memory taken before GDAL sees that the file ends.
Result<void> checkBlock(GDALRasterBand& band, int bandsTogether, const std::string& file) {
    constexpr double maxBytes = 256.0 * (1 << 20);
    int columns = 0, rows = 0;
    band.GetBlockSize(&columns, &rows);
    const double bytes = double(columns) * rows * GDALGetDataTypeSizeBytes(band.GetRasterDataType());
    if (bytes * bandsTogether <= maxBytes) return {};
    return limitReached(fmt::format("The raster is stored in blocks of {} x {} cells, more than {:g} MB each",
                                    columns, rows, maxBytes / (1 << 20)),
                        file, "Export it with tiles of 256 x 256 or 512 x 512 cells");
}

// The band itself, its overviews and its mask.
Result<void> checkBlocks(GDALRasterBand& band, int bandsTogether, const std::string& file) {
    auto checked = checkBlock(band, bandsTogether, file);
    for (int i = 0; checked && i < band.GetOverviewCount(); ++i)
        if (GDALRasterBand* overview = band.GetOverview(i))
            checked = checkBlock(*overview, bandsTogether, file);
    if (checked && (band.GetMaskFlags() & GMF_ALL_VALID) == 0)
        checked = checkBlock(*band.GetMaskBand(), 1, file);
    return checked;
}

Result<void> checkRaster(GDALDataset& dataset, const std::string& file) {
    constexpr int maxBands = 1000;
    const int bands = dataset.GetRasterCount();
    if (bands > maxBands)
        return limitReached(fmt::format("The raster has {} bands, more than {}", bands, maxBands), file,
                            "Export the band of elevations alone");
    const char* order = dataset.GetMetadataItem("INTERLEAVE", "IMAGE_STRUCTURE");
    const int together = order != nullptr && order == std::string_view("PIXEL") ? bands : 1;
    for (int i = 1; i <= bands; ++i)
        if (auto checked = checkBlocks(*dataset.GetRasterBand(i), together, file); !checked) return checked;
    return {};
}

// Limits that are checked before the memory or the time is spent.
Result<void> checkLimits(GDALDataset& dataset, DatasetContent content, const std::string& file) {
    if (void* database = dataset.GetInternalHandle("SQLITE_HANDLE");
        isGeoPackage(dataset) && database != nullptr)
        limitGeoPackage(database);
    if (content != DatasetContent::vectors) return checkRaster(dataset, file);
    if (dataset.GetLayerCount() <= maxLayers) return {};
    return limitReached(fmt::format("It has {} layers, more than {}", dataset.GetLayerCount(), maxLayers),
                        file, "Export the layers of buildings alone");
}

// The column of a table whose first value is the outline of a polygon, whatever it is called. Empty where
// none is, or where a text before it makes columns hard to count.
std::string findOutlineColumn(const fs::path& file) {
    const std::string head = readFileHead(file).bytes;
    const std::size_t end = head.find('\n');
    if (end == head.npos) return {};
    const std::string_view names = std::string_view(head).substr(0, end);
    std::string_view row = std::string_view(head).substr(end + 1);
    row = row.substr(0, row.find('\n'));
    std::string_view before = row.substr(0, std::min(row.find("POLYGON"), row.find("MULTIPOLYGON")));
    if (before.size() == row.size()) return {};
    if (before.ends_with('"')) before.remove_suffix(1);
    if (before.find('"') != before.npos) return {};
    const char divider = names.find(';') != names.npos ? ';' : names.find('\t') != names.npos ? '\t' : ',';
    std::string_view rest = names;
    for (auto columns = std::ranges::count(before, divider); columns > 0; --columns) {
        const std::size_t next = rest.find(divider);
        if (next == rest.npos) return {};
        rest.remove_prefix(next + 1);
    }
    std::string name(rest.substr(0, rest.find_first_of("\r;\t,")));
    std::erase(name, '"');
    return name;
}

// Options so that nothing is written or fetched, no code from the file runs, and a file that nobody is
// writing to is not locked.
CPLStringList optionsFor(std::string_view driver, const fs::path& file) {
    CPLStringList options;
    if (driver == "GML") {
        options.AddString("WRITE_GFS=NO");
        options.AddString("DOWNLOAD_SCHEMA=NO");
    }
    if (driver == "CSV")  // besides WKT, as GDAL calls it
        options.AddString(("GEOM_POSSIBLE_NAMES=WKT,geom,geometry,the_geom,wkt_geom,geom_wkt,wkb_geometry,"
                           "shape,polygon,geo_"
                           "shape," +
                           findOutlineColumn(file))
                              .c_str());
    if (driver == "GPKG") {
        options.AddString("LIST_ALL_TABLES=NO");
        options.AddString("PRELUDE_STATEMENTS=PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON");
        if (!isBeingWritten(file)) options.AddString("IMMUTABLE=YES");
    }
    return options;
}

}  // namespace

Result<DatasetPointer> openDataset(const fs::path& given, DatasetContent content) {
    // An absolute path cannot be mistaken for a connection, such as "PG:dbname=..." or "WMS:http://...".
    std::error_code error;
    const fs::path file = fs::absolute(given, error);
    if (error || file.native().starts_with("/vsi"))
        return failure("It is not a file that can be opened", given.string());
    if (auto plain = checkOnDisk(file, content); !plain) return tl::make_unexpected(plain.error());
    if (auto known = refuseForeignFormat(file); !known) return tl::make_unexpected(known.error());
    const GdalFolderScope folder(fs::is_directory(file, error) ? file : file.parent_path());
    CPLErrorReset();
    GDALDriverH found =
        GDALIdentifyDriverEx(file.c_str(), flagsOf(content), driversOf(content).List(), nullptr);
    if (StopScope::isStopped()) return cancelled();
    if (found == nullptr) return notOpened(given, content, CPLGetLastErrorMsg());
    const char* const driver[] = {GDALGetDescription(found), nullptr};
    if (driver[0] == std::string_view("GPKG"))
        if (auto harmless = checkGeoPackage(file); !harmless) return tl::make_unexpected(harmless.error());
    const CPLStringList options = optionsFor(driver[0], file);
    DatasetPointer dataset(GDALDataset::Open(
        file.c_str(), flagsOf(content) | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, driver, options.List()));
    if (StopScope::isStopped()) return cancelled();
    if (!dataset) return notOpened(given, content, CPLGetLastErrorMsg());
    return checkLimits(*dataset, content, given.string()).map([&] { return std::move(dataset); });
}

bool isUnknownFormat(const Error& error) { return error.kind == ErrorKind::unsupported; }

Result<DatasetPointer> openMapInMemory(const std::string& name) {
    const char* const drivers[] = {mapDriver, nullptr};
    DatasetPointer dataset(
        GDALDataset::Open(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, drivers));
    if (!dataset) return failure(fmt::format("It cannot be read ({})", CPLGetLastErrorMsg()), name);
    return dataset;
}

}  // namespace noonmark
