#include "app/window/files/file_dialogs.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "app/window/files/file_endings.h"
#include "scenarios/project/project_file.h"

namespace noonmark {

namespace {

QString tr(const char* text) { return QObject::tr(text); }

QString orAllFiles(const QString& name, const QStringList& endings) {
    return makeFileFilter(name, endings) + QStringLiteral(";;") + tr("All files (*)");
}

}  // namespace

QStringList askForCity(QWidget* parent) {
    return QFileDialog::getOpenFileNames(parent, tr("Open a project or a city"), {}, makeCityFilters());
}

QString askForProject(QWidget* parent, const QString& suggested) {
    const QString ending = QString::fromLatin1(projectEnding);
    QString file = QFileDialog::getSaveFileName(parent, tr("Save project as"), suggested,
                                                tr("Projects (*%1)").arg(ending), nullptr,
                                                QFileDialog::DontConfirmOverwrite);
    if (file.isEmpty()) return {};
    if (!file.endsWith(ending)) file += ending;
    if (!QFileInfo::exists(file)) return file;
    const auto answer = QMessageBox::question(
        parent, tr("Save project as"), tr("%1 already exists. Replace it?").arg(QFileInfo(file).fileName()));
    return answer == QMessageBox::Yes ? file : QString();
}

QString askForMesh(QWidget* parent) {
    return QFileDialog::getOpenFileName(parent, tr("Import a mesh as a building"), {},
                                        orAllFiles(tr("Meshes"), modelEndings()));
}

QString askForRegion(QWidget* parent) {
    return QFileDialog::getOpenFileName(parent, tr("Region from file"), {},
                                        orAllFiles(tr("Polygons"), vectorEndings()));
}

QStringList askForPlaces(QWidget* parent) {
    return QFileDialog::getOpenFileNames(parent, tr("Read places"), {},
                                         orAllFiles(tr("Maps and polygons"), vectorEndings()));
}

QString askForSky(QWidget* parent) {
    const QString file = QFileDialog::getSaveFileName(
        parent, tr("Save sun and sky"), QStringLiteral("sky.svg"),
        tr("Drawing (*.svg);;Picture (*.png);;Minutes by month and hour (*.csv)"));
    if (file.isEmpty() || !QFileInfo(file).suffix().isEmpty()) return file;
    return file + QStringLiteral(".svg");
}

QString askForPicture(QWidget* parent) {
    const QString file = QFileDialog::getSaveFileName(parent, tr("Save picture"),
                                                      QStringLiteral("noonmark.png"), tr("Pictures (*.png)"));
    if (file.isEmpty() || !QFileInfo(file).suffix().isEmpty()) return file;
    return file + QStringLiteral(".png");
}

QString askForMovie(QWidget* parent, const QString& suggested) {
    const QString file = QFileDialog::getSaveFileName(
        parent, tr("Export movie"), suggested + QStringLiteral(".mp4"), tr("Movies (*.mp4 *.gif)"));
    if (file.isEmpty() || !QFileInfo(file).suffix().isEmpty()) return file;
    return file + QStringLiteral(".mp4");
}

QString askForLogo(QWidget* parent) {
    return QFileDialog::getOpenFileName(parent, tr("Logo for the title block"), {},
                                        tr("Pictures (*.png *.jpg *.jpeg)"));
}

QString askForFolder(QWidget* parent, const QString& title) {
    return QFileDialog::getExistingDirectory(parent, title);
}

bool mayReplace(QWidget* parent, const QString& folder, const QStringList& files) {
    if (files.isEmpty()) return true;
    const auto answer =
        QMessageBox::question(parent, tr("Export"),
                              tr("%1 already contains these files: %2. Replace them?")
                                  .arg(QFileInfo(folder).fileName(), files.join(QStringLiteral(", "))));
    return answer == QMessageBox::Yes;
}

}  // namespace noonmark
