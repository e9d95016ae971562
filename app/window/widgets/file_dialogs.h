#pragma once

#include <QStringList>

class QWidget;

namespace noonmark {

/// The questions for file names; empty when the user changes their mind.
QStringList askForCity(QWidget* parent);                           ///< or a project
QString askForProject(QWidget* parent, const QString& suggested);  ///< to save; asks before one is replaced
QString askForMesh(QWidget* parent);
QString askForRegion(QWidget* parent);
QString askForPicture(QWidget* parent);  ///< always with an ending
QString askForFolder(QWidget* parent, const QString& title);

/// Whether files that lie in a folder already may be replaced; true where there are none.
bool mayReplace(QWidget* parent, const QString& folder, const QStringList& files);

}  // namespace noonmark
