#include "app/window/workbench.h"

#include <QFileInfo>

#include "app/report/study_files.h"

namespace noonmark {

namespace {

using Paths = std::vector<std::filesystem::path>;

std::vector<std::string> textsOf(const QStringList& files) {
    std::vector<std::string> texts;
    for (const QString& file : files) texts.push_back(file.toStdString());
    return texts;
}

}  // namespace

Workbench::Workbench(QObject* parent) : QObject(parent) {
    connect(&running_, &JobSlot::started, this,
            [this](const Job& job) { connect(&job, &Job::partial, this, &Workbench::studyPartial); });
}

void Workbench::open(const QStringList& files, const ReadSettings& reading) {
    if (files.isEmpty()) return;
    running_.cancel();
    opening_.start<OpenCity>(
        tr("Opening %1").arg(QFileInfo(files.front()).fileName()),
        [files = textsOf(files), reading](Progress& progress, std::stop_token stop) {
            return openCity(files, reading, progress, std::move(stop));
        },
        [this](Result<OpenCity> opened) { takeCity(std::move(opened)); });
}

void Workbench::takeCity(Result<OpenCity> opened) {
    if (!opened) {
        if (!isCancelled(opened.error())) Q_EMIT openFailed(opened.error());
        return;
    }
    running_.drop();  // its question was about the city before
    city_ = std::make_shared<const OpenCity>(*std::move(opened));
    study_.reset();
    document_.reset(firstSettings(city_->loaded));
    Q_EMIT cityOpened();
}

void Workbench::run() {
    if (!city_) return tell({"There is no city yet", {}, "Open a file or a sample first"});
    running_.start<Study>(
        tr("Study"),
        [city = city_, settings = document_.settings()](Progress& progress, std::stop_token stop) {
            return studyOf(city->loaded, settings, progress, std::move(stop));
        },
        [this](Result<Study> study) { takeStudy(std::move(study)); });
}

void Workbench::takeStudy(Result<Study> study) {
    if (!study) {
        Q_EMIT studyStopped(isCancelled(study.error()));
        return tell(study.error());
    }
    study_ = std::make_shared<const Study>(*std::move(study));
    Q_EMIT studyDone();
}

void Workbench::exportStudy(const std::filesystem::path& folder) {
    if (!study_) return tell({"There is no study to export yet", {}, "Press Run first"});
    writing_.start<Paths>(
        tr("Writing"),
        [study = study_, folder](Progress&, std::stop_token) {
            return writeStudyFiles(*study, folder, {.cellsCsv = true});
        },
        [this, folder](Result<Paths> paths) {
            if (!paths) return tell(paths.error());
            Q_EMIT noted(tr("%1 files written into %2")
                             .arg(paths->size())
                             .arg(QString::fromStdString(folder.string())));
        });
}

void Workbench::tell(const Error& error) {
    if (!isCancelled(error)) Q_EMIT failed(error);
}

}  // namespace noonmark
