#include "app/window/frame/window_menus.h"

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

namespace noonmark {

namespace {

QAction* added(QMenu& menu, const QString& text, const QKeySequence& keys, const QString& tip) {
    QAction* action = menu.addAction(text);
    action->setShortcut(keys);
    action->setStatusTip(tip);
    action->setToolTip(tip);
    return action;
}

QString tr(const char* text) { return QObject::tr(text); }

}  // namespace

WindowMenus::WindowMenus(QMainWindow& window) {
    QMenuBar& bar = *window.menuBar();
    QMenu& file = *bar.addMenu(tr("&File"));
    newProject = added(file, tr("&New project from a city..."), QKeySequence::New,
                       tr("Footprints, CityJSON, meshes, terrain; several files are combined into one city"));
    open = added(file, tr("&Open..."), QKeySequence::Open,
                 tr("A project, or city files, from which a new project is created"));
    openWith = added(file, tr("Open &with options..."), QKeySequence(tr("Ctrl+Shift+O")),
                     tr("For files without location, unit or heights"));
    QMenu& sample = *file.addMenu(tr("Open &sample"));
    openPark = added(sample, tr("&Central Park South"), {},
                     tr("The park, its streets and the towers of the case study"));
    openGrid = added(sample, tr("&Grid"), {}, tr("A synthetic city of blocks and lots"));
    recent = file.addMenu(tr("Open &recent"));
    file.addSeparator();
    save = added(file, tr("&Save project"), QKeySequence::Save,
                 tr("City, scenarios, lots, results and view in one file"));
    saveAs = added(file, tr("Save project &as..."), QKeySequence(tr("Ctrl+Shift+S")), {});
    file.addSeparator();
    savePicture = added(file, tr("Save &picture..."), QKeySequence(tr("Ctrl+P")),
                        tr("The view with its legend, as a PNG file"));
    exportStudy = added(file, tr("&Export study..."), QKeySequence(tr("Ctrl+E")),
                        tr("The displayed result as GeoTIFF, map, PDF page, table and JSON, as the command "
                           "line writes them"));
    file.addSeparator();
    quit = added(file, tr("&Quit"), QKeySequence::Quit, {});

    edit = bar.addMenu(tr("&Edit"));

    scenario = bar.addMenu(tr("S&cenario"));
    newScenario = added(*scenario, tr("&New scenario"), {}, tr("Starts from the existing city"));
    newFromThis = added(*scenario, tr("New scenario &from this one"), {},
                        tr("Starts from the displayed scenario and inherits its later changes"));
    compare = added(*scenario, tr("&Compare with the existing city"), QKeySequence(tr("Ctrl+K")),
                    tr("Shows how many minutes of shadow the scenario adds or removes"));
    compare->setCheckable(true);
    measureAll = added(*scenario, tr("&Measure all scenarios"), {},
                       tr("Runs the same study for each scenario, for comparison side by side"));
    scenario->addSeparator();

    QMenu& study = *bar.addMenu(tr("&Study"));
    run = added(study, tr("&Run"), QKeySequence(tr("Ctrl+R")), tr("Compute the shadow in the region"));
    cancel = added(study, tr("&Cancel"), QKeySequence(tr("Ctrl+.")), tr("Stop the study that is running"));
    drawRegion = added(study, tr("&Draw region"), QKeySequence(tr("Ctrl+D")),
                       tr("Click corners on the ground; Enter finishes, Esc cancels"));
    regionFile =
        added(study, tr("Region from &file..."), {}, tr("Polygons from a file, in any coordinate system"));
    keepResult =
        added(study, tr("&Save result"), {}, tr("Stores the displayed map and figures in the project"));
    study.addSeparator();
    gross =
        added(study, tr("Show &gross shadow"), QKeySequence(tr("Ctrl+1")), tr("Minutes in shadow per day"));
    continuous = added(study, tr("Show c&ontinuous shadow"), QKeySequence(tr("Ctrl+2")),
                       tr("Longest unbroken run in shadow"));

    QMenu& view = *bar.addMenu(tr("&View"));
    wholeCity = added(view, tr("Zoom to whole &city"), Qt::Key_Home, {});
    northUp = added(view, tr("&North up"), Qt::Key_N, {});
    fromAbove = added(view, tr("&Top view"), Qt::Key_T, {});
    region = added(view, tr("Zoom to &region"), Qt::Key_R, tr("The study region seen from above"));
    view.addSeparator();
    faces = added(view, tr("&Solid buildings"), Qt::Key_B,
                  tr("Off: wireframe, so that the ground behind buildings is visible"));
    faces->setCheckable(true);
    faces->setChecked(true);
    modes = view.addMenu(tr("&Mode"));
    byMaps = added(view, tr("&Explore by shadow accrual maps"), {},
                   tr("As in the paper, instead of rays: inexact at shadow edges, but hours that look alike "
                      "are computed once"));
    byMaps->setCheckable(true);
    docks = view.addMenu(tr("&Panels"));

    QMenu& help = *bar.addMenu(tr("&Help"));
    keys = added(help, tr("&Mouse and keys"), QKeySequence::HelpContents, {});
}

QString mouseAndKeys() {
    return tr(
        "Left or middle drag rotates, right drag or Shift pans, the wheel zooms to the cursor. Arrow keys "
        "pan, + and - zoom. Home: whole city. N: north up. T: top view. R: region. B: solid buildings or "
        "wireframe. F5: exploration, F6: analysis, F7: ray reference. Ctrl+R: run. Click a building to "
        "select it: drag its arrow or type its height in metres and press Enter, Delete demolishes it, M "
        "moves it, Ctrl+T replaces it by a tower, Esc deselects it. Drawing a region or a lot (Ctrl+L): "
        "click corners, with Shift at right angles to the last side; double click, Enter or right click "
        "finishes, Backspace removes the last corner, Esc cancels.");
}

}  // namespace noonmark
