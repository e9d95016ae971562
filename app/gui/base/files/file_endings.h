#pragma once

#include <QStringList>
#include <initializer_list>

#include "core/io/formats/format.h"

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

}  // namespace noonmark
