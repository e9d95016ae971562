#include "app/gui/base/files/file_endings.h"

#include <QObject>

#include "scenarios/project/project_file.h"

namespace noonmark {

namespace {

QStringList listOf(const char* endings) { return QString::fromLatin1(endings).split(u' '); }

}  // namespace

const QStringList& vectorEndings() {
    static const QStringList endings =
        listOf("osm pbf geojson geojsonl geojsons json topojson gpkg shp fgb gml kml csv");
    return endings;
}

const QStringList& modelEndings() {
    static const QStringList endings = listOf("json jsonl obj ply gltf glb ifc dxf");
    return endings;
}

const QStringList& massEndings() {
    static const QStringList endings = listOf("obj ply gltf glb ifc dxf");
    return endings;
}

const QStringList& terrainEndings() {
    static const QStringList endings = listOf("tif tiff asc grd img hgt dem dt0 dt1 dt2 bil flt xyz gpkg");
    return endings;
}

QString makeFileFilter(const QString& name, const QStringList& endings) {
    QStringList patterns;
    for (const QString& ending : endings) patterns += QStringLiteral("*.") + ending;
    return QStringLiteral("%1 (%2)").arg(name, patterns.join(u' '));
}

QString makeCityFilters() {
    const QString project = QString::fromLatin1(projectEnding).mid(1);
    QStringList all = QStringList{project} + vectorEndings() + modelEndings() + terrainEndings();
    all.removeDuplicates();
    return QStringList{makeFileFilter(QObject::tr("Projects, cities and terrain"), all),
                       makeFileFilter(QObject::tr("Projects"), {project}),
                       makeFileFilter(QObject::tr("Footprints"), vectorEndings()),
                       makeFileFilter(QObject::tr("3D models and meshes"), modelEndings()),
                       makeFileFilter(QObject::tr("Terrain"), terrainEndings()),
                       QObject::tr("All files (*)")}
        .join(QStringLiteral(";;"));
}

}  // namespace noonmark
