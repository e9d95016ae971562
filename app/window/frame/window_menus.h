#pragma once

#include <QObject>
#include <QString>

class QAction;
class QMainWindow;
class QMenu;

namespace noonmark {

/// Menus of the main window. The window connects the actions and owns them.
struct WindowMenus {
    explicit WindowMenus(QMainWindow& window);

    QAction* newProject;
    QAction* open;
    QAction* openWith;  ///< with reading settings
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

/// One-line summary of mouse and keyboard control.
QString mouseAndKeys();

}  // namespace noonmark
