#include "core/io/pictures/ground_raster_file.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <ogr_spatialref.h>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/base/gdal_calls.h"
#include "core/describe/text.h"
#include "core/geo/crs.h"
#include "core/io/files/open_dataset.h"
#include "core/io/files/write_text.h"
#include "core/io/terrain/raster_place.h"

namespace noonmark {

namespace {

using Words = std::vector<std::string>;
constexpr const char* exportAdvice = "Export it as a GeoTIFF with its coordinate reference system";

char** listOf(const Words& words) {
    char** list = nullptr;
    for (const std::string& word : words) list = CSLAddString(list, word.c_str());
    return list;
}

// A raster of colours and where it lies.
struct Picture {
    DatasetPointer dataset;
    std::string crs;
    RasterPlace place;
};

Result<void> checkBands(GDALDataset& dataset, const std::string& file) {
    constexpr double maxCells = 2e10;
    const int bands = dataset.GetRasterCount();
    if (bands < 1) return failure("The raster holds no band", file);
    for (int i = 1; i <= std::min(bands, 4); ++i)
        if (dataset.GetRasterBand(i)->GetRasterDataType() != GDT_Byte)
            return failure("The raster is no picture: its bands are not of 8 bits", file,
                           "Choose an aerial photograph or a map, or export it with 8 bits per colour");
    if (double(dataset.GetRasterXSize()) * double(dataset.GetRasterYSize()) > maxCells)
        return failure(fmt::format("The raster has {} x {} pixels, more than {:g} million in all",
                                   dataset.GetRasterXSize(), dataset.GetRasterYSize(), maxCells / 1e6),
                       file, "Cut out the part around the city");
    return {};
}

Result<Picture> openPicture(const std::filesystem::path& path) {
    const std::string file = path.string();
    Picture picture;
    auto dataset = openDataset(path, DatasetContent::pictures);
    if (!dataset) return tl::make_unexpected(dataset.error());
    picture.dataset = *std::move(dataset);
    if (auto bands = checkBands(*picture.dataset, file); !bands) return tl::make_unexpected(bands.error());
    picture.crs = wktOf(picture.dataset->GetSpatialRef());
    if (picture.crs.empty())
        return failure("The raster has no coordinate reference system", file, exportAdvice);
    picture.place = {picture.dataset->GetRasterXSize(), picture.dataset->GetRasterYSize(), {}};
    if (picture.dataset->GetGeoTransform(picture.place.geoTransform.data()) != CE_None)
        return failure("The raster does not state its position", file, exportAdvice);
    return picture;
}

// The box of the raster's outline in local metres.
Box2 outlineBox(const Picture& picture, const PixelPlaces& places) {
    constexpr int steps = 20;
    std::vector<glm::dvec2> pixels;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j)
            pixels.emplace_back(double(picture.place.columns) * i / steps,
                                double(picture.place.rows) * j / steps);
    Box2 box;
    for (const glm::dvec2 place : places.local(pixels))
        if (!std::isnan(place.x)) box.add(glm::vec2(place));
    return box;
}

Grid gridWithin(const Box2& box, const GroundRasterSettings& settings) {
    const glm::dvec2 size(box.high - box.low);
    const double cell = std::max(settings.finestM, std::max(size.x, size.y) / settings.maxPixels);
    const auto count = [&](double side) {
        return std::clamp(int(std::ceil(side / cell)), 1, settings.maxPixels);
    };
    return {double(box.low.x), double(box.low.y), cell, count(size.x), count(size.y)};
}

bool isAlpha(GDALDataset& dataset, int band) {
    return dataset.GetRasterBand(band)->GetColorInterpretation() == GCI_AlphaBand;
}

// Red, green and blue, and the band of transparency if there is one, as a virtual raster.
Words colourWords(GDALDataset& dataset) {
    Words words{"-of", "VRT"};
    const int bands = dataset.GetRasterCount();
    if (dataset.GetRasterBand(1)->GetColorTable() != nullptr) {
        words.insert(words.end(), {"-expand", "rgba"});
        return words;
    }
    const bool grey = bands < 3;
    for (int colour = 1; colour <= 3; ++colour)
        words.insert(words.end(), {"-b", std::to_string(grey ? 1 : colour)});
    const int last = grey ? 2 : 4;
    if (bands >= last && isAlpha(dataset, last))
        words.insert(words.end(), {"-b", std::to_string(last), "-colorinterp_4", "alpha"});
    return words;
}

DatasetPointer takeColours(GDALDataset& dataset) {
    char** words = listOf(colourWords(dataset));
    GDALTranslateOptions* options = GDALTranslateOptionsNew(words, nullptr);
    CSLDestroy(words);
    DatasetPointer colours(
        GDALDataset::FromHandle(GDALTranslate("", GDALDataset::ToHandle(&dataset), options, nullptr)));
    GDALTranslateOptionsFree(options);
    return colours;
}

struct Watch {
    Progress& progress;
    const std::stop_token& stop;
    static int CPL_STDCALL report(double done, const char*, void* watch) {
        auto& self = *static_cast<Watch*>(watch);
        self.progress.report(done, NM_TEXT("reading the picture"));
        return self.stop.stop_requested() ? 0 : 1;
    }
};

DatasetPointer warp(GDALDataset& colours, const std::string& crs, const Frame& frame, const Grid& grid,
                    Watch& watch) {
    Words asked = makeWarpArguments(crs, frame.projString(), grid);
    asked.insert(asked.end(), {"-r", "bilinear", "-dstalpha"});
    char** words = listOf(asked);
    GDALWarpAppOptions* options = GDALWarpAppOptionsNew(words, nullptr);
    CSLDestroy(words);
    GDALWarpAppOptionsSetProgress(options, &Watch::report, &watch);
    GDALDatasetH source = GDALDataset::ToHandle(&colours);
    DatasetPointer warped(GDALDataset::FromHandle(GDALWarp("", nullptr, 1, &source, options, nullptr)));
    GDALWarpAppOptionsFree(options);
    return warped;
}

// GDAL begins in the north, the grid in the south.
bool copyPixels(GDALDataset& warped, GroundRaster& raster) {
    const Grid& grid = raster.grid;
    raster.rgba.resize(grid.size() * 4);
    const GSpacing row = GSpacing(grid.columns) * 4;
    std::uint8_t* last = raster.rgba.data() + std::size_t(grid.rows - 1) * std::size_t(row);
    return warped.GetRasterCount() == 4 &&
           warped.RasterIO(GF_Read, 0, 0, grid.columns, grid.rows, last, grid.columns, grid.rows, GDT_Byte, 4,
                           nullptr, 4, -row, 1, nullptr) == CE_None;
}

bool isSeen(const GroundRaster& raster) {
    for (std::size_t alpha = 3; alpha < raster.rgba.size(); alpha += 4)
        if (raster.rgba[alpha] != 0) return true;
    return false;
}

tl::unexpected<Error> farAway(const std::string& file) {
    return failure("The picture shows no ground of this city", file,
                   "Choose a picture of this place, or check its coordinate reference system");
}

Result<GroundRaster> read(const std::filesystem::path& path, const Frame& frame, const Box2& wanted,
                          const GroundRasterSettings& settings, Watch& watch) {
    const GdalCalls gdal(watch.stop);
    const std::string file = path.string();
    const Result<Picture> picture = openPicture(path);
    if (!picture) return tl::make_unexpected(picture.error());
    const Result<CrsToLonLat> crs = CrsToLonLat::of(picture->crs);
    if (!crs) return failure(crs.error().what, file, exportAdvice);
    const Box2 own = outlineBox(*picture, PixelPlaces(picture->place, *crs, frame));
    const Box2 box{glm::max(own.low, wanted.low), glm::min(own.high, wanted.high)};
    if (own.empty() || box.low.x >= box.high.x || box.low.y >= box.high.y) return farAway(file);
    GroundRaster raster{.grid = gridWithin(box, settings)};
    const DatasetPointer colours = takeColours(*picture->dataset);
    const DatasetPointer warped = colours ? warp(*colours, picture->crs, frame, raster.grid, watch) : nullptr;
    if (watch.stop.stop_requested()) return cancelled();
    if (!warped || gdal.failed() || !copyPixels(*warped, raster))
        return failure(fmt::format("The picture cannot be read ({})", gdal.why()), file,
                       "Check that it is complete, or export it again");
    if (!isSeen(raster)) return farAway(file);
    return raster;
}

}  // namespace

bool isGroundPicture(const std::filesystem::path& file) {
    const GdalCalls gdal;
    const auto dataset = openDataset(file, DatasetContent::pictures);
    if (!dataset || (*dataset)->GetRasterCount() < 1) return false;
    GDALRasterBand& first = *(*dataset)->GetRasterBand(1);
    return first.GetRasterDataType() == GDT_Byte &&
           ((*dataset)->GetRasterCount() >= 3 || first.GetColorTable() != nullptr);
}

Result<GroundRaster> readGroundRaster(const std::filesystem::path& file, const Frame& frame, const Box2& box,
                                      const GroundRasterSettings& settings, Progress& progress,
                                      const std::stop_token& stop) try {
    Watch watch{progress, stop};
    return read(file, frame, box, settings, watch);
} catch (const std::exception& exception) {
    return failure(fmt::format("The picture cannot be read ({})", exception.what()), file.string(),
                   "Export it again");
}

namespace {

GDALDatasetUniquePtr createPicture(const std::filesystem::path& file, const PlacedPicture& picture) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    if (driver == nullptr) return nullptr;
    CPLStringList options;
    for (const auto& [name, value] : {std::pair("TILED", "YES"),
                                      {"COMPRESS", "DEFLATE"},
                                      {"PREDICTOR", "2"},
                                      {"PHOTOMETRIC", "RGB"},
                                      {"ALPHA", "NON-PREMULTIPLIED"}})
        options.SetNameValue(name, value);
    return GDALDatasetUniquePtr(
        driver->Create(file.c_str(), picture.columns, picture.rows, 4, GDT_Byte, options.List()));
}

bool fill(GDALDataset& dataset, const PlacedPicture& picture) {
    const auto system = parseCrs(picture.crs);
    if (!system) return false;
    auto place = picture.geoTransform;
    if (!picture.attribution.empty())
        dataset.SetMetadataItem("TIFFTAG_COPYRIGHT", picture.attribution.c_str());
    auto* pixels = const_cast<std::uint8_t*>(picture.rgba.data());  // GDAL only reads through this pointer
    return dataset.SetSpatialRef(&*system) == CE_None && dataset.SetGeoTransform(place.data()) == CE_None &&
           dataset.RasterIO(GF_Write, 0, 0, picture.columns, picture.rows, pixels, picture.columns,
                            picture.rows, GDT_Byte, 4, nullptr, 4, GSpacing(picture.columns) * 4, 1,
                            nullptr) == CE_None;
}

}  // namespace

Result<void> writePicture(const std::filesystem::path& file, const PlacedPicture& picture) {
    const GdalCalls gdal;
    PendingFile pending(file);
    GDALDatasetUniquePtr dataset = createPicture(pending.path(), picture);
    const bool filled = dataset && fill(*dataset, picture);
    dataset.reset();  // flushes: a full disk is reported here
    if (!filled || gdal.failed())
        return limitReached("The picture could not be written: " + gdal.why(), file.string(),
                            "Check that the folder exists, is writable and has space");
    return pending.commit();
}

}  // namespace noonmark
