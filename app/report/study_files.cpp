#include "app/report/study_files.h"

#include <QFile>
#include <QGuiApplication>
#include <functional>

#include "app/report/cells_csv.h"
#include "app/report/map_picture.h"
#include "app/report/study_report.h"
#include "core/io/pending_file.h"
#include "core/io/write_raster.h"
#include "core/study/region_text.h"
#include "core/study/repeat_command.h"

namespace noonmark {

namespace {

using Write = std::function<bool(QIODevice&)>;

Result<void> notWritten(const std::filesystem::path& file, const QString& why) {
    return failure("The file could not be written: " + why.toStdString(), file.string(),
                   "Choose a folder that you may write to, and check that its disk has room");
}

/// Whole or not at all: written beside the target, then renamed.
Result<void> writeWhole(const std::filesystem::path& file, const Write& write) {
    PendingFile pending(file);
    QFile device(pending.path());
    if (!device.open(QIODevice::WriteOnly)) return notWritten(file, device.errorString());
    const bool written = write(device) && device.flush();
    if (!written || device.error() != QFileDevice::NoError) return notWritten(file, device.errorString());
    device.close();
    return pending.commit();
}

Write text(std::string content) {
    return [content = std::move(content)](QIODevice& device) {
        return device.write(content.data(), qint64(content.size())) == qint64(content.size());
    };
}

/// The files of one study, one after the other; after the first error nothing more is written.
class StudyFolder {
public:
    explicit StudyFolder(const std::filesystem::path& folder)
        : folder_(folder), state_(prepareStudyFolder(folder)) {}

    void add(const char* name, const Write& write) {
        add(name, [&](const std::filesystem::path& file) { return writeWhole(file, write); });
    }

    void add(const char* name, const std::function<Result<void>(const std::filesystem::path&)>& write) {
        if (!state_) return;
        state_ = write(folder_ / name);
        if (state_) files_.push_back(folder_ / name);
    }

    Result<std::vector<std::filesystem::path>> result() && {
        if (!state_) return tl::make_unexpected(std::move(state_).error());
        return std::move(files_);
    }

private:
    std::filesystem::path folder_;
    std::vector<std::filesystem::path> files_;
    Result<void> state_;
};

Result<void> writeRaster(const Study& study, const std::filesystem::path& file) {
    return writeGeoTiff(file, study.city.frame, study.field.grid,
                        {{"gross shadow", "min/day", &study.field.grossMin},
                         {"continuous shadow", "min", &study.field.continuousMin}});
}

}  // namespace

Result<void> prepareStudyFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || !std::filesystem::is_directory(folder, error))
        return failure("The folder could not be made" + (error ? ": " + error.message() : std::string()),
                       folder.string(), "Choose a folder that you may write to");
    const PendingFile trial(folder / "study.json");  // removed again
    if (QFile file(trial.path()); !file.open(QIODevice::WriteOnly))
        return notWritten(folder, file.errorString());
    return {};
}

Result<std::vector<std::filesystem::path>> writeStudyFiles(const Study& study,
                                                           const std::filesystem::path& folder,
                                                           const StudyFileOptions& options) {
    if (qGuiApp == nullptr) return failure("Pictures and reports need a QGuiApplication", folder.string());
    StudyFolder files(folder);
    files.add("shadow.tif", [&](const std::filesystem::path& file) { return writeRaster(study, file); });
    files.add("shadow.png", [&](QIODevice& device) {
        return mapPicture(study, ShadowMeasure::gross).save(&device, "PNG");
    });
    files.add("report.pdf", [&](QIODevice& device) { return writeReport(study, device); });
    files.add("study.json", text(studyJson(study)));
    if (!boxTextOf(study.settings.region, study.city.frame))
        files.add(regionFileName, text(regionGeoJson(study.settings.region, study.city.frame)));
    if (options.cellsCsv)
        files.add("cells.csv",
                  [&](QIODevice& device) { return writeCellsCsv(study.field, study.city.frame, device); });
    return std::move(files).result();
}

}  // namespace noonmark
