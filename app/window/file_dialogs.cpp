#include "app/window/file_dialogs.h"

#include <QFileDialog>
#include <QFileInfo>

namespace noonmark {

namespace {

QString tr(const char* text) { return QObject::tr(text); }

}  // namespace

QStringList askForCity(QWidget* parent) {
    return QFileDialog::getOpenFileNames(parent, tr("Open a city"), {},
                                         tr("Cities and terrain (*.geojson *.json *.gpkg *.shp *.osm *.pbf "
                                            "*.jsonl *.obj *.ply *.gltf *.glb *.tif "
                                            "*.tiff *.asc *.vrt);;All files (*)"));
}

QString askForRegion(QWidget* parent) {
    return QFileDialog::getOpenFileName(parent, tr("Region from the polygons of a file"), {},
                                        tr("Polygons (*.geojson *.json *.gpkg *.shp *.kml);;All files (*)"));
}

QString askForPicture(QWidget* parent) {
    const QString file = QFileDialog::getSaveFileName(parent, tr("Save picture"),
                                                      QStringLiteral("noonmark.png"), tr("Pictures (*.png)"));
    if (file.isEmpty() || !QFileInfo(file).suffix().isEmpty()) return file;
    return file + QStringLiteral(".png");
}

QString askForFolder(QWidget* parent) {
    return QFileDialog::getExistingDirectory(parent, tr("Export study into a folder"));
}

}  // namespace noonmark
