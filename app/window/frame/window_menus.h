#pragma once

#include <QObject>
#include <QString>

class QAction;
class QMainWindow;
class QMenu;

namespace noonmark {

/// Menus of the main window; what they do is connected by the window. Actions belong to the window.
struct WindowMenus {
    explicit WindowMenus(QMainWindow& window);

    QAction* newProject;
    QAction* open;
    QAction* openWith;  ///< with settings of how to read
    QAction* openPark;
    QAction* openGrid;
    QMenu* recent;
    QAction* save;
    QAction* saveAs;
    QAction* savePicture;
    QAction* exportStudy;
    QAction* quit;
    QMenu* edit;
    QMenu* scenario;
    QAction* newScenario;
    QAction* newFromThis;
    QAction* compare;  ///< checkable
    QAction* measureAll;
    QAction* run;
    QAction* cancel;
    QAction* drawRegion;
    QAction* regionFile;
    QAction* keepResult;
    QAction* gross;
    QAction* continuous;
    QAction* wholeCity;
    QAction* northUp;
    QAction* fromAbove;
    QAction* region;
    QAction* faces;  ///< checkable
    QMenu* modes;
    QAction* byMaps;  ///< checkable
    QMenu* docks;
    QAction* keys;
};

/// How mouse and keys move the view and draw, in one line.
QString mouseAndKeys();

}  // namespace noonmark
