#include "app/gui/base/files/file_dialogs.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QObject>
#include <QUrl>
#include <algorithm>

#include "core/io/files/check_output.h"
#include "scenarios/project/project_file.h"

namespace noonmark {

namespace {

QStringList withoutDots(const std::vector<std::string_view>& endings) {
    QStringList list;
    for (const std::string_view ending : endings)
        list += QString::fromLatin1(ending.data(), qsizetype(ending.size())).mid(1);
    return list;
}

}  // namespace

QStringList endingsOf(std::initializer_list<FileKind> kinds) { return withoutDots(listEndings(kinds)); }

QStringList pictureEndings() {
    QStringList endings;
    for (const Format& format : coreFormats())
        if (format.isPicture) endings += withoutDots(format.endings);
    return endings;
}

QString withoutEndings(QString name) {
    const QStringList endings =
        endingsOf({FileKind::footprints, FileKind::terrain, FileKind::cityJson, FileKind::mesh});
    const auto chop = [&name](const QString& ending) {
        const qsizetype length = ending.size() + 1;
        if (name.size() <= length || !name.endsWith(QLatin1Char('.') + ending, Qt::CaseInsensitive))
            return false;
        name.chop(length);
        return true;
    };
    while (std::ranges::any_of(endings, chop)) {
    }
    return name;
}

QString makeFileFilter(const QString& name, const QStringList& endings) {
    QStringList patterns;
    for (const QString& ending : endings) patterns += QStringLiteral("*.") + ending;
    return QStringLiteral("%1 (%2)").arg(name, patterns.join(u' '));
}

QString makeCityFilters() {
    const QString project = QString::fromLatin1(projectEnding).mid(1);
    const QStringList maps = endingsOf({FileKind::footprints}), terrain = endingsOf({FileKind::terrain}),
                      models = endingsOf({FileKind::cityJson, FileKind::mesh});
    QStringList all = QStringList{project} + maps + models + terrain;
    all.removeDuplicates();
    return QStringList{makeFileFilter(QObject::tr("Projects, cities and terrain"), all),
                       makeFileFilter(QObject::tr("Projects"), {project}),
                       makeFileFilter(QObject::tr("Footprints"), maps),
                       makeFileFilter(QObject::tr("3D models and meshes"), models),
                       makeFileFilter(QObject::tr("Terrain"), terrain),
                       QObject::tr("All files (*)")}
        .join(QStringLiteral(";;"));
}

namespace {

QString orAllFiles(const QString& name, const QStringList& endings) {
    return makeFileFilter(name, endings) + QStringLiteral(";;") + QObject::tr("All files (*)");
}

}  // namespace

QStringList askForCity(QWidget* parent) {
    return QFileDialog::getOpenFileNames(parent, QObject::tr("Open a project or a city"), {},
                                         makeCityFilters());
}

QString askForProject(QWidget* parent, const QString& suggested) {
    const QString ending = QString::fromLatin1(projectEnding);
    QString file = QFileDialog::getSaveFileName(parent, QObject::tr("Save project as"), suggested,
                                                QObject::tr("Projects (*%1)").arg(ending), nullptr,
                                                QFileDialog::DontConfirmOverwrite);
    if (file.isEmpty()) return {};
    if (!file.endsWith(ending)) file += ending;
    if (!QFileInfo::exists(file)) return file;
    const auto answer =
        QMessageBox::question(parent, QObject::tr("Save project as"),
                              QObject::tr("%1 already exists. Replace it?").arg(QFileInfo(file).fileName()));
    return answer == QMessageBox::Yes ? file : QString();
}

QString askForMesh(QWidget* parent) {
    return QFileDialog::getOpenFileName(
        parent, QObject::tr("Import a mesh as a building"), {},
        orAllFiles(QObject::tr("Meshes"), endingsOf({FileKind::cityJson, FileKind::mesh})));
}

QString askForRegion(QWidget* parent) {
    return QFileDialog::getOpenFileName(
        parent, QObject::tr("Region from file"), {},
        orAllFiles(QObject::tr("Polygons"), endingsOf({FileKind::footprints})));
}

QString askForPhotograph(QWidget* parent) {
    return QFileDialog::getOpenFileName(
        parent, QObject::tr("Aerial photograph"), {},
        orAllFiles(QObject::tr("Pictures with a position"), pictureEndings()));
}

QString askWhereToSavePhotograph(QWidget* parent) {
    const QString file =
        QFileDialog::getSaveFileName(parent, QObject::tr("Save the tiles as a photograph"),
                                     QStringLiteral("photograph.tif"), QObject::tr("GeoTIFF (*.tif)"));
    if (file.isEmpty() || !QFileInfo(file).suffix().isEmpty()) return file;
    return file + QStringLiteral(".tif");
}

QString askForGlazing(QWidget* parent) {
    return QFileDialog::getOpenFileName(
        parent, QObject::tr("Windows from file"), {},
        orAllFiles(QObject::tr("Points and polygons"), endingsOf({FileKind::footprints})));
}

QString askForPoints(QWidget* parent) {
    return QFileDialog::getOpenFileName(
        parent, QObject::tr("Points from file"), {},
        orAllFiles(QObject::tr("Tables of points"), {QStringLiteral("csv"), QStringLiteral("txt")}));
}

QStringList askForPlaces(QWidget* parent, const QString& folder) {
    return QFileDialog::getOpenFileNames(
        parent, QObject::tr("Read places"), folder,
        orAllFiles(QObject::tr("Maps and polygons"), endingsOf({FileKind::footprints})));
}

QString askForSky(QWidget* parent) {
    const QString file = QFileDialog::getSaveFileName(
        parent, QObject::tr("Save sun and sky"), QStringLiteral("sky.svg"),
        QObject::tr("Drawing (*.svg);;Picture (*.png);;Minutes by month and hour (*.csv)"));
    if (file.isEmpty() || !QFileInfo(file).suffix().isEmpty()) return file;
    return file + QStringLiteral(".svg");
}

QString askForTable(QWidget* parent, const QString& suggested) {
    const QString file = QFileDialog::getSaveFileName(parent, QObject::tr("Save table"), suggested,
                                                      QObject::tr("Tables (*.csv)"));
    if (file.isEmpty() || !QFileInfo(file).suffix().isEmpty()) return file;
    return file + QStringLiteral(".csv");
}

QString askForPicture(QWidget* parent) {
    const QString file = QFileDialog::getSaveFileName(
        parent, QObject::tr("Save picture"), QStringLiteral("noonmark.png"), QObject::tr("Pictures (*.png)"));
    if (file.isEmpty() || !QFileInfo(file).suffix().isEmpty()) return file;
    return file + QStringLiteral(".png");
}

QString askForMovie(QWidget* parent, const QString& suggested) {
    const QString file =
        QFileDialog::getSaveFileName(parent, QObject::tr("Export movie"), suggested + QStringLiteral(".mp4"),
                                     QObject::tr("Movies (*.mp4 *.gif)"));
    if (file.isEmpty() || !QFileInfo(file).suffix().isEmpty()) return file;
    return file + QStringLiteral(".mp4");
}

QString askForBuildings(QWidget* parent, const QString& suggested, const QString& formats) {
    return QFileDialog::getSaveFileName(parent, QObject::tr("Export buildings"), suggested, formats);
}

QString askForLogo(QWidget* parent) {
    return QFileDialog::getOpenFileName(parent, QObject::tr("Logo for the title block"), {},
                                        QObject::tr("Pictures (*.png *.jpg *.jpeg)"));
}

QString askForFolder(QWidget* parent, const QString& title) {
    return QFileDialog::getExistingDirectory(parent, title);
}

QStringList listDroppedFiles(const QMimeData& dropped) {
    QStringList files;
    for (const QUrl& url : dropped.urls())
        if (url.isLocalFile()) files << url.toLocalFile();
    return files;
}

QStringList listExistingFiles(const QString& folder, const std::vector<std::string>& files) {
    QStringList there;
    for (const std::string& name : findExistingOutputs(folder.toStdString(), files))
        there << QString::fromStdString(name);
    return there;
}

bool mayReplace(QWidget* parent, const QString& folder, const QStringList& files) {
    if (files.isEmpty()) return true;
    const auto answer =
        QMessageBox::question(parent, QObject::tr("Export"),
                              QObject::tr("%1 already contains these files: %2. Replace them?")
                                  .arg(QFileInfo(folder).fileName(), files.join(QStringLiteral(", "))));
    return answer == QMessageBox::Yes;
}

}  // namespace noonmark
