#pragma once

#include <QStringList>

namespace noonmark {

/// Endings of the files that are read, lower case, without the dot. Formats are recognised by their content:
/// endings only choose what a dialog lists and what a dropped file may be.
/// docs/user/data.md lists the same formats.
const QStringList& vectorEndings();   ///< footprints, places, regions
const QStringList& modelEndings();    ///< 3D city models and meshes
const QStringList& massEndings();     ///< meshes without a place of their own: a building to be placed
const QStringList& terrainEndings();  ///< rasters of elevations

/// A filter of a file dialog: "Meshes (*.obj *.ply)".
QString makeFileFilter(const QString& name, const QStringList& endings);

/// The filters for cities: everything that is read, projects, each kind alone, all files.
QString makeCityFilters();

}  // namespace noonmark
