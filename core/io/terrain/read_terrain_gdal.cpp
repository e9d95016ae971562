#include <fmt/format.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/base/gdal_calls.h"
#include "core/describe/text.h"
#include "core/geo/crs.h"
#include "core/geo/frame.h"
#include "core/io/files/open_dataset.h"
#include "core/io/heights/height_text.h"
#include "core/io/pieces/read_part.h"
#include "core/io/settings/read_settings.h"
#include "core/io/terrain/raster_place.h"

namespace noonmark {

namespace {

// An open raster and its properties.
struct Source {
    GDALDatasetUniquePtr whole;    // the whole file if it has several bands; `dataset` then refers to it
    GDALDatasetUniquePtr dataset;  // of one band
    std::string file;
    std::string crs;
    CrsSource crsSource = CrsSource::file;
    std::array<double, 6> geoTransform{};
    double metresPerValue = 1;
    std::string noData;  // value to be taken as no data though the file does not say so; empty if none
    Warnings warnings;

    [[nodiscard]] GDALRasterBand& band() const { return *dataset->GetRasterBand(1); }
    void warn(WarningKind kind, std::string what) { warnings.push_back({kind, std::move(what), file}); }
    [[nodiscard]] RasterPlace place() const { return {band().GetXSize(), band().GetYSize(), geoTransform}; }
    [[nodiscard]] float metres(float value) const {
        return float((double(value) * band().GetScale() + band().GetOffset()) * metresPerValue);
    }
};

void keepFirstBand(Source& source) {
    source.warn(WarningKind::assumed, "the first of several bands is used as the elevation");
    char** words = nullptr;
    for (const char* word : {"-of", "VRT", "-b", "1"}) words = CSLAddString(words, word);
    GDALTranslateOptions* options = GDALTranslateOptionsNew(words, nullptr);
    CSLDestroy(words);
    source.whole = std::move(source.dataset);
    source.dataset.reset(GDALDataset::FromHandle(
        GDALTranslate("", GDALDataset::ToHandle(source.whole.get()), options, nullptr)));
    GDALTranslateOptionsFree(options);
}

Result<Source> openSource(const std::filesystem::path& file, const ReadSettings& settings) {
    Source source{.file = file.string()};
    auto dataset = openDataset(file, DatasetContent::elevations);
    if (!dataset) return tl::make_unexpected(dataset.error());
    source.dataset = *std::move(dataset);
    if (source.dataset->GetRasterCount() < 1) return failure("The raster holds no band", source.file);
    const bool picture =
        source.dataset->GetRasterCount() >= 3 && source.band().GetRasterDataType() == GDT_Byte;
    if (picture || source.band().GetColorTable() != nullptr)
        return failure("This raster is a picture, not elevations", source.file,
                       "Choose the elevation model itself");
    if (source.dataset->GetRasterCount() > 1) keepFirstBand(source);
    if (!source.dataset) return failure("The terrain's first band cannot be read", source.file);
    source.crs = wktOf(source.dataset->GetSpatialRef());
    if (source.crs.empty()) {
        source.crs = settings.crs.value_or("");
        source.crsSource = CrsSource::user;
    }
    if (source.crs.empty())
        return failure("The terrain has no coordinate reference system", source.file, crsAdvice());
    if (source.dataset->GetGeoTransform(source.geoTransform.data()) != CE_None)
        return failure("The raster does not state its position", source.file,
                       "Export it as a georeferenced GeoTIFF");
    return source;
}

// Grids in text have at least two bytes per cell; one of 500 bytes that claims 10^9 rows keeps GDAL busy for
// minutes. A raster must also not have so many cells that resampling it takes hours.
Result<void> checkCells(const Source& source) {
    constexpr double maxCells = 2e10;
    const double cells = double(source.band().GetXSize()) * double(source.band().GetYSize());
    if (cells > maxCells)
        return failure(fmt::format("The raster has {} x {} cells, more than {:g} million in all",
                                   source.band().GetXSize(), source.band().GetYSize(), maxCells / 1e6),
                       source.file, "Cut out the part around the city, or make its cells larger");
    const std::string driver = source.dataset->GetDriver()->GetDescription();
    if (driver != "AAIGrid" && driver != "GRASSASCIIGrid" && driver != "ISG") return {};
    std::error_code error;
    const auto bytes = std::filesystem::file_size(source.file, error);
    if (error || 2 * cells <= double(bytes) + 1) return {};
    return failure(fmt::format("The grid promises {} x {} cells, more than the file holds",
                               source.band().GetXSize(), source.band().GetYSize()),
                   source.file, "Export or download it again");
}

double metresOfUnitName(std::string name) {
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    const bool feet =
        name.find("ft") != name.npos || name.find("foot") != name.npos || name.find("feet") != name.npos;
    const bool us = name.find("us") != name.npos || name.find("survey") != name.npos;
    if (feet) return metresPer(us ? LengthUnit::usSurveyFeet : LengthUnit::feet);
    if (name == "cm" || name.starts_with("centim")) return 0.01;
    return name == "m" || name.starts_with("met") ? 1 : 0;
}

// The unit stated by the band, else by the vertical system, else by the user, else by the horizontal system.
void learnUnit(Source& source, const CrsToLonLat& crs, const ReadSettings& settings) {
    const std::string name = source.band().GetUnitType();
    source.metresPerValue = metresOfUnitName(name);
    if (source.metresPerValue > 0) return;
    source.metresPerValue = crs.metresPerElevationUnit();
    if (!name.empty()) source.warn(WarningKind::assumed, "unit \"" + name + "\" is not known");
    if (crs.elevationUnitIsStated()) return;
    if (settings.heightUnit) source.metresPerValue = metresPer(*settings.heightUnit);
    if (!settings.heightUnit && source.metresPerValue != 1)
        source.warn(WarningKind::assumed,
                    "elevations have no unit; the unit of the map, which is not metres, is assumed");
}

constexpr int sampleSide = 1000;

// The smallest overview that is large enough for a sample, else the band itself.
GDALRasterBand& thinnestBand(GDALRasterBand& band) {
    GDALRasterBand* thinnest = &band;
    for (int i = 0; i < band.GetOverviewCount(); ++i) {
        GDALRasterBand* overview = band.GetOverview(i);
        if (overview == nullptr || std::min(overview->GetXSize(), overview->GetYSize()) < sampleSide)
            continue;
        if (overview->GetXSize() < thinnest->GetXSize()) thinnest = overview;
    }
    return *thinnest;
}

// Row by row, since a single call for a huge raster cannot be stopped. Rows that cannot be read are missing.
std::vector<float> thinnedCopy(GDALRasterBand& band, const std::stop_token& stop) {
    const int columns = std::min(sampleSide, band.GetXSize());
    const int rows = std::min(sampleSide, band.GetYSize());
    std::vector<float> sample;
    auto line = std::vector<float>(std::size_t(columns));
    for (int i = 0; i < rows && !stop.stop_requested(); ++i) {
        const int row = int((i + 0.5) * band.GetYSize() / rows);
        if (band.RasterIO(GF_Read, 0, row, band.GetXSize(), 1, line.data(), columns, 1, GDT_Float32, 0, 0,
                          nullptr) != CE_None)
            break;
        sample.insert(sample.end(), line.begin(), line.end());
    }
    return sample;
}

// Finds values that commonly mean "no data", in a thinned copy, if the file does not state its value.
void learnNoData(Source& source, const std::stop_token& stop) {
    int stated = 0;
    source.band().GetNoDataValue(&stated);
    if (stated != 0 || (source.band().GetMaskFlags() & GMF_ALL_VALID) == 0) return;
    const std::vector<float> sample = thinnedCopy(thinnestBand(source.band()), stop);
    for (const float custom :
         {-9999.0F, -99999.0F, -32768.0F, -32767.0F, std::numeric_limits<float>::lowest()}) {
        if (std::find(sample.begin(), sample.end(), custom) == sample.end()) continue;
        source.noData = fmt::format("{:.9g}", custom);
        source.warn(
            WarningKind::assumed,
            fmt::format("cells with the value {:g} were taken as empty, though the file does not say so",
                        custom));
        return;
    }
}

using Options = std::unique_ptr<GDALWarpAppOptions, decltype(&GDALWarpAppOptionsFree)>;

Options warpOptions(const Source& source, const Grid& grid, bool coarser, GDALProgressFunc report,
                    void* reportTo, const std::string& target) {
    constexpr double offM = 0.05;  // tolerance for the position of a cell when GDAL resamples
    std::vector<std::string> words = makeWarpArguments(source.crs, target, grid);
    words.insert(words.end(), {"-r", coarser ? "average" : "bilinear", "-ot", "Float32", "-dstnodata", "nan",
                               "-et", fmt::format("{:.6f}", std::min(0.125, offM / grid.cellM))});
    if (!source.noData.empty()) words.insert(words.end(), {"-srcnodata", source.noData});
    char** list = nullptr;
    for (const std::string& word : words) list = CSLAddString(list, word.c_str());
    Options options(GDALWarpAppOptionsNew(list, nullptr), GDALWarpAppOptionsFree);
    CSLDestroy(list);
    if (options) GDALWarpAppOptionsSetProgress(options.get(), report, reportTo);
    return options;
}

struct Watcher {
    Progress& progress;
    std::stop_token stop;
    void reportReading(double done) const { progress.report(done, NM_TEXT("reading the terrain")); }
    static int CPL_STDCALL report(double done, const char*, void* watcher) {
        auto& self = *static_cast<Watcher*>(watcher);
        self.progress.report(done, NM_TEXT("resampling the terrain"));
        return self.stop.stop_requested() ? 0 : 1;
    }
};

// Elevations in metres above the datum, grid order; NaN where there are none. Empty if GDAL failed or was
// stopped.
std::vector<float> resample(Source& source, const Grid& grid, bool coarser, const std::string& target,
                            Watcher& watcher) {
    const Options options = warpOptions(source, grid, coarser, &Watcher::report, &watcher, target);
    GDALDatasetH handle = GDALDataset::ToHandle(source.dataset.get());
    const GDALDatasetUniquePtr warped(
        GDALDataset::FromHandle(GDALWarp("", nullptr, 1, &handle, options.get(), nullptr)));
    if (!warped) return {};
    std::vector<float> values(grid.size());
    const std::ptrdiff_t rowBytes = std::ptrdiff_t(sizeof(float)) * grid.columns;
    float* lastRow =
        values.data() + std::size_t(grid.rows - 1) * std::size_t(grid.columns);  // GDAL begins in the north
    if (warped->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, grid.columns, grid.rows, lastRow, grid.columns,
                                           grid.rows, GDT_Float32, sizeof(float), -rowBytes,
                                           nullptr) != CE_None)
        return {};
    for (float& value : values) value = source.metres(value);
    return values;
}

// Reads some rows of the raster, NaN where it has no data.
class RowReader {
public:
    explicit RowReader(Source& source)
        : source_(source), hasMask_((source.band().GetMaskFlags() & GMF_ALL_VALID) == 0) {
        if (!source.noData.empty()) noData_ = std::strtof(source.noData.c_str(), nullptr);
    }

    // Metres above the datum. False if GDAL failed.
    bool read(const PixelExtent& window, float* values) {
        GDALRasterBand& band = source_.band();
        if (band.RasterIO(GF_Read, window.column, window.row, window.columns, window.rows, values,
                          window.columns, window.rows, GDT_Float32, 0, 0, nullptr) != CE_None)
            return false;
        mask_.assign(window.size(), 255);
        if (hasMask_ && band.GetMaskBand()->RasterIO(GF_Read, window.column, window.row, window.columns,
                                                     window.rows, mask_.data(), window.columns, window.rows,
                                                     GDT_Byte, 0, 0, nullptr) != CE_None)
            return false;
        for (std::size_t i = 0; i < mask_.size(); ++i)
            values[i] = mask_[i] == 0 || values[i] == noData_ ? std::numeric_limits<float>::quiet_NaN()
                                                              : source_.metres(values[i]);
        return true;
    }

private:
    Source& source_;
    bool hasMask_;
    float noData_ = std::numeric_limits<float>::quiet_NaN();
    std::vector<unsigned char> mask_;
};

// The window's pixels in the order of the posts. Empty if GDAL failed or was stopped.
std::vector<float> savedElevations(Source& source, const TerrainGrid& place, const Watcher& watcher) {
    const PixelExtent& window = place.window;
    const auto columns = std::size_t(window.columns);
    const int rowsAtOnce = std::max(1, int((std::size_t(1) << 20) / columns));
    RowReader reader(source);
    std::vector<float> values(window.size()), strip;
    for (int row = 0; row < window.rows; row += rowsAtOnce) {
        if (watcher.stop.stop_requested()) return {};
        watcher.reportReading(double(row) / window.rows);
        const int rows = std::min(rowsAtOnce, window.rows - row);
        strip.resize(columns * std::size_t(rows));
        if (!reader.read({window.column, window.row + row, window.columns, rows}, strip.data())) return {};
        for (int i = 0; i < rows; ++i) {
            const int post = place.flipped ? window.rows - 1 - row - i : row + i;
            std::copy_n(strip.begin() + std::ptrdiff_t(columns) * i, columns,
                        values.begin() + std::ptrdiff_t(columns) * post);
        }
    }
    return values;
}

// Measures how far the resampled surface deviates from the raster's own posts, at up to 200 x 200 of them.
bool measureResampling(Source& source, const PixelPlaces& places, const Frame& frame,
                       const PixelExtent& window, Terrain& terrain) {
    constexpr int maximum = 200;
    RowReader reader(source);
    std::vector<float> values(std::size_t(window.columns));
    double squares = 0, count = 0;
    for (int row = 0; row < window.rows; row += std::max(1, window.rows / maximum)) {
        const PixelExtent one{window.column, window.row + row, window.columns, 1};
        if (!reader.read(one, values.data())) return false;
        std::vector<glm::dvec2> pixels;
        for (int column = 0; column < window.columns; column += std::max(1, window.columns / maximum))
            pixels.emplace_back(one.column + column + 0.5, one.row + 0.5);
        const std::vector<glm::dvec2> local = places.local(pixels);
        for (std::size_t i = 0; i < local.size(); ++i) {
            const float value = values[std::size_t(pixels[i].x) - std::size_t(one.column)];
            if (std::isnan(local[i].x) || !(value > -500 && value < 9000) ||
                beyondM(terrain.grid, local[i]) > 0)
                continue;
            const double off = std::abs(double(value) - frame.originElevationM() - earthDropM(local[i]) -
                                        double(elevationAt(terrain, local[i])));
            squares += off * off;
            ++count;
            terrain.source.heightMaxM = std::max(terrain.source.heightMaxM, off);
        }
    }
    terrain.source.heightRmsM = count > 0 ? std::sqrt(squares / count) : 0;
    return true;
}

Result<std::vector<float>> elevationsOf(Source& source, const TerrainGrid& place, Watcher& watcher,
                                        const GdalCalls& gdal) {
    std::vector<float> elevations = place.resampledTo ? resample(source, *place.resampledTo, place.coarser(),
                                                                 place.frame.projString(), watcher)
                                                      : savedElevations(source, place, watcher);
    if (watcher.stop.stop_requested()) return cancelled();
    if (elevations.empty())
        return failure(fmt::format("The terrain cannot be read ({})", gdal.why()), source.file,
                       "Export it as a GeoTIFF");
    return elevations;
}

Result<FilePiece> read(const std::filesystem::path& file, const ReadSettings& settings, Progress& progress,
                       const std::stop_token& stop) {
    const GdalCalls gdal(stop);
    Result<Source> source = openSource(file, settings);
    if (!source) return tl::make_unexpected(source.error());
    const Result<CrsToLonLat> crs = CrsToLonLat::of(source->crs);
    if (!crs) return failure(crs.error().what, source->file, crsAdvice());
    learnUnit(*source, *crs, settings);
    if (const auto whole = checkCells(*source); !whole) return tl::make_unexpected(whole.error());
    learnNoData(*source, stop);
    if (stop.stop_requested()) return cancelled();
    const RasterPlace raster = source->place();
    const Result<TerrainGrid> place = makeTerrainGrid(raster, *crs, settings, source->file);
    if (!place) return tl::make_unexpected(place.error());
    source->warnings.insert(source->warnings.end(), place->warnings.begin(), place->warnings.end());
    Watcher watcher{progress, stop};
    Result<std::vector<float>> elevations = elevationsOf(*source, *place, watcher, gdal);
    if (!elevations) return tl::make_unexpected(elevations.error());
    FilePiece piece{.warnings = std::move(source->warnings),
                    .format = source->dataset->GetDriver()->GetMetadataItem(GDAL_DMD_LONGNAME),
                    .crs = describeCrs(crs->name(), source->crsSource)};
    if (const auto finished = finishTerrain(*place, *std::move(elevations), settings, source->file, piece);
        !finished)
        return tl::make_unexpected(finished.error());
    if (stop.stop_requested()) return cancelled();  // gaps may be left
    if (!place->resampledTo) return piece;
    auto terrain = std::make_shared<Terrain>(*piece.terrain);
    const Frame frame = settings.frame.value_or(piece.frame.value_or(place->frame));
    if (!measureResampling(*source, PixelPlaces(raster, *crs, frame), frame, place->window, *terrain))
        return failure(fmt::format("The terrain cannot be read ({})", gdal.why()), source->file,
                       "Export it as a GeoTIFF");
    piece.terrain = std::move(terrain);
    return piece;
}

}  // namespace

Result<FilePiece> readTerrain(const std::filesystem::path& file, const ReadSettings& settings,
                              Progress& progress, std::stop_token stop) try {
    return read(file, settings, progress, stop);
} catch (const std::exception& exception) {
    return failure(fmt::format("The terrain cannot be read ({})", exception.what()), file.string(),
                   "Export it again");
}

}  // namespace noonmark
