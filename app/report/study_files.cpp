#include "app/report/study_files.h"

#include <QGuiApplication>

#include "app/report/cells_csv.h"
#include "app/report/map_picture.h"
#include "app/report/output_folder.h"
#include "app/report/study_report.h"
#include "core/io/write_raster.h"
#include "core/study/region_text.h"
#include "core/study/repeat_command.h"

namespace noonmark {

namespace {

Result<void> writeRaster(const Study& study, const std::filesystem::path& file) {
    return writeGeoTiff(file, study.city.frame, study.field.grid,
                        {{"gross shadow", "min/day", &study.field.grossMin},
                         {"continuous shadow", "min", &study.field.continuousMin}});
}

}  // namespace

Result<std::vector<std::filesystem::path>> writeStudyFiles(const Study& study,
                                                           const std::filesystem::path& folder,
                                                           const StudyFileOptions& options) {
    if (qGuiApp == nullptr) return failure("Pictures and reports need a QGuiApplication", folder.string());
    OutputFolder files(folder);
    files.add("shadow.tif", [&](const std::filesystem::path& file) { return writeRaster(study, file); });
    files.add("shadow.png", [&](QIODevice& device) {
        return mapPicture(study, ShadowMeasure::gross).save(&device, "PNG");
    });
    files.add("report.pdf", [&](QIODevice& device) { return writeReport(study, device); });
    files.add("study.json", textContent(studyJson(study)));
    if (!boxTextOf(study.settings.region, study.city.frame))
        files.add(regionFileName, textContent(regionGeoJson(study.settings.region, study.city.frame)));
    if (options.cellsCsv)
        files.add("cells.csv",
                  [&](QIODevice& device) { return writeCellsCsv(study.field, study.city.frame, device); });
    return std::move(files).result();
}

}  // namespace noonmark
