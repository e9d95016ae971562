#pragma once

#include <QStringList>
#include <initializer_list>
#include <string>
#include <vector>

#include "core/io/formats/format.h"

class QMimeData;
class QWidget;

namespace noonmark {

/// Endings of the files of these kinds that are read, without the dot. Formats are recognised by their
/// content: endings only choose what a dialog lists and what a dropped file may be.
QStringList endingsOf(std::initializer_list<FileKind> kinds);
QStringList pictureEndings();  ///< the same of aerial photographs

/// The name without the endings of files that are read, of which it may have several: "loop" of
/// "loop.osm.pbf".
QString withoutEndings(QString name);

/// A filter of a file dialog: "Meshes (*.obj *.ply)".
QString makeFileFilter(const QString& name, const QStringList& endings);

/// The filters for cities: everything that is read, projects, each kind alone, all files.
QString makeCityFilters();

/// File dialogs. Each returns an empty value if the user cancels.
QStringList askForCity(QWidget* parent);  ///< city files or a project
/// For saving; asks before replacing a file.
QString askForProject(QWidget* parent, const QString& suggested);
QString askForMesh(QWidget* parent);
QString askForRegion(QWidget* parent);
QString askForPhotograph(QWidget* parent);
QString askWhereToSavePhotograph(QWidget* parent);  ///< .tif; asks before replacing a file
QString askForGlazing(QWidget* parent);
QString askForPoints(QWidget* parent);                             ///< .csv
QStringList askForPlaces(QWidget* parent, const QString& folder);  ///< `folder`: where it begins
QString askForSky(QWidget* parent);                                ///< likewise: .svg, .png or .csv
QString askForTable(QWidget* parent, const QString& suggested);    ///< likewise: .csv
QString askForPicture(QWidget* parent);                            ///< always with a file extension
/// Buildings for CAD and GIS; may replace one. `formats`: "glTF (*.glb);;OBJ (*.obj)".
QString askForBuildings(QWidget* parent, const QString& suggested, const QString& formats);
QString askForMovie(QWidget* parent, const QString& suggested);  ///< .mp4 or .gif; may replace one
QString askForLogo(QWidget* parent);
QString askForFolder(QWidget* parent, const QString& title);

/// The local files that are dropped; empty: none.
QStringList listDroppedFiles(const QMimeData& dropped);

/// The names of those of the files that exist in the folder already.
QStringList listExistingFiles(const QString& folder, const std::vector<std::string>& files);
/// Asks whether existing files in a folder may be replaced; true if there are none.
bool mayReplace(QWidget* parent, const QString& folder, const QStringList& files);

}  // namespace noonmark
